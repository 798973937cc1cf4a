//! Light and glow to displayed colours.

use hearth_core::params::{DisplayMode, Layers, Model};

use crate::frame::{Frame, doubled};
use crate::image::Image;
use crate::palette::Tint;
use crate::pass::{Draw, Load, Pass};
use crate::shaders::uniforms;

/// How much more light falls on smoke where it is alone.
const SMOKE_ALONE: f32 = 1.6;
/// How much more of the glow there is where smoke scatters it.
const SCATTERED: f32 = 4.0;

/// The tone map.
pub struct ToneMap;

impl Pass for ToneMap {
    const KEY: &'static str = "develop";
    const TARGET: Image = Image::Shown;
    const LOAD: Load = Load::Clear;
    const DRAW: Draw = Draw::Halo;
    type Uniforms = uniforms::ToneMap;

    fn applies(frame: &Frame) -> bool {
        frame.shows(DisplayMode::Fire)
    }

    fn uniforms(frame: &Frame, _: usize) -> uniforms::ToneMap {
        let parameters = frame.parameters;
        let light_range = frame.format.light_range();
        // Encoded as for the screen: roughly a square root.
        let mut soot = doubled(parameters.exposure.min(0.0)).sqrt();
        if parameters.layers == Layers::Smoke {
            soot *= SMOKE_ALONE;
        }
        let (pale, yellow) = Tint::of(parameters).pale();
        uniforms::ToneMap {
            light_range,
            bloom: light_range * parameters.bloom,
            soot,
            scattered: match parameters.model() {
                Model::Classic => 0.0,
                Model::Combustion => SCATTERED,
            },
            pale,
            yellow,
        }
    }
}
