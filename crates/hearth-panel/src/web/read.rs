//! Values of JavaScript in the panel's types. A missing property or one of the wrong type counts
//! as empty.

use js_sys::{Array, Object, Reflect};
use wasm_bindgen::prelude::*;

use crate::state::fire::{Entry, Stats};
use crate::state::{ControllerState, CopyForm, Fields};

pub(super) fn value_of(value: &JsValue) -> Option<Entry> {
    let number = value.as_f64().map(Entry::Number);
    let flag = value.as_bool().map(Entry::Flag);
    number
        .or(flag)
        .or_else(|| value.as_string().map(Entry::Text))
}

/// The fields of a list of objects; `None` for anything else.
pub(super) fn objects(list: &JsValue) -> Option<Vec<Fields>> {
    let list: &Array = list.dyn_ref()?;
    let fields = |object: JsValue| -> Fields {
        let names = object.dyn_ref::<Object>().map(Object::keys);
        let names = names.unwrap_or_default();
        let names = names.iter().filter_map(|name| name.as_string());
        names
            .filter_map(|name| {
                let entry = value_of(&property(&object, &name))?;
                Some((name, entry))
            })
            .collect()
    };
    Some(list.iter().map(fields).collect())
}

pub(super) fn stats(value: &JsValue) -> Stats {
    let number = |name| property(value, name).as_f64().unwrap_or_default();
    Stats {
        fps: number("fps"),
        particles: number("particles"),
        asleep: number("asleep"),
        step_ms: number("stepMs"),
        steps_per_frame: number("stepsPerFrame"),
        draw_ms: number("drawMs"),
        slowed: property(value, "slowed").is_truthy(),
        time_scale: number("timeScale"),
        quality: text(value, "quality").unwrap_or_default(),
        reason: text(value, "qualityReason").unwrap_or_default(),
        stages: times(&property(value, "stages")),
        passes: times(&property(value, "passes")),
        on_card: text(value, "passTimer").as_deref() == Some("gpu"),
    }
}

/// Durations by name.
pub(super) fn times(value: &JsValue) -> Vec<(String, f64)> {
    let Some(object) = value.dyn_ref::<Object>() else {
        return Vec::new();
    };
    let names = Object::keys(object);
    names
        .iter()
        .filter_map(|name| name.as_string())
        .map(|name| {
            let time = property(value, &name).as_f64().unwrap_or_default();
            (name, time)
        })
        .collect()
}

/// The state of the panel controller.
pub(super) fn controller_state(state: &JsValue) -> ControllerState {
    let flag = |name| property(state, name).is_truthy();
    ControllerState {
        scene: text(state, "scene").unwrap_or_default(),
        preset: text(state, "preset").unwrap_or_default(),
        compared: text(state, "compared").unwrap_or_default(),
        undo: flag("undo"),
        redo: flag("redo"),
        copies: copy_forms(&property(state, "copies")),
        fullscreen: flag("fullscreen"),
        done: text(state, "done").unwrap_or_default(),
        message: text(state, "message").unwrap_or_default(),
    }
}

fn copy_forms(list: &JsValue) -> Vec<CopyForm> {
    let forms = list.dyn_ref::<Array>().map(Array::iter);
    let form = |form: JsValue| {
        let field = |name| text(&form, name).unwrap_or_default();
        CopyForm {
            name: field("name"),
            button: field("button"),
            hint: field("hint"),
        }
    };
    forms.into_iter().flatten().map(form).collect()
}

/// A property, or `undefined`.
pub(super) fn property(of: &JsValue, name: &str) -> JsValue {
    if of.dyn_ref::<Object>().is_none() {
        return JsValue::UNDEFINED;
    }
    Reflect::get(of, &name.into()).unwrap_or(JsValue::UNDEFINED)
}

pub(super) fn text(of: &JsValue, name: &str) -> Option<String> {
    property(of, name).as_string()
}

pub(super) fn to_js(entry: Entry) -> JsValue {
    match entry {
        Entry::Number(number) => number.into(),
        Entry::Flag(on) => on.into(),
        Entry::Text(text) => text.into(),
    }
}
