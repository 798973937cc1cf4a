//! The kernel, and the operators that the solver builds on it.

use std::f64::consts::PI;

use hearth_core::kernel::Kernel;
use hearth_core::random::Random;
use hearth_core::{Particle, Vec2};

use super::boxes::{GasBox, wide};
use super::measure::fit;
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "kernel",
        pace: Pace::Quick,
        run: kernel,
    },
    Case {
        name: "lattice-density",
        pace: Pace::Quick,
        run: lattice_density,
    },
    Case {
        name: "pressure-gradient",
        pace: Pace::Quick,
        run: pressure_gradient,
    },
    Case {
        name: "laplacian",
        pace: Pace::Quick,
        run: laplacian,
    },
    Case {
        name: "dissipation",
        pace: Pace::Quick,
        run: dissipation,
    },
    Case {
        name: "momentum",
        pace: Pace::Quick,
        run: momentum,
    },
];

const LATTICE: GasBox = GasBox {
    columns: 32,
    rows: 64,
    spacing: 0.02,
};

/// The ratios h/dx that the parameter allows: its ends and its default.
const RATIOS: [f64; 3] = [1.3, 1.5, 2.0];

/// The value farthest from `from`.
fn farthest(values: impl IntoIterator<Item = f64>, from: f64) -> f64 {
    let off = |value: f64| {
        if value.is_finite() {
            (value - from).abs()
        } else {
            f64::INFINITY
        }
    };
    values
        .into_iter()
        .max_by(|a, b| off(*a).total_cmp(&off(*b)))
        .unwrap_or(f64::NAN)
}

fn kernel() -> Outcome {
    let volume = |h: f32| {
        let kernel = Kernel::new(h);
        let cells = 200_000;
        let dr = f64::from(kernel.support()) / f64::from(cells);
        (0..cells)
            .map(|i| {
                let r = (f64::from(i) + 0.5) * dr;
                f64::from(kernel.value(r as f32)) * 2.0 * PI * r * dr
            })
            .sum::<f64>()
    };
    Outcome::rows([Row::new(
        "kernel",
        "kernel, ∫W dA",
        Expected::Value {
            value: 1.0,
            tolerance: 1e-6,
        },
        farthest([0.01, 0.035, 0.1].map(volume), 1.0),
    )])
}

fn lattice_density() -> Outcome {
    let worst = |ratio: f64| {
        let gas = LATTICE.gas(0.0, |_| {});
        let mut fire = LATTICE.simulation(&[("smoothing_ratio", ratio)], &gas);
        let rest = f64::from(fire.parameters().ambient_density);
        fire.step();
        let densities = fire.densities().into_iter();
        farthest(densities.map(|density| f64::from(density) / rest), 1.0)
    };
    Outcome::rows([Row::new(
        "lattice-density",
        "density of a lattice / ρ₀, h/dx 1.3, 1.5 and 2",
        Expected::Value {
            value: 1.0,
            tolerance: 0.005,
        },
        farthest(RATIOS.map(worst), 1.0),
    )])
}

/// A triangle wave over the height: 0 at the bottom and the top, 1 half way.
fn triangle(y: f32, height: f64) -> f64 {
    1.0 - (2.0 * f64::from(y) / height - 1.0).abs()
}

/// Whether `y` is farther than `margin` from the kinks of the triangle wave.
fn off_the_kinks(y: f64, height: f64, margin: f64) -> bool {
    let from_half = (y - 0.5 * height).abs();
    from_half > margin && 0.5 * height - from_half > margin
}

/// With the ideal gas, a temperature that rises linearly makes a pressure that
/// does. One step from rest gives the acceleration.
fn pressure_gradient() -> Outcome {
    let height = LATTICE.height();
    let factor = |ratio: f64| {
        let gas = LATTICE.gas(0.0, |particle| {
            particle.temperature = 293.0 + (2.0 * triangle(particle.position.y, height)) as f32;
        });
        let values = [
            ("smoothing_ratio", ratio),
            ("gas_expansion", 1.0),
            ("ambient_temperature", 293.0),
        ];
        let mut fire = LATTICE.simulation(&values, &gas);
        fire.step();
        let length = fire.step_length();
        let margin = 4.0 * ratio * LATTICE.spacing;
        let below = |y: f64| y < 0.5 * height;
        let inside = |y: f64| below(y) && off_the_kinks(y, height, margin);
        let (pressures, velocities) = (fire.pressures(), fire.velocities());
        let slope = fit::line(
            gas.iter()
                .zip(&pressures)
                .map(|(particle, &p)| (f64::from(particle.position.y), f64::from(p)))
                .filter(|(y, _)| inside(*y)),
        )
        .slope;
        farthest(
            gas.iter()
                .zip(velocities.iter().zip(fire.densities()))
                .filter(|(particle, _)| inside(f64::from(particle.position.y)))
                .map(|(_, (v, density))| -f64::from(v.y) / length * f64::from(density) / slope),
            1.0,
        )
    };
    Outcome::rows([Row::new(
        "pressure-gradient",
        "force of a linear pressure on a lattice / −∇p",
        Expected::Value {
            value: 1.0,
            tolerance: 0.03,
        },
        farthest(RATIOS.map(factor), 1.0),
    )])
}

/// One step of diffusion of a parabola.
fn laplacian() -> Outcome {
    let (height, curvature, diffusivity) = (LATTICE.height(), 1000.0, 0.01);
    let factor = |ratio: f64| {
        let middle = 0.5 * height;
        let gas = LATTICE.gas(0.0, |particle| {
            let off = f64::from(particle.position.y) - middle;
            particle.temperature = (400.0 + curvature * off * off) as f32;
        });
        let values = [("smoothing_ratio", ratio), ("diffusion", diffusivity)];
        let mut fire = LATTICE.simulation(&values, &gas);
        fire.step();
        let gained = f64::from(LATTICE.columns) * fire.step_length() * diffusivity * curvature;
        // Whole rows, so that the last bit of a temperature averages out.
        let columns = LATTICE.columns as usize;
        let (before, after) = (gas.chunks(columns), fire.temperatures());
        let margin = 4.0 * ratio * LATTICE.spacing;
        farthest(
            before
                .zip(after.chunks(columns))
                .filter(|(row, _)| {
                    row.first().is_some_and(|particle| {
                        (f64::from(particle.position.y) - middle).abs() < middle - margin
                    })
                })
                .map(|(row, warmer)| {
                    let rise = |(a, b): (&Particle, &f32)| f64::from(*b) - f64::from(a.temperature);
                    row.iter().zip(warmer).map(rise).sum::<f64>() / gained
                }),
            2.0,
        )
    };
    Outcome::rows([Row::new(
        "laplacian",
        "Laplacian of x² by heat diffusion on a lattice",
        Expected::Share {
            value: 2.0,
            tolerance: 0.04,
        },
        farthest(RATIOS.map(factor), 2.0),
    )])
}

/// Work of viscosity alone: that of a step with it less that of the same step
/// without, relative to the sum of magnitudes.
fn dissipation() -> Outcome {
    let cloud = GasBox {
        columns: 32,
        rows: 32,
        spacing: 0.02,
    };
    let work = |seed: u32| {
        let mut random = Random::new(seed);
        let (width, height) = (cloud.width() as f32, cloud.height() as f32);
        // Any cloud at all: clumps, holes, and pairs much closer than usual.
        let gas: Vec<_> = (0..cloud.columns * cloud.rows)
            .map(|_| {
                let x = random.between(-0.5, 0.5) * width;
                let mut particle = Particle::at(Vec2::new(x, random.unit() * height));
                particle.velocity = Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
                particle
            })
            .collect();
        let pushed = |viscosity: f64| -> Vec<(f64, f64)> {
            let values = [("kinematic_viscosity", viscosity)];
            let mut fire = cloud.simulation(&values, &gas);
            fire.step();
            let length = fire.step_length();
            let gained = |(after, before): (Vec2, &Particle)| {
                let ((x, y), (x0, y0)) = (wide(after), wide(before.velocity));
                ((x - x0) / length, (y - y0) / length)
            };
            fire.velocities()
                .into_iter()
                .zip(&gas)
                .map(gained)
                .collect()
        };
        let (with, without) = (pushed(0.01), pushed(0.0));
        let (mut sum, mut magnitudes) = (0.0, 0.0);
        for ((a, b), particle) in with.iter().zip(&without).zip(&gas) {
            let (u, v) = wide(particle.velocity);
            let work = u * (a.0 - b.0) + v * (a.1 - b.1);
            sum += work;
            magnitudes += work.abs();
        }
        sum / magnitudes
    };
    let works = (1..=8).map(work);
    Outcome::rows([Row::new(
        "dissipation",
        "work of viscosity in any cloud / its magnitude",
        Expected::AtMost(1e-12),
        works.fold(f64::NEG_INFINITY, f64::max),
    )])
}

/// Everything that moves momentum between particles, in a closed box.
fn momentum() -> Outcome {
    let gas_box = GasBox {
        columns: 32,
        rows: 32,
        spacing: 0.02,
    };
    let mut random = Random::new(5);
    let mut gas = gas_box.gas(0.2, |_| {});
    for particle in &mut gas {
        particle.velocity = Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        particle.temperature = random.between(293.0, 1500.0);
    }
    let values = [
        ("kinematic_viscosity", 1e-3),
        ("artificial_viscosity", 0.1),
        ("eddy_viscosity", 0.2),
        ("diffusion", 1e-3),
        ("gas_expansion", 0.5),
    ];
    let mut fire = gas_box.simulation(&values, &gas);
    let total = |velocities: Vec<Vec2>| {
        velocities
            .into_iter()
            .map(wide)
            .fold((0.0, 0.0), |sum, v| (sum.0 + v.0, sum.1 + v.1))
    };
    let magnitude: f64 = gas.iter().map(|p| f64::from(p.velocity.length())).sum();
    let before = total(fire.velocities());
    let mut worst: f64 = 0.0;
    for _ in 0..300 {
        fire.step();
        let now = total(fire.velocities());
        let drift = (now.0 - before.0).hypot(now.1 - before.1) / magnitude;
        worst = worst.max(drift);
    }
    Outcome::rows([Row::new(
        "momentum",
        "momentum of a closed box, drift / Σm|v|, 300 steps",
        // A sum of n terms of f32, 300 times: a few last bits.
        Expected::AtMost(2e-6),
        worst,
    )])
}
