//! Upsamples the blurred copies and blends them to a glow.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Levels, Pass};
use crate::shaders::uniforms;

/// The second half of the bloom, from the widest to the sharpest copy.
pub struct BloomUpsample;

impl Pass for BloomUpsample {
    const TARGET: Image = Image::Glow;
    const DRAW: Draw = Draw::All;
    const LEVELS: Levels = Levels::Up;
    type Uniforms = uniforms::BloomUpsample;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.blooms()
    }

    fn uniforms(frame: &FrameUniforms, level: usize) -> uniforms::BloomUpsample {
        let shares = frame.layout.limits.sharper_shares;
        uniforms::BloomUpsample {
            texel: frame.layout.blurs()[level + 1].map(|side| 1.0 / side as f32),
            share: shares[shares.len() - 1 - level],
        }
    }
}
