//! The settings file: a fire's settings as plain data, to store, send and open.
//!
//! `{"hearth": 2, "preset": "seed", "values": {"viscosity": 0.02}, "objects": [{"kind":
//! "source", "x": 0.1}]}` holds the preset, unless it is the default, and the differences from
//! it. Settings hold nothing about the device. The file of a scene has the same format, with a
//! label and a description.
//!
//! `values` are those of the present model, `classic` or `combustion` those that the other model has for
//! itself.
//!
//! `objects` is the whole list, and missing if at most the properties of the first source differ from the
//! preset: they are `values` then. In the list, the first source holds its differences from the preset, other
//! objects those from the defaults. If both state a property of the first source, the later one wins.
//!
//! `values` without `spacing` state the resolution of open air as the number of particles that would
//! fill the domain: `max_particles` or, without it, that of the preset.

use crate::apply::{OBJECTS, objects, of_model, other_model, with_settings};
use crate::settings::{Settings, StatedResolution};
use crate::untrusted::{Argument, Check, Form, Untrusted, ValidationError, Values};
use hearth_core::Scene;
use hearth_core::params::{Model, PARAMETERS};
use hearth_core::preset::Preset;
use hearth_core::scene::Kind;

/// The version of the format.
pub const VERSION: u32 = 2;

/// The fields and their checks.
const FIELDS: [(&str, Check); 8] = [
    ("hearth", Check::optional(Form::Any)),
    ("preset", Check::optional(Form::Text)),
    ("values", Check::optional(Form::Values)),
    ("classic", Check::optional(Form::Values)),
    ("combustion", Check::optional(Form::Values)),
    (OBJECTS, Check::optional(Form::Any)),
    ("label", Check::optional(Form::Text)),
    ("description", Check::optional(Form::Text)),
];

/// Checks the format and returns the fields in their order.
fn fields(config: &Untrusted) -> Result<Values<'_>, ValidationError> {
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
    let values = ["values", "classic", "combustion"].map(|field| config.field(field).fields());
    let refused = |(id, value): &&(String, Untrusted)| id == OBJECTS || *value == Untrusted::Null;
    if let Some((id, value)) = values.into_iter().flatten().find(refused) {
        let allowed = match id.as_str() {
            OBJECTS => "beside the values, not among them",
            _ => "a value",
        };
        return Err(ValidationError::new(id, value, allowed));
    }
    Ok(fields)
}

/// Reads a settings file.
pub(crate) fn read(config: &Untrusted) -> Result<Settings, Vec<ValidationError>> {
    let fields = fields(config).map_err(|error| vec![error])?;
    let base = match Argument::read(config.field("preset")) {
        Some(name) => Settings::of_preset(name)?,
        None => Settings::default(),
    };
    let scene = with_settings(base.scene(), fields)?;
    let combustion = Model::Combustion.name();
    let fields_of_combustion = match scene.settings().model() {
        Model::Combustion => &["values", combustion][..],
        Model::Classic => &[combustion],
    };
    let names = |name: &str| {
        let mut fields = fields_of_combustion.iter();
        fields.any(|field| !config.field(field).field(name).is_missing())
    };
    let resolution = StatedResolution::among(&names).unwrap_or_default();
    Ok(base.with(scene, resolution))
}

/// The values of `model` that differ from the preset, and the stated resolution. With `own`, only those that
/// the other model does not share. Without `source`, no property of the first source.
fn differences(settings: &Settings, model: Model, own: bool, source: bool) -> Untrusted {
    let preset = &settings.preset().parameters();
    let now = &of_model(settings.parameters(), model);
    // Each model has its own defaults.
    let base = &of_model(preset, model);
    let differing = PARAMETERS.iter().filter_map(|param| {
        let mut properties = Kind::SOURCE.properties();
        let of_source = !source && properties.any(|property| property.id == param.id);
        let domain = param.domain(model)?;
        let before = if param.id == "model" { preset } else { base };
        let value = param.get(now);
        let differs = if StatedResolution::is_part(param.id) && model == Model::Combustion {
            settings.states(param.id)
        } else {
            value != param.get(before)
        };
        let is_written = differs && !of_source && (!own || domain.model.is_some());
        is_written.then(|| Untrusted::named(param.id, Untrusted::of_value(value)))
    });
    Untrusted::Object(differing.collect())
}

/// The other objects and the name of the first source, if the preset has them too.
fn has_objects_of_preset(settings: &Settings) -> bool {
    let without_values = |scene: &Scene| objects(scene, Some(scene.settings()));
    without_values(settings.scene()) == without_values(&settings.preset().scene())
}

/// Writes settings as a settings file: the preset and the differences from it.
pub fn export(settings: &Settings) -> Untrusted {
    let now = settings.parameters();
    let number = Untrusted::Number(VERSION.into());
    let mut fields = vec![Untrusted::named("hearth", number)];
    if settings.preset().name != Preset::all()[0].name {
        let name = Untrusted::Text(settings.preset().name.to_owned());
        fields.push(Untrusted::named("preset", name));
    }
    let lists_objects = !has_objects_of_preset(settings);
    let mut objects_now = settings.scene().objects();
    let lists_source = lists_objects && objects_now.any(|object| object.is_first_source());
    let values = differences(settings, now.model(), false, !lists_source);
    fields.push(Untrusted::named("values", values));
    let other = other_model(now.model());
    let values = differences(settings, other, true, true);
    if !values.fields().is_empty() {
        fields.push(Untrusted::named(other.name(), values));
    }
    if lists_objects {
        let base = of_model(&settings.preset().parameters(), now.model());
        let list = objects(settings.scene(), Some(&base));
        fields.push(Untrusted::named(OBJECTS, list));
    }
    Untrusted::Object(fields)
}

/// The error of a field that settings do not have.
fn unknown_field(name: &str, value: &Untrusted) -> ValidationError {
    let known = "one of hearth, preset, values, objects (parameters stand in values)";
    ValidationError::new(name.get(..40).unwrap_or(name), value, known)
}
