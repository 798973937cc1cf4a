//! Settings files: export, import and validation.

use hearth_core::params::{Model, PARAMETERS};
use hearth_core::preset::Preset;
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, export};

use crate::harness::{after, imported, set, text};

fn object(fields: Vec<(&str, Untrusted)>) -> Untrusted {
    let named = fields.into_iter().map(|(id, value)| (id.to_owned(), value));
    Untrusted::Object(named.collect())
}

/// Ids of the exported values, and the number of exported objects.
fn differing(settings: &Settings) -> (Vec<String>, usize) {
    let config = export(settings);
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

fn errors(config: &Untrusted) -> Vec<String> {
    let refused = Settings::of_file(config).err().unwrap_or_default();
    refused.into_iter().map(|error| error.message).collect()
}

#[test]
fn an_unchanged_preset_exports_no_values() {
    for preset in Preset::all() {
        let settings = Settings::of_preset(preset.name);
        let changes = settings.as_ref().map(differing);
        assert_eq!(changes, Ok((vec![], 0)), "{}", preset.name);
    }
}

#[test]
fn import_restores_every_exported_change() {
    for preset in Preset::all() {
        for model in [Model::Classic, Model::Combustion] {
            let settings = Settings::of_preset(preset.name).unwrap_or_default();
            let mut settings = set(&settings, "model", text(model.name()));
            for param in PARAMETERS {
                let Some(domain) = param.domain(model) else {
                    continue;
                };
                let (min, max) = domain.range;
                let mut scene = settings.scene().clone();
                let one_end = match scene.value(param).as_number() == Some(max) {
                    true => min,
                    false => max,
                };
                // Only numbers are changed.
                if scene.set(param.id, one_end).is_ok() {
                    settings = set(&settings, param.id, Untrusted::Number(one_end));
                }
            }
            let back = imported(&export(&settings));
            assert!(back == settings, "{}: {:?}", preset.name, export(&settings));
        }
    }
}

#[test]
fn export_includes_a_stated_number_of_particles() {
    let settings = Settings::default();
    let default = f64::from(settings.parameters().particles);
    assert_eq!(differing(&settings), (vec![], 0));
    let settings = set(&settings, "particles", Untrusted::Number(default));
    assert_eq!(differing(&settings), (vec!["particles".to_owned()], 0));
    assert_eq!(imported(&export(&settings)), settings);
}

#[test]
fn texts_for_people_do_not_change_the_settings() {
    let values = || ("values", object(vec![("wind", Untrusted::Number(1.0))]));
    let scene = object(vec![
        ("hearth", Untrusted::Number(3.0)),
        ("label", text("Gale")),
        ("description", text("A fire in the wind.")),
        ("author", text("Ada")),
        ("licence", text("CC0-1.0")),
        values(),
    ]);
    assert_eq!(imported(&scene), imported(&object(vec![values()])));
}

#[test]
fn errors_name_the_invalid_field() {
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
            object(vec![("hearth", Untrusted::Number(1.0))]),
            "hearth = 1 is refused: it must be 3",
        ),
        (
            object(vec![("hearth", Untrusted::Number(2.0))]),
            "hearth = 2",
        ),
        (
            object(vec![("preset", text("sead"))]),
            "did you mean \"seed\"?",
        ),
        (
            object(vec![("preset", Untrusted::Number(1.0))]),
            "preset = 1",
        ),
        (object(vec![("label", Untrusted::Number(1.0))]), "label = 1"),
        (object(vec![("description", object(vec![]))]), "description"),
        (
            object(vec![("author", Untrusted::Number(1.0))]),
            "author = 1",
        ),
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
        let messages = errors(&wrong);
        assert!(
            messages.iter().any(|message| message.contains(named)),
            "{wrong:?}: {messages:?}"
        );
    }
    let two = values(vec![
        ("exposure", Untrusted::Number(99.0)),
        ("bloom", Untrusted::Number(-1.0)),
    ]);
    assert_eq!(errors(&two).len(), 2, "an error for each");
}

#[test]
fn a_long_name_is_cut_between_letters() {
    // No letter ends at byte 40.
    let long = "€".repeat(20_000);
    let field = object(vec![(long.as_str(), Untrusted::Number(1.0))]);
    let message = errors(&field).concat();
    assert!(message.starts_with(&"€".repeat(13)), "{message:.100}");
    for config in [
        object(vec![("values", field.clone())]),
        object(vec![("objects", Untrusted::List(vec![field.clone()]))]),
        field,
    ] {
        let length = errors(&config).concat().len();
        assert!((1..500).contains(&length), "{length} bytes");
    }
}

/// A list of sources with properties.
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
fn properties_of_the_first_source_are_exported_once() {
    let settings = set(&Settings::default(), "source_x", Untrusted::Number(0.2));
    let settings = set(&settings, "wind", Untrusted::Number(1.0));
    assert_eq!(
        export(&settings),
        object(vec![
            ("hearth", Untrusted::Number(3.0)),
            (
                "values",
                object(vec![
                    ("wind", Untrusted::Number(1.0)),
                    ("source_x", Untrusted::Number(0.2)),
                ]),
            ),
        ])
    );
}

#[test]
fn import_restores_objects_with_their_ids() {
    let two = set(
        &Settings::default(),
        "objects",
        sources(&[&[("x", -0.3)], &[("power", 50.0)]]),
    );
    let object = &[
        ("kind".to_owned(), text("source")),
        ("id".to_owned(), Untrusted::Number(7.0)),
        ("width".to_owned(), Untrusted::Number(0.05)),
    ];
    let solid = vec![("kind", text("solid")), ("shape", text("box"))];
    let polygon = vec![
        ("kind", text("solid")),
        ("shape", text("polygon")),
        ("points", text("0,0.1 0.333333,-0.0625 -0.2,1e-3")),
    ];
    let mask = vec![
        ("kind", text("solid")),
        ("shape", text("mask")),
        ("mask", text("8x4:3PSqSo")),
        ("width", Untrusted::Number(0.123)),
    ];
    let solids = Untrusted::List([solid, polygon, mask].map(self::object).into());
    let solids = set(&Settings::default(), "objects", solids);
    assert_eq!(solids.scene().solids().count(), 3);
    let three = after(&two, Change::AddObject(object));
    let fewer = after(&three, Change::RemoveObject(1));
    let none = set(&two, "objects", Untrusted::List(vec![]));
    // A source that is on a solid keeps the id of that solid.
    let on_solid = vec![
        ("kind", text("source")),
        ("shape", text("solid")),
        ("solid", Untrusted::Number(9.0)),
    ];
    let ninth = vec![("kind", text("solid")), ("id", Untrusted::Number(9.0))];
    let burning = Untrusted::List([on_solid, ninth].map(self::object).into());
    let burning = set(&Settings::default(), "objects", burning);
    let source = burning.scene().first_source();
    assert!(source.is_some_and(|source| burning.scene().solid_of(&source).is_some()));
    for settings in [&two, &three, &fewer, &none, &solids, &burning] {
        let back = imported(&export(settings));
        assert_eq!(back.scene(), settings.scene(), "{:?}", export(settings));
    }
    assert_eq!(fewer.scene().power(), 50.0 + 220.0);
}

#[test]
fn ids_of_parameters_name_the_first_of_the_objects_in_any_order() {
    let first = ("fuel_power".to_owned(), Untrusted::Number(100.0));
    let other = ("objects".to_owned(), sources(&[&[("power", 50.0)]]));
    for values in [[first.clone(), other.clone()], [other, first]] {
        let settings = after(&Settings::default(), Change::Set(&values));
        assert_eq!(settings.scene().power(), 100.0);
        let fields = values.map(|(id, value)| match id.as_str() {
            "objects" => ("objects", value),
            id => ("values", object(vec![(id, value)])),
        });
        assert_eq!(imported(&object(fields.to_vec())).scene().power(), 100.0);
    }
    // Without a source there is nothing that it names.
    let none = set(&Settings::default(), "objects", sources(&[]));
    let power = [("fuel_power".to_owned(), Untrusted::Number(100.0))];
    let refused = none.after(&Change::Set(&power)).expect_err("refused");
    assert!(refused[0].message.contains("there is none"), "{refused:?}");
}

#[test]
fn errors_name_the_invalid_object_and_no_object_changes() {
    let far = sources(&[&[], &[("x", 9.0)]]);
    let stone = Untrusted::List(vec![object(vec![("kind", text("stone"))])]);
    for (objects, named) in [
        (
            Untrusted::Number(1.0),
            "objects = 1 is refused: it must be an array of objects",
        ),
        (
            Untrusted::List(vec![Untrusted::Number(1.0)]),
            "objects[0].kind = \"undefined\" is refused: it must be source or solid",
        ),
        (
            stone,
            "objects[0].kind = \"stone\" is refused: it must be source or solid",
        ),
        (
            far,
            "objects[1].x = 9 is refused: it must be a number from -3 to 3 m",
        ),
        (
            sources(&[&[("pwer", 9.0)]]),
            "must be one of name, enabled, shape, solid, x, y, angle, width, power",
        ),
    ] {
        let messages = errors(&object(vec![("objects", objects.clone())]));
        assert!(
            messages.len() == 1 && messages[0].contains(named),
            "{messages:?}"
        );
        let values = &[
            ("wind".to_owned(), Untrusted::Number(1.0)),
            ("objects".to_owned(), objects),
        ];
        assert!(Settings::default().after(&Change::Set(values)).is_err());
    }
    let far = &[("x".to_owned(), text("far"))];
    let Err(invalid) = Settings::default().after(&Change::ChangeObject(1, far)) else {
        panic!("accepted");
    };
    assert_eq!(invalid[0].id, "objects[0].x");
    assert_eq!(invalid[0].value, text("far"));
    assert_eq!(invalid[0].range, Some((-3.0, 3.0)));
    assert!(Settings::default().after(&Change::RemoveObject(9)).is_err());
    let values = object(vec![("values", object(vec![("objects", sources(&[]))]))]);
    assert!(errors(&values)[0].contains("beside the values"));
}

#[test]
fn restoring_the_objects_gives_one_source() {
    let two = set(
        &Settings::default(),
        "objects",
        sources(&[&[("x", 0.2)], &[]]),
    );
    assert_eq!(set(&two, "objects", Untrusted::Null), Settings::default());
}

#[test]
fn a_field_that_is_undefined_states_nothing() {
    let fields = ["hearth", "preset", "values", "objects", "children"];
    let fields = fields.map(|field| (field, Untrusted::Missing));
    assert_eq!(imported(&object(fields.to_vec())), Settings::default());
}
