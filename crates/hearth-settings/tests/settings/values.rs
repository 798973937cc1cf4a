//! Values of parameters: how changes set and restore them.

use crate::harness::{Sent, number, sent, set, text};
use hearth_core::Parameters;
use hearth_core::params::Model;
use hearth_settings::untrusted::{Untrusted, ValidationError};
use hearth_settings::{Change, Settings};

/// The values of a model.
fn of_model<const N: usize>(model: &str, values: [(&str, Untrusted); N]) -> Sent {
    let mut all = sent([("model", text(model))]);
    all.extend(sent(values));
    all
}

fn ids(errors: &[ValidationError]) -> Vec<&str> {
    errors.iter().map(|error| error.id.as_str()).collect()
}

fn with_values(
    old: &Settings,
    values: &[(String, Untrusted)],
) -> Result<Settings, Vec<ValidationError>> {
    old.after(&Change::Set(values))
}

fn with_defaults<const N: usize>(
    old: &Settings,
    ids: [&str; N],
) -> Result<Settings, Vec<ValidationError>> {
    old.after(&Change::Set(
        &ids.map(|id| (id.to_owned(), Untrusted::Null)),
    ))
}

/// The default settings of a model.
fn default_of(model: Model) -> Settings {
    set(&Settings::default(), "model", text(model.name()))
}

#[test]
fn values_are_set_all_or_none() {
    let old = default_of(Model::Classic);
    let good = sent([("viscosity", number(0.02))]);
    let set = with_values(&old, &good);
    assert_eq!(set.map(|new| new.parameters().viscosity), Ok(0.02));

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

#[test]
fn restoring_a_parameter_sets_its_default_and_no_other() {
    let values = sent([("viscosity", number(0.02)), ("bloom", number(0.5))]);
    let default = default_of(Model::Classic);
    let restored =
        with_values(&default, &values).and_then(|new| with_defaults(&new, ["viscosity"]));
    assert_eq!(
        restored.map(|new| (new.parameters().viscosity, new.parameters().bloom)),
        Ok((default.parameters().viscosity, 0.5))
    );
    assert!(with_defaults(&default, ["heat"]).is_err());
}

#[test]
fn the_model_is_set_before_values_whose_range_depends_on_it() {
    // A parameter of both models with different ranges, and one of each model.
    let sent = of_model(
        "classic",
        [
            ("emission_speed", number(2.5)),
            ("gas_constant", number(1.0)),
        ],
    );
    for model in [Model::Classic, Model::Combustion] {
        let old = default_of(model);
        let new = with_values(&old, &sent);
        let seen = new.map(|new| {
            let speed = new.scene().first_source().map(|source| source.speed);
            (new.scene().model(), speed, new.parameters().gas_constant)
        });
        assert_eq!(seen, Ok((Model::Classic, Some(2.5), 1.0)));

        let mut reversed = sent.clone();
        reversed.reverse();
        assert_eq!(with_values(&old, &reversed), with_values(&old, &sent));

        // That speed is out of range in the other model, which refuses all values.
        let mut other = sent.clone();
        other[0].1 = text("combustion");
        let errors = with_values(&old, &other).expect_err("refused");
        assert_eq!(ids(&errors), ["emission_speed", "gas_constant"]);
    }
}

#[test]
fn the_model_is_restored_before_values_whose_default_depends_on_it() {
    for model in [Model::Classic, Model::Combustion] {
        let old = default_of(model);
        let high = with_values(&old, &sent([("domain_height", number(4.0))]));
        let restored = high.and_then(|high| with_defaults(&high, ["domain_height", "model"]));
        let seen = restored.map(|new| (new.parameters().model(), new.parameters().domain_height));
        let default = Parameters::default();
        assert_eq!(seen, Ok((default.model(), default.domain_height)));
    }
}
