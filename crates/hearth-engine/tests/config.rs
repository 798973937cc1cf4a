//! Settings: what is exported can be imported, and nothing wrong is taken.

use hearth_bindings::{Untrusted, Whole};
use hearth_core::params::{Input, Model, PARAMETERS};
use hearth_core::preset::PRESETS;
use hearth_engine::commands::Command;
use hearth_engine::config::{Config, export};
use hearth_engine::requested::Requested;

fn object(fields: Vec<(&str, Untrusted)>) -> Untrusted {
    let named = fields.into_iter().map(|(id, value)| (id.to_owned(), value));
    Untrusted::Object(named.collect())
}

fn text(words: &str) -> Untrusted {
    Untrusted::Text(words.to_owned())
}

/// The ids of the values that differ from the preset, and how many fields objects have.
fn differing(wanted: &Requested) -> (Vec<String>, usize) {
    let config = export(wanted);
    let ids = match config.field("values") {
        Untrusted::Object(values) => values.iter().map(|(id, _)| id.clone()).collect(),
        _ => vec!["no values".to_owned()],
    };
    let objects = match config.field("objects") {
        Untrusted::List(objects) => objects.len(),
        _ => 0,
    };
    (ids, objects)
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

fn set(wanted: &Requested, id: &str, value: Untrusted) -> Requested {
    let values = &[(id.to_owned(), value)];
    match wanted.after(&Command::Set {
        values,
        source: "test",
    }) {
        Some(Ok(wanted)) => wanted,
        other => panic!("{id} gives {other:?}"),
    }
}

#[test]
fn a_preset_alone_has_nothing_to_tell() {
    for preset in PRESETS {
        let wanted = Requested::of_preset(preset.name);
        let changes = wanted.as_ref().map(differing);
        assert_eq!(changes, Ok((vec![], 0)), "{}", preset.name);
    }
}

#[test]
fn whatever_is_changed_comes_back() {
    for preset in PRESETS {
        for model in [Model::Classic, Model::Combustion] {
            let wanted = Requested::of_preset(preset.name).unwrap_or_default();
            let mut wanted = set(&wanted, "model", text(model.name()));
            for param in PARAMETERS {
                let Some(domain) = param.domain(model) else {
                    continue;
                };
                let (min, max) = domain.range;
                let mut parameters = wanted.parameters().clone();
                let one_end = if param.get(&parameters).as_number() == Some(max) {
                    min
                } else {
                    max
                };
                // What is no number stays as it is here.
                if parameters.set(param.id, Input::Number(one_end)).is_ok() {
                    wanted.scene.set_settings(parameters);
                }
            }
            let back = imported(&export(&wanted));
            for param in PARAMETERS {
                if param.domain(model).is_some() {
                    let values = (param.get(back.parameters()), param.get(wanted.parameters()));
                    assert_eq!(values.0, values.1, "{} of {}", param.id, preset.name);
                }
            }
            assert_eq!(export(&back), export(&wanted));
            assert_eq!(back.preset, preset.name);
        }
    }
}

#[test]
fn a_number_of_particles_that_somebody_set_is_kept() {
    let wanted = Requested::default();
    let default = f64::from(wanted.parameters().max_particles);
    assert_eq!(differing(&wanted), (vec![], 0));
    let wanted = set(&wanted, "max_particles", Untrusted::Number(default));
    assert_eq!(differing(&wanted), (vec!["max_particles".to_owned()], 0));
    assert!(imported(&export(&wanted)).count_overridden);
}

#[test]
fn settings_replace_all_that_was() {
    let wanted = set(&Requested::default(), "exposure", Untrusted::Number(1.0));
    let config = &object(vec![("values", object(vec![]))]);
    let source = "test";
    let after = wanted.after(&Command::Import { config, source });
    assert_eq!(after, Some(Ok(Requested::default())));
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
            object(vec![("hearth", Untrusted::Number(3.0))]),
            "hearth = 3",
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

/// A list of sources with these properties.
fn sources(all: &[&[(&str, f64)]]) -> Untrusted {
    let of_one = |properties: &&[(&str, f64)]| {
        let mut fields = vec![("kind", text("source"))];
        let numbers = properties.iter();
        fields.extend(numbers.map(|&(name, x)| (name, Untrusted::Number(x))));
        object(fields)
    };
    Untrusted::List(all.iter().map(of_one).collect())
}

#[test]
fn version_1_is_read_as_it_was_and_writes_back_as_version_2() {
    for preset in PRESETS {
        // A scene of version 1 as its file has it: all that differs from the defaults.
        let values = preset.values.iter().map(|&(id, input)| {
            let raw = match input {
                Input::Number(x) => Untrusted::Number(x),
                Input::Text(words) => text(words),
                Input::Flag(on) => Untrusted::Flag(on),
            };
            (id, raw)
        });
        let file = object(vec![
            ("hearth", Untrusted::Number(1.0)),
            ("values", object(values.collect())),
        ]);
        let read = imported(&file);
        assert_eq!(read.scene, preset.scene(), "{}", preset.name);
        assert_eq!(
            imported(&export(&read)).scene,
            read.scene,
            "{}",
            preset.name
        );
    }
}

#[test]
fn what_belongs_to_the_first_source_is_written_once() {
    let wanted = set(&Requested::default(), "source_x", Untrusted::Number(0.2));
    let wanted = set(&wanted, "wind", Untrusted::Number(1.0));
    assert_eq!(
        export(&wanted),
        object(vec![
            ("hearth", Untrusted::Number(2.0)),
            ("values", object(vec![("wind", Untrusted::Number(1.0))])),
            ("objects", sources(&[&[("x", 0.2)]])),
        ])
    );
}

#[test]
fn objects_come_back_with_their_ids_and_without_them_the_settings_keep_theirs() {
    let two = set(
        &Requested::default(),
        "objects",
        sources(&[&[("x", -0.3)], &[("power", 50.0)]]),
    );
    let object = &[
        ("kind".to_owned(), text("source")),
        ("id".to_owned(), Untrusted::Number(7.0)),
        ("width".to_owned(), Untrusted::Number(0.05)),
    ];
    let order = Command::AddObject {
        object,
        source: "test",
    };
    let Some(Ok(three)) = two.after(&order) else {
        panic!("it was refused");
    };
    let Some(Ok(fewer)) = three.after(&Command::RemoveObject {
        id: Whole(1),
        source: "test",
    }) else {
        panic!("it was refused");
    };
    let none = set(&two, "objects", Untrusted::List(vec![]));
    for wanted in [&two, &three, &fewer, &none] {
        let back = imported(&export(wanted));
        assert_eq!(back.scene, wanted.scene, "{:?}", export(wanted));
    }
    assert_eq!(fewer.parameters().fuel_power, 50.0);
    assert_eq!(none.parameters().source_x, -0.3);
}

#[test]
fn of_two_words_about_one_property_the_later_counts() {
    let one = ("fuel_power".to_owned(), Untrusted::Number(100.0));
    let other = ("objects".to_owned(), sources(&[&[("power", 50.0)]]));
    for (values, power) in [([one.clone(), other.clone()], 50.0), ([other, one], 100.0)] {
        let set = Requested::default().after(&Command::Set {
            values: &values,
            source: "test",
        });
        let Some(Ok(wanted)) = set else {
            panic!("{values:?} was refused");
        };
        assert_eq!(wanted.parameters().fuel_power, power);
        let fields = values.map(|(id, raw)| match id.as_str() {
            "objects" => ("objects", raw),
            id => ("values", object(vec![(id, raw)])),
        });
        assert_eq!(
            imported(&object(fields.to_vec())).parameters().fuel_power,
            power
        );
    }
}

#[test]
fn an_object_that_is_wrong_is_named_and_nothing_is_taken() {
    let far = sources(&[&[], &[("x", 9.0)]]);
    let solid = Untrusted::List(vec![object(vec![("kind", text("solid"))])]);
    for (objects, named) in [
        (
            Untrusted::Number(1.0),
            "objects = 1 is refused: it must be an array of objects",
        ),
        (
            Untrusted::List(vec![Untrusted::Number(1.0)]),
            "objects[0].kind = \"undefined\" is refused: it must be source",
        ),
        (
            solid,
            "objects[0].kind = \"solid\" is refused: it must be source",
        ),
        (
            far,
            "objects[1].x = 9 is refused: it must be a number from -3 to 3 m",
        ),
        (
            sources(&[&[("pwer", 9.0)]]),
            "must be one of x, y, width, power",
        ),
    ] {
        let said = errors(&object(vec![("objects", objects.clone())]));
        assert!(said.len() == 1 && said[0].contains(named), "{said:?}");
        let values = &[
            ("wind".to_owned(), Untrusted::Number(1.0)),
            ("objects".to_owned(), objects),
        ];
        let order = Command::Set {
            values,
            source: "test",
        };
        assert!(matches!(Requested::default().after(&order), Some(Err(_))));
    }
    let order = Command::ChangeObject {
        id: Whole(1),
        values: &[("x".to_owned(), text("far"))],
        source: "test",
    };
    let Some(Err(refused)) = Requested::default().after(&order) else {
        panic!("it was taken");
    };
    assert_eq!(refused[0].id, "objects[0].x");
    assert_eq!(refused[0].value, text("far"));
    assert_eq!(refused[0].range, Some((-3.0, 3.0)));
    let order = Command::RemoveObject {
        id: Whole(9),
        source: "test",
    };
    assert!(matches!(Requested::default().after(&order), Some(Err(_))));
    let values = object(vec![("values", object(vec![("objects", sources(&[]))]))]);
    assert!(errors(&values)[0].contains("beside the values"));
}

#[test]
fn the_default_objects_are_one_source_with_the_values_of_the_settings() {
    let wanted = set(&Requested::default(), "source_x", Untrusted::Number(0.2));
    let two = set(&wanted, "objects", sources(&[&[], &[]]));
    let ids = &[text("objects")];
    let order = Command::Restore {
        ids,
        source: "test",
    };
    assert_eq!(two.after(&order), Some(Ok(wanted)));
}
