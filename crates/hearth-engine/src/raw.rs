//! What somebody sent, before any of it is believed.
//!
//! A message comes from JavaScript, where every field may be missing or of any
//! type, a getter may throw and an object may contain itself. It is copied into
//! [`Raw`], a small tree of plain data, and only that tree is checked. So the
//! checks need no browser, and no code of the page runs while they do.

use hearth_core::params::{Input, Value};
use wasm_bindgen::{JsCast, JsValue};

/// Deepest nesting that a message has use for: `{config: {objects: [{property: value}]}}`.
const DEEPEST: u32 = 4;

/// Most fields or elements; far more than there are parameters.
const LONGEST: u32 = 1000;

/// Longest text that anything has use for, in UTF-16 units.
const LONGEST_TEXT: u32 = 1000;

/// Most bytes of a kept fire.
const LONGEST_BYTES: u32 = 65_536;

/// A piece of a message.
#[derive(Clone, Debug, PartialEq)]
pub enum Raw {
    /// `undefined`: the field is not there.
    Missing,
    /// A number, not necessarily a finite one.
    Number(f64),
    /// A text.
    Text(String),
    /// True or false.
    Flag(bool),
    /// An array.
    List(Vec<Raw>),
    /// Bytes.
    Bytes(Vec<u8>),
    /// An object's own fields.
    Object(Vec<(String, Raw)>),
    /// Something that no message has use for, in words.
    Other(&'static str),
}

impl Raw {
    /// Copies a JavaScript value.
    pub fn of(value: &JsValue) -> Raw {
        Raw::at_depth(value, 0)
    }

    fn at_depth(value: &JsValue, depth: u32) -> Raw {
        if value.is_undefined() {
            return Raw::Missing;
        }
        if value.is_null() {
            return Raw::Other("null");
        }
        if let Some(x) = value.as_f64() {
            return Raw::Number(x);
        }
        if let Some(text) = value.dyn_ref::<js_sys::JsString>() {
            if text.length() > LONGEST_TEXT {
                return Raw::Other("a text of more than a thousand letters");
            }
            return Raw::Text(text.into());
        }
        if let Some(on) = value.as_bool() {
            return Raw::Flag(on);
        }
        if !value.is_object() || depth == DEEPEST {
            return Raw::Other(Raw::words(value));
        }
        if let Some(bytes) = value.dyn_ref::<js_sys::Uint8Array>() {
            if bytes.length() > LONGEST_BYTES {
                return Raw::Other("more than 64 KiB");
            }
            return Raw::Bytes(bytes.to_vec());
        }
        let copy = |key: &JsValue| match js_sys::Reflect::get(value, key) {
            Ok(field) => Raw::at_depth(&field, depth + 1),
            Err(_) => Raw::Other("unreadable"),
        };
        if let Some(list) = value.dyn_ref::<js_sys::Array>() {
            let length = list.length();
            if length > LONGEST {
                return Raw::Other("an array of more than a thousand elements");
            }
            return Raw::List((0..length).map(|at| copy(&at.into())).collect());
        }
        let Ok(keys) = js_sys::Reflect::own_keys(value) else {
            return Raw::Other("unreadable");
        };
        if keys.length() > LONGEST {
            return Raw::Other("an object of more than a thousand fields");
        }
        let fields = keys
            .iter()
            .filter_map(|key| Some((key.as_string()?, copy(&key))));
        Raw::Object(fields.collect())
    }

    fn words(value: &JsValue) -> &'static str {
        if value.is_object() {
            "an object"
        } else if value.is_function() {
            "a function"
        } else if value.is_symbol() {
            "a symbol"
        } else {
            "a big integer"
        }
    }

    /// A field of that name.
    #[inline(never)]
    pub fn named(name: &str, value: Raw) -> (String, Raw) {
        (name.to_owned(), value)
    }

    /// A text.
    #[inline(never)]
    pub fn text(text: &str) -> Raw {
        Raw::Text(text.to_owned())
    }

    /// A checked value.
    #[inline(never)]
    pub fn of_value(value: Value) -> Raw {
        match value {
            Value::Flag(on) => Raw::Flag(on),
            _ => match value.as_number() {
                Some(number) => Raw::Number(number),
                None => Raw::Text(value.to_string()),
            },
        }
    }

    /// The same as JavaScript has it.
    pub fn to_js(&self) -> JsValue {
        match self {
            Raw::Missing => JsValue::UNDEFINED,
            Raw::Number(x) => (*x).into(),
            Raw::Text(text) => text.as_str().into(),
            Raw::Flag(on) => (*on).into(),
            Raw::List(list) => list
                .iter()
                .map(Raw::to_js)
                .collect::<js_sys::Array>()
                .into(),
            Raw::Bytes(_) => "an array".into(),
            Raw::Object(fields) => {
                let object = js_sys::Object::new();
                for (name, value) in fields {
                    // An object of ours takes every field.
                    let _ = js_sys::Reflect::set(&object, &name.into(), &value.to_js());
                }
                object.into()
            }
            Raw::Other(words) => (*words).into(),
        }
    }

    /// The field of that name; [`Raw::Missing`] where there is none.
    pub fn field(&self, name: &str) -> &Raw {
        match self {
            Raw::Object(fields) => fields
                .iter()
                .find(|(known, _)| known == name)
                .map_or(&Raw::Missing, |(_, value)| value),
            _ => &Raw::Missing,
        }
    }

    /// The same as the table of parameters takes it. What is no number, text or
    /// flag becomes words that no parameter accepts, so the refusal names them.
    pub fn input(&self) -> Input<'_> {
        match self {
            Raw::Number(x) => Input::Number(*x),
            Raw::Text(text) => Input::Text(text),
            Raw::Flag(on) => Input::Flag(*on),
            Raw::Missing => Input::Text("undefined"),
            Raw::List(_) | Raw::Bytes(_) => Input::Text("an array"),
            Raw::Object(_) => Input::Text("an object"),
            Raw::Other(words) => Input::Text(words),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::Parameters;
    use hearth_core::params::PARAMETERS;

    #[test]
    fn what_is_no_value_is_refused_by_every_parameter() {
        let strange = [
            Raw::Missing,
            Raw::Number(f64::NAN),
            Raw::Number(f64::INFINITY),
            Raw::List(vec![Raw::Number(1.0)]),
            Raw::Object(vec![]),
            Raw::Other("null"),
            Raw::Other("a function"),
            Raw::Other("unreadable"),
        ];
        for param in PARAMETERS {
            for raw in &strange {
                let mut parameters = Parameters::default();
                let refused = parameters.set(param.id, raw.input());
                assert!(refused.is_err(), "{} = {raw:?}", param.id);
            }
        }
    }

    #[test]
    fn a_field_of_something_else_is_missing() {
        let object = Raw::Object(vec![("fire".into(), Raw::Number(1.0))]);
        assert_eq!(object.field("fire"), &Raw::Number(1.0));
        assert_eq!(object.field("canvas"), &Raw::Missing);
        assert_eq!(Raw::Text("fire".into()).field("fire"), &Raw::Missing);
    }
}
