//! Fires that are sprayed, and solids that are wet.

use hearth_core::params::Input;
use hearth_core::{BurningState, IgniteError, IgnitionTarget, Scene, Simulation, Vec2};
use hearth_tests::fires::{burn_on, combustion, in_the_open, on_floor};

use super::{ID, assert_balanced, log, open, spray, sprayed, with_solid};

/// Power of the flame, averaged over the next second [kW/m].
fn power(fire: &mut Simulation) -> f64 {
    let (start, mut sum) = (fire.time(), 0.0);
    while fire.time() < start + 1.0 {
        fire.step();
        sum += f64::from(fire.power().unwrap_or_default()) * fire.step_length();
    }
    sum / (fire.time() - start)
}

#[test]
fn water_that_strikes_wood_is_in_its_cells_and_its_heat_is_counted() {
    let mut fire = log(&[]);
    assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
    burn_on(&mut fire, 1.5);
    let before = fire.burning_solids()[0];
    let jet = [Vec2::new(0.0, 0.7), Vec2::new(0.0, -4.0)];
    spray(&mut fire, jet, (0.05, 1.0), assert_balanced);
    let after = fire.burning_solids()[0];
    let soaked = sprayed(&fire).soaked;
    assert!(soaked > 0.001, "{:?}", sprayed(&fire));
    let gained = after.water + after.steam - before.water - before.steam;
    assert!((gained / soaked - 1.0).abs() < 0.01, "{gained} of {soaked}");
    let heat = after.stored + after.lost;
    assert!(
        (heat - after.gained).abs() < 0.01 * after.gained,
        "{after:?}"
    );
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn wood_that_is_sprayed_enough_goes_out_and_stays_out_and_sprayed_little_burns_on() {
    let jet = [Vec2::new(0.0, 0.75), Vec2::new(0.0, -3.0)];
    // The last cells of a wet log cool for up to five seconds.
    let left = [(0.0, 3.0), (0.004, 3.0), (0.25, 6.0)].map(|(rate, after)| {
        let mut fire = log(&[]);
        assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
        burn_on(&mut fire, 2.0);
        assert_eq!(fire.burning_solids()[0].state, BurningState::Burning);
        spray(&mut fire, jet, (rate, 2.0), |_| ());
        burn_on(&mut fire, after);
        (
            fire.burning_solids()[0].state,
            fire.burning_solids()[0].fuel,
        )
    });
    let states = left.map(|(state, _)| state);
    let [burning, out] = [BurningState::Burning, BurningState::Out];
    assert_eq!(states, [burning, burning, out], "{left:?}");
    assert!(left.map(|(_, fuel)| fuel).is_sorted(), "{left:?}");
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn wet_wood_burns_later_than_dry() {
    let burns_after = |rate: f64| {
        let mut fire = log(&[("source_height", 0.05)]);
        let jet = [Vec2::new(0.0, 0.6), Vec2::new(0.0, -2.0)];
        spray(&mut fire, jet, (rate, 1.0), |_| ());
        burn_on(&mut fire, 0.5);
        // A flame below it: `ignite` would dry it.
        let mut scene = fire.scene().clone();
        for (name, value) in [("fuel_power", 200.0), ("source_width", 0.3)] {
            assert_eq!(scene.set(name, value), Ok(()));
        }
        fire.set_scene(scene);
        let start = fire.time();
        while fire.burning_solids()[0].gas < 0.01 && fire.time() < start + 20.0 {
            fire.step();
        }
        fire.time() - start
    };
    let [dry, wet] = [0.0, 0.3].map(burns_after);
    assert!(wet > 1.5 * dry, "dry after {dry} s, wet after {wet} s");
}

/// A source on a floor.
fn bed() -> Simulation {
    let values = [
        ("fuel_power", 150.0),
        ("source_height", 0.1),
        ("source_width", 0.3),
    ];
    let embers = [("ember_rate", 0.0)];
    let settings = combustion(&[&values[..], &embers].concat());
    Simulation::new(on_floor(in_the_open(settings, 3000)))
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn the_more_a_source_is_sprayed_the_less_it_burns_until_it_stays_out() {
    let jet = [Vec2::new(0.0, 0.5), Vec2::new(0.0, -3.0)];
    let mut flying = Vec::new();
    let powers = [0.0, 0.01, 0.15].map(|rate| {
        let mut fire = bed();
        burn_on(&mut fire, 1.5);
        spray(&mut fire, jet, (rate, 2.0), assert_balanced);
        let during = power(&mut fire);
        burn_on(&mut fire, 6.0);
        flying.push(sprayed(&fire));
        (during, power(&mut fire))
    });
    let [dry, little, enough] = powers;
    assert!(little.1 > 0.8 * dry.1, "{powers:?}, {flying:?}");
    assert!(enough.0 < 0.5 * dry.0, "{powers:?}, {flying:?}");
    assert!(enough.1 < 0.01 * dry.1, "{powers:?}, {flying:?}");
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn a_source_that_water_has_put_out_burns_again_once_it_is_lit() {
    let jet = [Vec2::new(0.0, 0.5), Vec2::new(0.0, -3.0)];
    let beside = IgnitionTarget::Place(Vec2::new(0.2, 0.12), 0.0);
    let far = IgnitionTarget::Place(Vec2::new(0.4, 0.12), 0.0);
    let mut fire = bed();
    burn_on(&mut fire, 1.5);
    let before = power(&mut fire);
    assert_eq!(fire.ignite(beside), Ok(()), "it burns already");
    spray(&mut fire, jet, (0.15, 2.0), assert_balanced);
    burn_on(&mut fire, 4.0);
    assert_eq!(fire.ignite(far), Err(IgniteError));
    assert!(power(&mut fire) < 0.01 * before);
    assert_eq!(fire.ignite(beside), Ok(()));
    assert_balanced(&fire);
    burn_on(&mut fire, 8.0);
    let after = power(&mut fire);
    assert!(after > 0.8 * before, "{before} kW/m, then {after}");
}

#[test]
fn a_log_that_is_lit_in_a_wet_source_lights_the_source() {
    let jet = [Vec2::new(0.0, 0.5), Vec2::new(0.0, -3.0)];
    for (fuel, target) in [("wood", false), ("none", false), ("wood", true)] {
        let texts = [("shape", "box"), ("fuel", fuel)];
        let numbers = [("y", 0.2), ("width", 0.2), ("height", 0.1), ("load", 8.0)];
        let mut fire = Simulation::new(with_solid(bed().scene().clone(), &texts, &numbers));
        burn_on(&mut fire, 0.2);
        // Beside the log, through which no water comes.
        for x in [-0.13, 0.13] {
            let beside = jet.map(|at| Vec2::new(x, at.y));
            spray(&mut fire, beside, (0.3, 0.5), assert_balanced);
        }
        burn_on(&mut fire, 0.5);
        assert!(sprayed(&fire).held > 0.0, "{fuel}: {:?}", sprayed(&fire));
        // On the log, more than 0.1 m above the source.
        let at = match target {
            true => IgnitionTarget::Object(ID),
            false => IgnitionTarget::Place(Vec2::new(0.05, 0.26), 0.0),
        };
        assert_eq!(fire.ignite(at), Ok(()), "{fuel}");
        assert!(sprayed(&fire).held == 0.0, "{fuel}: {:?}", sprayed(&fire));
        assert_balanced(&fire);
    }
}

#[test]
fn the_flame_of_another_dries_a_source_that_is_wet_throughout() {
    let held = |power: f64| {
        let mut scene = bed().scene().clone();
        assert_eq!(scene.set("fuel_power", 150.0), Ok(()));
        let numbers = [("power", power), ("y", 0.1), ("width", 0.3)];
        let mut fields = vec![("kind", Input::Text("source"))];
        fields.extend(numbers.map(|(name, x)| (name, Input::Number(x))));
        assert_eq!(scene.add(&fields), Ok(ID));
        let mut fire = Simulation::new(scene);
        // The first source takes all that it can hold, and the rest runs off.
        let jet = [Vec2::new(0.0, 0.3), Vec2::new(0.0, -3.0)];
        spray(&mut fire, jet, (1.0, 0.5), assert_balanced);
        burn_on(&mut fire, 0.3);
        let wet = sprayed(&fire).held;
        burn_on(&mut fire, 3.0);
        assert_balanced(&fire);
        sprayed(&fire).held / wet
    };
    let [alone, beside] = [0.0, 150.0].map(held);
    assert!(alone > 0.999 && beside < 0.98, "{alone} and {beside}");
}

#[test]
fn a_hot_solid_boils_water_off_and_loses_the_heat_and_a_cold_one_lets_it_run_off() {
    let kept = |kelvin: f64| {
        let texts = [("shape", "box"), ("thermal", "conducting")];
        let numbers = [
            ("y", 0.3),
            ("width", 0.4),
            ("height", 0.1),
            ("heat_capacity", 2000.0),
            ("temperature", kelvin),
        ];
        let scene: Scene = with_solid(open(&[]), &texts, &numbers);
        let mut wet = Simulation::new(scene);
        let mut dry = wet.clone();
        let jet = [Vec2::new(0.0, 0.6), Vec2::new(0.0, -3.0)];
        spray(&mut wet, jet, (0.1, 0.5), assert_balanced);
        burn_on(&mut wet, 0.5);
        burn_on(&mut dry, wet.time());
        let of = |fire: &Simulation| {
            f64::from(
                fire.solid_temperatures()
                    .next()
                    .map_or(0.0, |solid| solid.1),
            )
        };
        (of(&dry) - of(&wet), sprayed(&wet))
    };
    let (cooled, all) = kept(900.0);
    // 2000 kJ/(m³·K) × 0.04 m².
    let lost = 80.0 * cooled;
    assert!(all.boiled > 0.02, "{all:?}");
    assert!(
        (lost / all.solid_heat - 1.0).abs() < 0.2,
        "{lost} kJ/m, {all:?}"
    );
    let (cooled, all) = kept(300.0);
    assert_eq!(all.boiled, 0.0);
    assert!(
        all.run_off > 0.02 && cooled.abs() < 1.0,
        "{cooled} K, {all:?}"
    );
}
