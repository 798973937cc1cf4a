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
//! `children` are those of the element, and `order` the ids of all objects. Only [whole](crate::whole) settings have
//! them, whose `objects` are those without the children, and `first`, the id of the first object of the preset.
//!
//! `spacing` states the resolution as a length, `particles` as the number of particles that would fill the domain.

use crate::apply::OBJECTS;
use crate::untrusted::{Check, Form, Untrusted, ValidationError, Values};

/// The name of the list of children in whole settings.
pub const CHILDREN: &str = "children";
/// The name of the order of the objects in whole settings.
pub const ORDER: &str = "order";
/// The name of the id of the first object of the preset in whole settings.
pub const FIRST: &str = "first";
/// The version of the format.
pub const VERSION: u32 = 2;

/// The fields and their checks.
const FIELDS: [(&str, Check); 11] = [
    ("hearth", Check::optional(Form::Any)),
    ("preset", Check::optional(Form::Text)),
    ("values", Check::optional(Form::Values)),
    ("classic", Check::optional(Form::Values)),
    ("combustion", Check::optional(Form::Values)),
    (OBJECTS, Check::optional(Form::Any)),
    (CHILDREN, Check::optional(Form::Any)),
    (ORDER, Check::optional(Form::Text)),
    (FIRST, Check::optional(Form::Any)),
    ("label", Check::optional(Form::Text)),
    ("description", Check::optional(Form::Text)),
];

/// Checks the format and returns the fields in their order.
pub(crate) fn fields(config: &Untrusted) -> Result<Values<'_>, ValidationError> {
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

/// The error of a field that settings do not have.
fn unknown_field(name: &str, value: &Untrusted) -> ValidationError {
    let known = "one of hearth, preset, values, objects (parameters stand in values)";
    ValidationError::new(name.get(..40).unwrap_or(name), value, known)
}
