//! Events that an engine posts.
//!
//! | type | other fields |
//! |---|---|
//! | `ready` | `fire`; `values`: all of them, as the fire burns; `objects`; `settings`: the [whole](hearth_settings::whole) |
//! | `done` | `fire`, `request`; `value`: the result, if the command has one |
//! | `changed` | `fire`, `source`; `values` that changed; `redo` and `undo`: the [deltas](hearth_settings::delta) to the new settings and back; with children, `objects`: the delta of those that burn, and `children`, all of them |
//! | `refused` | `fire`, `request`; `errors`: id, value, message and, for a number, min and max |
//! | `stats` | `fire`; `stats`: see [`stats`](crate::stats) |
//! | `samples` | `fire`; `samples`: those of a frame, of the left channel, then of the right one |
//! | `lights` | `fire`; `numbers` of the picture before: left, lower, right and upper edge, the light with its place, the [pale](hearth_render::pale) colour, and eight of each ember |
//! | `quality` | `fire`; `requested`: auto or a level; `quality`: the level; `reason` |
//! | `state` | `fire`, `playing` |
//! | `warming` | `fire`: a new fire warms up and replaces the picture then |
//! | `error` | `fire`; `kind`: unsupported, context-lost, load; `message`; `burns`: whether the fire burns nevertheless |
//! | `restored` | `fire`: its lost context is restored |

use hearth_bindings::{Record, values};
use hearth_core::params::PARAMETERS;
use hearth_settings::untrusted::ValidationError;
use hearth_settings::{OBJECTS, Settings, children, delta, export, objects, objects_delta, whole};
use js_sys::Float32Array;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::pacing::quality::Quality;

#[wasm_bindgen]
extern "C" {
    /// The function that delivers an event later. It never throws.
    pub type Post;

    #[wasm_bindgen(method, js_name = call)]
    fn deliver(this: &Post, of: &JsValue, event: &Record);
}

/// Kinds of errors of a fire.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// The browser cannot draw fires.
    Unsupported,
    /// The graphics context is lost. The browser may restore it.
    ContextLost,
    /// There is no memory for the fire.
    Memory,
}

/// Posts the events of an engine.
pub struct Events {
    post: Post,
}

impl Events {
    /// Events go through `post`.
    pub fn new(post: Post) -> Events {
        Events { post }
    }

    /// Posts an event.
    pub fn post(&self, event: &Record) {
        self.post.deliver(&JsValue::UNDEFINED, event);
    }

    /// A new fire has these settings.
    pub fn ready(&self, fire: u32, settings: &Settings) {
        let event = event("ready", fire);
        event.set_object("values", &values_of(settings, None));
        event.set_any(OBJECTS, &values::to_js(&objects(settings.scene())));
        event.set_any("settings", &values::to_js(&whole(settings)));
        self.post(&event);
    }

    /// Settings changed from `old`; posts nothing if they did not.
    pub fn changed(&self, fire: u32, source: &str, old: &Settings, new: &Settings) {
        if new == old {
            return;
        }
        let event = event("changed", fire);
        event.set_text("source", source);
        event.set_object("values", &values_of(new, Some(old)));
        event.set_any("redo", &values::to_js(&delta(old, new)));
        event.set_any("undo", &values::to_js(&delta(new, old)));
        if old.has_children() || new.has_children() {
            event.set_any(
                OBJECTS,
                &values::to_js(&objects_delta(old.scene(), new.scene())),
            );
            event.set_any("children", &values::to_js(&children(new)));
        }
        self.post(&event);
    }

    /// A request is done; 0: no request.
    pub fn done(&self, fire: u32, request: u32) {
        if request != 0 {
            self.post(&answer("done", fire, request));
        }
    }

    /// A request is done and has a result.
    pub fn answer(&self, fire: u32, request: u32, value: &JsValue) {
        let event = answer("done", fire, request);
        event.set_any("value", value);
        self.post(&event);
    }

    /// A request for numbers is done.
    pub fn numbers(&self, fire: u32, request: u32, numbers: &[f32]) {
        self.answer(fire, request, &Float32Array::from(numbers));
    }

    /// A request for the settings is done.
    pub fn config(&self, fire: u32, request: u32, settings: &Settings) {
        self.answer(fire, request, &values::to_js(&export(settings)));
    }

    /// Values or arguments are invalid.
    pub fn refused(&self, fire: u32, request: u32, errors: &[ValidationError]) {
        let event = answer("refused", fire, request);
        event.set_object("errors", &values::records_of(errors));
        self.post(&event);
    }

    /// The statistics of a fire.
    pub fn stats(&self, fire: u32, stats: &Record) {
        let event = event("stats", fire);
        event.set_object("stats", stats);
        self.post(&event);
    }

    /// The samples of a frame.
    pub fn samples(&self, fire: u32, samples: &[f32]) {
        let event = event("samples", fire);
        event.set_any("samples", &Float32Array::from(samples));
        self.post(&event);
    }

    /// The lights of a picture.
    pub fn lights(&self, fire: u32, numbers: &[f32]) {
        let event = event("lights", fire);
        event.set_any("numbers", &Float32Array::from(numbers));
        self.post(&event);
    }

    /// The level of quality or the request for it changed.
    pub fn quality(&self, fire: u32, quality: &Quality) {
        let event = event("quality", fire);
        let requested = quality.requested().map_or("auto", |level| level.name());
        event.set_text("requested", requested);
        event.set_text("quality", quality.level().name());
        event.set_text("reason", quality.reason());
        self.post(&event);
    }

    /// A fire plays or pauses.
    pub fn state(&self, fire: u32, playing: bool) {
        let event = event("state", fire);
        event.set_flag("playing", playing);
        self.post(&event);
    }

    /// A new fire warms up before it is shown.
    pub fn warming(&self, fire: u32) {
        self.post(&event("warming", fire));
    }

    /// A saved fire is damaged; the fire burns without it.
    pub fn warn(&self, fire: u32, message: &str) {
        let event = error(fire, "load", message);
        event.set_flag("burns", true);
        self.post(&event);
    }

    /// A fire cannot be drawn.
    pub fn error(&self, fire: u32, kind: ErrorKind, message: &str) {
        let kind = match kind {
            ErrorKind::Unsupported => "unsupported",
            ErrorKind::ContextLost => "context-lost",
            ErrorKind::Memory => "load",
        };
        self.post(&error(fire, kind, message));
    }

    /// A lost context is restored and the fire is drawn again.
    pub fn restored(&self, fire: u32) {
        self.post(&event("restored", fire));
    }
}

/// The values of what burns that differ from those of `old`.
fn values_of(settings: &Settings, old: Option<&Settings>) -> Record {
    let values = Record::new();
    for param in PARAMETERS {
        let value = settings.scene().value(param);
        if old.is_none_or(|old| old.scene().value(param) != value) {
            values.set_value(param.id, value);
        }
    }
    values
}

fn event(kind: &str, fire: u32) -> Record {
    let event = Record::new();
    event.set_text("type", kind);
    event.set_number("fire", fire.into());
    event
}

fn answer(kind: &str, fire: u32, request: u32) -> Record {
    let answer = event(kind, fire);
    answer.set_number("request", request.into());
    answer
}

fn error(fire: u32, kind: &str, message: &str) -> Record {
    let error = event("error", fire);
    error.set_text("kind", kind);
    error.set_text("message", message);
    error
}
