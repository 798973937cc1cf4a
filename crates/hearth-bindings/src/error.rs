//! Errors about untrusted values.

use hearth_core::params::{Input, ParamError};
use js_sys::Array;

use crate::{Record, Untrusted};

/// A refused value, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct ValidationError {
    /// The parameter, argument or field.
    pub id: String,
    /// The value that was sent for it, in words where it is no number, text or flag.
    pub value: Untrusted,
    /// The reason: the text names the id, the value and what is allowed.
    pub message: String,
    /// Smallest and largest allowed value of a number.
    pub range: Option<(f64, f64)>,
}

impl ValidationError {
    /// An error that says what is `allowed`.
    // A copy in each of the many callers would cost a kilobyte.
    #[inline(never)]
    pub fn new(id: &str, value: &Untrusted, allowed: &str) -> ValidationError {
        ValidationError {
            id: id.to_owned(),
            value: value.summary(),
            message: format!("{id} = {} is refused: it must be {allowed}", value.input()),
            range: None,
        }
    }

    /// The error of a parameter, with the value that was sent for it.
    pub fn of_parameter(error: &ParamError, value: &Untrusted) -> ValidationError {
        ValidationError {
            id: error.id.clone(),
            value: value.summary(),
            message: error.to_string(),
            range: error.range(),
        }
    }

    /// The error as a plain object: id, value, message and, of a number, min and max.
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
