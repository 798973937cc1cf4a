//! Splats the gas of the combustion model into the field.

use hearth_core::params::Model;

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::kernel::peak;
use crate::pass::{Blend, Draw, Load, Pass, Per};
use crate::shaders::uniforms;

/// Sums the gas's kernels.
pub struct Gas;

impl Pass for Gas {
    const TARGET: Image = Image::Field;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Add;
    const DRAW: Draw = Draw::Particles;
    const PER: Per = Per::Slice;
    type Uniforms = uniforms::Gas;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.burns_as(Model::Combustion)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Gas {
        let share = frame.particles.share;
        let scale = frame.field_range().map(|range| share / range);
        of_gas(frame, frame.kernel.radius, 0.0, scale)
    }
}

/// Uniforms for kernels of a radius \[m\]. `velocities`: 1 for the velocity pass, else 0.
pub fn of_gas(
    frame: &FrameUniforms,
    radius: f32,
    velocities: f32,
    field_scale: [f32; 4],
) -> uniforms::Gas {
    let (slice, batch) = (&frame.slice, &frame.particles);
    let [to_clip, floor] = frame.viewport.to_clip();
    uniforms::Gas {
        row: batch.row.unwrap_or(0) as f32,
        ahead: batch.ahead,
        slice_scale: slice.scale,
        clip_scale: [0, 1].map(|axis| to_clip[axis] * slice.scale[axis]),
        clip_offset: [0, 1].map(|axis| to_clip[axis] * slice.offset[axis] + floor[axis]),
        count: batch.count as f32,
        radius,
        stride: batch.stride as f32,
        peak: peak(radius) * batch.unit * batch.stride as f32,
        velocities,
        field_scale,
    }
}
