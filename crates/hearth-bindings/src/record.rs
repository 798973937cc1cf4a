//! Plain JavaScript objects, written field by field.

use hearth_core::params::AnyValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    /// A plain object. A setter per kind of value makes a field one call without a `JsValue`.
    #[wasm_bindgen(extends = js_sys::Object, js_name = Object)]
    #[derive(Clone, Debug)]
    pub type Record;

    /// An empty object.
    #[wasm_bindgen(constructor, js_class = Object)]
    pub fn new() -> Record;

    /// Sets a text.
    #[wasm_bindgen(method, structural, indexing_setter)]
    pub fn set_text(this: &Record, name: &str, text: &str);

    /// Sets a number.
    #[wasm_bindgen(method, structural, indexing_setter)]
    pub fn set_number(this: &Record, name: &str, number: f64);

    /// Sets a flag.
    #[wasm_bindgen(method, structural, indexing_setter)]
    pub fn set_flag(this: &Record, name: &str, on: bool);

    /// Sets any value.
    #[wasm_bindgen(method, structural, indexing_setter)]
    pub fn set_any(this: &Record, name: &str, value: &wasm_bindgen::JsValue);

    /// Sets an object or an array.
    #[wasm_bindgen(method, structural, indexing_setter)]
    pub fn set_object(this: &Record, name: &str, object: &js_sys::Object);
}

impl Record {
    /// Sets the value of a parameter.
    pub fn set_value(&self, name: &str, value: AnyValue<'_>) {
        match value {
            AnyValue::Flag(on) => self.set_flag(name, on),
            _ => match value.as_number() {
                Some(number) => self.set_number(name, number),
                None => self.set_text(name, &format!("{value}")),
            },
        }
    }
}
