//! The settings file: a fire's settings as plain data, to store, send and open.
//!
//! `{"hearth": 3, "preset": "seed", "values": {"viscosity": 0.02}, "objects": [{"kind":
//! "source", "x": 0.1}]}` holds the preset, unless it is the default, and the differences from
//! it. Settings hold nothing about the device. The file of a scene has the same format, with a
//! label and a description, and that of the community's with an author and a licence.
//!
//! `values` are those of the world, and of the first source by the ids of its properties. `objects` is the whole list;
//! without it, the scene has the objects of the preset. The model comes first, then the objects, then the other values.
//!
//! `children` are those of the element. Only [whole](crate::whole) settings have them, whose `objects` are those without
//! the children.
//!
//! `spacing` states the resolution as a length, `particles` as the number of particles that would fill the domain.

use crate::apply::OBJECTS;
use crate::untrusted::{Check, Form, Untrusted, ValidationError};

/// The name of the list of children in whole settings.
pub const CHILDREN: &str = "children";
/// The name of the number of the list of objects in whole settings.
pub const LIST: &str = "list";
/// The version of the format.
pub const VERSION: u32 = 3;

/// The fields and their checks.
const FIELDS: [(&str, Check); 10] = [
    ("hearth", Check::optional(Form::Any)),
    ("preset", Check::optional(Form::Text)),
    ("values", Check::optional(Form::Values)),
    (OBJECTS, Check::optional(Form::Any)),
    (CHILDREN, Check::optional(Form::Any)),
    (LIST, Check::optional(Form::Finite)),
    ("label", Check::optional(Form::Text)),
    ("description", Check::optional(Form::Text)),
    ("author", Check::optional(Form::Text)),
    ("licence", Check::optional(Form::Text)),
];

/// Checks the format.
pub(crate) fn check(config: &Untrusted) -> Result<(), ValidationError> {
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
    let refused = |(id, value): &&(String, Untrusted)| id == OBJECTS || *value == Untrusted::Null;
    if let Some((id, value)) = values.iter().find(refused) {
        let allowed = match id.as_str() {
            OBJECTS => "beside the values, not among them",
            _ => "a value",
        };
        return Err(ValidationError::new(id, value, allowed));
    }
    Ok(())
}

/// The error of a field that settings do not have.
fn unknown_field(name: &str, value: &Untrusted) -> ValidationError {
    let known = "one of hearth, preset, values, objects (parameters stand in values)";
    ValidationError::new(name, value, known)
}
