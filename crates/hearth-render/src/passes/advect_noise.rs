//! Advects the noise with the flow.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Pass};
use crate::shaders::uniforms;

/// Advances the offsets of the advected noise. It draws the whole target, because the next picture
/// may show fire in any part.
pub struct AdvectNoise;

impl Pass for AdvectNoise {
    const TARGET: Image = Image::NoiseOffsets;
    const DRAW: Draw = Draw::All;
    type Uniforms = uniforms::AdvectNoise;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.advects_noise()
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::AdvectNoise {
        let advection = &frame.motion.advection;
        let [before_scale, before_offset] = frame.viewport.before(frame.before);
        uniforms::AdvectNoise {
            before_scale,
            before_offset,
            step_time: frame.viewport.metres.map(|side| advection.elapsed / side),
            kept: advection.kept,
        }
    }
}
