//! Blurs the field of the classic model.

use hearth_core::params::Model;

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Pass};
use crate::shaders::uniforms;

/// Blurs the field.
pub struct Spread;

impl Pass for Spread {
    const TARGET: Image = Image::Wide;
    const DRAW: Draw = Draw::All;
    type Uniforms = uniforms::Spread;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.burns_as(Model::Classic)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Spread {
        // Five reads in each direction, one radius apart, span six radii of a kernel.
        let radius = frame.kernel.radius / frame.viewport.metres[1] * frame.used[1] as f32;
        uniforms::Spread {
            field_used: frame.field_used(),
            read_step: frame.layout.field.map(|side| radius / side as f32),
        }
    }
}
