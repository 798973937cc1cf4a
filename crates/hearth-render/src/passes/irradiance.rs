//! Computes the irradiance on the backdrop.

use crate::frame::Frame;
use crate::image::Image;
use crate::pass::{Draw, Pass};
use crate::shaders::uniforms;

/// The fire as an area light.
pub struct Irradiance;

impl Pass for Irradiance {
    const KEY: &'static str = "backdrop";
    const TARGET: Image = Image::Irradiance;
    const DRAW: Draw = Draw::All;
    type Uniforms = uniforms::Irradiance;

    fn applies(frame: &Frame) -> bool {
        frame.has_backdrop() || frame.lights_solids()
    }

    fn uniforms(frame: &Frame, _: usize) -> uniforms::Irradiance {
        uniforms::Irradiance {
            size: frame.viewport.heights(),
        }
    }
}
