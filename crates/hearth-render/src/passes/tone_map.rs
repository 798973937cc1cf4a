//! Maps light and glow to displayed colours.

use hearth_core::params::{DisplayMode, Layers};

use crate::frame_uniforms::{FrameUniforms, background, exp2};
use crate::image::Image;
use crate::palette::Tint;
use crate::pass::{Draw, Load, Pass};
use crate::shaders::uniforms;

/// Factor on the light on smoke that is shown without fire.
const SMOKE_ALONE_LIGHT: f32 = 1.6;
/// Share of the light on smoke that an opaque dark background, or a wall, takes away.
const NIGHT: f32 = 0.65;

/// The tone map.
pub struct ToneMap;

impl Pass for ToneMap {
    const TARGET: Image = Image::Shown;
    const LOAD: Load = Load::Clear;
    const DRAW: Draw = Draw::Halo;
    type Uniforms = uniforms::ToneMap;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.shows(DisplayMode::Fire) && !frame.sheets
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::ToneMap {
        let parameters = frame.parameters;
        let light_range = frame.format.light_range();
        let (pale, yellow) = Tint::of(parameters).pale();
        uniforms::ToneMap {
            light_range,
            rooted: f32::from(frame.format.is_rooted()),
            bloom: light_range * parameters.bloom,
            soot: soot_light(frame),
            pale,
            yellow,
        }
    }
}

/// Light of the sky on soot.
pub fn soot_light(frame: &FrameUniforms) -> f32 {
    let parameters = frame.parameters;
    // The square root approximates the encoding of the screen.
    let mut soot = exp2(parameters.exposure.min(0.0)).sqrt();
    if parameters.layers == Layers::Smoke {
        soot *= SMOKE_ALONE_LIGHT;
    }
    let [r, g, b, cover] = background(parameters.background);
    let bright = r.max(g).max(b) + 1.0 - cover;
    soot * (1.0 - NIGHT * (1.0 - bright * (1.0 - frame.wall())))
}
