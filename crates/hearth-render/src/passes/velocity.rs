//! Splats the velocities of the combustion model into the flow, with the shaders of the gas.

use super::gas::of_gas;
use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Blend, Draw, Load, Pass, Per};
use crate::shaders::uniforms;

/// Sums the gas's velocities.
pub struct Velocity;

impl Pass for Velocity {
    const TARGET: Image = Image::Flow;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Add;
    const DRAW: Draw = Draw::Particles;
    const PER: Per = Per::Sample;
    type Uniforms = uniforms::Gas;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.advects_noise()
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Gas {
        let radius = frame.resolved(frame.kernel.radius, frame.layout.flow[1]);
        of_gas(frame, radius, 1.0, [1.0; 4])
    }
}
