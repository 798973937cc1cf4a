//! Changes of settings and the level's number of particles.

use crate::harness::{after, at_level, sent, set};
use hearth_core::Simulation;
use hearth_core::params::{Model, PARAMETERS};
use hearth_core::preset::Preset;
use hearth_core::resolution::Level;
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, adapt};

fn number(particles: u32) -> (&'static str, Untrusted) {
    ("particles", Untrusted::Number(particles.into()))
}

fn model(name: &str) -> (&'static str, Untrusted) {
    ("model", Untrusted::Text(name.to_owned()))
}

/// The settings with these values.
fn with<const N: usize>(settings: &Settings, values: [(&str, Untrusted); N]) -> Settings {
    after(settings, Change::Set(&sent(values)))
}

/// The settings with the default of this parameter.
fn without(settings: &Settings, id: &str) -> Settings {
    set(settings, id, Untrusted::Null)
}

/// Number of particles at each level.
fn particles(settings: &Settings) -> [u32; 3] {
    Level::ALL.map(|level| at_level(settings, level).settings().domain_particles())
}

/// The default spacing, of three digits, gives 3007 particles instead of 3000.
const FOLLOWS: [u32; 3] = [1200, 3007, 6700];

#[test]
fn the_level_decides_the_number_until_it_is_stated() {
    let default = Settings::default();
    assert_eq!(particles(&default), FOLLOWS);
    // Also if it is the default.
    for (own, found) in [(2000, 2000), (2999, 2999), (3000, 3007), (3001, 3001)] {
        let settings = with(&default, [number(own)]);
        assert_eq!(particles(&settings), [found; 3]);
        // Restoring the parameter or all settings resets it.
        assert_eq!(without(&settings, "particles"), default);
        assert_eq!(after(&settings, Change::Preset("default")), default);
        // Changes of other parameters do not.
        let others = [
            without(&settings, "seed"),
            with(&settings, [("seed", Untrusted::Number(7.0))]),
        ];
        for other in others {
            assert_eq!(particles(&other), [found; 3]);
        }
    }
}

#[test]
fn undefined_states_nothing_and_null_restores() {
    for preset in Preset::all() {
        let settings = Settings::starting_from(preset);
        let all = |value: Untrusted| {
            let ids = PARAMETERS
                .iter()
                .map(|param| (param.id.to_owned(), value.clone()));
            after(&settings, Change::Set(&ids.collect::<Vec<_>>()))
        };
        assert_eq!(all(Untrusted::Missing), settings);
        let one_by_one = PARAMETERS.iter().fold(settings.clone(), |settings, param| {
            set(&settings, param.id, Untrusted::Null)
        });
        assert_eq!(all(Untrusted::Null), one_by_one);
        let x = sent([("x", Untrusted::Missing)]);
        assert_eq!(after(&settings, Change::ChangeObject(1, &x)), settings);
        // In the properties of an object, too.
        let kinds = settings
            .scene()
            .objects()
            .map(|object| (object.id, object.kind));
        for (id, kind) in kinds {
            let model = settings.parameters().model();
            let used = kind
                .properties()
                .filter(|property| property.param(model).is_some());
            for property in used {
                let null = sent([(property.name, Untrusted::Null)]);
                let settings = after(&settings, Change::ChangeObject(id, &null));
                let object = settings.scene().objects().find(|object| object.id == id);
                let mut all = object.into_iter().flat_map(|object| object.properties());
                let (_, param, value) = all.find(|(name, ..)| *name == property.name).expect("it");
                assert_eq!(value, param.any_domain(model).default, "{}", property.name);
            }
        }
    }
}

#[test]
fn each_model_has_its_own_number() {
    let cap = ("max_particles", Untrusted::Number(500.0));
    let classic = with(&Settings::default(), [model("classic"), cap]);
    assert_eq!(particles(&classic), [500; 3]);
    assert_eq!(particles(&with(&classic, [model("combustion")])), FOLLOWS);
    // And vice versa.
    let settings = with(&Settings::default(), [number(3000)]);
    let settings = without(&with(&settings, [model("classic")]), "max_particles");
    let settings = with(&settings, [model("combustion")]);
    assert_eq!(particles(&settings), [FOLLOWS[1]; 3]);
}

#[test]
fn changes_of_the_cost_are_detected() {
    let settings = Settings::default();
    for other in [
        model("classic"),
        number(2000),
        // The same number at this level, but fixed.
        number(3000),
        ("time_scale", Untrusted::Number(0.5)),
    ] {
        assert!(!with(&settings, [other]).costs_like(&settings));
    }
    for same in [
        ("bloom", Untrusted::Number(0.5)),
        ("wind", Untrusted::Number(0.2)),
    ] {
        assert!(with(&settings, [same]).costs_like(&settings));
    }
}

#[test]
fn the_start_does_not_depend_on_the_guess_for_the_machine() {
    let settings = Settings::default();
    let set = |id: &str, number| with(&settings, [(id, Untrusted::Number(number))]);
    let cases = [
        (settings.clone(), Level::Medium),
        (set("particles", 2000.0), Level::Low),
        (set("domain_height", 1.2), Level::Low),
    ];
    for (changed, level) in cases {
        let burnt = |guess: Level| {
            let mut fire = Simulation::new(at_level(&settings, guess));
            adapt(&mut fire, at_level(&changed, level));
            for _ in 0..20 {
                fire.step();
            }
            fire.positions()
        };
        let (low, high) = (burnt(Level::Low), burnt(Level::High));
        assert_eq!(low, high);
        // A reset fire is the same.
        let mut again = Simulation::new(at_level(&settings, Level::High));
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
    let settings = Settings::default();
    assert_eq!(settings.parameters().model(), Model::Combustion);
    let mut fire = Simulation::new(at_level(&settings, Level::Medium));
    for _ in 0..20 {
        fire.step();
    }
    let time = fire.time();
    adapt(&mut fire, at_level(&settings, Level::Low));
    assert_eq!(fire.time(), time);
    assert!(fire.count() < 1500);
}
