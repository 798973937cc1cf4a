//! Copies of values from JavaScript, and values as JavaScript.
//!
//! Scripts copy the values of a page into plain data (`postable` in
//! `web/element/session/requests.js`, `columns` in `web/sim/values.js`), so no getter of a page runs during
//! a call of wasm. This module makes a tree of it in Rust, which is checked without a browser.

use hearth_core::params::Input;
use hearth_core::scene::Scene;
use hearth_settings::untrusted::{
    MAX_BYTES, MAX_DEPTH, MAX_LENGTH, MAX_TEXT_BYTES, Untrusted, ValidationError,
};
use js_sys::{Array, Object, Uint8Array};
use wasm_bindgen::{JsCast, JsValue};

use crate::Record;

/// Copies a number, a text, a flag or `null`. Any other value is missing.
pub fn scalar(value: &JsValue) -> Untrusted {
    if value.is_null() {
        return Untrusted::Null;
    }
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
pub fn copied(value: &JsValue) -> Untrusted {
    at_depth(value, 0)
}

fn at_depth(value: &JsValue, depth: u32) -> Untrusted {
    let scalar = scalar(value);
    if !scalar.is_missing() || value.is_undefined() {
        return scalar;
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
    let copy = |of: &Array, at| at_depth(&of.get(at), depth + 1);
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

/// The same value in JavaScript.
pub fn to_js(value: &Untrusted) -> JsValue {
    match value {
        Untrusted::Missing => JsValue::UNDEFINED,
        Untrusted::Null => JsValue::NULL,
        Untrusted::Number(number) => (*number).into(),
        Untrusted::Text(text) => text.as_str().into(),
        Untrusted::Flag(on) => (*on).into(),
        Untrusted::List(list) => list.iter().map(to_js).collect::<Array>().into(),
        Untrusted::Object(fields) => {
            let record = Record::new();
            for (name, value) in fields {
                record.set_any(name, &to_js(value));
            }
            record.into()
        }
        Untrusted::Bytes(_) => "an array".into(),
        Untrusted::Other(words) => (*words).into(),
    }
}

/// An error as a plain object with id, value and message, and min and max of a number.
pub fn record_of(error: &ValidationError) -> Record {
    let record = Record::new();
    record.set_text("id", &error.id);
    match &error.value {
        Untrusted::Missing | Untrusted::Null => {}
        Untrusted::Number(number) => record.set_number("value", *number),
        Untrusted::Flag(on) => record.set_flag("value", *on),
        other => {
            if let Input::Text(words) = other.input() {
                record.set_text("value", words);
            }
        }
    }
    record.set_text("message", &error.message);
    if let Some((min, max)) = error.range {
        record.set_number("min", min);
        record.set_number("max", max);
    }
    record
}

/// Errors as an array of plain objects.
pub fn records_of(errors: &[ValidationError]) -> Array {
    errors.iter().map(record_of).collect()
}

/// The objects of a scene as plain objects with all of their properties.
pub fn object_records(scene: &Scene) -> Array {
    let records = Array::new();
    for object in scene.objects() {
        let record = Record::new();
        record.set_text("kind", object.kind.name);
        record.set_number("id", object.id.into());
        for (name, _, value) in object.properties() {
            record.set_value(name, value);
        }
        records.push(&record);
    }
    records
}
