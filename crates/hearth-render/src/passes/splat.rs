//! Splats the particles of the classic model into the field.

use hearth_core::Parameters;
use hearth_core::params::Model;

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Blend, Draw, Load, Pass};
use crate::shaders::uniforms;

/// Number of overlapping kernels in undisturbed gas at which a kernel weighs 1.
const OVERLAP_OF_UNIT_WEIGHT: f32 = 3.6;

/// Sums the particles' kernels.
pub struct Splat;

impl Pass for Splat {
    const TARGET: Image = Image::Field;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Add;
    const DRAW: Draw = Draw::Particles;
    type Uniforms = uniforms::Splat;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.burns_as(Model::Classic)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Splat {
        let [clip_scale, clip_offset] = frame.viewport.to_clip();
        let radius = frame.kernel.radius;
        uniforms::Splat {
            clip_scale,
            clip_offset,
            count: frame.particles.count as f32,
            radius,
            weight: kernel_weight(radius, frame.parameters),
            field_scale: frame.field_range().map(|range| 1.0 / range),
        }
    }
}

/// Weight of a kernel. Small or few particles weigh more, so that the fire stays dense, but the
/// square root leaves an effect of their size.
fn kernel_weight(radius: f32, parameters: &Parameters) -> f32 {
    let per_area = parameters.rest_density / parameters.particle_mass;
    // The kernel (1 − q²)² covers a third of its circle.
    let overlap = per_area * std::f32::consts::PI / 3.0 * radius * radius;
    (OVERLAP_OF_UNIT_WEIGHT / overlap).sqrt().clamp(0.1, 4.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::RADII_PER_SIZE;

    #[test]
    fn larger_particles_weigh_less_and_cover_more() {
        let parameters = Parameters::new(Model::Classic);
        let cover = |size: f32| {
            let radius = RADII_PER_SIZE * size;
            kernel_weight(radius, &parameters) * radius * radius
        };
        let sizes = [0.01, 0.02, 0.04, 0.08, 0.1];
        for pair in sizes.windows(2) {
            assert!(kernel_weight(pair[1], &parameters) < kernel_weight(pair[0], &parameters));
            assert!(cover(pair[1]) > cover(pair[0]));
        }
    }
}
