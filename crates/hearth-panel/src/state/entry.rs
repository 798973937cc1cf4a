//! Values that have not been checked.

use hearth_core::params::{AnyValue, Input};

/// An input that has not been checked.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// A number.
    Number(f64),
    /// On or off.
    Flag(bool),
    /// A text, which may spell any kind of value.
    Text(String),
}

impl From<AnyValue<'_>> for Entry {
    fn from(value: AnyValue<'_>) -> Entry {
        match (value.as_number(), value) {
            (Some(number), _) => Entry::Number(number),
            (None, AnyValue::Flag(on)) => Entry::Flag(on),
            (None, value) => Entry::Text(value.to_string()),
        }
    }
}

impl Entry {
    /// The input of the parameter table.
    pub fn input(&self) -> Input<'_> {
        match self {
            Entry::Number(number) => Input::Number(*number),
            Entry::Flag(on) => Input::Flag(*on),
            Entry::Text(text) => Input::Text(text),
        }
    }
}
