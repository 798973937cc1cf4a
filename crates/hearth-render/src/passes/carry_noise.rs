//! Carries the advected noise on from a sample to the moment of its slice.

use super::advect_noise::AdvectNoise;
use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Pass, Per};
use crate::shaders::uniforms;

/// The offsets between two samples, with the shaders and uniforms of the advection.
pub struct CarryNoise;

impl Pass for CarryNoise {
    const TARGET: Image = Image::NoiseOffsets;
    const DRAW: Draw = Draw::All;
    const PER: Per = Per::Slice;
    type Uniforms = uniforms::AdvectNoise;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.advects_noise()
    }

    fn uniforms(frame: &FrameUniforms, level: usize) -> uniforms::AdvectNoise {
        AdvectNoise::uniforms(frame, level)
    }
}
