//! The table of statistics, which a fire posts a few times a second.
//!
//! Each entry has a name, a type in TypeScript, a doc and an expression for its value. The
//! posted object, the interface `HearthStats` in `web/parameters.d.ts` and the list in
//! `docs/element.md` come from this table.

#[cfg(target_arch = "wasm32")]
use hearth_bindings::Record;

#[cfg(target_arch = "wasm32")]
use crate::fire::Fire;
#[cfg(target_arch = "wasm32")]
use crate::shared_canvas::SharedCanvas;

/// The documentation of a statistic.
#[derive(Clone, Copy, Debug)]
pub struct Stat {
    /// Name in `stats`.
    pub name: &'static str,
    /// Type in TypeScript.
    pub kind: &'static str,
    /// Description.
    pub doc: &'static str,
}

/// Expands the table to [`STATS`] and, in wasm, to the function that fills an object.
macro_rules! stats {
    ($fire:ident, $report:ident, $fuels:ident, $canvas:ident => $(
        $(#[doc = $doc:literal])+
        $name:literal : $kind:literal = $setter:ident($value:expr)
    )+) => {
        /// All statistics.
        pub static STATS: &[Stat] = &[ $( Stat {
            name: $name,
            kind: $kind,
            doc: concat!($($doc),+).trim_ascii(),
        } ),+ ];

        /// The statistics of a fire that is drawn on this canvas.
        #[cfg(target_arch = "wasm32")]
        pub(crate) fn of($fire: &Fire, $canvas: &SharedCanvas) -> Record {
            // The report counts the neighbours again.
            let $report = $fire.simulation.report();
            let $fuels = $fire.simulation.fuel_total().unwrap_or_default();
            let record = Record::new();
            $( record.$setter($name, $value); )+
            record
        }
    };
}

stats! { fire, report, fuels, canvas =>
    /// Pictures per second.
    "fps": "number" = set_number(fire.pacing.fps.fps())
    /// Number of particles.
    "particles": "number" = set_number(fire.simulation.count() as f64)
    /// Share of the air around the fire that is left out, because `max_particles` are reached.
    "asleep": "number" = set_number(report.asleep.unwrap_or(0.0).into())
    /// Number of particles removed because solids left no room, since the fire began.
    "removed": "number" = set_number(fire.simulation.removed().unwrap_or_default().particles as f64)
    /// Number of glowing embers.
    "embers": "number" = set_number(fire.simulation.embers().len() as f64)
    /// Age of the fire [s].
    "time": "number" = set_number(fire.simulation.time())
    /// Power of the combustion [kW/m]; 0 in the classic model.
    "power": "number" = set_number(fire.pacing.averages.power)
    /// Colour of the light as a whole, as `#rrggbb`: of its palette, to the camera's white balance.
    "glow": "string" = set_text(&hearth_render::light_colour(fire.settings().parameters()))
    /// Fuel that is left in solids, as a share; 0 without any.
    "fuelLeft": "number" = set_number(fuels.left)
    /// Whether solids with fuel burn: `burning` if one does. Otherwise `no-oxygen` or `out`, if one went
    /// out because it lacked oxygen or heat; `unlit`; `burnt`, if nothing is left; empty without fuel.
    "fuel": "string" = set_text(fuels.state)
    /// Real-time factor: seconds of fire per second of the clock, averaged over a second.
    "timeScale": "number" = set_number(fire.pacing.real_time.factor())
    /// Whether the fire fell behind the clock in the last second, so that the page stays
    /// responsive.
    "slowed": "boolean" = set_flag(fire.pacing.real_time.slowed())
    /// Simulation steps per picture.
    "stepsPerFrame": "number" = set_number(fire.pacing.averages.steps_per_frame)
    /// Length of a step [s of fire].
    "stepLength": "number" = set_number(fire.pacing.averages.step_length)
    /// Number of substeps that the last step needed to be stable.
    "substeps": "number" = set_number(report.substeps.into())
    /// Time of a step on the processor [ms].
    "stepMs": "number" = set_number(fire.pacing.averages.step_ms())
    /// Time of drawing a picture on the processor [ms].
    "drawMs": "number" = set_number(fire.pacing.averages.draw_ms)
    /// Time per frame of each stage [ms]: `sort`, `density`, `forces` and `integrate` of all
    /// steps, whose sum is `stepMs` × `stepsPerFrame`, and `upload`, which is part of `drawMs`.
    /// Averages over more than a hundred steps hide the coarse clocks of browsers.
    "stages": "Record<'sort' | 'density' | 'forces' | 'integrate' | 'upload', number>" = set_object(&numbers(&fire.pacing.averages.stages()))
    /// Time of each render pass [ms], by name, in drawing order.
    "passes": "Record<string, number>" = set_object(&numbers(fire.presentation.renderer.passes().map_or(&[], |passes| &passes.times)))
    /// What `passes` measures: `gpu`, time on the graphics card, of all passes of a
    /// picture after the results of the one before; `submit`, time of submitting the pass, if the browser offers no timer query.
    "passTimer": "'gpu' | 'submit' | ''" = set_text(fire.presentation.renderer.passes().map_or("", |passes| passes.timer()))
    /// Number of slices of the last picture: fewer than `depth` at low quality, while slices fade in, and where many
    /// fires share their memory.
    "slices": "number" = set_number(fire.presentation.renderer.slices() as f64)
    /// The current level of quality.
    "quality": "'low' | 'medium' | 'high'" = set_text(fire.pacing.quality.level().name())
    /// The reason of that level.
    "qualityReason": "string" = set_text(fire.pacing.quality.reason())
    /// What limits the number of particles: `quality low`, `quality medium`, `quality high`,
    /// `size` or, where more would take too long, `speed`; else empty.
    "limit": "string" = set_text(fire.particle_count().limit.name())
    /// Mean number of neighbours of a particle.
    "neighbours": "number" = set_number(report.mean_neighbours.into())
    /// Quantities of the first and last colour, such as `[0, 2000]`, in the unit of the shown
    /// quantity; `null` if `display_mode` shows none.
    "scale": "[min: number, max: number] | null" = set_object(&scale(fire.measured()))
    /// Number of particles at the speed limit.
    "atSpeedLimit": "number" = set_number(report.speed_limited.into())
    /// Whether the fire is paused.
    "paused": "boolean" = set_flag(!fire.playback.playing)
    /// Format of the render targets.
    "targetFormat": "string" = set_text(canvas.target_format())
}

/// An object of named numbers.
#[cfg(target_arch = "wasm32")]
fn numbers(numbers: &[(&str, f64)]) -> Record {
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
