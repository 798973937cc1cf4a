//! Values that have not been checked.

use hearth_core::params::Input;

/// An input that has not been checked.
#[derive(Clone, Debug)]
pub enum Entry {
    /// A number.
    Number(f64),
    /// On or off.
    Flag(bool),
    /// A text, which may spell any kind of value.
    Text(String),
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
