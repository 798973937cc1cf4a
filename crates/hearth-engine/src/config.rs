//! A fire's settings as one small piece of data: to be kept, sent and opened again.
//!
//! `{"hearth": 1, "preset": "seed", "values": {"viscosity": 0.02}}`: the preset it
//! starts from, where that is not the default one, and what differs from it. It
//! holds what a fire burns with and nothing of the device that it burns on. A scene's
//! file is one too: its label and its description are for people.

use hearth_core::params::{Input, Model, PARAMETERS, Param, Value};

use crate::fields::Fields;
use crate::message::{Refused, SentValues, with_values};
use crate::raw::Raw;
use crate::wanted::{NUMBER, Wanted};

/// The version of the form.
pub const VERSION: u32 = 1;

/// The fields that there are.
const FIELDS: [&str; 5] = ["hearth", "preset", "values", "label", "description"];

/// Settings whose form is right. Their values are not checked yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// The preset.
    pub preset: Option<String>,
    /// What differs from it.
    pub values: SentValues,
}

impl Config {
    /// Checks the form.
    ///
    /// # Errors
    /// The first field that is not as described above.
    pub fn parse(raw: &Raw) -> Result<Config, Refused> {
        let Raw::Object(fields) = raw else {
            let allowed = "an object with the fields preset and values";
            return Err(Refused::field("config", raw, allowed));
        };
        for (name, value) in fields {
            if !FIELDS.contains(&name.as_str()) {
                return Err(unknown_field(name, value));
            }
        }
        let mut fields = Fields::of(raw);
        match raw.field("hearth") {
            Raw::Missing => {}
            Raw::Number(version) if *version == f64::from(VERSION) => {}
            _ => fields.refuse("hearth", "1, the version of the form"),
        }
        for words in ["label", "description"] {
            fields.optional_text(words);
        }
        let config = Config {
            preset: fields.optional_text("preset"),
            values: fields.optional_values("values"),
        };
        fields.refused().map_or(Ok(config), Err)
    }

    /// What a fire with these settings burns with.
    ///
    /// # Errors
    /// Everything in them that is refused.
    pub fn wanted(&self) -> Result<Wanted, Vec<Refused>> {
        let base = match &self.preset {
            Some(name) => Wanted::of_preset(name)?,
            None => Wanted::default(),
        };
        let parameters = with_values(&base.parameters, &self.values)?;
        let named = self.values.iter().any(|(id, _)| id == NUMBER);
        Ok(Wanted {
            own_number: named && parameters.model() == Model::Combustion,
            parameters,
            ..base
        })
    }
}

/// The values of a fire that differ from those of its preset, as far as its model
/// has a use for them: what would have to be set to have it again.
pub fn changed(wanted: &Wanted) -> Vec<(&'static Param, Value)> {
    let now = &wanted.parameters;
    let preset = wanted.of_its_preset();
    let mut base = preset.clone();
    if base.model() != now.model() {
        // Another model has other defaults.
        let set = base.set("model", Input::Text(now.model.name()));
        debug_assert_eq!(set, Ok(()));
    }
    let differs = |param: &&Param| {
        let before = if param.id == "model" { &preset } else { &base };
        param.get(now) != param.get(before) || param.id == NUMBER && wanted.names_number()
    };
    let used = PARAMETERS
        .iter()
        .filter(|param| param.domain(now.model()).is_some());
    used.filter(differs)
        .map(|param| (param, param.get(now)))
        .collect()
}

/// A field that settings have no use for, with the one that may have been meant.
fn unknown_field(name: &str, value: &Raw) -> Refused {
    let known = "one of hearth, preset, values (parameters stand in values)";
    Refused::field(name.get(..40).unwrap_or(name), value, known)
}
