//! The cards of `docs/learn.md`: from one end of its slider to the other, the number of a card moves as
//! the card says, by at least three times its own scatter.

use std::collections::BTreeMap;

use hearth_core::params::Input;
use hearth_core::preset::Preset;
use hearth_core::{Simulation, Vec2};
use serde_json::Value;

/// What a card shows is a mean over so long; between two means of a test, a fire burns as long \[s\].
const MEAN: f64 = 4.0;
/// The fire that a page shows first is burning already \[s\].
const WARM: f64 = 3.0;
const SEEDS: u32 = 2;
const MEANS: u32 = 2;

/// Measurements in a second, fewer than those of a page.
const PER_SECOND: f64 = 12.0;

/// The cards, by the headings above them.
fn cards() -> BTreeMap<&'static str, Value> {
    let text = include_str!("../../docs/learn.md");
    let sections = text.split("\n## ").skip(1);
    let cards = sections.filter_map(|section| {
        let (heading, rest) = section.split_once('\n')?;
        let (_, rest) = rest.split_once("```json card\n")?;
        let (json, _) = rest.split_once("```")?;
        Some((heading, serde_json::from_str(json).ok()?))
    });
    cards.collect()
}

/// Its number at a moment.
fn number(fire: &Simulation, card: &Value) -> Option<f64> {
    let at = |name: &str| card[name].as_f64().unwrap_or_default() as f32;
    let all = fire.measure(Vec2::new(at("x"), at("y")));
    // Numbers of the fire, then of the place.
    let names = [
        "power",
        "flameHeight",
        "luminosity",
        "temperature",
        "u",
        "v",
        "density",
        "fuel",
        "oxygen",
    ];
    let name = card["number"].as_str()?;
    let index = names.into_iter().position(|it| it == name)?;
    all.get(3 + index).copied().map(f64::from)
}

/// Means of the number of a fire whose slider has the value of that end.
fn means(card: &Value, end: &str) -> Option<Vec<f64>> {
    let mut means = Vec::new();
    for seed in 1..=SEEDS {
        let mut scene = Preset::find(card["scene"].as_str()?).ok()?.scene();
        let slider = (card["slider"].as_str()?, &card[end]);
        let values = card["values"].as_object().into_iter().flatten();
        for (id, value) in values.map(|(id, value)| (&**id, value)).chain([slider]) {
            scene.set(id, Input::Number(value.as_f64()?)).ok()?;
        }
        scene.set("seed", Input::Number(seed.into())).ok()?;
        let mut fire = Simulation::new(scene);
        fire.advance(WARM);
        for _ in 0..MEANS {
            let count = (MEAN * PER_SECOND) as usize;
            let numbers = (0..count).map(|_| {
                fire.advance(1.0 / PER_SECOND);
                number(&fire, card)
            });
            let (mean, scatter) = mean_and_scatter(&numbers.collect::<Option<Vec<_>>>()?);
            let spread = card["spread"].as_bool().unwrap_or_default();
            means.push(if spread { scatter } else { mean });
        }
    }
    Some(means)
}

/// The mean and the standard deviation.
fn mean_and_scatter(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (mean, (squares / (count - 1.0)).sqrt())
}

/// What the teachers' sheet says of both fires of a card, in the units of `measure`.
fn answers(heading: &str, card: &Value) -> Option<[f64; 2]> {
    let sheet = include_str!("../../docs/lesson-sheet.md");
    let start = format!("| [{heading}]");
    let row = sheet.lines().find(|row| row.starts_with(&start))?;
    let said = |cell: &str| {
        let value: f64 = cell.trim().split(' ').next()?.parse().ok()?;
        Some(match card["number"].as_str()? {
            "temperature" => value + 273.15,
            "oxygen" => value / 21.0,
            "flameHeight" => value / 100.0,
            _ => value,
        })
    };
    let mut cells = row.split('|').skip(4);
    Some([said(cells.next()?)?, said(cells.next()?)?])
}

/// `None` for a card that states something else than a page understands.
fn moves(heading: &str) -> Option<()> {
    let card = cards().remove(heading)?;
    let (from, to) = (means(&card, "from")?, means(&card, "to")?);
    let ((first, one), (last, other)) = (mean_and_scatter(&from), mean_and_scatter(&to));
    let grows = card["grows"].as_bool()?;
    let moved = if grows { last - first } else { first - last };
    assert!(moved > 3.0 * one.max(other), "{from:?} to {to:?}");
    for (said, measured) in answers(heading, &card)?.into_iter().zip([first, last]) {
        assert!(
            (said - measured).abs() < 0.15 * moved,
            "{said} is {measured}"
        );
    }
    Some(())
}

/// The unit of the light in the plots of the page.
#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn the_scene_candle_shines_as_one_candle() {
    let script = include_str!("../../web/plots/units.js");
    let (_, rest) = script.split_once("CANDLE = ").unwrap();
    let candle: f64 = rest.split_once(';').unwrap().0.parse().unwrap();
    let mut fire = Simulation::new(Preset::find("candle").unwrap().scene());
    fire.advance(WARM);
    let mut sum = 0.0;
    for _ in 0..20 {
        fire.advance(0.1);
        sum += f64::from(fire.measure(Vec2::ZERO)[5]);
    }
    let light = sum / 20.0 / candle;
    assert!((light - 1.0).abs() < 0.1, "{light} candles");
}

/// A test of each card.
macro_rules! tests {
    ($($name:ident: $heading:literal,)*) => {
        $(
            #[test]
            #[ignore = "burns for minutes: `cargo xtask test burns`"]
            fn $name() {
                assert_eq!(moves($heading), Some(()));
            }
        )*

        #[test]
        fn every_card_has_a_test() {
            let mut tested = [$($heading),*];
            tested.sort_unstable();
            assert!(cards().into_keys().eq(tested));
        }
    };
}

tests! {
    buoyancy_raises_the_gas_faster: "Buoyancy",
    gravity_brings_the_flame_its_air: "Gravity",
    viscosity_calms_the_flame: "Viscosity",
    more_fuel_makes_a_higher_flame: "Fuel and air",
    radiated_heat_cools_the_flame: "Heat loss",
    wind_carries_the_heat_aside: "Wind",
}
