//! The height of the flame over its power.

use crate::validation::boxes::{combustion, on_floor, open};
use crate::validation::measure::fit;
use crate::validation::plot::{Plot, Series};
use crate::validation::record::watch;
use crate::validation::{Expected, Outcome, Row};

/// Flame height over power, L50 = 0.035 Q'^⅔ for a line fire. Fires of similar shape, source
/// and spacing, relative to their characteristic length, have similar flames; at one spacing,
/// the weaker fire is the coarser one, and has at least eight particles across that length.
pub(super) fn flame_height() -> Outcome {
    /// Height and characteristic length over spacing of a flame of `power` [kW/m], with that
    /// spacing \[m\].
    fn flame(power: f64, spacing: impl Fn(f64) -> f64) -> Flame {
        let length = characteristic_length(power);
        let time = (length / f64::from(combustion([]).world().gravity)).sqrt();
        let spacing = spacing(length);
        let parameters = on_floor(open(
            (4.0 * length, 6.5 * length + BASE),
            spacing,
            [
                ("fuel_power", power),
                ("source_width", 0.6 * length),
                ("source_height", BASE),
            ],
        ));
        Flame {
            power,
            height: watch(parameters, 12.0 * time, 48.0 * time).height(0.5),
            cells: length / spacing,
        }
    }
    const BASE: f64 = 0.25;
    const PREFACTOR: f64 = 0.035;
    let fine = [50.0, 110.0, 250.0, 600.0].map(|power| flame(power, |length| 0.1 * length));
    let fixed = [50.0, 80.0, 130.0, 210.0].map(|power| flame(power, |_| 0.0145));
    let point = |flame: &Flame| (flame.power, flame.height);
    let prefactor = |flame: &Flame| flame.height / flame.power.powf(2.0 / 3.0);
    let list = |flames: &[Flame], value: fn(&Flame) -> f64, digits: usize| {
        let values = flames
            .iter()
            .map(|flame| format!("{:.digits$}", value(flame)));
        values.collect::<Vec<_>>().join(", ")
    };
    let plot = Plot::new(
        "flame-height",
        "Flame height over power",
        "Q' [kW/m]",
        "L50 [m]",
    )
    .showing(Series::line(
        "0.035 Q'^⅔",
        (8..=120)
            .map(|i| 5.0 * f64::from(i))
            .map(|q| (q, PREFACTOR * q.powf(2.0 / 3.0))),
    ))
    .showing(Series::dots(
        "ten particles across D*",
        fine.iter().map(point),
    ))
    .showing(Series::line("", []))
    .showing(Series::dots("at 14.5 mm", fixed.iter().map(point)));
    let exponent = Expected::Value {
        value: 2.0 / 3.0,
        tolerance: 0.15,
    };
    Outcome::rows([
        Row::new(
            "flame-height",
            "flame height L50 ∝ Q'ⁿ with ten particles across D*, 50 to 600 kW/m, n",
            exponent,
            fit::exponent(fine.iter().map(point)),
        ),
        Row::new(
            "flame-height-prefactor",
            "flame height L50 / Q'^⅔ with ten particles across D*, mean",
            Expected::Share {
                value: PREFACTOR,
                tolerance: 0.3,
            },
            fit::mean(fine.iter().map(prefactor)),
        )
        .noting(list(&fine, prefactor, 3)),
        Row::new(
            "flame-height-fixed",
            "flame height L50 ∝ Q'ⁿ at a spacing of 14.5 mm, 50 to 210 kW/m, n",
            exponent,
            fit::exponent(fixed.iter().map(point)),
        )
        .noting(format!(
            "prefactors {} with {} particles across D*",
            list(&fixed, prefactor, 3),
            list(&fixed, |flame| flame.cells, 1)
        )),
    ])
    .with(plot)
}

/// A flame of the height L50.
struct Flame {
    /// [kW/m]
    power: f64,
    /// \[m\]
    height: f64,
    /// Particles across the characteristic length.
    cells: f64,
}

/// The characteristic length D* = (Q'/(ρ cp T √g))^⅔ of a line fire \[m\].
fn characteristic_length(power: f64) -> f64 {
    let scene = combustion([]);
    let p = scene.world();
    let heat = f64::from(p.ambient_density) * f64::from(p.ambient_temperature);
    (power / (heat * f64::from(p.gravity).sqrt())).powf(2.0 / 3.0)
}
