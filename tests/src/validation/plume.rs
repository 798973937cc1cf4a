//! The plume far above a small flame: velocity, temperature, entrainment.

use super::boxes::{on_floor, open};
use super::measure::fit;
use super::plot::{Plot, Series};
use super::record::{Record, SEEDS, watch};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[Case {
    name: "plume",
    pace: Pace::Long(300),
    run: plume,
}];

/// A line plume of constant buoyancy flux B = gQ'/(ρ cp T): no radiation. Its
/// velocity on the axis does not change with height, its excess temperature
/// falls as 1/z, and the air that it takes in widens it.
///
/// A bell of the velocity U e^(−(x/b)²) carries q = √π U b, and dq/dz = 2αU
/// defines the entrainment coefficient α (Kotsovinos and List 1977). With a
/// constant U, db/dz = 2α/√π.
fn plume() -> Outcome {
    const POWER: f64 = 30.0;
    let parameters = |seed| {
        on_floor(open(
            (3.0, 5.0),
            0.04,
            [
                ("seed", seed),
                ("fuel_power", POWER),
                ("source_width", 0.1),
                ("source_height", 0.25),
                ("radiative_cooling", 0.0),
            ],
        ))
    };
    let scene = parameters(SEEDS[0]);
    let p = scene.world();
    let ambient = f64::from(p.ambient_temperature);
    let record = Record::joined(SEEDS.map(|seed| watch(parameters(seed), 5.0, 65.0)));
    let sampler = &record.sampler;
    // Below 2 m, the plume becomes turbulent: its thermal width overtakes that of its
    // velocity, and both grow faster than further up, where their ratio is constant.
    let from = sampler.row(record.base + 2.0);
    let to = sampler.row(record.base + 4.0);
    let rows: Vec<_> = (from..to).collect();
    let height = |row: usize| sampler.y(row) - record.base;
    let heat = fit::mean(rows.iter().map(|&row| record.over(&record.heat_flux, row)));
    let flux = f64::from(p.gravity) * heat / (f64::from(p.ambient_density) * ambient);
    let bells: Vec<_> = rows
        .iter()
        .map(|&row| {
            let profile = record.across(&record.rise, row);
            let excess: Vec<_> = record
                .across(&record.temperature, row)
                .into_iter()
                .map(|(x, t)| (x, t - ambient))
                .collect();
            (height(row), fit::bell(&profile), fit::bell(&excess))
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
    // The plume seems to come from where the width of its velocity vanishes. That of its
    // temperature has no information: the flux of heat is constant, so it grows as the
    // excess temperature falls.
    let spread = fit::line(bells.iter().map(|bell| (bell.0, bell.1.width)));
    let origin = -spread.intercept / spread.slope;
    let exponent =
        |from: f64| fit::exponent(bells.iter().map(|bell| (bell.0 - from, bell.2.height)));
    let cooling = exponent(origin);
    // All air that comes in rises with the plume.
    let fluxes = rows.iter().map(|&row| record.over(&record.rise, row));
    let growth = fit::line(bells.iter().map(|bell| bell.0).zip(fluxes));
    let inflow = 0.5 * growth.slope / speed;
    // The velocity's half width b grows by 2α/√π with the height.
    let spreading = 0.5 * std::f64::consts::PI.sqrt() * spread.slope;
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
            Expected::Between(1.66, 2.1),
            speed / law,
        )
        .noting(format!(
            "B from the measured flux of heat, {heat:.1} kW/m; Kotsovinos and List 1977"
        )),
        Row::new(
            "plume-temperature",
            "line plume: exponent of the excess temperature over the height above its virtual origin",
            Expected::Value {
                value: -1.0,
                tolerance: 0.3,
            },
            cooling,
        )
        .noting(format!(
            "origin {origin:.2} m above the burner; {:.2} from the burner itself",
            exponent(0.0)
        )),
        Row::new(
            "entrainment",
            "line plume: entrainment α, growth of the volume flux / twice the velocity on the axis",
            Expected::Share {
                value: 0.11,
                tolerance: 0.3,
            },
            inflow,
        )
        .noting("Kotsovinos and List 1977"),
        Row::new(
            "entrainment-spread",
            "line plume: entrainment α, by the spreading of the velocity",
            Expected::Share {
                value: 0.11,
                tolerance: 0.3,
            },
            spreading,
        ),
        Row::new(
            "entrainment-agreement",
            "line plume: entrainment by volume flux / by spreading",
            Expected::Share {
                value: 1.0,
                tolerance: 0.3,
            },
            inflow / spreading,
        ),
    ])
    .with(plot)
}
