//! Flows along and between solids.

use hearth_core::params::Input;
use hearth_core::{Simulation, Vec2};

use super::boxes::{GasBox, fill, run};
use super::measure::field::Sampler;
use super::measure::fit;
use super::plot::{Plot, Series};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "channel",
        pace: Pace::Long(10),
        run: channel,
    },
    Case {
        name: "column",
        pace: Pace::Long(10),
        run: column,
    },
    Case {
        name: "cavity",
        pace: Pace::Long(60),
        run: cavity,
    },
];

/// The id of the first solid of a scene.
const FIRST: u32 = 2;

/// A box \[m\] or, with equal sizes and `round`, a disc: centre and size.
#[derive(Clone, Copy)]
pub(super) struct Body {
    pub x: f64,
    pub y: f64,
    pub width: f64,
    pub height: f64,
    pub round: bool,
}

fn plate(x: f64, y: f64, width: f64, height: f64) -> Body {
    Body {
        x,
        y,
        width,
        height,
        round: false,
    }
}

/// A simulation of the gas of a box around solids, at rest or at `speed` along x.
///
/// # Panics
/// If a value is invalid, because the case is wrong.
pub(super) fn around(
    gas_box: &GasBox,
    values: &[(&str, f64)],
    bodies: &[Body],
    speed: f64,
) -> Simulation {
    let mut scene = gas_box.scene(values);
    for body in bodies {
        let shape = if body.round { "circle" } else { "box" };
        let fields = [
            ("kind", Input::Text("solid")),
            ("shape", Input::Text(shape)),
            ("x", Input::Number(body.x)),
            ("y", Input::Number(body.y)),
            ("width", Input::Number(body.width)),
            ("height", Input::Number(body.height)),
        ];
        if let Err(refused) = scene.add(&fields) {
            panic!("{refused:?}");
        }
    }
    let mut gas = gas_box.gas(0.0, |particle| particle.velocity.x = speed as f32);
    gas.retain(|particle| {
        let distances = scene
            .surfaces()
            .map(|(_, _, surface)| surface.distance(particle.position).0);
        distances.fold(f32::INFINITY, f32::min) > 0.25 * gas_box.spacing as f32
    });
    let mut fire = Simulation::new(scene);
    fill(&mut fire, &gas);
    fire
}

/// Gas between two plates under a body force along them.
fn channel() -> Outcome {
    const GAP_ROWS: u32 = 24;
    const PLATE_ROWS: u32 = 8;
    const GAP: f64 = 0.1;
    const SPEED: f64 = 0.1;
    const VISCOSITY: f64 = 0.01;
    let gas_box = GasBox {
        columns: 24,
        rows: GAP_ROWS + PLATE_ROWS,
        spacing: GAP / f64::from(GAP_ROWS),
    };
    let thickness = f64::from(PLATE_ROWS) * gas_box.spacing;
    let bodies = [plate(0.0, 0.5 * thickness, gas_box.width(), thickness)];
    let values = [("stiffness", 4.0), ("kinematic_viscosity", VISCOSITY)];
    let mut fire = around(&gas_box, &values, &bodies, 0.0);
    let force = 8.0 * VISCOSITY * SPEED / (GAP * GAP);
    let mut rows = vec![(0.0, 0.0); GAP_ROWS as usize];
    let mut came = true;
    for (until, measured) in [(1.0, false), (1.5, true)] {
        came &= run(&mut fire, until * GAP * GAP / VISCOSITY, |fire| {
            fire.step_with(|_, _| Vec2::new(force as f32, 0.0));
            if !measured {
                return;
            }
            for (position, velocity) in fire.positions().into_iter().zip(fire.velocities()) {
                let y = (f64::from(position.y) - thickness) / gas_box.spacing;
                if let Some(row) = rows.get_mut(y.max(0.0) as usize) {
                    row.0 += f64::from(velocity.x);
                    row.1 += 1.0;
                }
            }
        });
    }
    let exact = |y: f64| 4.0 * y * (1.0 - y);
    let profile: Vec<_> = (0_u32..)
        .zip(&rows)
        .map(|(i, (sum, n))| ((f64::from(i) + 0.5) / f64::from(GAP_ROWS), sum / n / SPEED))
        .collect();
    let off = profile.iter().map(|(y, u)| (u - exact(*y)).abs());
    let off = off.fold(0.0, f64::max);
    let fine = (0..=40).map(|i| f64::from(i) / 40.0);
    let plot = Plot::new("channel", "Flow between plates", "y / L", "u / U")
        .showing(Series::line("4y(1 − y)", fine.map(|y| (y, exact(y)))))
        .showing(Series::dots("measured", profile));
    Outcome::rows([Row::new(
        "channel",
        "steady flow between two solids, greatest error / greatest speed",
        Expected::AtMost(0.05),
        if came { off } else { f64::NAN },
    )
    .noting("24 particles across")])
    .with(plot)
}

/// Hot gas between a lower and an upper plate, lifted against the upper one.
fn column() -> Outcome {
    const ROWS: u32 = 48;
    const PLATE_ROWS: u32 = 8;
    const FORCE: f64 = 9.81;
    let gas_box = GasBox {
        columns: 16,
        rows: ROWS + PLATE_ROWS,
        spacing: 0.01,
    };
    let thickness = f64::from(PLATE_ROWS) * gas_box.spacing;
    let bodies = [plate(0.0, 0.5 * thickness, gas_box.width(), thickness)];
    let values = [
        ("stiffness", 10.0),
        ("kinematic_viscosity", 0.005),
        ("artificial_viscosity", 0.5),
    ];
    let mut fire = around(&gas_box, &values, &bodies, 0.0);
    // The force grows slowly, so that no sound is left when it is all there.
    let step = |fire: &mut Simulation| {
        let force = (FORCE * (fire.time() / 0.5).min(1.0)) as f32;
        fire.step_with(|_, _| Vec2::new(0.0, force));
    };
    let mut came = run(&mut fire, 2.0, step);
    let mut rows = vec![[0.0_f64; 3]; ROWS as usize];
    came &= run(&mut fire, 3.5, |fire| {
        step(fire);
        let state = fire.positions().into_iter().zip(fire.pressures());
        for ((position, pressure), density) in state.zip(fire.densities()) {
            let row = (f64::from(position.y) - thickness) / gas_box.spacing;
            if let Some(row) = rows.get_mut(row.max(0.0) as usize) {
                row[0] += 1.0;
                row[1] += f64::from(pressure);
                row[2] += f64::from(density);
            }
        }
    });
    let profile: Vec<_> = (0_u32..)
        .zip(&rows)
        .map(|(i, [n, p, rho])| ((f64::from(i) + 0.5) * gas_box.spacing, p / n, rho / n))
        .collect();
    let slope = fit::line(profile.iter().map(|(y, p, _)| (*y, *p))).slope;
    let density = fit::mean(profile.iter().map(|row| row.2));
    let plot = Plot::new("column", "Column between solids", "y [m]", "p [Pa]").showing(
        Series::dots("measured", profile.iter().map(|row| (row.0, row.1))),
    );
    Outcome::rows([Row::new(
        "column",
        "column between solids, dp/dy / ρf",
        Expected::Value {
            value: 1.0,
            tolerance: 0.03,
        },
        if came {
            slope / (density * FORCE)
        } else {
            f64::NAN
        },
    )
    .noting("all rows, those at the solids too")])
    .with(plot)
}

/// Velocity along x on the vertical centre line over y/L, in speeds of the lid, at Re 100 (Ghia,
/// Ghia and Shin 1982, table I).
const GHIA_U: [(f64, f64); 15] = [
    (0.9766, 0.84123),
    (0.9688, 0.78871),
    (0.9609, 0.73722),
    (0.9531, 0.68717),
    (0.8516, 0.23151),
    (0.7344, 0.00332),
    (0.6172, -0.13641),
    (0.5000, -0.20581),
    (0.4531, -0.21090),
    (0.2813, -0.15662),
    (0.1719, -0.10150),
    (0.1016, -0.06434),
    (0.0703, -0.04775),
    (0.0625, -0.04192),
    (0.0547, -0.03717),
];
/// Velocity along y on the horizontal centre line over x/L (table II).
const GHIA_V: [(f64, f64); 15] = [
    (0.9688, -0.05906),
    (0.9609, -0.07391),
    (0.9531, -0.08864),
    (0.9453, -0.10313),
    (0.9063, -0.16914),
    (0.8594, -0.22445),
    (0.8047, -0.24533),
    (0.5000, 0.05454),
    (0.2344, 0.17527),
    (0.2266, 0.17507),
    (0.1563, 0.16077),
    (0.0938, 0.12317),
    (0.0781, 0.10890),
    (0.0703, 0.10091),
    (0.0625, 0.09233),
];

/// Gas in a square cavity of four solids, whose upper one slides.
fn cavity() -> Outcome {
    const CELLS: u32 = 50;
    const WALL: u32 = 8;
    const SIDE: f64 = 0.3;
    const SPEED: f64 = 0.4;
    const STEPS: u32 = 8;
    let spacing = SIDE / f64::from(CELLS);
    let gas_box = GasBox {
        columns: CELLS + 2 * WALL,
        rows: CELLS + 2 * WALL,
        spacing,
    };
    let (size, wall) = (gas_box.width(), f64::from(WALL) * spacing);
    let sides = 0.5 * (SIDE + wall);
    let path = 6.0;
    let bodies = [
        plate(-0.5 * path, size - 0.5 * wall, 10.0, wall),
        plate(0.0, 0.5 * wall, size, wall),
        plate(-sides, 0.5 * size, wall, SIDE),
        plate(sides, 0.5 * size, wall, SIDE),
    ];
    let values = [
        ("stiffness", 4.0),
        ("kinematic_viscosity", SPEED * SIDE / 100.0),
        ("smoothing_ratio", 1.5),
    ];
    let mut fire = around(&gas_box, &values, &bodies, 0.0);
    let sampler = Sampler::new(SIDE, SIDE, spacing, 1.0 * spacing);
    let mut sums = [
        vec![0.0; sampler.columns * sampler.rows],
        vec![0.0; sampler.columns * sampler.rows],
    ];
    let (mut count, mut steps) = (0.0, 0);
    let came = run(&mut fire, 0.95 * path / SPEED, |fire| {
        if steps % STEPS == 0 {
            let mut scene = fire.scene().clone();
            let x = SPEED * fire.time() - 0.5 * path;
            if let Err(refused) = scene.change(FIRST, &[("x", Input::Number(x))]) {
                panic!("{refused:?}");
            }
            fire.set_scene(scene);
        }
        steps += 1;
        fire.step();
        if fire.time() > 0.7 * path / SPEED && steps % 20 == 0 {
            count += 1.0;
            let state = fire.positions().into_iter().zip(fire.velocities());
            let volume = (spacing * spacing) as f32;
            let gas = state.map(|(at, v)| (at - Vec2::new(0.0, wall as f32), volume, [v.x, v.y]));
            for (sum, field) in sums.iter_mut().zip(sampler.sample::<2>(gas)) {
                for (sum, value) in sum.iter_mut().zip(field) {
                    *sum += value;
                }
            }
        }
    });
    // The centre lines lie between two columns and two rows.
    let middle = CELLS as usize / 2;
    let cell = |field: &[f64], column: usize, row: usize| {
        field[row * sampler.columns + column] / count / SPEED
    };
    let place = |i: usize| (i as f64 + 0.5) / f64::from(CELLS);
    let up: Vec<_> = (0..sampler.rows)
        .map(|row| {
            (
                place(row),
                0.5 * (cell(&sums[0], middle - 1, row) + cell(&sums[0], middle, row)),
            )
        })
        .collect();
    let across: Vec<_> = (0..sampler.columns)
        .map(|column| {
            (
                place(column),
                0.5 * (cell(&sums[1], column, middle - 1) + cell(&sums[1], column, middle)),
            )
        })
        .collect();
    let worst = |measured: &[(f64, f64)], known: &[(f64, f64)]| {
        known
            .iter()
            .map(|&(at, value)| (between(measured, at) - value).abs())
            .fold(0.0, f64::max)
    };
    let off = worst(&up, &GHIA_U).max(worst(&across, &GHIA_V));
    let plot = Plot::new(
        "cavity",
        "Lid-driven cavity, Re 100",
        "place / L",
        "velocity / U",
    )
    .showing(Series::dots("Ghia, Ghia and Shin 1982, u(y)", GHIA_U))
    .showing(Series::line("u(y)", up))
    .showing(Series::dots("v(x)", GHIA_V))
    .showing(Series::line("v(x) measured", across));
    Outcome::rows([Row::new(
        "cavity",
        "lid-driven cavity, Re 100: greatest error on both centre lines / speed of the lid (Ghia, Ghia and Shin 1982)",
        Expected::AtMost(0.05),
        if came { off } else { f64::NAN },
    )
    .noting("50 particles across")])
    .with(plot)
}

/// The value at a place, between the two measured ones beside it.
fn between(measured: &[(f64, f64)], at: f64) -> f64 {
    let after = measured
        .partition_point(|point| point.0 < at)
        .clamp(1, measured.len() - 1);
    let ((x0, y0), (x1, y1)) = (measured[after - 1], measured[after]);
    y0 + (y1 - y0) * (at - x0) / (x1 - x0)
}
