//! A fire's settings as plain data, which can be stored, sent and opened again.
//!
//! `{"hearth": 1, "preset": "seed", "values": {"viscosity": 0.02}}` names the preset,
//! where that is not the default one, and what differs from it. Settings hold what a fire
//! burns with and nothing of the device that it burns on. The file of a scene has the
//! same form, with a label and a description for people.

use hearth_bindings::{Argument, Check, Form, Untrusted, ValidationError, Values, settings};
use hearth_core::params::{Input, Model, PARAMETERS, Param, Value};

use crate::requested::{COUNT, Requested};

/// The version of the form.
pub const VERSION: u32 = 1;

/// The fields, and what each must be.
const FIELDS: [(&str, Check); 5] = [
    ("hearth", Check::optional(Form::Any)),
    ("preset", Check::optional(Form::Text)),
    ("values", Check::optional(Form::Values)),
    ("label", Check::optional(Form::Text)),
    ("description", Check::optional(Form::Text)),
];

/// Settings whose form is right. Their values are not checked yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Config<'a> {
    /// The preset.
    pub preset: Option<&'a str>,
    /// What differs from it.
    pub values: Values<'a>,
}

impl<'a> Config<'a> {
    /// Checks the form.
    ///
    /// # Errors
    /// The first field that is not as described above.
    pub fn parse(config: &'a Untrusted) -> Result<Config<'a>, ValidationError> {
        let Untrusted::Object(fields) = config else {
            let allowed = "an object with the fields preset and values";
            return Err(ValidationError::new("config", config, allowed));
        };
        for (name, value) in fields {
            match FIELDS.iter().find(|(known, _)| known == name) {
                Some((_, check)) => check.test(name, value)?,
                None => return Err(unknown_field(name, value)),
            }
        }
        let version = config.field("hearth");
        if !version.is_missing() && version.number() != f64::from(VERSION) {
            let allowed = "1, the version of the form";
            return Err(ValidationError::new("hearth", version, allowed));
        }
        Ok(Config {
            preset: Argument::read(config.field("preset")),
            values: config.field("values").fields(),
        })
    }

    /// What a fire with untrusted settings burns with.
    ///
    /// # Errors
    /// Everything in them that is refused.
    pub fn requested_by(config: &'a Untrusted) -> Result<Requested, Vec<ValidationError>> {
        Config::parse(config)
            .map_err(|error| vec![error])?
            .requested()
    }

    /// What a fire with these settings burns with.
    ///
    /// # Errors
    /// Everything in them that is refused.
    pub fn requested(&self) -> Result<Requested, Vec<ValidationError>> {
        let base = match self.preset {
            Some(name) => Requested::of_preset(name)?,
            None => Requested::default(),
        };
        let parameters = settings::with_values(&base.parameters, self.values)?;
        let named = self.values.iter().any(|(id, _)| id == COUNT);
        Ok(Requested {
            count_overridden: named && parameters.model() == Model::Combustion,
            parameters,
            ..base
        })
    }
}

/// The values of a fire that differ from those of its preset, as far as its model
/// has a use for them: what would have to be set to have it again.
pub fn changed(requested: &Requested) -> Vec<(&'static Param, Value)> {
    let now = &requested.parameters;
    let preset = requested.of_its_preset();
    let mut base = preset.clone();
    if base.model() != now.model() {
        // Another model has other defaults.
        let set = base.set("model", Input::Text(now.model.name()));
        debug_assert_eq!(set, Ok(()));
    }
    let differs = |param: &&Param| {
        let before = if param.id == "model" { &preset } else { &base };
        param.get(now) != param.get(before) || param.id == COUNT && requested.names_count()
    };
    let used = PARAMETERS
        .iter()
        .filter(|param| param.domain(now.model()).is_some());
    used.filter(differs)
        .map(|param| (param, param.get(now)))
        .collect()
}

/// A field that settings have no use for, with the one that may have been meant.
fn unknown_field(name: &str, value: &Untrusted) -> ValidationError {
    let known = "one of hearth, preset, values (parameters stand in values)";
    ValidationError::new(name.get(..40).unwrap_or(name), value, known)
}
