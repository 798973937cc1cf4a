//! Slow flows with exact solutions.

use std::f64::consts::{PI, TAU};

use hearth_core::{Particle, Simulation, Vec2};

use super::boxes::{GasBox, fill, run, wide};
use super::measure::{fit, signal};
use super::plot::{Plot, Series};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "taylor-green-20",
        pace: Pace::Quick,
        run: || taylor_green(20.0, 0.05),
    },
    Case {
        name: "taylor-green-100",
        pace: Pace::Quick,
        run: || taylor_green(100.0, 0.10),
    },
    Case {
        name: "couette",
        pace: Pace::Quick,
        run: couette,
    },
    Case {
        name: "poiseuille",
        pace: Pace::Quick,
        run: poiseuille,
    },
];

/// Four vortices whose kinetic energy falls as e^(−4νk²t), by Reynolds'
/// number UL/ν, L the side of the box; followed until 1/e of it should be left.
fn taylor_green(reynolds: f64, tolerance: f64) -> Outcome {
    const SPEED: f64 = 0.5;
    let gas_box = GasBox {
        columns: 64,
        rows: 64,
        spacing: 0.4 / 64.0,
    };
    let viscosity = SPEED * gas_box.width() / reynolds;
    let k = TAU / gas_box.width();
    let rate = 4.0 * viscosity * k * k;
    let gas = gas_box.gas(0.1, |particle| {
        let (x, y) = wide(particle.position);
        let (u, v) = ((k * x).sin() * (k * y).cos(), (k * x).cos() * (k * y).sin());
        particle.velocity = Vec2::new((SPEED * u) as f32, (-SPEED * v) as f32);
    });
    let values = [
        ("stiffness", 10.0 * SPEED),
        ("kinematic_viscosity", viscosity),
        ("smoothing_ratio", 1.5),
    ];
    let mut fire = gas_box.simulation(&values, &gas);
    let energy = |fire: &Simulation| -> f64 {
        let velocities = fire.velocities().into_iter().map(wide);
        velocities.map(|(u, v)| u * u + v * v).sum()
    };
    let (first, until) = (energy(&fire), 1.0 / rate);
    let mut left = vec![(0.0, 1.0)];
    let came = run(&mut fire, until, |fire| {
        fire.step();
        left.push((fire.time(), energy(fire) / first));
    });
    // The gas starts without the pressure of the vortices; what that stirs
    // up is over after a tenth.
    let settled = left.iter().filter(|(t, _)| *t > 0.1 * until).copied();
    let measured = if came {
        -signal::growth(settled) / rate
    } else {
        f64::NAN
    };
    let name = format!("taylor-green-{reynolds}");
    let exact = (0..=40).map(|i| {
        let t = f64::from(i) / 40.0 * until;
        (t, (-rate * t).exp())
    });
    let plot = Plot::new(
        &name,
        &format!("Taylor–Green vortices, Re {reynolds}"),
        "t [s]",
        "kinetic energy left",
    )
    .showing(Series::line("e^(−4νk²t)", exact))
    .showing(Series::dots("measured", left));
    Outcome::rows([Row::new(
        name,
        format!("Taylor–Green vortices, Re {reynolds}: rate of decay / 4νk²"),
        Expected::Value {
            value: 1.0,
            tolerance,
        },
        measured,
    )
    .noting(format!("64 × 64, final energy {:.3} e⁻¹", last(&plot)))])
    .with(plot)
}

/// The last measured value times e.
fn last(plot: &Plot) -> f64 {
    plot.series
        .last()
        .and_then(|series| series.points.last())
        .map_or(f64::NAN, |point| point.1 * 1f64.exp())
}

const GAP: f64 = 0.1;
const VISCOSITY: f64 = 0.01;
const GAP_ROWS: u32 = 24;
/// Rows of a plate: on each side as many as the kernel reaches.
const PLATE_ROWS: u32 = 6;

/// Mean velocities along x of rows of the gas, `from` that row on.
fn profile(fire: &Simulation, spacing: f64, from: u32) -> Vec<(f64, f64)> {
    let mut rows = vec![(0.0, 0.0); GAP_ROWS as usize];
    for (position, velocity) in fire.positions().into_iter().zip(fire.velocities()) {
        let row = (f64::from(position.y) / spacing).floor() - f64::from(from);
        if row >= 0.0
            && let Some(row) = rows.get_mut(row as usize)
        {
            row.0 += f64::from(velocity.x);
            row.1 += 1.0;
        }
    }
    rows.into_iter()
        .enumerate()
        .map(|(i, (sum, n))| ((i as f64 + 0.5) * spacing / GAP, sum / n))
        .collect()
}

/// Greatest difference of profiles from an exact one over all given times,
/// and a plot of them.
struct Profiles {
    off: f64,
    plot: Plot,
}

impl Profiles {
    fn add(&mut self, time: f64, measured: &[(f64, f64)], exact: impl Fn(f64) -> f64) {
        for &(y, u) in measured {
            let off = (u - exact(y)).abs();
            self.off = if off.is_nan() {
                f64::INFINITY
            } else {
                self.off.max(off)
            };
        }
        let fine = (0..=40).map(|i| f64::from(i) / 40.0);
        let label = format!("t = {:.2} L²/ν", time * VISCOSITY / (GAP * GAP));
        self.plot
            .push(Series::line("", fine.map(|y| (y, exact(y)))));
        self.plot
            .push(Series::dots(&label, measured.iter().copied()));
    }

    fn outcome(self, id: &str, what: &str) -> Outcome {
        Outcome::rows([Row::new(id, what, Expected::AtMost(0.02), self.off)
            .noting("series of Morris, Fox and Zhu 1997")])
        .with(self.plot)
    }
}

/// Times of the profiles in L²/ν: early, half way, nearly steady.
const TIMES: [f64; 4] = [0.02, 0.06, 0.15, 0.6];

/// Two plates that are part of the gas, one at rest and one at speed; between
/// them, upward and downward, the gas is dragged along. So that a plate's edge
/// has its speed, the velocities in it mirror those before it (Morris, Fox and
/// Zhu 1997).
fn couette() -> Outcome {
    const SPEED: f64 = 0.1;
    let spacing = GAP / f64::from(GAP_ROWS);
    let gas_box = GasBox {
        columns: 24,
        rows: 2 * (GAP_ROWS + PLATE_ROWS),
        spacing,
    };
    let mut gas = gas_box.gas(0.0, |_| {});
    hold_plates(&mut gas, &gas_box, SPEED);
    let values = [("stiffness", 4.0), ("kinematic_viscosity", VISCOSITY)];
    let mut fire = gas_box.simulation(&values, &gas);
    let mut profiles = Profiles {
        off: 0.0,
        plot: Plot::new("couette", "Couette flow", "y / L", "u / U"),
    };
    for time in TIMES {
        run(&mut fire, time * GAP * GAP / VISCOSITY, |fire| {
            fire.step();
            let mut gas = fire.particles();
            hold_plates(&mut gas, &gas_box, SPEED);
            fill(fire, &gas);
        });
        let t = fire.time() * VISCOSITY / (GAP * GAP);
        let exact = |y: f64| {
            let swing = |n: f64| {
                let sign = if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
                2.0 / (n * PI) * sign * signal::mode(n, y) * (-(n * PI).powi(2) * t).exp()
            };
            y + (1..200).map(|n| swing(f64::from(n))).sum::<f64>()
        };
        // Both gaps, as seen from the plate at rest.
        let up = profile(&fire, spacing, PLATE_ROWS);
        let down = profile(&fire, spacing, 2 * PLATE_ROWS + GAP_ROWS);
        let both: Vec<_> = up
            .iter()
            .zip(down.iter().rev())
            .map(|(a, b)| (a.0, fit::mean([a.1, b.1]) / SPEED))
            .collect();
        profiles.add(fire.time(), &both, exact);
    }
    profiles.outcome("couette", "Couette flow, greatest error / U")
}

/// Gives the rows of both plates, the lowest one's at rest and the other's at
/// `speed`, twice that less the mean velocity of the row that lies as far
/// before the plate's edge.
fn hold_plates(gas: &mut [Particle], gas_box: &GasBox, speed: f64) {
    let rows = gas_box.rows as usize;
    let plate = PLATE_ROWS as usize;
    let row_of = |particle: &Particle| {
        ((f64::from(particle.position.y) / gas_box.spacing) as usize).min(rows - 1)
    };
    let mut sums = vec![(0.0, 0.0); rows];
    for particle in gas.iter() {
        let (sum, n) = &mut sums[row_of(particle)];
        *sum += f64::from(particle.velocity.x);
        *n += 1.0;
    }
    for particle in gas {
        let row = row_of(particle);
        let half = rows / 2;
        let (from, speed) = if row < half { (0, 0.0) } else { (half, speed) };
        let depth = row - from;
        if depth >= plate {
            continue;
        }
        let mirror = if depth < plate / 2 {
            (from + rows - 1 - depth) % rows
        } else {
            from + 2 * plate - 1 - depth
        };
        let (sum, n) = sums[mirror];
        particle.velocity = Vec2::new((2.0 * speed - sum / f64::max(n, 1.0)) as f32, 0.0);
    }
}

/// Body forces to the right in one half and to the left in the other make two
/// Poiseuille flows without a wall (Backer et al. 2005).
fn poiseuille() -> Outcome {
    const SPEED: f64 = 0.1;
    let force = 8.0 * VISCOSITY * SPEED / (GAP * GAP);
    let spacing = GAP / f64::from(GAP_ROWS);
    let gas_box = GasBox {
        columns: 24,
        rows: 2 * GAP_ROWS,
        spacing,
    };
    let values = [("stiffness", 4.0), ("kinematic_viscosity", VISCOSITY)];
    let mut fire = gas_box.simulation(&values, &gas_box.gas(0.0, |_| {}));
    let mut profiles = Profiles {
        off: 0.0,
        plot: Plot::new("poiseuille", "Poiseuille flow", "y / L", "u / U"),
    };
    for time in TIMES {
        run(&mut fire, time * GAP * GAP / VISCOSITY, |fire| {
            fire.step_with(|position, _| {
                let right = position.y < GAP as f32;
                Vec2::new(if right { force } else { -force } as f32, 0.0)
            });
        });
        let t = fire.time() * VISCOSITY / (GAP * GAP);
        let exact = |y: f64| {
            let swing = |n: f64| {
                32.0 / (n * PI).powi(3) * signal::mode(n, y) * (-(n * PI).powi(2) * t).exp()
            };
            4.0 * y * (1.0 - y) - signal::odd_series(swing)
        };
        let (right, left) = (
            profile(&fire, spacing, 0),
            profile(&fire, spacing, GAP_ROWS),
        );
        let both: Vec<_> = right
            .iter()
            .zip(&left)
            .map(|(a, b)| (a.0, 0.5 * (a.1 - b.1) / SPEED))
            .collect();
        profiles.add(fire.time(), &both, exact);
    }
    profiles.outcome("poiseuille", "reverse Poiseuille flow, greatest error / U")
}
