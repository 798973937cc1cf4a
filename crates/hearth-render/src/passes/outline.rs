//! Draws the outlines of solids.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Blend, Draw, Pass};
use crate::shaders::uniforms;

/// Half of the width of an outline [pixels].
const HALF_LINE_PIXELS: f32 = 3.0;

/// The solids of display modes without light.
pub struct Outline;

impl Pass for Outline {
    const TARGET: Image = Image::Picture;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::Solids;
    type Uniforms = uniforms::Outline;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.solids > 0 && !frame.lights_solids()
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Outline {
        let [clip_scale, clip_offset] = frame.viewport.to_clip();
        let pixel_size = frame.pixel();
        uniforms::Outline {
            clip_scale,
            clip_offset,
            first_solid: 0.0,
            count: frame.solids as f32,
            margin: HALF_LINE_PIXELS * pixel_size,
            pixel_size,
        }
    }
}
