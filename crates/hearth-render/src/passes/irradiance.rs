//! Computes the irradiance on the backdrop.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Pass};
use crate::shaders::uniforms;

/// The fire as an area light.
pub struct Irradiance;

impl Pass for Irradiance {
    const TARGET: Image = Image::Irradiance;
    const DRAW: Draw = Draw::All;
    type Uniforms = uniforms::Irradiance;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.has_backdrop() || frame.lights_solids()
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Irradiance {
        uniforms::Irradiance {
            size: frame.viewport.heights(),
        }
    }
}
