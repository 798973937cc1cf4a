//! Draws the displayed colours in front of the background.

use hearth_core::params::DisplayMode;

use crate::frame_uniforms::{FrameUniforms, background};
use crate::image::Image;
use crate::pass::{Draw, Load, Pass};
use crate::shaders::uniforms;

/// A fire without a wall, whose ground is drawn over it, and sprites.
pub struct Composite;

impl Pass for Composite {
    const TARGET: Image = Image::Picture;
    const LOAD: Load = Load::Clear;
    const DRAW: Draw = Draw::Halo;
    type Uniforms = uniforms::Composite;

    fn applies(frame: &FrameUniforms) -> bool {
        let fire = frame.shows(DisplayMode::Fire) && !frame.has_wall() && !frame.sheets;
        fire || frame.shows(DisplayMode::Sprites)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Composite {
        uniforms::Composite {
            background: background(frame.parameters.background),
        }
    }
}
