//! Draws the light of the slices behind the front one.

use crate::bounds::Bounds;
use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Blend, Draw, Load, Pass, Per};
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
        frame.slice.index == 0 && frame.behind.is_some() && !frame.sheets
    }

    fn uniforms(_: &FrameUniforms, _: usize) -> uniforms::Behind {
        uniforms::Behind {}
    }
}

/// The light of a slice under those before it, of which an atlas has each alone.
pub struct Under;

impl Pass for Under {
    // The light of the front slice, whatever the slice.
    const TARGET: Image = Image::Sharper;
    const BLEND: Blend = Blend::Under;
    const DRAW: Draw = Draw::Reach;
    const PER: Per = Per::Slice;
    type Uniforms = uniforms::Behind;

    fn applies(frame: &FrameUniforms) -> bool {
        // The front slice knows the bounds of the others; the frame that prepares them all does not.
        let is_front = |bounds: Bounds| frame.slice.index == 0 && bounds.heights != [0.0; 2];
        frame.sheets && frame.behind.is_some_and(|bounds| !is_front(bounds))
    }

    fn uniforms(_: &FrameUniforms, _: usize) -> uniforms::Behind {
        uniforms::Behind {}
    }
}
