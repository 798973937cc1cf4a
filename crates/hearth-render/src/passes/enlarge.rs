//! Enlarges the lit wall.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Pass};
use crate::shaders::uniforms;

/// A fire before a wall in a picture with more lines than the wall has.
pub struct Enlarge;

impl Pass for Enlarge {
    const TARGET: Image = Image::Picture;
    const DRAW: Draw = Draw::Backdrop;
    type Uniforms = uniforms::Enlarge;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.enlarges()
    }

    fn uniforms(_: &FrameUniforms, _: usize) -> uniforms::Enlarge {
        uniforms::Enlarge {}
    }
}
