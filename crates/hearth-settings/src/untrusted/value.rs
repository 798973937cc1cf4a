//! A value as it was sent, and lists of such values.

use hearth_core::params::{AnyValue, Input};

/// Deepest nesting of lists and objects.
pub const MAX_DEPTH: u32 = 6;

/// Most elements of a list and fields of an object; far more than there are parameters.
pub const MAX_LENGTH: u32 = 1000;

/// Longest text in bytes: that of the largest mask.
pub const MAX_TEXT_BYTES: usize = 66_000;

/// Most bytes of a saved fire.
pub const MAX_BYTES: u32 = 65_536;

/// Values by their ids, in the order in which they were sent.
pub type Values<'a> = &'a [(String, Untrusted)];

/// A value as it was sent.
#[derive(Clone, Debug, PartialEq)]
pub enum Untrusted {
    /// None: `undefined` in JavaScript. It states nothing.
    Missing,
    /// `null` in JavaScript. It restores what it is the value of.
    Null,
    /// A number, finite or not.
    Number(f64),
    /// A text.
    Text(String),
    /// True or false.
    Flag(bool),
    /// An array.
    List(Vec<Untrusted>),
    /// Bytes.
    Bytes(Vec<u8>),
    /// An object's own fields.
    Object(Vec<(String, Untrusted)>),
    /// Any other value, by its description.
    Other(&'static str),
}

impl Untrusted {
    /// A field of an object: its name and its value.
    pub fn field_of(name: &str, value: Untrusted) -> (String, Untrusted) {
        (name.to_owned(), value)
    }

    /// A checked value.
    pub fn of_value(value: AnyValue<'_>) -> Untrusted {
        match value {
            AnyValue::Flag(on) => Untrusted::Flag(on),
            _ => match value.as_number() {
                Some(number) => Untrusted::Number(number),
                None => Untrusted::Text(format!("{value}")),
            },
        }
    }

    /// Whether the value is missing.
    pub fn is_missing(&self) -> bool {
        matches!(self, Untrusted::Missing)
    }

    /// The fields of an object; empty for any other value.
    pub fn fields(&self) -> Values<'_> {
        match self {
            Untrusted::Object(fields) => fields,
            _ => &[],
        }
    }

    /// The elements of a list; empty for any other value.
    pub fn list(&self) -> &[Untrusted] {
        match self {
            Untrusted::List(elements) => elements,
            _ => &[],
        }
    }

    /// The field with this name, or [`Untrusted::Missing`].
    pub fn field(&self, name: &str) -> &Untrusted {
        self.fields()
            .iter()
            .find(|(known, _)| known == name)
            .map_or(&Untrusted::Missing, |(_, value)| value)
    }

    /// The bytes; empty for any other value.
    pub fn bytes(&self) -> &[u8] {
        match self {
            Untrusted::Bytes(bytes) => bytes,
            _ => &[],
        }
    }

    /// The value for an error: a number, a text or a flag, and a description of any other value.
    pub fn summary(&self) -> Untrusted {
        match self {
            Untrusted::Missing => Untrusted::Missing,
            Untrusted::Null => Untrusted::Null,
            Untrusted::Number(number) => Untrusted::Number(*number),
            Untrusted::Flag(on) => Untrusted::Flag(*on),
            Untrusted::Text(text) => Untrusted::Text(text.clone()),
            Untrusted::List(_) | Untrusted::Bytes(_) => Untrusted::Other("an array"),
            Untrusted::Object(_) => Untrusted::Other("an object"),
            Untrusted::Other(words) => Untrusted::Other(words),
        }
    }

    /// The number; NaN for any other value.
    pub fn number(&self) -> f64 {
        match *self {
            Untrusted::Number(number) => number,
            _ => f64::NAN,
        }
    }

    /// The text; empty for any other value.
    pub fn text(&self) -> &str {
        match self {
            Untrusted::Text(text) => text,
            _ => "",
        }
    }

    /// The value as input of a parameter. A value that is not a number, a text or a flag becomes
    /// a text, which is invalid for every parameter.
    pub fn input(&self) -> Input<'_> {
        match self {
            Untrusted::Number(number) => Input::Number(*number),
            Untrusted::Flag(on) => Input::Flag(*on),
            Untrusted::Text(text) => Input::Text(text),
            Untrusted::Missing => Input::Text("undefined"),
            Untrusted::Null => Input::Text("null"),
            Untrusted::List(_) | Untrusted::Bytes(_) => Input::Text("an array"),
            Untrusted::Object(_) => Input::Text("an object"),
            Untrusted::Other(words) => Input::Text(words),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::Parameters;
    use hearth_core::params::PARAMETERS;

    #[test]
    fn other_values_are_invalid_for_every_parameter() {
        let strange = [
            Untrusted::Missing,
            Untrusted::Number(f64::NAN),
            Untrusted::Number(f64::INFINITY),
            Untrusted::List(vec![Untrusted::Number(1.0)]),
            Untrusted::Object(vec![]),
            Untrusted::Bytes(vec![1]),
            Untrusted::Null,
        ];
        for param in PARAMETERS {
            for value in &strange {
                let mut parameters = Parameters::default();
                let set = parameters.set(param.id, value.input());
                assert!(set.is_err(), "{} = {value:?}", param.id);
            }
        }
    }

    #[test]
    fn only_objects_have_fields() {
        let object = Untrusted::Object(vec![("fire".into(), Untrusted::Number(1.0))]);
        assert_eq!(object.field("fire"), &Untrusted::Number(1.0));
        assert_eq!(object.field("canvas"), &Untrusted::Missing);
        let text = Untrusted::Text("fire".into());
        assert_eq!(text.field("fire"), &Untrusted::Missing);
    }
}
