//! A fire's settings as plain data, which can be stored, sent and opened again.
//!
//! `{"hearth": 2, "preset": "seed", "values": {"viscosity": 0.02}, "objects": [{"kind":
//! "source", "x": 0.1}]}` names the preset, where that is not the default one, and what
//! differs from it. Settings hold what a fire burns with and nothing of the device that it
//! burns on. The file of a scene has the same form, with a label and a description for
//! people.
//!
//! `objects` is the whole list, and left out where it is the preset's one source. Of the
//! first object it holds what differs from the preset, of others what differs from the
//! defaults. Version 1 has no objects: its `values` hold the parameters of its one source,
//! which version 2 reads as well. Of two values for the same property the later one counts.

use hearth_bindings::settings::{self, OBJECTS};
use hearth_bindings::{Argument, Check, Form, Untrusted, ValidationError, Values};
use hearth_core::params::{Input, Model, PARAMETERS};
use hearth_core::preset::PRESETS;
use hearth_core::scene::KINDS;

use crate::requested::{COUNT, Requested};

/// The version of the form.
pub const VERSION: u32 = 2;

/// The fields, and what each must be.
const FIELDS: [(&str, Check); 6] = [
    ("hearth", Check::optional(Form::Any)),
    ("preset", Check::optional(Form::Text)),
    ("values", Check::optional(Form::Values)),
    (OBJECTS, Check::optional(Form::Any)),
    ("label", Check::optional(Form::Text)),
    ("description", Check::optional(Form::Text)),
];

/// Settings whose form is right. Their values are not checked yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Config<'a> {
    /// The preset.
    pub preset: Option<&'a str>,
    /// The values that differ from it.
    pub values: Values<'a>,
    /// All fields, in their order.
    fields: Values<'a>,
}

impl<'a> Config<'a> {
    /// Checks the form.
    ///
    /// # Errors
    /// The first field that is not as described above.
    pub fn parse(config: &'a Untrusted) -> Result<Config<'a>, ValidationError> {
        let Untrusted::Object(fields) = config else {
            let allowed = "an object with the fields preset, values and objects";
            return Err(ValidationError::new("config", config, allowed));
        };
        for (name, value) in fields {
            match FIELDS.iter().find(|(known, _)| known == name) {
                Some((_, check)) => check.test(name, value)?,
                None => return Err(unknown_field(name, value)),
            }
        }
        let version = config.field("hearth");
        if !version.is_missing() && ![1.0, f64::from(VERSION)].contains(&version.number()) {
            let allowed = "1 or 2, the version of the form";
            return Err(ValidationError::new("hearth", version, allowed));
        }
        let values = config.field("values").fields();
        if let Some((id, value)) = values.iter().find(|(id, _)| id == OBJECTS) {
            let allowed = "beside the values, not among them";
            return Err(ValidationError::new(id, value, allowed));
        }
        Ok(Config {
            preset: Argument::read(config.field("preset")),
            values,
            fields,
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
        let scene = settings::with_settings(&base.scene, self.fields)?;
        let named = self.values.iter().any(|(id, _)| id == COUNT);
        Ok(Requested {
            count_overridden: named && scene.settings().model() == Model::Combustion,
            scene,
            ..base
        })
    }
}

/// The settings of a fire, which [`Config::parse`] reads: what has to be set of its preset
/// to have the fire again.
pub fn export(requested: &Requested) -> Untrusted {
    let now = requested.parameters();
    let preset = requested.of_its_preset();
    let preset = preset.settings();
    let mut base = preset.clone();
    // Another model has other defaults.
    let set = base.set("model", Input::Text(now.model.name()));
    debug_assert_eq!(set, Ok(()));
    let has_source = requested.scene.objects().len() > 0;
    let mut values = Vec::new();
    for param in PARAMETERS {
        let mut properties = KINDS.iter().flat_map(|kind| kind.properties);
        let of_source = has_source && properties.any(|one| one.id == param.id);
        let before = if param.id == "model" { preset } else { &base };
        let value = param.get(now);
        let differs = value != param.get(before) || param.id == COUNT && requested.names_count();
        // The first source has its own properties.
        if differs && !of_source && param.domain(now.model()).is_some() {
            values.push(Untrusted::named(param.id, Untrusted::of_value(value)));
        }
    }
    let mut fields = vec![Untrusted::named(
        "hearth",
        Untrusted::Number(VERSION.into()),
    )];
    if requested.preset != PRESETS[0].name {
        let name = Untrusted::Text(requested.preset.to_owned());
        fields.push(Untrusted::named("preset", name));
    }
    fields.push(Untrusted::named("values", Untrusted::Object(values)));
    let objects = settings::objects(&requested.scene, Some(&base));
    // One source without properties is the preset's.
    if !matches!(objects.list(), [one] if one.fields().len() == 1) {
        fields.push(Untrusted::named(OBJECTS, objects));
    }
    Untrusted::Object(fields)
}

/// A field that settings have no use for, with the one that may have been meant.
fn unknown_field(name: &str, value: &Untrusted) -> ValidationError {
    let known = "one of hearth, preset, values, objects (parameters stand in values)";
    ValidationError::new(name.get(..40).unwrap_or(name), value, known)
}
