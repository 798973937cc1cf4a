//! Errors about untrusted values.

use hearth_core::params::{Input, ParamError};
use js_sys::Array;

use crate::{Record, Untrusted};

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
        ValidationError {
            id: id.to_owned(),
            value: value.summary(),
            message: format!("{id} = {} is refused: it must be {allowed}", value.input()),
            range: None,
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

    /// The error as a plain object with id, value and message, and min and max of a number.
    pub fn to_record(&self) -> Record {
        let record = Record::new();
        record.set_text("id", &self.id);
        match &self.value {
            Untrusted::Missing => {}
            Untrusted::Number(number) => record.set_number("value", *number),
            Untrusted::Flag(on) => record.set_flag("value", *on),
            other => {
                if let Input::Text(words) = other.input() {
                    record.set_text("value", words);
                }
            }
        }
        record.set_text("message", &self.message);
        if let Some((min, max)) = self.range {
            record.set_number("min", min);
            record.set_number("max", max);
        }
        record
    }

    /// Errors as an array of plain objects.
    pub fn to_array(errors: &[ValidationError]) -> Array {
        let array = Array::new();
        for error in errors {
            array.push(&error.to_record());
        }
        array
    }
}
