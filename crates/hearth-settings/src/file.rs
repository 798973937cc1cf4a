//! The settings file: a fire's settings as plain data, to store, send and open.
//!
//! `{"hearth": 2, "preset": "seed", "values": {"viscosity": 0.02}, "objects": [{"kind":
//! "source", "x": 0.1}]}` holds the preset, unless it is the default, and the differences from
//! it. Settings hold nothing about the device. The file of a scene has the same format, with a
//! label and a description.
//!
//! `objects` is the whole list, and missing if it is the preset's. The first source
//! holds its differences from the preset, other objects those from the defaults. `values` may hold
//! parameters of the first source, too: the later of two values of one property wins.
//!
//! `values` without `spacing` state the resolution of open air as the number of particles that would
//! fill the domain: `max_particles` or, without it, that of the preset.

use crate::apply::{OBJECTS, objects, with_settings};
use crate::requested::{COUNT, Requested, SPACING};
use crate::untrusted::{Argument, Check, Form, Untrusted, ValidationError, Values};
use hearth_core::params::{Input, Model, PARAMETERS};
use hearth_core::preset::Preset;
use hearth_core::scene::Kind;

/// The version of the format.
pub const VERSION: u32 = 2;

/// The fields and their checks.
const FIELDS: [(&str, Check); 6] = [
    ("hearth", Check::optional(Form::Any)),
    ("preset", Check::optional(Form::Text)),
    ("values", Check::optional(Form::Values)),
    (OBJECTS, Check::optional(Form::Any)),
    ("label", Check::optional(Form::Text)),
    ("description", Check::optional(Form::Text)),
];

/// Settings in the right format. Their values are not checked yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Config<'a> {
    /// The preset.
    pub preset: Option<&'a str>,
    /// The parameters that differ from it.
    pub values: Values<'a>,
    /// All fields in their order.
    fields: Values<'a>,
}

impl<'a> Config<'a> {
    /// Checks the format.
    ///
    /// # Errors
    /// The first field that does not conform.
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
        if !version.is_missing() && version.number() != f64::from(VERSION) {
            let allowed = format!("{VERSION}, the version of the format");
            return Err(ValidationError::new("hearth", version, &allowed));
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

    /// The request that untrusted settings make.
    ///
    /// # Errors
    /// All their validation errors.
    pub fn requested_by(config: &'a Untrusted) -> Result<Requested, Vec<ValidationError>> {
        Config::parse(config)
            .map_err(|error| vec![error])?
            .requested()
    }

    /// The request that the settings make.
    ///
    /// # Errors
    /// All their validation errors.
    pub fn requested(&self) -> Result<Requested, Vec<ValidationError>> {
        let base = match self.preset {
            Some(name) => Requested::of_preset(name)?,
            None => Requested::default(),
        };
        let scene = with_settings(&base.scene, self.fields)?;
        let combustion = scene.settings().model() == Model::Combustion;
        let sets = |name: &str| combustion && self.values.iter().any(|(id, _)| id == name);
        let mut requested = Requested {
            count_overridden: sets(COUNT),
            spacing_overridden: sets(SPACING),
            scene,
            ..base
        };
        requested.follow_domain();
        Ok(requested)
    }
}

/// Writes settings that [`Config::parse`] reads: the preset and the differences from it.
pub fn export(requested: &Requested) -> Untrusted {
    let now = requested.parameters();
    let preset = &requested.preset().parameters();
    let mut base = preset.clone();
    // Each model has its own defaults.
    let set = base.set("model", Input::Text(now.model.name()));
    debug_assert_eq!(set, Ok(()));
    let has_source = requested
        .scene
        .objects()
        .any(|object| object.is_first_source());
    let mut values = Vec::new();
    for param in PARAMETERS {
        let mut properties = Kind::SOURCE.properties();
        let of_source = has_source && properties.any(|property| property.id == param.id);
        let before = if param.id == "model" { preset } else { &base };
        let value = param.get(now);
        let differs = match param.id {
            // A spacing that follows the domain is not stated.
            SPACING => requested.spacing_overridden,
            COUNT => value != param.get(before) || requested.exports_count(),
            _ => value != param.get(before),
        };
        // The properties of the first source are written with the objects.
        if differs && !of_source && param.domain(now.model()).is_some() {
            values.push(Untrusted::named(param.id, Untrusted::of_value(value)));
        }
    }
    let mut fields = vec![Untrusted::named(
        "hearth",
        Untrusted::Number(VERSION.into()),
    )];
    if requested.preset != Preset::all()[0].name {
        let name = Untrusted::Text(requested.preset.to_owned());
        fields.push(Untrusted::named("preset", name));
    }
    fields.push(Untrusted::named("values", Untrusted::Object(values)));
    let list = objects(&requested.scene, Some(&base));
    let of_preset = requested.preset().scene();
    if list != objects(&of_preset, Some(of_preset.settings())) {
        fields.push(Untrusted::named(OBJECTS, list));
    }
    Untrusted::Object(fields)
}

/// The error of a field that settings do not have.
fn unknown_field(name: &str, value: &Untrusted) -> ValidationError {
    let known = "one of hearth, preset, values, objects (parameters stand in values)";
    ValidationError::new(name.get(..40).unwrap_or(name), value, known)
}
