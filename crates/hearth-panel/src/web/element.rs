//! The `<hearth-fire>` element, read through its public API alone, and the desk of
//! the page's script (`web/panel/controller.js`), which does what is wished and can undo it.
//!
//! The desk's methods return promises, the element's events say what changed. A page may use a
//! stand-in with the same API, so nothing here asks for a class, and whatever
//! is missing or of the wrong type counts as nothing.

use std::cell::RefCell;
use std::rc::{Rc, Weak};
use std::time::Duration;

use hearth_core::params::{Input, PARAMETERS, Param, Value};
use js_sys::{Array, Function, Object, Promise, Reflect};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{CustomEvent, Event, EventTarget};

use super::listener::Listener;
use crate::Panel;
use crate::desk::Desk;
use crate::fire::{Command, MODEL, Stats};

/// The fire, as seen from the panel.
pub struct Element {
    fire: JsValue,
    desk: JsValue,
    panel: Rc<RefCell<Panel>>,
    ctx: egui::Context,
    _listeners: Vec<Listener>,
}

impl Element {
    /// Reads everything once and listens from then on.
    pub fn new(
        fire: JsValue,
        desk: JsValue,
        panel: Rc<RefCell<Panel>>,
        ctx: egui::Context,
    ) -> Result<Element, String> {
        let words = |_| "the fire cannot be listened to".to_owned();
        let target: &EventTarget = fire.unchecked_ref();
        let mut listeners = Vec::new();
        let names = [
            "params-change",
            "quality-change",
            "stats",
            "play",
            "pause",
            "ready",
            "restored",
            "error",
        ];
        for name in names {
            let (fire, panel, ctx) = (fire.clone(), Rc::downgrade(&panel), ctx.clone());
            let heard = move |event: Event| {
                if let Some(panel) = panel.upgrade()
                    && let Ok(mut panel) = panel.try_borrow_mut()
                {
                    hear(&mut panel, &fire, name, &event);
                    paint_soon(&ctx);
                }
            };
            listeners.push(Listener::new(target, name, false, heard).map_err(words)?);
        }
        let element = Element {
            fire,
            desk,
            panel,
            ctx,
            _listeners: listeners,
        };
        if let Ok(mut panel) = element.panel.try_borrow_mut() {
            read_desk(&mut panel, &element.desk);
            read_all(&mut panel, &element.fire);
        }
        Ok(element)
    }

    /// Sends a wish; what becomes of it is heard by events, and a refusal is
    /// shown at the parameter's row.
    pub fn send(&self, command: Command) {
        let id = match &command {
            Command::Set(id, _) => Some(*id),
            _ => None,
        };
        if let (Some(id), Ok(mut panel)) = (id, self.panel.try_borrow_mut()) {
            panel.fire.sent(id);
        }
        let answer = self.call(command);
        let (fire, panel) = (self.fire.clone(), Rc::downgrade(&self.panel));
        let ctx = self.ctx.clone();
        spawn_local(async move {
            let refusal = match answer {
                Ok(answer) => JsFuture::from(Promise::resolve(&answer)).await.err(),
                Err(error) => Some(error),
            };
            settle(&panel, &fire, id, refusal);
            paint_soon(&ctx);
        });
    }

    fn call(&self, command: Command) -> Result<JsValue, JsValue> {
        let arguments = Array::new();
        let method = match command {
            Command::Set(id, value) => {
                arguments.push(&JsValue::from_str(id));
                arguments.push(&to_js(value));
                "set"
            }
            Command::Restore(id) => {
                arguments.push(&id.into());
                "restore"
            }
            Command::Remember(memory) => {
                let folded: Array = memory.folded.into_iter().map(JsValue::from_str).collect();
                arguments.push(&folded);
                arguments.push(&memory.times.into());
                "rememberFolds"
            }
            Command::RestoreAll => "restoreAll",
            Command::Quality(name) => {
                arguments.push(&name.into());
                "quality"
            }
            Command::Copy(what) => {
                arguments.push(&what.into());
                "copy"
            }
            Command::Scenes => "scenes",
            Command::Play => "play",
            Command::Pause => "pause",
            Command::Reset => "reset",
            Command::Step => "step",
            Command::Undo => "undo",
            Command::Redo => "redo",
            Command::Paste => "paste",
            Command::Picture => "picture",
            Command::Fullscreen => "fullscreen",
            Command::Help => "help",
        };
        let function: Function = Reflect::get(&self.desk, &method.into())?.dyn_into()?;
        function.apply(&self.desk, &arguments)
    }
}

/// A wish was answered: says why if it was refused, and reads what is so now.
fn settle(
    panel: &Weak<RefCell<Panel>>,
    fire: &JsValue,
    id: Option<&'static str>,
    refusal: Option<JsValue>,
) {
    let Some(panel) = panel.upgrade() else { return };
    let Ok(mut panel) = panel.try_borrow_mut() else {
        return;
    };
    let refusal = refusal.map(|error| text(&error, "message").unwrap_or_default());
    match id {
        Some(id) => {
            if panel.fire.answered(id) {
                let value = property(&property(fire, "params"), id);
                hear_value(&mut panel, fire, id, &value);
            }
            if let Some(refusal) = refusal {
                panel.fire.refusals.insert(id, refusal);
            }
        }
        None => {
            read_all(&mut panel, fire);
            if let Some(refusal) = refusal {
                panel.fire.notice = Some(refusal);
            }
        }
    }
}

fn hear(panel: &mut Panel, fire: &JsValue, name: &str, event: &Event) {
    let detail = event
        .dyn_ref::<CustomEvent>()
        .map_or(JsValue::UNDEFINED, CustomEvent::detail);
    match name {
        "stats" => {
            let stats = stats(&property(fire, "stats"));
            panel.fire.measure(stats);
            panel.fire.quality = text(fire, "quality").unwrap_or_default();
            panel.fire.paused = property(fire, "paused").is_truthy();
        }
        "params-change" => {
            if let Some(id) = text(&detail, "id") {
                hear_value(panel, fire, &id, &property(&detail, "value"));
            }
        }
        "quality-change" => {
            panel.fire.quality = text(fire, "quality").unwrap_or_default();
            panel.fire.stats.quality = text(&detail, "quality").unwrap_or_default();
            panel.fire.stats.reason = text(&detail, "reason").unwrap_or_default();
        }
        "play" => panel.fire.paused = false,
        "pause" => panel.fire.paused = true,
        "error" => {
            let message = text(&detail, "message").unwrap_or_default();
            let id = text(&detail, "id");
            let known = PARAMETERS
                .iter()
                .find(|param| Some(param.id) == id.as_deref());
            match known {
                Some(param) => {
                    panel.fire.refusals.insert(param.id, message);
                }
                None => panel.fire.notice = Some(message),
            }
        }
        _ => {
            panel.fire.notice = None;
            read_all(panel, fire);
        }
    }
}

/// The fire has this value now. Another model has other values as well, also
/// where they are the same as the last one's, of which no event tells.
fn hear_value(panel: &mut Panel, fire: &JsValue, id: &str, value: &JsValue) {
    if id == MODEL {
        read_values(panel, fire);
    } else {
        learn(panel, id, value);
    }
}

/// What the page wants to be shown, and what was kept of the last visit.
fn read_desk(panel: &mut Panel, desk: &JsValue) {
    let only = property(desk, "only");
    if let Some(ids) = only.dyn_ref::<Array>() {
        let ids = ids.iter().filter_map(|id| id.as_string());
        panel.only = Some(ids.filter_map(|id| Param::find(&id)).collect());
    }
    let memory = property(desk, "folds");
    if let Some(folded) = property(&memory, "folded").dyn_ref::<Array>() {
        let names: Vec<String> = folded.iter().filter_map(|name| name.as_string()).collect();
        panel.memory.fold(names.iter().map(String::as_str));
    }
    panel.memory.times = property(&memory, "times").is_truthy();
}

/// The fire started from a scene of these values.
pub(super) fn read_scene(panel: &mut Panel, values: &JsValue) {
    let of = |param: &'static Param| Some((param.id, value_of(&property(values, param.id))?));
    let values: Vec<_> = PARAMETERS.iter().filter_map(of).collect();
    panel
        .fire
        .start_from(values.iter().map(|(id, value)| (*id, value.input())));
}

/// A value as JavaScript has it.
enum Own {
    Number(f64),
    Flag(bool),
    Text(String),
}

impl Own {
    fn input(&self) -> Input<'_> {
        match self {
            Own::Number(number) => Input::Number(*number),
            Own::Flag(on) => Input::Flag(*on),
            Own::Text(text) => Input::Text(text),
        }
    }
}

fn value_of(value: &JsValue) -> Option<Own> {
    let number = value.as_f64().map(Own::Number);
    let flag = value.as_bool().map(Own::Flag);
    number.or(flag).or_else(|| value.as_string().map(Own::Text))
}

fn read_values(panel: &mut Panel, fire: &JsValue) {
    let values = property(fire, "params");
    for param in PARAMETERS {
        learn(panel, param.id, &property(&values, param.id));
    }
}

fn read_all(panel: &mut Panel, fire: &JsValue) {
    read_values(panel, fire);
    panel.fire.paused = property(fire, "paused").is_truthy();
    panel.fire.quality = text(fire, "quality").unwrap_or_default();
    panel.fire.stats = stats(&property(fire, "stats"));
}

fn learn(panel: &mut Panel, id: &str, value: &JsValue) {
    if let Some(own) = value_of(value) {
        panel.fire.learn(id, own.input());
    }
}

fn stats(value: &JsValue) -> Stats {
    let number = |name| property(value, name).as_f64().unwrap_or_default();
    Stats {
        fps: number("fps"),
        particles: number("particles"),
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

/// Times by their names.
fn times(value: &JsValue) -> Vec<(String, f64)> {
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

/// What the page's script says about its desk.
pub(super) fn desk(state: &JsValue) -> Desk {
    let flag = |name| property(state, name).is_truthy();
    Desk {
        scene: text(state, "scene").unwrap_or_default(),
        preset: text(state, "preset").unwrap_or_default(),
        undo: flag("undo"),
        redo: flag("redo"),
        link: flag("link"),
        iframe: flag("iframe"),
        fullscreen: flag("fullscreen"),
        done: text(state, "done").unwrap_or_default(),
        said: text(state, "said").unwrap_or_default(),
    }
}

/// One frame: `request_repaint` would cost two.
pub(super) fn paint_soon(ctx: &egui::Context) {
    ctx.request_repaint_after(Duration::from_millis(1));
}

/// A property, or `undefined` where there is none.
pub(super) fn property(of: &JsValue, name: &str) -> JsValue {
    if of.dyn_ref::<Object>().is_none() {
        return JsValue::UNDEFINED;
    }
    Reflect::get(of, &name.into()).unwrap_or(JsValue::UNDEFINED)
}

fn text(of: &JsValue, name: &str) -> Option<String> {
    property(of, name).as_string()
}

fn to_js(value: Value) -> JsValue {
    match (value, value.as_number()) {
        (_, Some(number)) => JsValue::from_f64(number),
        (Value::Flag(on), None) => JsValue::from_bool(on),
        (_, None) => JsValue::from_str(&value.to_string()),
    }
}
