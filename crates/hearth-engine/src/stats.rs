//! The table of statistics: what a fire reports about itself a few times a second.
//!
//! A value of `stats` is stated once: its name, its type in TypeScript, its doc and what
//! it is. From the table come the object that is posted, the interface `HearthStats` in
//! `web/parameters.d.ts` and the list in `docs/element.md`.

#[cfg(target_arch = "wasm32")]
use hearth_bindings::Record;

#[cfg(target_arch = "wasm32")]
use crate::fire::Fire;
#[cfg(target_arch = "wasm32")]
use crate::shared_canvas::SharedCanvas;

/// What a person reads about a value of `stats`.
#[derive(Clone, Copy, Debug)]
pub struct Stat {
    /// Its name.
    pub name: &'static str,
    /// Its type in TypeScript.
    pub kind: &'static str,
    /// What it is.
    pub doc: &'static str,
}

/// Turns the table into [`STATS`] and, in wasm, the function that fills an object.
macro_rules! stats {
    ($fire:ident, $canvas:ident => $(
        $(#[doc = $doc:literal])+
        $name:literal : $kind:literal = $setter:ident($value:expr)
    )+) => {
        /// Every value of `stats`.
        pub static STATS: &[Stat] = &[ $( Stat {
            name: $name,
            kind: $kind,
            doc: concat!($($doc),+).trim_ascii(),
        } ),+ ];

        /// The values of a fire, which is drawn on this canvas.
        #[cfg(target_arch = "wasm32")]
        pub(crate) fn of($fire: &Fire, $canvas: &SharedCanvas) -> Record {
            let record = Record::new();
            $( record.$setter($name, $value); )+
            record
        }
    };
}

stats! { fire, canvas =>
    /// Pictures a second.
    "fps": "number" = set_number(fire.fps.fps())
    /// Particles alive.
    "particles": "number" = set_number(fire.simulation.count() as f64)
    /// Embers that glow.
    "embers": "number" = set_number(fire.simulation.embers().len() as f64)
    /// Age of the fire [s].
    "time": "number" = set_number(fire.simulation.time())
    /// Power of the burning [kW/m]; 0 in the classic model.
    "power": "number" = set_number(fire.averages.power)
    /// Seconds of fire for each second of the clock, of late.
    "timeScale": "number" = set_number(fire.real_time.factor())
    /// Whether it lately fell behind the clock, so that the page would not freeze.
    "slowed": "boolean" = set_flag(fire.real_time.slowed())
    /// Steps of the simulation for each picture.
    "stepsPerFrame": "number" = set_number(fire.averages.steps_per_frame)
    /// Length of a step [s of fire].
    "stepLength": "number" = set_number(fire.averages.step_length)
    /// Parts that stability divided the last step into.
    "substeps": "number" = set_number(fire.simulation.report().substeps.into())
    /// Time that a step takes the processor [ms].
    "stepMs": "number" = set_number(fire.averages.step_ms())
    /// Time that a picture takes the processor [ms].
    "drawMs": "number" = set_number(fire.averages.draw_ms)
    /// What takes how long in a frame [ms]: `sort`, `density`, `forces` and `integrate` of
    /// all its steps, which together are `stepMs` × `stepsPerFrame`, and `upload`, a part of
    /// `drawMs`. A browser's clock may tick only every 0.1 ms; these are averages over a
    /// hundred steps and more, so that does not show.
    "stages": "Record<'sort' | 'density' | 'forces' | 'integrate' | 'upload', number>" = set_object(&fire.averages.stages())
    /// What each pass of the picture takes [ms], by name, in their order.
    "passes": "Record<string, number>" = set_object(&numbers(fire.picture.passes().map_or(&[], |passes| &passes.times)))
    /// The clock of `passes`: `gpu`, the graphics card's, one pass a picture in turn; or
    /// `submit`, where the browser does not lend that one: only how long it took to hand
    /// the pass over.
    "passTimer": "'gpu' | 'submit' | ''" = set_text(fire.picture.passes().map_or("", |passes| passes.timer()))
    /// The quality that it has.
    "quality": "'low' | 'medium' | 'high'" = set_text(fire.quality.level().name())
    /// Why it has that quality.
    "qualityReason": "string" = set_text(fire.quality.reason())
    /// What the number of particles follows from: `quality low`, `quality medium`,
    /// `quality high` or `size`; empty where `max_particles` says it, and in the classic
    /// model.
    "limit": "string" = set_text(fire.limited_by())
    /// Neighbours of a particle, on average.
    "neighbours": "number" = set_number(fire.simulation.report().mean_neighbours.into())
    /// What the first and the last colour of the picture stand for, as `[0, 2000]`, in the
    /// unit of what `display_mode` shows; `null` where that is a fire.
    "scale": "[min: number, max: number] | null" = set_object(&scale(fire.measured()))
    /// Particles at the speed limit.
    "atSpeedLimit": "number" = set_number(fire.simulation.report().speed_limited.into())
    /// Whether it stands still.
    "paused": "boolean" = set_flag(!fire.playing)
    /// The format of the textures that it is drawn into.
    "targetFormat": "string" = set_text(canvas.target_format())
}

/// Numbers by their names.
#[cfg(target_arch = "wasm32")]
pub(crate) fn numbers(numbers: &[(&str, f64)]) -> Record {
    let record = Record::new();
    for (name, number) in numbers {
        record.set_number(name, *number);
    }
    record
}

/// The ends of a range as an array.
#[cfg(target_arch = "wasm32")]
fn scale(ends: Option<[f32; 2]>) -> js_sys::Object {
    use hearth_core::params::Value;
    use wasm_bindgen::{JsCast, JsValue};

    let Some(ends) = ends else {
        return JsValue::NULL.unchecked_into();
    };
    let array = js_sys::Array::new();
    for end in ends {
        array.push(&Value::Number(end).as_number().into());
    }
    array.into()
}
