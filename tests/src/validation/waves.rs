//! Pressure: a wave that stands, and a column that rests.

use std::f64::consts::TAU;

use hearth_core::Vec2;

use super::boxes::{GasBox, run};
use super::measure::{fit, signal};
use super::plot::{Plot, Series};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "standing-wave",
        pace: Pace::Quick,
        run: standing_wave,
    },
    Case {
        name: "hydrostatic",
        pace: Pace::Quick,
        run: hydrostatic,
    },
];

/// A velocity sin(kx), one wave across the box, swings at c/L.
fn standing_wave() -> Outcome {
    let gas_box = GasBox {
        columns: 64,
        rows: 16,
        spacing: 0.01,
    };
    let (length, speed) = (gas_box.width(), 10.0);
    let wave = |x: f32| (TAU * f64::from(x) / length).sin();
    let gas = gas_box.gas(0.0, |particle| {
        particle.velocity.x = (0.001 * speed * wave(particle.position.x)) as f32;
    });
    let mut fire = gas_box.simulation(&[("stiffness", speed)], &gas);
    let sound = f64::from(fire.sound_speed());
    let mut swing = Vec::new();
    run(&mut fire, 4.2 * length / speed, |fire| {
        fire.step();
        let projected: f64 = fire
            .positions()
            .iter()
            .zip(fire.velocities())
            .map(|(position, v)| f64::from(v.x) * wave(position.x))
            .sum();
        swing.push((fire.time(), projected));
    });
    let frequency = signal::crossing_frequency(&swing);
    Outcome::rows([Row::new(
        "standing-wave",
        "standing sound wave, frequency / (c/L)",
        Expected::Value {
            value: 1.0,
            tolerance: 0.02,
        },
        frequency * length / sound,
    )])
}

/// A body force up in the lower half and down in the upper one presses the
/// gas together in the middle: dp/dy = ρf below, −ρf above.
fn hydrostatic() -> Outcome {
    const FORCE: f64 = 9.81;
    let gas_box = GasBox {
        columns: 16,
        rows: 64,
        spacing: 0.01,
    };
    let height = gas_box.height();
    let values = [
        ("stiffness", 10.0),
        ("kinematic_viscosity", 0.005),
        ("artificial_viscosity", 0.5),
    ];
    let mut fire = gas_box.simulation(&values, &gas_box.gas(0.0, |_| {}));
    // The force comes slowly, so that no sound is left when it is all there.
    let middle = 0.5 * height as f32;
    let push = |time: f64| (FORCE * (time / 0.5).min(1.0)) as f32;
    let mut step = |fire: &mut hearth_core::Simulation| {
        let force = push(fire.time());
        fire.step_with(|position, _| {
            Vec2::new(0.0, if position.y < middle { force } else { -force })
        });
    };
    run(&mut fire, 2.0, &mut step);
    // Rows of pressure, averaged over a while.
    let (mut column, mut weight) = (vec![[0.0_f64; 3]; gas_box.rows as usize], 0.0);
    run(&mut fire, 3.5, |fire| {
        step(fire);
        weight += 1.0;
        let state = fire.positions().into_iter().zip(fire.pressures());
        for ((position, pressure), density) in state.zip(fire.densities()) {
            let row = (f64::from(position.y) / gas_box.spacing) as usize;
            if let Some(row) = column.get_mut(row) {
                row[0] += 1.0;
                row[1] += f64::from(pressure);
                row[2] += f64::from(density);
            }
        }
    });
    let rows: Vec<_> = column
        .iter()
        .enumerate()
        .map(|(i, [n, p, rho])| ((i as f64 + 0.5) * gas_box.spacing, p / n, rho / n))
        .collect();
    let margin = 4.0 * gas_box.spacing;
    let inside = rows.iter().filter_map(|(y, p, density)| {
        let from_middle = (y - 0.5 * height).abs();
        let off_kinks = from_middle > margin && from_middle < 0.5 * height - margin;
        off_kinks.then_some((from_middle, *p, *density))
    });
    let density = fit::mean(inside.clone().map(|row| row.2));
    let slope = -fit::line(inside.map(|row| (row.0, row.1))).slope;
    let least = rows.iter().map(|row| row.1).fold(f64::INFINITY, f64::min);
    let rest = f64::from(fire.parameters().ambient_density);
    let exact = |y: f64| -(y - 0.5 * height).abs() * rest * FORCE;
    let lift = fit::mean(rows.iter().map(|(y, p, _)| p - exact(*y)));
    let plot = Plot::new("hydrostatic", "Hydrostatic columns", "y [m]", "p [Pa]")
        .showing(Series::line(
            "ρf",
            rows.iter().map(|row| (row.0, exact(row.0) + lift)),
        ))
        .showing(Series::dots(
            "measured",
            rows.iter().map(|row| (row.0, row.1)),
        ));
    Outcome::rows([Row::new(
        "hydrostatic",
        "hydrostatic columns, |dp/dy| / ρf",
        Expected::Value {
            value: 1.0,
            tolerance: 0.03,
        },
        slope / (density * FORCE),
    )
    .noting(format!("least pressure {least:.1} Pa"))])
    .with(plot)
}
