//! Draws the backdrop in white light.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Pass};
use crate::shaders::uniforms;

/// A wall and a ground, drawn again only when they or their position in the picture change.
pub struct Scenery;

impl Pass for Scenery {
    const TARGET: Image = Image::Scenery;
    const DRAW: Draw = Draw::All;
    type Uniforms = uniforms::Scenery;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.has_backdrop() && frame.scenery_is_stale
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Scenery {
        uniforms::Scenery {
            floor_middle: frame.viewport.floor,
            size: frame.viewport.heights(),
            wall_foot: frame.wall_foot(),
            wall: frame.wall(),
            ground: frame.ground(),
        }
    }
}
