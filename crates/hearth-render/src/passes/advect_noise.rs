//! Advects the noise with the flow.

use crate::advection::seconds_moved;
use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Pass, Per};
use crate::shaders::uniforms;

/// Advances the offsets of a slice's noise to the next sample of the history, so the noise depends on no frame
/// rate. It draws the whole target, because the next picture may show fire in any part.
pub struct AdvectNoise;

impl Pass for AdvectNoise {
    const TARGET: Image = Image::AdvectedNoise;
    const DRAW: Draw = Draw::All;
    const PER: Per = Per::Sample;
    type Uniforms = uniforms::AdvectNoise;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.advects_noise()
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::AdvectNoise {
        let [before_scale, before_offset] = frame.viewport.before(frame.before);
        let advected = &frame.advected;
        uniforms::AdvectNoise {
            before_scale,
            before_offset,
            per_metre: frame.viewport.metres.map(|side| 1.0 / side),
            seconds: seconds_moved(advected.kept, advected.elapsed),
            elapsed: advected.elapsed,
            kept: advected.kept,
        }
    }
}
