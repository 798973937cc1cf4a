//! Settings: what is exported can be imported, and nothing wrong is taken.

use hearth_core::params::{Input, Model, PARAMETERS};
use hearth_core::preset::PRESETS;
use hearth_engine::config::{Config, changed};
use hearth_engine::message::Order;
use hearth_engine::raw::Raw;
use hearth_engine::wanted::Wanted;

fn object(fields: Vec<(&str, Raw)>) -> Raw {
    let named = fields.into_iter().map(|(id, value)| (id.to_owned(), value));
    Raw::Object(named.collect())
}

fn text(words: &str) -> Raw {
    Raw::Text(words.to_owned())
}

/// A fire's settings as they are sent.
fn exported(wanted: &Wanted) -> Raw {
    let values = changed(wanted).into_iter().map(|(param, value)| {
        let value = value
            .as_number()
            .map_or_else(|| text(&value.to_string()), Raw::Number);
        (param.id, value)
    });
    object(vec![
        ("hearth", Raw::Number(1.0)),
        ("preset", text(wanted.preset)),
        ("values", object(values.collect())),
    ])
}

fn imported(raw: &Raw) -> Wanted {
    let config = Config::parse(raw);
    match config.map(|config| config.wanted()) {
        Ok(Ok(wanted)) => wanted,
        other => panic!("{raw:?} gives {other:?}"),
    }
}

fn errors(raw: &Raw) -> Vec<String> {
    let refused = match Config::parse(raw) {
        Ok(config) => config.wanted().err().unwrap_or_default(),
        Err(refused) => vec![refused],
    };
    refused.into_iter().map(|one| one.message).collect()
}

fn set(wanted: &Wanted, id: &str, value: Raw) -> Wanted {
    match wanted.after(&Order::Set(vec![(id.to_owned(), value)])) {
        Some(Ok(wanted)) => wanted,
        other => panic!("{id} gives {other:?}"),
    }
}

#[test]
fn a_preset_alone_has_nothing_to_tell() {
    for preset in PRESETS {
        let wanted = Wanted::of_preset(preset.name);
        assert_eq!(
            wanted.map(|wanted| changed(&wanted).len()),
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
            let wanted = Wanted::of_preset(preset.name).unwrap_or_default();
            let mut wanted = set(&wanted, "model", text(model.name()));
            for param in PARAMETERS {
                let Some(domain) = param.domain(model) else {
                    continue;
                };
                let (min, max) = domain.range;
                let mut parameters = wanted.parameters.clone();
                let one_end = if param.get(&parameters).as_number() == Some(max) {
                    min
                } else {
                    max
                };
                // What is no number stays as it is here.
                if parameters.set(param.id, Input::Number(one_end)).is_ok() {
                    wanted.parameters = parameters;
                }
            }
            let back = imported(&exported(&wanted));
            for (param, value) in changed(&wanted) {
                assert_eq!(
                    param.get(&back.parameters),
                    value,
                    "{} of {}",
                    param.id,
                    preset.name
                );
            }
            assert_eq!(exported(&back), exported(&wanted));
            assert_eq!(back.preset, preset.name);
        }
    }
}

#[test]
fn a_number_of_particles_that_somebody_set_is_kept() {
    let wanted = Wanted::default();
    let default = f64::from(wanted.parameters.max_particles);
    assert!(changed(&wanted).is_empty());
    let wanted = set(&wanted, "max_particles", Raw::Number(default));
    let ids: Vec<_> = changed(&wanted).iter().map(|(param, _)| param.id).collect();
    assert_eq!(ids, ["max_particles"]);
    assert!(imported(&exported(&wanted)).own_number);
}

#[test]
fn settings_replace_all_that_was() {
    let wanted = set(&Wanted::default(), "exposure", Raw::Number(1.0));
    let config = Config::parse(&object(vec![("values", object(vec![]))]));
    let order = config.map(Order::Import);
    assert_eq!(
        order.map(|order| wanted.after(&order)),
        Ok(Some(Ok(Wanted::default())))
    );
}

#[test]
fn the_words_of_a_scene_change_nothing() {
    let values = || ("values", object(vec![("wind", Raw::Number(1.0))]));
    let scene = object(vec![
        ("hearth", Raw::Number(1.0)),
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
        (Raw::Missing, "config"),
        (Raw::Number(1.0), "config"),
        (Raw::List(vec![]), "config"),
        (object(vec![("exposure", Raw::Number(1.0))]), "exposure"),
        (object(vec![("__proto__", object(vec![]))]), "__proto__"),
        (object(vec![("hearth", Raw::Number(2.0))]), "hearth = 2"),
        (object(vec![("preset", text("sead"))]), "seed"),
        (object(vec![("preset", Raw::Number(1.0))]), "preset = 1"),
        (object(vec![("label", Raw::Number(1.0))]), "label = 1"),
        (object(vec![("description", object(vec![]))]), "description"),
        (object(vec![("values", text("many"))]), "values = \"many\""),
        (
            values(vec![("exposurr", Raw::Number(1.0))]),
            "did you mean \"exposure\"?",
        ),
        (
            values(vec![("exposure", Raw::Number(99.0))]),
            "from -4 to 4",
        ),
        (
            values(vec![("exposure", Raw::Number(f64::NAN))]),
            "exposure = NaN",
        ),
        (
            values(vec![("exposure", object(vec![]))]),
            "exposure = \"an object\"",
        ),
        (values(vec![("__proto__", Raw::Number(1.0))]), "__proto__"),
    ] {
        let said = errors(&wrong);
        assert!(
            said.iter().any(|words| words.contains(named)),
            "{wrong:?}: {said:?}"
        );
    }
    let two = values(vec![
        ("exposure", Raw::Number(99.0)),
        ("bloom", Raw::Number(-1.0)),
    ]);
    assert_eq!(errors(&two).len(), 2, "each of them is named");
}
