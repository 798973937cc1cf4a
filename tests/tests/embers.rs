//! Embers are born in the flames, fly, cool and die.

use std::collections::HashMap;

use hearth_core::params::Model;
use hearth_core::{Ember, Parameters, Vec2};
use hearth_tests::fires::{burn, burn_on, combustion, watch};

/// The identity of an ember.
fn name(ember: &Ember) -> (u32, u32) {
    (ember.size.to_bits(), ember.lifetime.to_bits())
}

/// Embers in the air, on average, as a share of those that would be thrown in
/// the mean of their lives.
fn share_of_expected(rate: f64, low: f64, high: f64) -> f64 {
    let values = [
        ("ember_rate", rate),
        ("ember_life_min", low),
        ("ember_life_max", high),
    ];
    let mut fire = burn(combustion(&values), 1.0);
    let (mut alive, mut n) = (0.0, 0.0);
    watch(&mut fire, 3.0, |fire| {
        alive += fire.embers().len() as f64;
        n += 1.0;
    });
    alive / n / (rate * 0.5 * (low + high))
}

#[test]
fn the_number_of_embers_is_rate_times_lifetime() {
    for (rate, low, high) in [
        (40.0, 0.2, 0.4),
        (300.0, 0.1, 0.3),
        (300.0, 0.2, 0.2),
        (1000.0, 0.2, 0.2),
    ] {
        let share = share_of_expected(rate, low, high);
        // A tenth, or three standard errors of as many as are thrown in three seconds.
        let tolerance = (3.0 / (3.0 * rate).sqrt()).max(0.1);
        assert!((share - 1.0).abs() < tolerance, "{share} at {rate}/s");
    }
}

#[test]
fn lifetimes_and_sizes_are_in_their_ranges() {
    let mut fire = burn(
        combustion(&[
            ("ember_rate", 200.0),
            ("ember_life_min", 0.3),
            ("ember_life_max", 0.8),
            ("ember_size", 0.01),
        ]),
        1.0,
    );
    let (mut shortest, mut longest) = (f32::INFINITY, 0.0_f32);
    watch(&mut fire, 1.0, |fire| {
        for ember in fire.embers() {
            shortest = shortest.min(ember.lifetime);
            longest = longest.max(ember.lifetime);
            assert!(ember.age < ember.lifetime, "{ember:?}");
            // A pop throws one of twice the size, which lives as long as any.
            let largest = if ember.lifetime == 0.8 { 0.02 } else { 0.01 };
            assert!(ember.size > 0.0 && ember.size <= largest, "{ember:?}");
        }
    });
    // All of the range is used, and nothing beyond.
    assert!((0.3..0.35).contains(&shortest), "{shortest} s");
    assert!((0.75..=0.8).contains(&longest), "{longest} s");
}

#[test]
fn embers_cool_rise_with_the_flow_and_die() {
    let lives = [("ember_life_min", 0.3), ("ember_life_max", 1.0)];
    let rate = [("ember_rate", 150.0)];
    let mut fire = burn(combustion(&[&lives[..], &rate].concat()), 1.0);
    let (mut first, mut last) = (HashMap::new(), HashMap::new());
    watch(&mut fire, 2.0, |fire| {
        // Those of pops have one size and lifetime, and so one name.
        let others = |ember: &&Ember| ember.lifetime < 1.0;
        for ember in fire.embers().iter().filter(others) {
            first.entry(name(ember)).or_insert(*ember);
            if let Some(before) = last.insert(name(ember), *ember) {
                assert!(ember.temperature < before.temperature, "{ember:?}");
                assert!(ember.age > before.age, "{ember:?}");
            }
        }
    });
    let flown: Vec<_> = first.iter().filter(|(_, ember)| ember.age < 0.1).collect();
    assert!(flown.len() > 200, "{}", flown.len());
    let risen = flown
        .iter()
        .map(|(name, ember)| last[*name].position.y - ember.position.y)
        .sum::<f32>()
        / flown.len() as f32;
    assert!(risen > 0.3, "{risen} m");

    let alive = fire.embers().len();
    let dead = first.keys().filter(|&name| {
        let alive = |ember: &Ember| self::name(ember) == *name;
        !fire.embers().iter().any(alive)
    });
    assert!(dead.count() > 2 * alive);
}

#[test]
fn without_a_rate_there_are_no_births() {
    assert_eq!(burn(combustion(&[("ember_rate", 0.0)]), 1.0).embers(), []);

    let mut fire = burn(combustion(&[("ember_life_max", 0.6)]), 1.0);
    assert!(!fire.embers().is_empty());
    let none = hearth_core::params::Input::Number(0.0);
    assert_eq!(fire.set("ember_rate", none), Ok(()));
    burn_on(&mut fire, 0.65);
    assert_eq!(fire.embers(), []);
}

#[test]
fn there_are_no_embers_without_flames_and_in_the_classic_model() {
    let many = ("ember_rate", 1000.0);
    assert_eq!(
        burn(combustion(&[many, ("fuel_power", 0.0)]), 1.0).embers(),
        []
    );

    let classic = burn(Parameters::new(Model::Classic), 1.0);
    let mut instances = vec![[1.0; 8]];
    classic.write_embers(&mut instances);
    assert_eq!((classic.embers(), &instances[..]), (&[][..], &[][..]));
}

#[test]
fn embers_do_not_change_the_gas() {
    // They draw from the same generator, but the gas draws nothing after its start.
    let with = burn(combustion(&[("ember_rate", 1000.0)]), 0.5);
    let without = burn(combustion(&[("ember_rate", 0.0)]), 0.5);
    assert_eq!(with.particles(), without.particles());
}

#[test]
fn the_renderer_receives_every_ember() {
    let fire = burn(combustion(&[("ember_rate", 300.0)]), 1.0);
    let mut instances = Vec::new();
    fire.write_embers(&mut instances);
    assert_eq!(instances.len(), fire.embers().len());
    assert!(!instances.is_empty());
    for (i, ember) in instances.iter().zip(fire.embers()) {
        assert_eq!(i[..2], ember.position.to_array());
        assert_eq!(i[2..4], ember.velocity.to_array());
        assert_eq!(i[4..7], [ember.temperature, ember.size, ember.age]);
        assert_eq!(i[7], 1.0 - ember.age / ember.lifetime);
    }
}

#[test]
fn thrown_embers_start_at_their_position_and_are_deterministic() {
    let place = Vec2::new(0.2, 0.7);
    let thrown = || {
        let values = [
            ("ember_rate", 0.0),
            ("ember_size", 0.01),
            ("ember_life_min", 0.3),
        ];
        let mut fire = burn(combustion(&values), 0.3);
        fire.throw_embers(place, 24);
        assert_eq!(fire.embers().len(), 24);
        assert!(fire.embers().iter().all(|ember| ember.position == place));
        burn_on(&mut fire, 0.1);
        fire
    };
    let fire = thrown();
    assert_eq!(fire.embers().len(), 24);
    for ember in fire.embers() {
        let way = ember.position - place;
        assert!((0.001..0.5).contains(&way.length()), "{ember:?}");
        assert!((0.004..=0.01).contains(&ember.size) && ember.lifetime >= 0.3);
    }
    let sides = fire
        .embers()
        .iter()
        .filter(|ember| ember.position.x > place.x)
        .count();
    assert!((6..=18).contains(&sides), "{sides} to the right");
    assert_eq!(fire.embers(), thrown().embers());

    // The gas is as it was without them, and they die as the others do.
    let mut without = burn(combustion(&[("ember_rate", 0.0)]), 0.3);
    burn_on(&mut without, 0.1);
    assert_eq!(fire.particles(), without.particles());
    let mut fire = fire;
    burn_on(&mut fire, 2.2);
    assert_eq!(fire.embers(), []);
}

#[test]
fn thrown_embers_are_limited_and_start_inside() {
    let mut fire = burn(combustion(&[("ember_rate", 0.0)]), 0.1);
    for place in [
        Vec2::new(0.0, 9.0),
        Vec2::new(-5.0, 0.5),
        Vec2::new(f32::NAN, 0.5),
        Vec2::new(0.0, f32::INFINITY),
    ] {
        fire.throw_embers(place, 24);
    }
    assert_eq!(fire.embers(), []);
    for _ in 0..100 {
        fire.throw_embers(Vec2::new(0.0, 0.5), u32::MAX);
    }
    assert_eq!(fire.embers().len(), 4000);

    let mut classic = burn(Parameters::new(Model::Classic), 0.1);
    classic.throw_embers(Vec2::new(0.0, 0.5), 24);
    assert_eq!(classic.embers(), []);
}
