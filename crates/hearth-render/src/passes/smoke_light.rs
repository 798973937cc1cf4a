//! Lights smoke by the fire and the sky, through the smoke between.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::palette::Tint;
use crate::pass::{Draw, Pass};
use crate::shaders::uniforms;
use hearth_core::params::DisplayMode;

/// Extinction of opaque smoke that is as deep as the source is wide, times that width.
const EXTINCTION: f32 = 3.0;

/// The light on smoke.
pub struct SmokeLight;

impl Pass for SmokeLight {
    const TARGET: Image = Image::SmokeLight;
    const DRAW: Draw = Draw::All;
    type Uniforms = uniforms::SmokeLight;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.shows(DisplayMode::Fire) && frame.smoke_opacity() > 0.0
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::SmokeLight {
        let parameters = frame.parameters;
        let (pale, yellow) = Tint::of(parameters).pale();
        uniforms::SmokeLight {
            light_range: frame.format.light_range(),
            size: frame.viewport.heights(),
            extinction: EXTINCTION * parameters.domain_height / frame.source.width,
            pale,
            yellow,
        }
    }
}
