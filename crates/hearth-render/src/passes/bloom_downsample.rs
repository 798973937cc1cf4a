//! Downsamples the light to blurred copies.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Levels, Pass};
use crate::shaders::uniforms;

/// The first half of the bloom.
pub struct BloomDownsample;

impl Pass for BloomDownsample {
    const TARGET: Image = Image::Blur;
    const DRAW: Draw = Draw::All;
    const LEVELS: Levels = Levels::Down;
    type Uniforms = uniforms::BloomDownsample;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.blooms()
    }

    fn uniforms(frame: &FrameUniforms, level: usize) -> uniforms::BloomDownsample {
        uniforms::BloomDownsample {
            // The copies are roots in every format.
            rooted: f32::from(level > 0 || frame.format.is_rooted()),
            texel: frame.layout.blurs()[level].map(|side| 1.0 / side as f32),
        }
    }
}
