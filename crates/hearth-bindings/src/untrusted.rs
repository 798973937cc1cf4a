//! Copies of values from JavaScript.
//!
//! Scripts copy the values of a page into plain data (`postable` in
//! `web/element/session/requests.js`, `columns` in `web/sim/values.js`), so no getter of a page runs during
//! a call of wasm. This module makes a tree of it in Rust, which is checked without a browser.

use hearth_core::params::{AnyValue, Input};
use js_sys::{Array, Object, Uint8Array};
use wasm_bindgen::{JsCast, JsValue};

use crate::Record;

/// Deepest nesting of lists and objects.
const MAX_DEPTH: u32 = 6;

/// Most elements of a list and fields of an object; far more than there are parameters.
const MAX_LENGTH: u32 = 1000;

/// Longest text in bytes: that of the largest mask.
const MAX_TEXT_BYTES: usize = 66_000;

/// Most bytes of a saved fire.
const MAX_BYTES: u32 = 65_536;

/// Values by their ids, in the order in which they were sent.
pub type Values<'a> = &'a [(String, Untrusted)];

/// Ids, which are texts after the check.
pub type Ids<'a> = &'a [Untrusted];

/// A value as JavaScript sent it.
#[derive(Clone, Debug, PartialEq)]
pub enum Untrusted {
    /// `undefined`.
    Missing,
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
    /// Copies a number, a text or a flag. Any other value is missing.
    pub fn scalar(value: &JsValue) -> Untrusted {
        if let Some(number) = value.as_f64() {
            return Untrusted::Number(number);
        }
        if let Some(text) = value.as_string() {
            return if text.len() > MAX_TEXT_BYTES {
                Untrusted::Other("a text of more than 66000 letters")
            } else {
                Untrusted::Text(text)
            };
        }
        value.as_bool().map_or(Untrusted::Missing, Untrusted::Flag)
    }

    /// Copies plain data, lists and objects included.
    pub fn of(value: &JsValue) -> Untrusted {
        Untrusted::at_depth(value, 0)
    }

    fn at_depth(value: &JsValue, depth: u32) -> Untrusted {
        let scalar = Untrusted::scalar(value);
        if !scalar.is_missing() || value.is_undefined() {
            return scalar;
        }
        if value.is_null() {
            return Untrusted::Other("null");
        }
        if !value.is_object() || depth == MAX_DEPTH {
            return Untrusted::Other("an object");
        }
        if let Some(bytes) = value.dyn_ref::<Uint8Array>() {
            return if bytes.length() > MAX_BYTES {
                Untrusted::Other("more than 64 KiB")
            } else {
                Untrusted::Bytes(bytes.to_vec())
            };
        }
        let is_list = Array::is_array(value);
        let elements = if is_list {
            value.unchecked_ref::<Array>()
        } else {
            &Object::entries(value.unchecked_ref())
        };
        let length = elements.length();
        if length > MAX_LENGTH {
            return Untrusted::Other("more than a thousand elements");
        }
        let copy = |of: &Array, at| Untrusted::at_depth(&of.get(at), depth + 1);
        if is_list {
            return Untrusted::List((0..length).map(|at| copy(elements, at)).collect());
        }
        let fields = (0..length).map(|at| {
            let field: Array = elements.get(at).unchecked_into();
            (
                field.get(0).as_string().unwrap_or_default(),
                copy(&field, 1),
            )
        });
        Untrusted::Object(fields.collect())
    }

    /// A field with this name.
    pub fn named(name: &str, value: Untrusted) -> (String, Untrusted) {
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

    /// The same value in JavaScript.
    pub fn to_js(&self) -> JsValue {
        match self {
            Untrusted::Missing => JsValue::UNDEFINED,
            Untrusted::Number(number) => (*number).into(),
            Untrusted::Text(text) => text.as_str().into(),
            Untrusted::Flag(on) => (*on).into(),
            Untrusted::List(list) => list.iter().map(Untrusted::to_js).collect::<Array>().into(),
            Untrusted::Object(fields) => {
                let record = Record::new();
                for (name, value) in fields {
                    record.set_any(name, &value.to_js());
                }
                record.into()
            }
            Untrusted::Bytes(_) => "an array".into(),
            Untrusted::Other(words) => (*words).into(),
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
            Untrusted::Other("null"),
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
