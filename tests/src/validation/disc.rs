//! The wake of a disc.

use hearth_core::{Simulation, Vec2};

use super::boxes::{GasBox, run};
use super::measure::field::Sampler;
use super::measure::{fit, signal};
use super::plot::{Plot, Series};
use super::solids::{Body, around};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[Case {
    name: "cylinder",
    pace: Pace::Long(400),
    run: cylinder,
}];

/// A disc in a stream, Re 100: vortices leave it in turn.
fn cylinder() -> Outcome {
    const ACROSS: u32 = 16;
    const DIAMETER: f64 = 0.2;
    const SPEED: f64 = 0.4;
    /// Length of the domain, its height, and the place of the disc in it, in diameters.
    const LENGTH: u32 = 16;
    const HEIGHT: u32 = 10;
    const PLACE: f64 = -3.0;
    let spacing = DIAMETER / f64::from(ACROSS);
    let gas_box = GasBox {
        columns: LENGTH * ACROSS,
        rows: HEIGHT * ACROSS,
        spacing,
    };
    let (x, y) = (PLACE * DIAMETER, 0.5 * gas_box.height());
    let disc = Body {
        x,
        y,
        width: DIAMETER,
        height: DIAMETER,
        round: true,
    };
    let values = [
        ("stiffness", 4.0),
        ("kinematic_viscosity", SPEED * DIAMETER / 100.0),
        ("smoothing_ratio", 1.5),
    ];
    let mut fire = around(&gas_box, &values, &[disc], SPEED);
    // The last 3 diameters turn the wake into the stream again.
    let (end, strip) = (0.5 * gas_box.width(), 3.0 * DIAMETER);
    let unit = DIAMETER / SPEED;
    let step = |fire: &mut Simulation| {
        let push = 0.3 * SPEED / unit * f64::exp(-(fire.time() / unit - 1.0).powi(2));
        fire.step_with(|position, velocity| {
            let depth = (f64::from(position.x) - (end - strip)) / strip;
            if depth > 0.0 {
                let rate = 4.0 / unit * (1.0 - (2.0 * depth - 1.0).abs());
                (Vec2::new(SPEED as f32, 0.0) - velocity) * rate as f32
            } else {
                // A gust at first, so that the vortices need not wait for rounding.
                Vec2::new(0.0, push as f32)
            }
        });
    };
    let sampler = Sampler::new(gas_box.width(), gas_box.height(), DIAMETER / 8.0, spacing);
    let cells = sampler.columns * sampler.rows;
    let mut means = vec![vec![0.0; cells]; 5];
    let (mut count, mut steps) = (0.0, 0_u32);
    let mut swing = Vec::new();
    let probe = Vec2::new((x + 1.5 * DIAMETER) as f32, y as f32);
    let came = run(&mut fire, 110.0 * unit, |fire| {
        step(fire);
        steps += 1;
        if fire.time() < 50.0 * unit || steps % 16 != 0 {
            return;
        }
        let gas: Vec<_> = fire
            .positions()
            .into_iter()
            .zip(fire.velocities())
            .zip(fire.pressures())
            .collect();
        let near = gas
            .iter()
            .filter(|((at, _), _)| at.distance(probe) < 2.0 * spacing as f32);
        swing.push((
            fire.time() / unit,
            fit::mean(near.map(|((_, v), _)| f64::from(v.y))),
        ));
        if steps % 64 == 0 {
            count += 1.0;
            let volume = (spacing * spacing) as f32;
            let values = gas
                .iter()
                .map(|((at, v), p)| (*at, volume, [v.x, v.x * v.x, v.x * v.y, *p, v.y]));
            for (mean, field) in means.iter_mut().zip(sampler.sample::<5>(values)) {
                for (mean, value) in mean.iter_mut().zip(field) {
                    *mean += value;
                }
            }
        }
    });
    for mean in means.iter_mut().flatten() {
        *mean /= count;
    }
    // The momentum that a rectangle around the disc loses.
    let density = f64::from(fire.parameters().ambient_density);
    let viscosity = SPEED * DIAMETER / 100.0;
    let (left, right) = (
        sampler.column(x - 1.5 * DIAMETER),
        sampler.column(x + 3.0 * DIAMETER),
    );
    let (low, high) = (
        sampler.row(y - 2.5 * DIAMETER),
        sampler.row(y + 2.5 * DIAMETER),
    );
    let at = |field: usize, column: usize, row: usize| means[field][row * sampler.columns + column];
    let slope = |field: usize, column: usize, row: usize, along: bool| {
        let (dc, dr) = if along { (1, 0) } else { (0, 1) };
        (at(field, column + dc, row + dr) - at(field, column - dc, row - dr)) / (2.0 * sampler.cell)
    };
    let through = |column: usize| -> f64 {
        (low..high)
            .map(|row| {
                let row_mean = |f: &dyn Fn(usize) -> f64| 0.5 * (f(row) + f(row + 1));
                row_mean(&|row| {
                    density * at(1, column, row) + at(3, column, row)
                        - 2.0 * density * viscosity * slope(0, column, row, true)
                })
            })
            .sum::<f64>()
            * sampler.cell
    };
    let over = |row: usize| -> f64 {
        (left..right)
            .map(|column| {
                let mean = |f: &dyn Fn(usize) -> f64| 0.5 * (f(column) + f(column + 1));
                mean(&|column| {
                    density * at(2, column, row)
                        - density
                            * viscosity
                            * (slope(0, column, row, false) + slope(4, column, row, true))
                })
            })
            .sum::<f64>()
            * sampler.cell
    };
    let force = through(left) - through(right) + over(low) - over(high);
    let stream = 0.5 * density * SPEED * SPEED * DIAMETER;
    let strouhal = signal::crossing_frequency(&swing);
    let plot = Plot::new(
        "cylinder",
        "Wake of a disc, Re 100",
        "t U/D",
        "velocity across / U",
    )
    .showing(Series::line("", swing.iter().map(|(t, v)| (*t, v / SPEED))));
    let known = |value, tolerance| Expected::Share { value, tolerance };
    let seen = |value: f64| if came { value } else { f64::NAN };
    Outcome::rows([
        Row::new(
            "cylinder-strouhal",
            "disc in a stream, Re 100: Strouhal number",
            known(0.165, 0.1),
            seen(strouhal),
        )
        .noting("16 particles across, blockage 1/10"),
        Row::new(
            "cylinder-drag",
            "disc in a stream, Re 100: drag coefficient",
            known(1.35, 0.15),
            seen(force / stream),
        )
        .noting("momentum that a rectangle around it loses"),
    ])
    .with(plot)
}
