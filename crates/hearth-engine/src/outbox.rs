//! The messages that an engine sends.
//!
//! | type | other fields |
//! |---|---|
//! | `ready` | `fire`, `values` and `objects`: all of them; `ownNumber`: whether somebody set the number of particles; `preset` |
//! | `done` | `fire`, `request`, `value`: its settings, where it was asked for them |
//! | `changed` | `fire`, `source`, `values`: only those that changed; `objects`: all, where any changed; `anew`: whether those of every model were replaced; `ownNumber`, `preset` |
//! | `refused` | `fire`, `request`, `source`, `errors`: id, value, message and, where there is a range, min and max |
//! | `stats` | `fire`, `stats`: see [`Stats`] |
//! | `quality` | `fire`, `wish`: auto or as asked for; `quality`, `reason`: what it has and why |
//! | `state` | `fire`, `playing` |
//! | `warming` | `fire`: the next picture is that of a new fire, which burns first |
//! | `error` | `fire`, `kind`: unsupported, context-lost, load; `message`; `burns`: it does all the same |
//! | `restored` | `fire`: its lost context is back |
//!
//! They are collected here and posted when the engine is done with what it was
//! doing: so whoever receives one may send the next at once.

use hearth_core::Parameters;
use hearth_core::params::{PARAMETERS, Value};
use js_sys::{Array, Function, Object, Reflect};
use wasm_bindgen::JsValue;

use crate::config::export;
use crate::message::{Refused, RefusedMessage};
use crate::quality::Quality;
use crate::raw::Raw;
use crate::scene::{OBJECTS, objects};
use crate::wanted::Wanted;

/// What went wrong with a fire's picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trouble {
    /// The browser cannot draw it at all.
    Unsupported,
    /// The graphics context is lost; it may come back.
    ContextLost,
}

/// What a fire says about itself a few times a second.
#[derive(Clone, Debug)]
pub struct Stats<'a> {
    /// Frames a second, smoothed.
    pub fps: f64,
    /// Particles alive.
    pub particles: usize,
    /// Time that a step takes, in ms.
    pub step_ms: f64,
    /// Time that handing a frame to the graphics driver takes, in ms.
    pub draw_ms: f64,
    /// Steps made for each frame.
    pub steps_per_frame: f64,
    /// Parts that the last step was divided into.
    pub substeps: u32,
    /// Neighbours of a particle, on average.
    pub neighbours: f32,
    /// Particles at the speed limit.
    pub at_speed_limit: u32,
    /// Seconds that the fire has burnt.
    pub time: f64,
    /// Whether it stands still.
    pub paused: bool,
    /// Whether steps had to be dropped to keep the page quick.
    pub slowed: bool,
    /// Seconds of fire for each second of the clock, as it lately was.
    pub time_scale: f64,
    /// Length of a step in seconds of fire.
    pub step_length: f64,
    /// Power that burns [kW/m].
    pub power: f64,
    /// Embers that glow.
    pub embers: usize,
    /// Format of the render targets; empty while nothing can be drawn.
    pub target_format: &'static str,
    /// What takes how long in a frame, in ms: the stages of its steps, and sending
    /// the particles to the graphics card.
    pub stages: [(&'static str, f64); 5],
    /// What each pass of the picture takes, in ms.
    pub passes: &'a [(&'static str, f64)],
    /// Whose clock says that: `gpu`, or `submit`.
    pub pass_timer: &'static str,
    /// How much work it makes itself, and why.
    pub quality: &'a Quality,
    /// What the number of particles follows from, in words; empty: somebody set it.
    pub limit: &'a str,
    /// What the first and the last colour of the picture stand for, where they
    /// measure something.
    pub scale: Option<[f32; 2]>,
}

/// Messages that wait to be posted.
#[derive(Debug, Default)]
pub struct Outbox(Vec<JsValue>);

impl Outbox {
    /// Posts all of them, in order. What the receiver throws is its own affair.
    pub fn post(self, post: &Function) {
        for message in self.0 {
            let _ = post.call1(&JsValue::UNDEFINED, &message);
        }
    }

    /// A new fire is there, with these values.
    pub fn ready(&mut self, fire: u32, wanted: &Wanted) {
        let message = about("ready", fire);
        put(&message, "values", &values(wanted.parameters(), |_| true));
        put(&message, OBJECTS, &objects(&wanted.scene, None).to_js());
        put_start(&message, wanted);
        self.0.push(message.into());
    }

    /// A request was carried out.
    pub fn done(&mut self, fire: u32, request: Option<f64>) {
        if let Some(request) = request {
            let message = about("done", fire);
            put(&message, "request", &request.into());
            self.0.push(message.into());
        }
    }

    /// A request was carried out, and this is what it asked for.
    pub fn answer(&mut self, fire: u32, request: Option<f64>, value: &JsValue) {
        let message = about("done", fire);
        if let Some(request) = request {
            put(&message, "request", &request.into());
        }
        put(&message, "value", value);
        self.0.push(message.into());
    }

    /// The settings that were asked for.
    pub fn config(&mut self, fire: u32, request: Option<f64>, wanted: &Wanted) {
        self.answer(fire, request, &export(wanted).to_js());
    }

    /// Values changed; nothing is sent where none did. `anew`: also those that
    /// the model before kept for its return, if there are any, are new.
    pub fn changed(&mut self, fire: u32, source: &str, anew: bool, old: &Wanted, new: &Wanted) {
        let (before, now) = (old.parameters(), new.parameters());
        let (objects_before, objects) = (objects(&old.scene, None), objects(&new.scene, None));
        let changed = |param: &hearth_core::params::Param| param.get(before) != param.get(now);
        if anew
            || old.preset != new.preset
            || old.own_number != new.own_number
            || objects != objects_before
            || PARAMETERS.iter().any(changed)
        {
            let message = about("changed", fire);
            put(&message, "anew", &anew.into());
            put(&message, "source", &source.into());
            put(&message, "values", &values(now, changed));
            if objects != objects_before {
                put(&message, OBJECTS, &objects.to_js());
            }
            put_start(&message, new);
            self.0.push(message.into());
        }
    }

    /// A message or a value was refused.
    pub fn refused(&mut self, refused: RefusedMessage) {
        let message = Object::new();
        put(&message, "type", &"refused".into());
        if let Some(fire) = refused.fire {
            put(&message, "fire", &fire.into());
        }
        if let Some(request) = refused.request {
            put(&message, "request", &request.into());
        }
        put(&message, "source", &refused.source.into());
        let errors: Array = refused.errors.iter().map(error).collect();
        put(&message, "errors", &errors);
        self.0.push(message.into());
    }

    /// How a fire is doing.
    pub fn stats(&mut self, fire: u32, stats: &Stats<'_>) {
        // Numbers and texts apart: so there is no list of JavaScript's values, each of
        // which wants to be let go.
        let object = numbers(&[
            ("fps", stats.fps),
            ("particles", stats.particles as f64),
            ("stepMs", stats.step_ms),
            ("drawMs", stats.draw_ms),
            ("stepsPerFrame", stats.steps_per_frame),
            ("substeps", stats.substeps.into()),
            ("neighbours", stats.neighbours.into()),
            ("atSpeedLimit", stats.at_speed_limit.into()),
            ("time", stats.time),
            ("timeScale", stats.time_scale),
            ("stepLength", stats.step_length),
            ("power", stats.power),
            ("embers", stats.embers as f64),
        ]);
        for (name, text) in [
            ("targetFormat", stats.target_format),
            ("passTimer", stats.pass_timer),
            ("quality", stats.quality.level().name()),
            ("qualityReason", stats.quality.reason()),
            ("limit", stats.limit),
        ] {
            put(&object, name, &text.into());
        }
        put(&object, "paused", &stats.paused.into());
        put(&object, "slowed", &stats.slowed.into());
        put(&object, "stages", &numbers(&stats.stages));
        put(&object, "passes", &numbers(stats.passes));
        put(&object, "scale", &scale(stats.scale));
        let message = about("stats", fire);
        put(&message, "stats", &object);
        self.0.push(message.into());
    }

    /// How much work a fire makes itself, when that or who decides it changed.
    pub fn quality(&mut self, fire: u32, quality: &Quality) {
        let message = about("quality", fire);
        let wish = quality.wish().map_or("auto", |level| level.name());
        put(&message, "wish", &wish.into());
        put(&message, "quality", &quality.level().name().into());
        put(&message, "reason", &quality.reason().into());
        self.0.push(message.into());
    }

    /// Whether a fire plays, when that changed.
    pub fn state(&mut self, fire: u32, playing: bool) {
        let message = about("state", fire);
        put(&message, "playing", &playing.into());
        self.0.push(message.into());
    }

    /// A new fire burns before it is shown.
    pub fn warming(&mut self, fire: u32) {
        self.0.push(about("warming", fire).into());
    }

    /// Something could not be used, and the fire burns without it.
    pub fn complaint(&mut self, fire: u32, words: &str) {
        let message = about("error", fire);
        put(&message, "kind", &"load".into());
        put(&message, "message", &words.into());
        put(&message, "burns", &true.into());
        self.0.push(message.into());
    }

    /// A fire cannot be drawn.
    pub fn error(&mut self, fire: u32, trouble: Trouble, words: &str) {
        let kind = match trouble {
            Trouble::Unsupported => "unsupported",
            Trouble::ContextLost => "context-lost",
        };
        let message = about("error", fire);
        put(&message, "kind", &kind.into());
        put(&message, "message", &words.into());
        self.0.push(message.into());
    }

    /// A lost context is back and the fire is drawn again.
    pub fn restored(&mut self, fire: u32) {
        self.0.push(about("restored", fire).into());
    }
}

// Many callers; a copy in each would be a kilobyte.
#[inline(never)]
fn about(kind: &str, fire: u32) -> Object {
    let message = Object::new();
    put(&message, "type", &kind.into());
    put(&message, "fire", &fire.into());
    message
}

/// Sets a field of a plain object of ours, which cannot fail.
// As above.
#[inline(never)]
fn put(object: &Object, name: &str, value: &JsValue) {
    let _ = Reflect::set(object, &name.into(), value);
}

fn values(parameters: &Parameters, wanted: impl Fn(&hearth_core::params::Param) -> bool) -> Object {
    let object = Object::new();
    for param in PARAMETERS.iter().filter(|param| wanted(param)) {
        put(&object, param.id, &plain(param.get(parameters)));
    }
    object
}

/// What the values started from.
fn put_start(message: &Object, wanted: &Wanted) {
    put(message, "ownNumber", &wanted.own_number.into());
    put(message, "preset", &wanted.preset.into());
}

#[inline(never)]
fn numbers(numbers: &[(&str, f64)]) -> Object {
    let object = Object::new();
    for (name, number) in numbers {
        put(&object, name, &(*number).into());
    }
    object
}

fn scale(ends: Option<[f32; 2]>) -> JsValue {
    ends.map_or(JsValue::NULL, |ends| {
        Array::from_iter(ends.map(|end| plain(Value::Number(end)))).into()
    })
}

fn plain(value: Value) -> JsValue {
    Raw::of_value(value).to_js()
}

fn error(refused: &Refused) -> JsValue {
    let object = Object::new();
    put(&object, "id", &refused.id.as_str().into());
    let value = match &refused.value {
        // Large ones are told by their kind.
        Raw::List(_) => "an array".into(),
        Raw::Object(_) => "an object".into(),
        value => value.to_js(),
    };
    put(&object, "value", &value);
    put(&object, "message", &refused.message.as_str().into());
    if let Some((min, max)) = refused.range {
        put(&object, "min", &min.into());
        put(&object, "max", &max.into());
    }
    object.into()
}
