//! Errors about untrusted values.

use super::value::Untrusted;
use hearth_core::params::{ParamError, quoted};

/// An error of an invalid value.
#[derive(Clone, Debug, PartialEq)]
pub struct ValidationError {
    /// The id of the parameter, argument or field.
    pub id: String,
    /// The sent value; its description if it is not a number, a text or a flag.
    pub value: Untrusted,
    /// The message, which names the id, the value and the allowed values.
    pub message: String,
    /// Smallest and largest allowed number.
    pub range: Option<(f64, f64)>,
}

impl ValidationError {
    /// An error that names the `allowed` values.
    pub fn new(id: &str, value: &Untrusted, allowed: &str) -> ValidationError {
        let id = quoted(id);
        ValidationError {
            value: value.summary(),
            message: format!("{id} = {} is refused: it must be {allowed}", value.input()),
            range: None,
            id,
        }
    }

    /// The error of a parameter, with the sent value.
    pub fn of_parameter(error: &ParamError, value: &Untrusted) -> ValidationError {
        ValidationError {
            id: error.id.clone(),
            value: value.summary(),
            message: format!("{error}"),
            range: error.range(),
        }
    }
}
