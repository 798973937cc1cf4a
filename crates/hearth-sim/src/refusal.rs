//! What is refused, as the error that JavaScript catches.

use hearth_core::params::{Input, ParamError};
use hearth_core::simulation::ParticleError;
use js_sys::{Array, Object, RangeError, Reflect};
use wasm_bindgen::JsValue;

/// A value as a script sent it.
pub enum Sent {
    /// A number, not necessarily a finite one.
    Number(f64),
    /// A text, or words for what is no value at all, which no parameter accepts.
    Text(String),
    /// True or false.
    Flag(bool),
}

impl Sent {
    /// Copies a value; what is none of the three becomes words for it.
    pub fn of(value: &JsValue) -> Sent {
        if let Some(x) = value.as_f64() {
            return Sent::Number(x);
        }
        if let Some(on) = value.as_bool() {
            return Sent::Flag(on);
        }
        Sent::Text(value.as_string().unwrap_or_else(|| words(value).to_owned()))
    }

    /// The same as the table of parameters takes it.
    pub fn input(&self) -> Input<'_> {
        match self {
            Sent::Number(x) => Input::Number(*x),
            Sent::Text(text) => Input::Text(text),
            Sent::Flag(on) => Input::Flag(*on),
        }
    }
}

fn words(value: &JsValue) -> &'static str {
    if value.is_undefined() {
        "undefined"
    } else if value.is_null() {
        "null"
    } else if value.is_array() {
        "an array"
    } else if value.is_function() {
        "a function"
    } else if value.is_object() {
        "an object"
    } else if value.is_symbol() {
        "a symbol"
    } else {
        "a big integer"
    }
}

/// A `RangeError` that has the first refusal's id, value and range, and all of
/// them as `errors`. `value_of` gives the value that was sent for an id.
pub fn of_values(errors: &[ParamError], value_of: &dyn Fn(&str) -> JsValue) -> JsValue {
    let all = Array::new();
    for error in errors {
        let one = Object::new();
        put(&one, "message", &error.to_string().into());
        describe(&one, error, value_of);
        all.push(&one);
    }
    let words = errors.first().map(ParamError::to_string);
    let range_error = RangeError::new(&words.unwrap_or_default());
    if let Some(first) = errors.first() {
        describe(&range_error, first, value_of);
    }
    put(&range_error, "errors", &all);
    range_error.into()
}

fn describe(object: &Object, error: &ParamError, value_of: &dyn Fn(&str) -> JsValue) {
    put(object, "id", &error.id.as_str().into());
    put(object, "value", &value_of(&error.id));
    if let Some((min, max)) = error.range() {
        put(object, "min", &min.into());
        put(object, "max", &max.into());
    }
}

/// A `RangeError` about a field that is no parameter.
pub fn of_field(id: &str, value: JsValue, message: &str) -> JsValue {
    let error = RangeError::new(message);
    put(&error, "id", &id.into());
    put(&error, "value", &value);
    error.into()
}

/// A `RangeError` about particles; its `index` is that of the first bad one.
pub fn of_particles(refused: &ParticleError) -> JsValue {
    let error = RangeError::new(&refused.to_string());
    if let Some(index) = refused.index {
        put(&error, "index", &(index as f64).into());
    }
    error.into()
}

/// Sets a field of an object of ours, which cannot fail.
// Many callers; a copy in each would be a kilobyte.
#[inline(never)]
pub fn put(object: &Object, name: &str, value: &JsValue) {
    let _ = Reflect::set(object, &name.into(), value);
}
