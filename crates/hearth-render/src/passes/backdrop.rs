//! Draws the displayed colours in front of the backdrop.

use crate::frame_uniforms::{FrameUniforms, background, wrapped};
use crate::image::Image;
use crate::noise;
use crate::pass::{Draw, Pass};
use crate::shaders::uniforms;

/// Displacement of the view through hot gas, in heights of the domain.
const BEND_HEIGHT: f32 = 0.035;
/// Waves of the haze per height of the domain.
const WAVES_PER_HEIGHT: f32 = 3.5;

/// Coverage of the wall by soot of opaque smoke, after a long time, and the time in which most of it settles \[s\].
const MAX_STAIN: f32 = 0.7;
const STAIN_SECONDS: f64 = 300.0;

/// Coverage of the wall by soot of opaque smoke at an age of the fire \[s\].
fn stain(time: f64) -> f32 {
    MAX_STAIN * (1.0 - libm::expf(-(time / STAIN_SECONDS) as f32))
}

/// A fire with a backdrop, which the fire illuminates and makes shimmer.
pub struct Backdrop;

impl Pass for Backdrop {
    const TARGET: Image = Image::Plate;
    const DRAW: Draw = Draw::Backdrop;
    type Uniforms = uniforms::Backdrop;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.has_backdrop()
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Backdrop {
        let viewport = &frame.viewport;
        let tiles = WAVES_PER_HEIGHT * viewport.zoom / noise::CELLS as f32;
        let risen = frame.risen / f64::from(viewport.metres[1]);
        let [weight, heat, ..] = frame.field_range();
        uniforms::Backdrop {
            field_used: frame.field_used(),
            field_edge: frame.field_edge(),
            weight_range: [weight, heat],
            haze_tiles: [tiles * viewport.aspect, tiles],
            haze_risen: wrapped(risen * f64::from(tiles)),
            haze_bend: frame.wall() * frame.parameters.heat_haze * BEND_HEIGHT / viewport.zoom,
            light_range: frame.light_on_things(),
            wall: frame.wall(),
            sky: frame.sky(),
            page: frame.page(),
            foot: frame.foot(),
            size: viewport.heights(),
            soot: frame.smoke_opacity() * stain(frame.time),
            background: background(frame.parameters.background),
        }
    }
}
