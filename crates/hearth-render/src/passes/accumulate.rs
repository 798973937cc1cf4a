//! Accumulates a measured quantity in the field.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::kernel::peak;
use crate::pass::{Blend, Draw, Load, Pass};
use crate::shaders::uniforms;

/// Maximum weight of gas, which a target of eight bits stores as 1.
pub const MAX_WEIGHT: f32 = 1.5;

/// Sums the kernels of a measured quantity.
pub struct Accumulate;

impl Pass for Accumulate {
    const TARGET: Image = Image::Field;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Add;
    const DRAW: Draw = Draw::Particles;
    type Uniforms = uniforms::Accumulate;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.shows_quantity()
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Accumulate {
        let [clip_scale, clip_offset] = frame.viewport.to_clip();
        let radius = frame.kernel.radius;
        let [span_from, per_span] = frame.span();
        uniforms::Accumulate {
            clip_scale,
            clip_offset,
            count: frame.particles.count as f32,
            radius,
            reach: 1.0,
            peak: peak(radius) / MAX_WEIGHT,
            span_from,
            per_span,
        }
    }
}
