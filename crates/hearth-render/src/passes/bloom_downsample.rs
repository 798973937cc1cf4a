//! Downsamples the light to blurred copies.

use crate::frame::Frame;
use crate::image::Image;
use crate::pass::{Draw, Levels, Pass};
use crate::shaders::uniforms;

/// The first half of the bloom.
pub struct BloomDownsample;

impl Pass for BloomDownsample {
    const KEY: &'static str = "bloom";
    const TARGET: Image = Image::Blur;
    const DRAW: Draw = Draw::All;
    const LEVELS: Levels = Levels::Down;
    type Uniforms = uniforms::BloomDownsample;

    fn applies(frame: &Frame) -> bool {
        frame.blooms()
    }

    fn uniforms(frame: &Frame, level: usize) -> uniforms::BloomDownsample {
        uniforms::BloomDownsample {
            texel: frame.layout.blurs()[level].map(|side| 1.0 / side as f32),
        }
    }
}
