//! Splats the gas of the combustion model into the field.

use hearth_core::params::Model;

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::kernel::peak;
use crate::pass::{Blend, Draw, Load, Pass};
use crate::shaders::uniforms;

/// Sums the gas's kernels.
pub struct Gas;

impl Pass for Gas {
    const TARGET: Image = Image::Field;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Add;
    const DRAW: Draw = Draw::Particles;
    type Uniforms = uniforms::Gas;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.burns_as(Model::Combustion)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Gas {
        let scale = frame.field_range().map(|range| 1.0 / range);
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
    let [clip_scale, clip_offset] = frame.viewport.to_clip();
    uniforms::Gas {
        clip_scale,
        clip_offset,
        count: frame.particles as f32,
        radius,
        peak: peak(radius),
        velocities,
        field_scale,
    }
}
