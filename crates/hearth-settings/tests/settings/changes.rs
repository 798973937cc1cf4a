//! Changes of settings and the level's number of particles.

use crate::harness::{after, at_level, sent, set};
use hearth_core::Simulation;
use hearth_core::params::{Model, PARAMETERS};
use hearth_core::preset::Preset;
use hearth_core::resolution::Level;
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings};

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
    Level::ALL.map(|level| at_level(settings, level).world().domain_particles())
}

/// The default spacing, of three digits, gives 3007 particles instead of 3000.
const FOLLOWS: [u32; 3] = [1500, 3007, 6700];

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
        let model = settings.scene().model();
        let used = || {
            PARAMETERS
                .iter()
                .filter(|param| param.only_in(model).is_none())
        };
        let all = |value: Untrusted| {
            let ids = used().map(|param| (param.id.to_owned(), value.clone()));
            after(&settings, Change::Set(&ids.collect::<Vec<_>>()))
        };
        assert_eq!(all(Untrusted::Missing), settings);
        let models_last = used().filter(|param| param.id != "model");
        let restored = models_last.fold(settings.clone(), |settings, param| {
            set(&settings, param.id, Untrusted::Null)
        });
        if model == Model::default() {
            assert_eq!(all(Untrusted::Null), restored);
        }
        let x = sent([("x", Untrusted::Missing)]);
        assert_eq!(after(&settings, Change::ChangeObject(1, &x)), settings);
        // In the properties of an object, too.
        for id in settings.scene().ids() {
            let names = settings.scene().object(id).into_iter();
            let names = names.flat_map(|object| object.properties());
            for (name, param, _) in names {
                let null = sent([(name, Untrusted::Null)]);
                let settings = after(&settings, Change::ChangeObject(id, &null));
                let object = settings.scene().object(id).into_iter();
                let mut all = object.flat_map(|object| object.properties());
                let (.., value) = all.find(|(known, ..)| *known == name).expect("it");
                assert_eq!(value, param.any_domain(model).default, "{name}");
            }
        }
    }
}

#[test]
fn a_change_with_a_refused_value_changes_nothing() {
    let bad = sent([number(3000), ("bloom", Untrusted::Number(99.0))]);
    for values in [bad, sent([number(0)])] {
        assert!(Settings::default().after(&Change::Set(&values)).is_err());
    }
}

#[test]
fn another_model_keeps_what_both_have_and_starts_the_rest_from_its_defaults() {
    let values = [
        number(2000),
        ("wind", Untrusted::Number(1.0)),
        ("turbulence", Untrusted::Number(2.0)),
    ];
    let burning = with(&Settings::default(), values);
    let cap = ("max_particles", Untrusted::Number(500.0));
    let classic = with(&burning, [model("classic"), cap]);
    assert_eq!(particles(&classic), [500; 3]);
    let back = with(&classic, [model("combustion")]);
    assert_eq!(
        back,
        with(
            &Settings::default(),
            [("turbulence", Untrusted::Number(2.0))]
        )
    );
    assert_eq!(particles(&back), FOLLOWS);
}

#[test]
fn attributes_of_another_model_have_no_effect_and_apply_with_it() {
    let page = sent([
        ("wind", Untrusted::Number(1.0)),
        ("gas_constant", Untrusted::Number(1.0)),
        ("bloom", Untrusted::Number(0.3)),
    ]);
    let mut errors = Vec::new();
    let settings = Settings::default().after_valid(&page, &mut errors);
    assert_eq!((errors.len(), settings.parameters().wind), (0, 1.0));
    // A call refuses it by name.
    let refused = settings
        .after(&Change::Set(&page[1..2]))
        .expect_err("refused");
    assert!(
        refused[0].message.contains("only the classic model has it"),
        "{refused:?}"
    );
    assert_eq!(set(&settings, "gas_constant", Untrusted::Null), settings);
    // What both models have keeps what calls have set since.
    let called = with(&settings, [("bloom", Untrusted::Number(0.5))]);
    let classic = sent([model("classic")]);
    let classic = after(&called, Change::SetModel(&classic, &page));
    let values = classic.parameters();
    assert_eq!((values.gas_constant, values.bloom), (1.0, 0.5));
    let back = sent([model("combustion"), ("wind", Untrusted::Number(-1.0))]);
    let back = after(&classic, Change::SetModel(&back, &page));
    assert_eq!(back.parameters().wind, -1.0);
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
            fire.adapt(at_level(&changed, level));
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
        again.adapt(at_level(&changed, level));
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
    fire.adapt(at_level(&settings, Level::Low));
    assert_eq!(fire.time(), time);
    assert!(fire.count() < 1500);
}
