//! Requested settings and the level's number of particles.

use crate::harness::{Sent, at_level, sent};
use hearth_core::Simulation;
use hearth_core::params::Model;
use hearth_core::resolution::Level;
use hearth_engine::change;
use hearth_engine::commands::{Command, Start};
use hearth_settings::untrusted::{Argument, Untrusted};
use hearth_settings::{Requested, adapt};

/// A change of settings.
enum Change {
    Set(Sent),
    Restore(&'static str),
    Preset(&'static str),
}

fn at_first(start: &Start<'_>) -> Requested {
    let (requested, errors) = change::at_first(start);
    assert_eq!(errors, []);
    requested
}

fn number(particles: u32) -> (&'static str, Untrusted) {
    ("max_particles", Untrusted::Number(particles.into()))
}

fn model(name: &str) -> (&'static str, Untrusted) {
    ("model", Untrusted::Text(name.to_owned()))
}

fn result(requested: &Requested, change: &Change) -> Option<Requested> {
    let source = "test";
    let after = match change {
        Change::Set(values) => change::after(requested, &Command::Set { values, source }),
        Change::Restore(id) => {
            let ids = &[Untrusted::Text((*id).to_owned())];
            change::after(requested, &Command::Restore { ids, source })
        }
        Change::Preset(name) => change::after(requested, &Command::Preset { name, source }),
    };
    after.and_then(Result::ok)
}

/// The settings after a valid change.
fn then(requested: &Requested, change: &Change) -> Requested {
    match result(requested, change) {
        Some(requested) => requested,
        None => panic!("a valid change is refused"),
    }
}

/// The settings after these changes.
fn after<const N: usize>(changes: [Change; N]) -> Requested {
    let first = Requested::default();
    changes
        .iter()
        .fold(first, |requested, change| then(&requested, change))
}

/// Number of particles at each level.
fn particles(requested: &Requested) -> [u32; 3] {
    Level::ALL.map(|level| at_level(requested, level).settings().domain_particles())
}

/// The default spacing, of three digits, gives 3007 particles instead of 3000.
const FOLLOWS: [u32; 3] = [1200, 3007, 6700];

#[test]
fn the_level_decides_the_number_until_a_page_sets_it() {
    assert_eq!(particles(&Requested::default()), FOLLOWS);
    // Also if it is the default.
    for (own, found) in [(2000, 2000), (2999, 2999), (3000, 3007), (3001, 3001)] {
        let requested = after([Change::Set(sent([number(own)]))]);
        assert_eq!(particles(&requested), [found; 3]);
        // Restoring the parameter or all settings resets it.
        for back in [Change::Restore("max_particles"), Change::Preset("default")] {
            let requested = then(&requested, &back);
            assert_eq!(particles(&requested), FOLLOWS);
        }
        // Changes of other parameters do not.
        for other in [
            Change::Restore("seed"),
            Change::Set(sent([("seed", Untrusted::Number(7.0))])),
        ] {
            let requested = then(&requested, &other);
            assert_eq!(particles(&requested), [found; 3]);
        }
        assert_eq!(change::after(&requested, &Command::Play {}), None);
    }
}

#[test]
fn refused_values_do_not_set_the_number() {
    let requested = Requested::default();
    let bad = Change::Set(sent([number(3000), ("bloom", Untrusted::Number(99.0))]));
    assert_eq!(result(&requested, &bad), None);
    let alone = Change::Set(sent([number(0)]));
    assert_eq!(result(&requested, &alone), None);
}

#[test]
fn each_model_has_its_own_number() {
    let classic = after([Change::Set(sent([model("classic"), number(500)]))]);
    assert_eq!(particles(&classic), [500; 3]);
    let back = then(&classic, &Change::Set(sent([model("combustion")])));
    assert_eq!(particles(&back), FOLLOWS);
    // And vice versa.
    let requested = after([
        Change::Set(sent([number(3000)])),
        Change::Set(sent([model("classic")])),
        Change::Restore("max_particles"),
        Change::Set(sent([model("combustion")])),
    ]);
    assert_eq!(particles(&requested), [FOLLOWS[1]; 3]);
}

#[test]
fn a_recreated_fire_keeps_whether_the_number_was_set() {
    for (overridden, expected) in [(true, [FOLLOWS[1]; 3]), (false, FOLLOWS)] {
        let values = sent([model("combustion"), number(3000)]);
        let start = Untrusted::Object(sent([
            ("values", Untrusted::Object(values)),
            ("countOverridden", Untrusted::Flag(overridden)),
        ]));
        assert_eq!(particles(&at_first(&Start::read(&start))), expected);
    }
}

#[test]
fn changes_of_the_cost_are_detected() {
    let requested = Requested::default();
    for other in [
        model("classic"),
        number(2000),
        // The same number at this level, but fixed.
        number(3000),
        ("time_scale", Untrusted::Number(0.5)),
    ] {
        assert!(!then(&requested, &Change::Set(sent([other]))).costs_like(&requested));
    }
    for same in [
        ("bloom", Untrusted::Number(0.5)),
        ("wind", Untrusted::Number(0.2)),
    ] {
        assert!(then(&requested, &Change::Set(sent([same]))).costs_like(&requested));
    }
}

#[test]
fn the_start_does_not_depend_on_the_guess_for_the_machine() {
    let requested = Requested::default();
    let set = |values| then(&requested, &Change::Set(values));
    let cases = [
        (requested.clone(), Level::Medium),
        (set(sent([number(2000)])), Level::Low),
        (
            set(sent([("domain_height", Untrusted::Number(1.2))])),
            Level::Low,
        ),
    ];
    for (changed, level) in cases {
        let burnt = |guess: Level| {
            let mut fire = Simulation::new(at_level(&requested, guess));
            adapt(&mut fire, at_level(&changed, level));
            for _ in 0..20 {
                fire.step();
            }
            fire.positions()
        };
        let (low, high) = (burnt(Level::Low), burnt(Level::High));
        assert_eq!(low, high);
        // A reset fire is the same.
        let mut again = Simulation::new(at_level(&requested, Level::High));
        again.step();
        adapt(&mut again, at_level(&changed, level));
        again.reset();
        for _ in 0..20 {
            again.step();
        }
        assert_eq!(again.positions(), low);
    }
}

#[test]
fn a_burning_fire_is_resampled() {
    let requested = Requested::default();
    assert_eq!(requested.parameters().model(), Model::Combustion);
    let mut fire = Simulation::new(at_level(&requested, Level::Medium));
    for _ in 0..20 {
        fire.step();
    }
    let time = fire.time();
    adapt(&mut fire, at_level(&requested, Level::Low));
    assert_eq!(fire.time(), time);
    assert!(fire.count() < 1500);
}
