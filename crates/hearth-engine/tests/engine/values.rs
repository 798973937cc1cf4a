//! Values of parameters: how commands change them, and what a new fire starts with.

use crate::harness::{Sent, number, object, sent, text};
use hearth_core::Parameters;
use hearth_core::params::{Input, Model};
use hearth_engine::change::at_first;
use hearth_engine::commands::Start;
use hearth_settings::Requested;
use hearth_settings::untrusted::{Argument, Untrusted, ValidationError};

/// The values of a model.
fn of_model<const N: usize>(model: &str, values: [(&str, Untrusted); N]) -> Sent {
    let mut all = sent([("model", text(model))]);
    all.extend(sent(values));
    all
}

/// The parameters of a new fire, and the errors in its start.
fn starting_values(start: &Untrusted) -> (Parameters, Vec<ValidationError>) {
    let (requested, errors) = at_first(&Start::read(start));
    (requested.parameters().clone(), errors)
}

/// A start with these values only.
fn start(values: Sent) -> Untrusted {
    object([("values", Untrusted::Object(values))])
}

fn ids(errors: &[ValidationError]) -> Vec<&str> {
    errors.iter().map(|error| error.id.as_str()).collect()
}

fn with_values(
    old: &Parameters,
    values: &[(String, Untrusted)],
) -> Result<Parameters, Vec<ValidationError>> {
    let new = hearth_settings::with_values(&old.clone().into(), values);
    new.map(|scene| scene.settings().clone())
}

fn with_defaults(
    old: &Parameters,
    values: &[(String, Untrusted)],
) -> Result<Parameters, Vec<ValidationError>> {
    let new = hearth_settings::with_defaults(&old.clone().into(), values);
    new.map(|scene| scene.settings().clone())
}

#[test]
fn values_are_set_all_or_none() {
    let old = Parameters::new(Model::Classic);
    let good = sent([("viscosity", number(0.02))]);
    let set = with_values(&old, &good);
    assert_eq!(set.map(|new| new.viscosity), Ok(0.02));

    let mixed = sent([
        ("viscosity", number(0.02)),
        ("bloom", number(99.0)),
        ("viscositty", number(0.02)),
    ]);
    let Err(errors) = with_values(&old, &mixed) else {
        panic!("an invalid value was accepted");
    };
    assert_eq!(ids(&errors), ["bloom", "viscositty"]);
    assert!(errors[0].message.contains("99") && errors[0].range.is_some());
    assert_eq!(errors[0].value, number(99.0));
    assert!(errors[1].message.contains("viscosity"));
}

/// The ids of parameters to restore.
fn named<const N: usize>(ids: [&str; N]) -> Sent {
    sent(ids.map(|id| (id, Untrusted::Missing)))
}

#[test]
fn restoring_a_parameter_sets_its_default_and_no_other() {
    let values = sent([("viscosity", number(0.02)), ("bloom", number(0.5))]);
    let default = Parameters::new(Model::Classic);
    let restored =
        with_values(&default, &values).and_then(|new| with_defaults(&new, &named(["viscosity"])));
    assert_eq!(
        restored.map(|new| (new.viscosity, new.bloom)),
        Ok((default.viscosity, 0.5))
    );
    assert!(with_defaults(&default, &named(["heat"])).is_err());
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
    assert_eq!(parameters.viscosity, 0.02);
    assert_eq!(parameters.bloom, Parameters::default().bloom);
    assert_eq!(ids(&errors), ["preset", "bloom"]);
}

#[test]
fn the_error_of_an_unknown_preset_lists_the_known_names() {
    let errors = Requested::of_preset("sead").expect_err("refused");
    assert!(errors[0].message.contains("one of default, "));
    assert!(errors[0].message.contains("seed") && errors[0].message.contains("\"sead\""));
    for name in ["", "__proto__", &"x".repeat(1000)] {
        let errors = Requested::of_preset(name).expect_err("refused");
        assert!(errors[0].message.len() < 600, "{errors:?}");
    }
}

#[test]
fn the_model_is_set_before_values_whose_range_depends_on_it() {
    // A parameter of both models with different ranges, and one of each model.
    let sent = of_model(
        "classic",
        [
            ("emission_speed", number(2.5)),
            ("gas_constant", number(1.0)),
            ("fuel_power", number(100.0)),
        ],
    );
    for model in [Model::Classic, Model::Combustion] {
        let old = Parameters::new(model);
        let new = with_values(&old, &sent);
        let seen = new.map(|new| (new.model(), new.emission_speed, new.gas_constant));
        assert_eq!(seen, Ok((Model::Classic, 2.5, 1.0)));

        let mut reversed = sent.clone();
        reversed.reverse();
        assert_eq!(with_values(&old, &reversed), with_values(&old, &sent));

        // That speed is out of range in the other model, which refuses all values.
        let mut other = sent.clone();
        other[0].1 = text("combustion");
        let errors = with_values(&old, &other).expect_err("refused");
        assert_eq!(ids(&errors), ["emission_speed"]);
    }
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
        (parameters.emission_speed, parameters.domain_height),
        (2.5, 1.0)
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
    assert_eq!(parameters, Parameters::new(Model::Combustion));
}

#[test]
fn a_recreated_fire_has_the_values_of_both_models() {
    let values =
        |model, height| Untrusted::Object(of_model(model, [("domain_height", number(height))]));
    let (mut parameters, errors) = starting_values(&object([
        ("kept", values("combustion", 3.0)),
        ("values", values("classic", 2.0)),
    ]));
    assert_eq!(errors, []);
    assert_eq!(
        (parameters.model(), parameters.domain_height),
        (Model::Classic, 2.0)
    );
    assert_eq!(parameters.set("model", Input::Text("combustion")), Ok(()));
    assert_eq!(parameters.domain_height, 3.0);
}

#[test]
fn the_model_is_restored_before_values_whose_default_depends_on_it() {
    for model in [Model::Classic, Model::Combustion] {
        let old = Parameters::new(model);
        let high = with_values(&old, &sent([("domain_height", number(4.0))]));
        let ids = named(["domain_height", "model"]);
        let restored = high.and_then(|high| with_defaults(&high, &ids));
        let default = Parameters::default();
        let seen = restored.map(|new| (new.model(), new.domain_height));
        assert_eq!(seen, Ok((default.model(), default.domain_height)));
    }
}
