//! Draws a measured quantity as discs.

use hearth_core::params::DisplayMode;

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Blend, Draw, Load, Pass};
use crate::shaders::uniforms;

/// Diameter of a disc in spacings.
const DIAMETER_SPACINGS: f32 = 0.8;

/// A disc per particle.
pub struct Disc;

impl Pass for Disc {
    const TARGET: Image = Image::Picture;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::Particles;
    type Uniforms = uniforms::Disc;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.shows(DisplayMode::Particles) || frame.shows(DisplayMode::Neighbours)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Disc {
        let [clip_scale, clip_offset] = frame.viewport.to_clip();
        let pixel = frame.pixel();
        let pixels = (0.5 * DIAMETER_SPACINGS * frame.parameters.spacing() / pixel).max(1.0);
        let [span_from, per_span] = frame.span();
        uniforms::Disc {
            clip_scale,
            clip_offset,
            count: frame.particles.count as f32,
            radius: pixels * pixel,
            reach: 1.0 + 1.0 / pixels,
            // A constant weight instead of a kernel.
            peak: 0.0,
            span_from,
            per_span,
            pixels,
            two_sided: frame.two_sided(),
        }
    }
}
