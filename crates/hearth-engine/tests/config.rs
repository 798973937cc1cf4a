//! Settings: what is exported can be imported, and nothing wrong is taken.

use hearth_bindings::Untrusted;
use hearth_core::params::{Input, Model, PARAMETERS};
use hearth_core::preset::PRESETS;
use hearth_engine::commands::Command;
use hearth_engine::config::{Config, changed};
use hearth_engine::requested::Requested;

fn object(fields: Vec<(&str, Untrusted)>) -> Untrusted {
    let named = fields.into_iter().map(|(id, value)| (id.to_owned(), value));
    Untrusted::Object(named.collect())
}

fn text(words: &str) -> Untrusted {
    Untrusted::Text(words.to_owned())
}

/// A fire's settings as they are sent.
fn exported(requested: &Requested) -> Untrusted {
    let values = changed(requested).into_iter().map(|(param, value)| {
        let value = value
            .as_number()
            .map_or_else(|| text(&value.to_string()), Untrusted::Number);
        (param.id, value)
    });
    object(vec![
        ("hearth", Untrusted::Number(1.0)),
        ("preset", text(requested.preset)),
        ("values", object(values.collect())),
    ])
}

fn imported(config: &Untrusted) -> Requested {
    match Config::requested_by(config) {
        Ok(requested) => requested,
        other => panic!("{config:?} gives {other:?}"),
    }
}

fn errors(config: &Untrusted) -> Vec<String> {
    let refused = Config::requested_by(config).err().unwrap_or_default();
    refused.into_iter().map(|one| one.message).collect()
}

fn set(requested: &Requested, id: &str, value: Untrusted) -> Requested {
    let values = &[(id.to_owned(), value)];
    let source = "test";
    match requested.after(&Command::Set { values, source }) {
        Some(Ok(requested)) => requested,
        other => panic!("{id} gives {other:?}"),
    }
}

#[test]
fn a_preset_alone_has_nothing_to_tell() {
    for preset in PRESETS {
        let requested = Requested::of_preset(preset.name);
        assert_eq!(
            requested.map(|requested| changed(&requested).len()),
            Ok(0),
            "{}",
            preset.name
        );
    }
}

#[test]
fn whatever_is_changed_comes_back() {
    for preset in PRESETS {
        for model in [Model::Classic, Model::Combustion] {
            let requested = Requested::of_preset(preset.name).unwrap_or_default();
            let mut requested = set(&requested, "model", text(model.name()));
            for param in PARAMETERS {
                let Some(domain) = param.domain(model) else {
                    continue;
                };
                let (min, max) = domain.range;
                let mut parameters = requested.parameters.clone();
                let one_end = if param.get(&parameters).as_number() == Some(max) {
                    min
                } else {
                    max
                };
                // What is no number stays as it is here.
                if parameters.set(param.id, Input::Number(one_end)).is_ok() {
                    requested.parameters = parameters;
                }
            }
            let back = imported(&exported(&requested));
            for (param, value) in changed(&requested) {
                assert_eq!(
                    param.get(&back.parameters),
                    value,
                    "{} of {}",
                    param.id,
                    preset.name
                );
            }
            assert_eq!(exported(&back), exported(&requested));
            assert_eq!(back.preset, preset.name);
        }
    }
}

#[test]
fn an_overridden_number_of_particles_is_kept() {
    let requested = Requested::default();
    let default = f64::from(requested.parameters.max_particles);
    assert!(changed(&requested).is_empty());
    let requested = set(&requested, "max_particles", Untrusted::Number(default));
    let ids: Vec<_> = changed(&requested)
        .iter()
        .map(|(param, _)| param.id)
        .collect();
    assert_eq!(ids, ["max_particles"]);
    assert!(imported(&exported(&requested)).count_overridden);
}

#[test]
fn settings_replace_all_that_was() {
    let requested = set(&Requested::default(), "exposure", Untrusted::Number(1.0));
    let config = &object(vec![("values", object(vec![]))]);
    let source = "test";
    assert_eq!(
        requested.after(&Command::Import { config, source }),
        Some(Ok(Requested::default()))
    );
}

#[test]
fn the_words_of_a_scene_change_nothing() {
    let values = || ("values", object(vec![("wind", Untrusted::Number(1.0))]));
    let scene = object(vec![
        ("hearth", Untrusted::Number(1.0)),
        ("label", text("Gale")),
        ("description", text("A fire in the wind.")),
        values(),
    ]);
    assert_eq!(imported(&scene), imported(&object(vec![values()])));
}

#[test]
fn what_is_wrong_is_named_and_nothing_is_taken() {
    let values = |fields| object(vec![("values", object(fields))]);
    for (wrong, named) in [
        (Untrusted::Missing, "config"),
        (Untrusted::Number(1.0), "config"),
        (Untrusted::List(vec![]), "config"),
        (
            object(vec![("exposure", Untrusted::Number(1.0))]),
            "exposure",
        ),
        (object(vec![("__proto__", object(vec![]))]), "__proto__"),
        (
            object(vec![("hearth", Untrusted::Number(2.0))]),
            "hearth = 2",
        ),
        (object(vec![("preset", text("sead"))]), "seed"),
        (
            object(vec![("preset", Untrusted::Number(1.0))]),
            "preset = 1",
        ),
        (object(vec![("label", Untrusted::Number(1.0))]), "label = 1"),
        (object(vec![("description", object(vec![]))]), "description"),
        (object(vec![("values", text("many"))]), "values = \"many\""),
        (
            values(vec![("exposurr", Untrusted::Number(1.0))]),
            "did you mean \"exposure\"?",
        ),
        (
            values(vec![("exposure", Untrusted::Number(99.0))]),
            "from -4 to 4",
        ),
        (
            values(vec![("exposure", Untrusted::Number(f64::NAN))]),
            "exposure = NaN",
        ),
        (
            values(vec![("exposure", object(vec![]))]),
            "exposure = \"an object\"",
        ),
        (
            values(vec![("__proto__", Untrusted::Number(1.0))]),
            "__proto__",
        ),
    ] {
        let said = errors(&wrong);
        assert!(
            said.iter().any(|words| words.contains(named)),
            "{wrong:?}: {said:?}"
        );
    }
    let two = values(vec![
        ("exposure", Untrusted::Number(99.0)),
        ("bloom", Untrusted::Number(-1.0)),
    ]);
    assert_eq!(errors(&two).len(), 2, "each of them is named");
}
