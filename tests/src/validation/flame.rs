//! The flame: its power, its puffing, its height and shape.

mod height;

use hearth_core::{Scene, Simulation};

use super::boxes::{combustion, on_floor, open};
use super::measure::{fit, signal};
use super::plot::{Plot, Series};
use super::record::{Record, SEEDS, delivered, mean_spectrum, watch};
use super::{Case, Expected, Outcome, Pace, Row};
use crate::fires::source;

pub(super) const CASES: &[Case] = &[
    Case {
        name: "burner-power",
        pace: Pace::Quick,
        run: || burner_power(&[(1000, 5.0), (3000, 4.0)]),
    },
    Case {
        name: "burner-power-fine",
        pace: Pace::Long(120),
        run: || burner_power(&[(12_000, 3.0), (50_000, 1.5)]),
    },
    Case {
        name: "outer-sheet",
        pace: Pace::Quick,
        run: outer_sheet,
    },
    Case {
        name: "default-flame",
        pace: Pace::Long(90),
        run: default_flame,
    },
    Case {
        name: "flame-resolution",
        pace: Pace::Long(100),
        run: flame_resolution,
    },
    Case {
        name: "puffing-0.2",
        pace: Pace::Long(80),
        run: || puffing(0.2),
    },
    Case {
        name: "puffing-0.4",
        pace: Pace::Long(60),
        run: || puffing(0.4),
    },
    Case {
        name: "puffing-0.8",
        pace: Pace::Long(50),
        run: || puffing(0.8),
    },
    Case {
        name: "flame-height",
        pace: Pace::Long(90),
        run: height::flame_height,
    },
];

fn burner_power(sizes: &[(u32, f64)]) -> Outcome {
    Outcome::rows(sizes.iter().map(|&(n, seconds)| {
        let scene = combustion([("particles", f64::from(n))]);
        let nominal = f64::from(scene.power());
        let mut fire = Simulation::new(scene);
        delivered(&mut fire, 0.5);
        let expected = Expected::Share {
            value: nominal,
            tolerance: 0.02,
        };
        let measured = delivered(&mut fire, seconds);
        Row::new(
            format!("burner-power-{n}"),
            format!("burner power, {n} particles"),
            expected,
            measured,
        )
        .in_unit("kW/m")
    }))
}

/// A gas flame that gets all of its air from outside burns at its rim: somewhere
/// below half its height it is hottest there, on both sides.
fn outer_sheet() -> Outcome {
    // Without premixed air the flame is taller than the default frame.
    let record = watch(open((1.2, 3.0), 0.03, [("source_oxygen", 0.0)]), 1.5, 8.0);
    let source = f64::from(source(record.fire.scene()).width);
    let half = 0.5 * record.height(0.5);
    let rows = record.sampler.row(record.base + 0.1 * half)..record.sampler.row(record.base + half);
    // How much hotter the cooler rim is than the axis, in each row.
    let excess = |row: usize| {
        let profile = record.across(&record.temperature, row);
        let hottest = |wanted: &dyn Fn(f64) -> bool| {
            let side = profile.iter().filter(|(x, _)| wanted(*x));
            side.map(|(_, t)| *t).fold(f64::NAN, f64::max)
        };
        let axis = hottest(&|x| x.abs() < 0.05 * source);
        let rims = [
            hottest(&|x| x < -0.1 * source),
            hottest(&|x| x > 0.1 * source),
        ];
        rims[0].min(rims[1]) - axis
    };
    let clearest = rows
        .max_by(|&a, &b| excess(a).total_cmp(&excess(b)))
        .unwrap_or(0);
    let height = record.sampler.y(clearest) - record.base;
    let plot = Plot::new(
        "outer-sheet",
        "Mean temperature across a flame without premixed air",
        "x [m]",
        "T [K]",
    )
    .showing(Series::dots(
        &format!("{height:.2} m above the burner"),
        record.across(&record.temperature, clearest),
    ));
    Outcome::rows([Row::new(
        "outer-sheet",
        "flame without premixed air: cooler rim − axis, where it is most, below half the height",
        Expected::AtLeast(1.0),
        excess(clearest),
    )
    .in_unit("K")
    .noting(format!(
        "{:.2} of L50 above the burner",
        0.5 * height / half
    ))])
    .with(plot)
}

/// Frequency \[Hz\] at which a slot burner puffs: St = 0.55 Ri^0.45 with
/// St = fD/v₀, Ri = (1 − ρ/ρ₀) g D / v₀² (Cetegen, Dong and Soteriou, Phys.
/// Fluids 10, 1998, planar plumes), ρ being the density of the gas that rises.
fn planar_frequency(scene: &Scene) -> f64 {
    let (p, source) = (scene.world(), source(scene));
    let [width, speed] = [source.width, source.speed].map(f64::from);
    let deficit = 1.0 - f64::from(p.ambient_temperature) / FLAME_TEMPERATURE;
    let richardson = deficit * f64::from(p.gravity) * width / (speed * speed);
    0.55 * richardson.powf(0.45) * speed / width
}

/// Temperature of the gas that rises \[K\]: 800 K above the air, as in the
/// continuous flame of real fires (McCaffrey 1979).
const FLAME_TEMPERATURE: f64 = 1093.0;

/// Seconds that are watched where a spectrum is wanted.
const SPECTRUM_SECONDS: f64 = 60.0;

/// The same of each of several records of puffing.
const PUFFING_SECONDS: f64 = 40.0;

/// Time after which the first plume has risen through the domain \[s\].
const SETTLED: f64 = 6.0;

/// A burner of this width \[m\] in a frame of open air that scales with it, at a power that
/// keeps the flame's height over its width. Air is drawn in at half a width above it.
fn puffing(width: f64) -> Outcome {
    let scale = width / 0.4;
    let record = |seed| {
        watch(
            on_floor(open(
                // Tall enough that no flame reaches the end of the air.
                (3.0 * width, 6.0 * width),
                0.067 * width,
                [
                    ("seed", seed),
                    ("source_width", width),
                    ("source_height", 0.25 * scale),
                    ("fuel_power", (220.0 * scale.powf(1.5)).min(600.0)),
                    ("stiffness", 6.0 * scale.sqrt().min(1.0)),
                ],
            )),
            SETTLED,
            PUFFING_SECONDS,
        )
    };
    let records = SEEDS.map(record);
    let expected = planar_frequency(records[0].fire.scene());
    let mean = |of: &dyn Fn(&Record) -> Vec<(f64, f64)>| mean_spectrum(&records.each_ref().map(of));
    let spectrum = mean(&|record| record.breath_spectrum(0.5 * width));
    let light = mean(&|record| record.light_spectrum(width));
    let lowest = 0.25 * expected;
    let measured = signal::peak(&spectrum, lowest);
    let plain = signal::peak(&signal::plain(&spectrum), lowest);
    let allowed = Expected::Share {
        value: expected,
        tolerance: 0.3,
    };
    let id = format!("puffing-{width}");
    let plot = Plot::new(
        &id,
        &format!("Puffing of a slot flame, D = {width} m"),
        "f [Hz]",
        "f × power / greatest",
    )
    .showing(Series::line("St = 0.55 Ri^0.45", mark(expected)))
    .showing(Series::dots("air drawn in", scaled(&spectrum)))
    .showing(Series::line("", []))
    .showing(Series::dots("light", scaled(&light)));
    Outcome::rows([
        Row::new(
            id.clone(),
            format!("puffing of a slot flame, D = {width} m"),
            allowed,
            measured,
        )
        .in_unit("Hz")
        .noting(format!(
            "plain spectrum: {plain:.2} Hz; its light: {:.2} Hz",
            signal::peak(&light, lowest)
        )),
        Row::new(
            format!("{id}-plain"),
            format!("puffing of a slot flame by the plain spectrum, D = {width} m"),
            allowed,
            plain,
        )
        .in_unit("Hz"),
    ])
    .with(plot)
}

/// A line up at x.
fn mark(x: f64) -> [(f64, f64); 2] {
    [(x, 0.0), (x, 1.0)]
}

/// A spectrum with its greatest power as one.
fn scaled(spectrum: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let most = spectrum.iter().map(|p| p.1).fold(0.0, f64::max);
    spectrum.iter().map(|(f, p)| (*f, p / most)).collect()
}

/// The page's default fire by the figures of realism that need no pixels.
fn default_flame() -> Outcome {
    // The tips of the flame leave the default frame now and then.
    let spacing = f64::from(combustion([]).world().spacing());
    let tall = |seed| combustion([("seed", seed), ("domain_height", 2.6), ("spacing", spacing)]);
    // Which way the flame of one seed leans is chance.
    let record = Record::joined(SEEDS.map(|seed| watch(tall(seed), SETTLED, SPECTRUM_SECONDS)));
    let expected = planar_frequency(record.fire.scene());
    // Higher up, a flame of this length sways, and two puffs shine at a time.
    let spectrum = record.light_spectrum(f64::from(source(record.fire.scene()).width));
    let whole = record.light_spectrum(f64::INFINITY);
    let [tall, half, short] = [0.05, 0.5, 0.95].map(|share| record.height(share));
    let source = f64::from(source(record.fire.scene()).width);
    let width = |part: f64| record.widths[record.sampler.row(record.base + part * half)];
    let (rise, rows) = rises(&record, tall);
    let heights: Vec<_> = rows
        .iter()
        .map(|&row| {
            (
                record.sampler.y(row) - record.base,
                record.intermittency[row],
            )
        })
        .collect();
    let widths = rows.iter().map(|&row| {
        (
            record.sampler.y(row) - record.base,
            record.widths[row] / source,
        )
    });
    let shape = Plot::new(
        "flame",
        "The default flame over its height",
        "height above the burner [m]",
        "share",
    )
    .showing(Series::line("", []))
    .showing(Series::dots(
        "time with luminous gas",
        heights.iter().copied(),
    ))
    .showing(Series::line("", []))
    .showing(Series::dots("mean width / source", widths));
    let light = Plot::new(
        "flame-light",
        "Light of the default flame's lower part",
        "f [Hz]",
        "f × power / greatest",
    )
    .showing(Series::line("St = 0.55 Ri^0.45", mark(expected)))
    .showing(Series::dots("measured", scaled(&spectrum)));
    let decreasing = [0.25, 0.5, 0.75, 1.0].map(width);
    Outcome::rows([
        Row::new(
            "light-frequency",
            "default flame: peak of its light's spectrum, up to D above the burner",
            Expected::Share {
                value: expected,
                tolerance: 0.3,
            },
            signal::peak(&spectrum, 0.25 * expected),
        )
        .in_unit("Hz")
        .noting(format!(
            "plain spectrum: {:.2} Hz; the whole flame: {:.2} Hz",
            signal::peak(&signal::plain(&spectrum), 0.25 * expected),
            signal::peak(&whole, 0.25 * expected)
        )),
        Row::new(
            "intermittency",
            "default flame: rise of intermittency with height, summed",
            Expected::AtMost(0.05),
            rise,
        ),
        Row::new(
            "intermittency-span",
            "default flame: L05 / L95",
            Expected::Between(1.5, 5.0),
            tall / short,
        )
        .noting(format!(
            "L95 {short:.2}, L50 {half:.2}, L05 {tall:.2} m above the burner"
        )),
        Row::new(
            "tip-variation",
            "default flame: tip height, coefficient of variation",
            Expected::Between(0.1, 0.3),
            fit::variation(&record.tips),
        ),
        Row::new(
            "taper",
            "default flame: width at half height / source width",
            Expected::AtMost(0.5),
            width(0.5) / source,
        ),
        Row::new(
            "taper-upward",
            "default flame: greatest widening upward from L50/4 to L50",
            Expected::AtMost(0.0),
            decreasing
                .windows(2)
                .map(|pair| (pair[1] - pair[0]) / source)
                .fold(f64::NEG_INFINITY, f64::max),
        )
        .noting(format!(
            "{} of the source at L50/4, /2, 3/4 and 1",
            decreasing.map(|w| format!("{:.2}", w / source)).join(", ")
        )),
        Row::new(
            "asymmetry",
            "default flame: difference of mean luminous areas left and right / sum",
            Expected::AtMost(0.1),
            asymmetry(&record),
        ),
    ])
    .with(light)
    .with(shape)
}

/// How much the intermittency rises in all, going up from where it is
/// greatest to `top` \[m\], and the rows between.
fn rises(record: &Record, top: f64) -> (f64, Vec<usize>) {
    let rows: Vec<_> = (record.steadiest()..=record.sampler.row(record.base + 1.3 * top)).collect();
    let rise = rows
        .windows(2)
        .map(|pair| (record.intermittency[pair[1]] - record.intermittency[pair[0]]).max(0.0))
        .sum();
    (rise, rows)
}

fn asymmetry(record: &Record) -> f64 {
    let (mut left, mut right) = (0.0, 0.0);
    for row in 0..record.sampler.rows {
        for (x, share) in record.across(&record.luminous, row) {
            // A cell on the middle has a part on each side.
            let part = (0.5 + x / record.sampler.cell).clamp(0.0, 1.0);
            left += share * (1.0 - part);
            right += share * part;
        }
    }
    (left - right).abs() / (left + right)
}

/// Four times the particles, the same flame, in a frame in which it ends.
fn flame_resolution() -> Outcome {
    const HEIGHT: f64 = 2.6;
    let heights = [(3000.0, 20.0), (12_000.0, 12.0)].map(|(n, seconds)| {
        let scene = combustion([("particles", n)]);
        let world = scene.world();
        let frame = (f64::from(world.domain_width), HEIGHT);
        let scene = open(frame, f64::from(world.spacing()), []);
        let record = watch(scene, 2.0, seconds);
        (fit::mean(record.tips.iter().copied()), record.height(0.5))
    });
    let [(coarse, coarse_half), (fine, fine_half)] = heights;
    Outcome::rows([Row::new(
        "flame-resolution",
        "mean flame height, 12,000 particles / 3,000",
        Expected::Value {
            value: 1.0,
            tolerance: 0.15,
        },
        fine / coarse,
    )
    .noting(format!(
        "{coarse:.2} and {fine:.2} m, L50 {coarse_half:.2} and {fine_half:.2} m"
    ))])
}
