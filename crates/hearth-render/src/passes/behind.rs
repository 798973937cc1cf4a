//! Draws the light of the slices behind the front one.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Load, Pass, Per};
use crate::shaders::uniforms;

/// The coarser light of the slices behind, which the light of the front one covers.
pub struct Behind;

impl Pass for Behind {
    const TARGET: Image = Image::Light;
    const LOAD: Load = Load::Clear;
    const DRAW: Draw = Draw::Behind;
    const PER: Per = Per::Slice;
    type Uniforms = uniforms::Behind;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.slice.index == 0 && frame.behind.is_some()
    }

    fn uniforms(_: &FrameUniforms, _: usize) -> uniforms::Behind {
        uniforms::Behind {}
    }
}
