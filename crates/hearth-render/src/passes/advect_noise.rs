//! The flow to how far it has carried the noise.

use crate::frame::Frame;
use crate::image::Image;
use crate::pass::{Draw, Pass};
use crate::shaders::uniforms;

/// Noise advection. It draws the whole target: the next picture may show fire where this one
/// shows none.
pub struct AdvectNoise;

impl Pass for AdvectNoise {
    const KEY: &'static str = "drift";
    const TARGET: Image = Image::Carried;
    const DRAW: Draw = Draw::All;
    type Uniforms = uniforms::AdvectNoise;

    fn applies(frame: &Frame) -> bool {
        frame.carries_noise()
    }

    fn uniforms(frame: &Frame, _: usize) -> uniforms::AdvectNoise {
        let advection = &frame.motion.advection;
        uniforms::AdvectNoise {
            step_time: frame.viewport.metres.map(|side| advection.elapsed / side),
            kept: advection.kept,
        }
    }
}
