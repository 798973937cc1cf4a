//! The plume far above a small flame: velocity, temperature, entrainment.

use hearth_core::Simulation;

use super::boxes::combustion;
use super::measure::fit;
use super::plot::{Plot, Series};
use super::record::{Record, SEEDS, watch};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[Case {
    name: "plume",
    pace: Pace::Long(120),
    run: plume,
}];

/// The power that makes the gas of the source as hot as it is, over three
/// seconds \[kW/m\].
fn preheat(fire: &mut Simulation) -> f64 {
    let (mut heat, start) = (0.0, fire.time());
    while fire.time() < start + 3.0 {
        fire.step();
        let report = fire.report();
        heat += f64::from(report.preheat) * f64::from(report.length);
    }
    heat / (fire.time() - start)
}

/// A line plume of constant buoyancy flux B = gQ'/(ρ cp T): no radiation. Its
/// velocity on the axis does not change with height, its excess temperature
/// falls as 1/z, and the air that it takes in widens it.
fn plume() -> Outcome {
    const POWER: f64 = 30.0;
    let parameters = |seed| {
        combustion([
            ("seed", seed),
            ("fuel_power", POWER),
            ("source_width", 0.1),
            ("source_height", 0.25),
            ("domain_width", 2.0),
            ("domain_height", 3.0),
            ("max_particles", 6000.0),
            ("radiative_cooling", 0.0),
        ])
    };
    let p = &parameters(SEEDS[0]);
    let ambient = f64::from(p.ambient_temperature);
    let mut record = Record::joined(SEEDS.map(|seed| watch(parameters(seed), 5.0, 30.0)));
    // The gas of the source is hot already; that lifts too.
    let heat = POWER + preheat(&mut record.fire);
    let flux = f64::from(p.gravity) * heat / (f64::from(p.ambient_density) * ambient);
    let sampler = &record.sampler;
    // Well above the flame, and well below the seam, which swallows the plume.
    let from = sampler.row(record.base + 0.8);
    let to = sampler.row(record.base + 1.5);
    let rows: Vec<_> = (from..to).collect();
    let height = |row: usize| sampler.y(row) - record.base;
    // The domain is closed upon itself, so the air around the plume moves a
    // little as a whole; the plume's velocity is that through this air.
    let bells: Vec<_> = rows
        .iter()
        .map(|&row| {
            let profile = record.across(&record.rise, row);
            let air = profile.iter().map(|p| p.1).fold(f64::INFINITY, f64::min);
            let through_air: Vec<_> = profile.iter().map(|(x, v)| (*x, v - air)).collect();
            let excess: Vec<_> = record
                .across(&record.temperature, row)
                .into_iter()
                .map(|(x, t)| (x, t - ambient))
                .collect();
            (height(row), fit::bell(&through_air), fit::bell(&excess))
        })
        .collect();
    let speed = fit::mean(bells.iter().map(|bell| bell.1.height));
    let law = flux.cbrt();
    let trend = fit::line(bells.iter().map(|bell| (bell.0, bell.1.height)));
    let unevenness = bells
        .iter()
        .map(|bell| (trend.intercept + trend.slope * bell.0) / speed - 1.0)
        .map(f64::abs)
        .fold(0.0, f64::max);
    // The plume seems to come from where its thermal width vanishes.
    let widening = fit::line(bells.iter().map(|bell| (bell.0, bell.2.width)));
    let origin = -widening.intercept / widening.slope;
    let exponent =
        |from: f64| fit::exponent(bells.iter().map(|bell| (bell.0 - from, bell.2.height)));
    let cooling = exponent(origin);
    // Air comes in over both edges of the plume, where its velocity is over,
    // at the speed αU.
    let inflow = fit::mean(rows.iter().zip(&bells).map(|(&row, (_, bell, _))| {
        let drift = |x: f64| record.drift[row * sampler.columns + sampler.column(x)];
        let edge = 2.0 * bell.width;
        0.5 * (drift(bell.middle - edge) - drift(bell.middle + edge)) / bell.height
    }));
    let ends = [bells.first(), bells.last()].into_iter().flatten();
    let plot = Plot::new(
        "plume",
        "A line plume",
        "height above the burner [m]",
        "U / B^⅓, ΔT / 100 K, b [m]",
    )
    .showing(Series::line("1.73 B^⅓", ends.map(|bell| (bell.0, 1.73))))
    .showing(Series::dots(
        "velocity",
        bells.iter().map(|b| (b.0, b.1.height / law)),
    ))
    .showing(Series::line("", []))
    .showing(Series::dots(
        "excess temperature",
        bells.iter().map(|b| (b.0, b.2.height / 100.0)),
    ))
    .showing(Series::line("", []))
    .showing(Series::dots(
        "half width",
        bells.iter().map(|b| (b.0, b.1.width)),
    ));
    Outcome::rows([
        Row::new(
            "plume-constant",
            "line plume: trend of the velocity on the axis, end to middle",
            Expected::AtMost(0.1),
            unevenness,
        ),
        Row::new(
            "plume-velocity",
            "line plume: velocity on the axis / B^⅓",
            // From 20 % below 1.66 to 20 % above 1.8.
            Expected::Between(1.66 * 0.8, 1.8 * 1.2),
            speed / law,
        )
        .noting("1.66 to 1.8, each ± 20 %"),
        Row::new(
            "plume-temperature",
            "line plume: exponent of the excess temperature over the height above its virtual origin",
            Expected::Value {
                value: -1.0,
                tolerance: 0.4,
            },
            cooling,
        )
        .noting(format!(
            "origin {origin:.2} m above the burner; {:.2} from the burner itself",
            exponent(0.0)
        )),
        Row::new(
            "entrainment",
            "line plume: entrainment α, inflow over its edges / velocity on the axis",
            Expected::Share {
                value: 0.11,
                tolerance: 0.3,
            },
            inflow,
        )
        .noting("Richardson and Hunt 2022"),
    ])
    .with(plot)
}
