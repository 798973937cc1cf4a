//! Draws the outlines of solids.

use crate::frame::Frame;
use crate::image::Image;
use crate::pass::{Blend, Draw, Pass};
use crate::shaders::uniforms;

/// Half of the width of an outline [pixels].
const MARGIN: f32 = 3.0;

/// The solids of display modes without light.
pub struct Outline;

impl Pass for Outline {
    const KEY: &'static str = "outlines";
    const TARGET: Image = Image::Picture;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::Solids;
    type Uniforms = uniforms::Outline;

    fn applies(frame: &Frame) -> bool {
        frame.solids > 0 && !frame.lights_solids()
    }

    fn uniforms(frame: &Frame, _: usize) -> uniforms::Outline {
        let [clip_scale, clip_offset] = frame.viewport.to_clip();
        let pixel_size = frame.pixel();
        uniforms::Outline {
            clip_scale,
            clip_offset,
            count: frame.solids as f32,
            margin: MARGIN * pixel_size,
            pixel_size,
        }
    }
}
