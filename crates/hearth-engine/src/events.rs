//! The events that an engine posts.
//!
//! | type | other fields |
//! |---|---|
//! | `ready` | `fire`; `values`: all of them; `ownNumber`, `preset` |
//! | `done` | `fire`, `request`; `value`: the settings, where they were asked for |
//! | `changed` | `fire`, `source`; `values`: those that changed; `anew`: whether the values of every model were replaced; `ownNumber`, `preset` |
//! | `refused` | `fire`, `request`; `errors`: id, value, message and, of a number, min and max |
//! | `stats` | `fire`; `stats`: see [`stats`](crate::stats) |
//! | `quality` | `fire`; `wish`: auto or the requested level; `quality`, `reason`: the level and why |
//! | `state` | `fire`, `playing` |
//! | `warming` | `fire`: the next picture is that of a new fire, which burns first |
//! | `error` | `fire`; `kind`: unsupported, context-lost, load; `message`; `burns`: whether the fire burns all the same |
//! | `restored` | `fire`: its lost context is back |
//!
//! `ownNumber` says whether the number of particles was set and does not follow quality.

use hearth_bindings::settings::{OBJECTS, objects};
use hearth_bindings::{Record, ValidationError};
use hearth_core::params::PARAMETERS;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::config::export;
use crate::quality::Quality;
use crate::requested::Requested;

#[wasm_bindgen]
extern "C" {
    /// What delivers an event, later. It never throws.
    pub type Post;

    #[wasm_bindgen(method, js_name = call)]
    fn deliver(this: &Post, of: &JsValue, event: &Record);
}

/// What went wrong with a fire's picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// The browser cannot draw it at all.
    Unsupported,
    /// The graphics context is lost; it may come back.
    ContextLost,
}

/// The way out of an engine.
pub struct Events {
    post: Post,
}

impl Events {
    /// Events go through `post`.
    pub fn new(post: Post) -> Events {
        Events { post }
    }

    /// Posts an event.
    // A copy in each of the many callers would cost a kilobyte, here and below.
    #[inline(never)]
    pub fn post(&self, event: &Record) {
        self.post.deliver(&JsValue::UNDEFINED, event);
    }

    /// A new fire is there, with these values.
    pub fn ready(&self, fire: u32, requested: &Requested) {
        let event = event("ready", fire);
        self.put_values(&event, requested, None);
        self.post(&event);
    }

    /// Values changed, from those of `old`; nothing is posted where none did. `replaced`:
    /// the values that another model kept are new, too.
    pub fn changed(
        &self,
        fire: u32,
        source: &str,
        replaced: bool,
        old: &Requested,
        new: &Requested,
    ) {
        let event = event("changed", fire);
        event.set_flag("anew", replaced);
        event.set_text("source", source);
        let same = old.preset == new.preset && old.count_overridden == new.count_overridden;
        if self.put_values(&event, new, Some(old)) || replaced || !same {
            self.post(&event);
        }
    }

    /// Puts the requested values into an event, of which `old` has others; whether there
    /// are any.
    fn put_values(&self, event: &Record, requested: &Requested, old: Option<&Requested>) -> bool {
        let values = Record::new();
        let mut any = false;
        for param in PARAMETERS {
            let value = param.get(requested.parameters());
            if old.is_none_or(|old| param.get(old.parameters()) != value) {
                values.set_value(param.id, value);
                any = true;
            }
        }
        event.set_object("values", &values);
        let now = objects(&requested.scene, None);
        if old.is_none_or(|old| objects(&old.scene, None) != now) {
            event.set_any(OBJECTS, &now.to_js());
            any = true;
        }
        event.set_flag("ownNumber", requested.count_overridden);
        event.set_text("preset", requested.preset);
        any
    }

    /// A request was carried out; 0: nobody waits for it.
    pub fn done(&self, fire: u32, request: u32) {
        if request != 0 {
            self.post(&answer("done", fire, request));
        }
    }

    /// A request was carried out, and this is what it asked for.
    pub fn answer(&self, fire: u32, request: u32, value: &JsValue) {
        let event = answer("done", fire, request);
        event.set_any("value", value);
        self.post(&event);
    }

    /// The settings that were asked for.
    pub fn config(&self, fire: u32, request: u32, requested: &Requested) {
        self.answer(fire, request, &export(requested).to_js());
    }

    /// Values or arguments were refused.
    pub fn refused(&self, fire: u32, request: u32, errors: &[ValidationError]) {
        let event = answer("refused", fire, request);
        event.set_object("errors", &ValidationError::to_array(errors));
        self.post(&event);
    }

    /// How a fire is doing.
    pub fn stats(&self, fire: u32, stats: &Record) {
        let event = event("stats", fire);
        event.set_object("stats", stats);
        self.post(&event);
    }

    /// The level of quality or the wish for one changed.
    pub fn quality(&self, fire: u32, quality: &Quality) {
        let event = event("quality", fire);
        let wish = quality.wish().map_or("auto", |level| level.name());
        event.set_text("wish", wish);
        event.set_text("quality", quality.level().name());
        event.set_text("reason", quality.reason());
        self.post(&event);
    }

    /// A fire plays or stands still from now on.
    pub fn state(&self, fire: u32, playing: bool) {
        let event = event("state", fire);
        event.set_flag("playing", playing);
        self.post(&event);
    }

    /// A new fire burns before it is shown.
    pub fn warming(&self, fire: u32) {
        self.post(&event("warming", fire));
    }

    /// A saved fire could not be used; the fire burns without it.
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
        };
        self.post(&error(fire, kind, message));
    }

    /// A lost context is back and the fire is drawn again.
    pub fn restored(&self, fire: u32) {
        self.post(&event("restored", fire));
    }
}

#[inline(never)]
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
