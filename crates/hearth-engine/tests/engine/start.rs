//! What a new fire starts with.

use crate::harness::{Sent, number, object, sent, text};
use hearth_core::Scene;
use hearth_core::params::{Model, Value};
use hearth_engine::change::{at_first, by_command};
use hearth_engine::commands::{Command, Start};
use hearth_settings::untrusted::{Argument, Untrusted, ValidationError};
use hearth_settings::{Change, Settings, whole};

/// The values of a model.
fn of_model<const N: usize>(model: &str, values: [(&str, Untrusted); N]) -> Sent {
    let mut all = sent([("model", text(model))]);
    all.extend(sent(values));
    all
}

/// The parameters of a new fire, and the errors in its start.
fn starting_values(start: &Untrusted) -> (Scene, Vec<ValidationError>) {
    let (settings, errors) = at_first(&Start::read(start));
    (settings.scene().clone(), errors)
}

/// A start with these values only.
fn start(values: Sent) -> Untrusted {
    object([("values", Untrusted::Object(values))])
}

fn ids(errors: &[ValidationError]) -> Vec<&str> {
    errors.iter().map(|error| error.id.as_str()).collect()
}

#[test]
fn a_new_fire_takes_the_valid_values_beside_an_invalid_one() {
    let values = of_model(
        "classic",
        [("viscosity", number(0.02)), ("bloom", text("much"))],
    );
    let (parameters, errors) = starting_values(&object([
        ("preset", text("no such preset")),
        ("values", Untrusted::Object(values)),
    ]));
    assert_eq!(parameters.world().viscosity, 0.02);
    assert_eq!(parameters.world().bloom, Scene::default().world().bloom);
    assert_eq!(ids(&errors), ["preset", "bloom"]);
}

#[test]
fn the_order_of_values_does_not_change_the_start() {
    let mut sent = of_model(
        "classic",
        [
            ("emission_speed", number(2.5)),
            ("domain_height", number(1.0)),
        ],
    );
    let (parameters, errors) = starting_values(&start(sent.clone()));
    assert_eq!(errors, []);
    assert_eq!(parameters.model(), Model::Classic);
    assert_eq!(
        (
            parameters.get("emission_speed"),
            parameters.get("domain_height")
        ),
        (Some(Value::Number(2.5)), Some(Value::Number(1.0)))
    );
    sent.reverse();
    assert_eq!(starting_values(&start(sent)), (parameters, Vec::new()));
}

#[test]
fn a_model_among_the_values_overrides_that_of_the_preset() {
    let (parameters, errors) = starting_values(&object([
        ("preset", text("classic")),
        ("values", Untrusted::Object(of_model("combustion", []))),
    ]));
    assert_eq!(errors, []);
    assert_eq!(parameters, Scene::default());
}

#[test]
fn a_recreated_fire_has_the_settings_of_its_file() {
    let config = object([
        ("preset", text("candle")),
        ("values", object([("max_particles", number(2000.0))])),
        ("classic", object([("domain_height", number(3.0))])),
    ]);
    let file = object([("config", config.clone())]);
    let (settings, errors) = at_first(&Start::read(&file));
    assert_eq!(errors, []);
    assert_eq!(Ok(settings), Settings::of_file(&config));
}

#[test]
fn import_keeps_the_seed_on_request_unless_the_settings_name_one() {
    let seed = |value: f64| sent([("seed", number(value))]);
    let seventh = Settings::default().after(&Change::Set(&seed(7.0)));
    let seventh = seventh.expect("a seed is valid");
    let imported = |config: &Untrusted, keeps_seed| {
        let command = Command::Import {
            config,
            source: "test",
            keeps_seed,
        };
        let (after, _) = by_command(&seventh, &command, &mut Vec::new())?;
        after.ok()
    };
    let torch = object([("preset", text("torch"))]);
    let third = object([("values", Untrusted::Object(seed(3.0)))]);
    // Whole settings name the seed that their preset has.
    let first = whole(&Settings::default());
    for (config, keeps_seed, expected) in [
        (&torch, None, 1),
        (&torch, Some(true), 7),
        (&third, Some(true), 3),
        (&first, Some(true), 1),
    ] {
        let after = imported(config, keeps_seed).expect("the settings are valid");
        assert_eq!(after.parameters().seed, expected, "{config:?}");
    }
    let torch = imported(&torch, Some(true)).expect("the settings are valid");
    assert_eq!(torch.preset().name, "torch");
}
