//! Draws particles as in the original paper.

use hearth_core::params::{DisplayMode, Model};

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::palette::Tint;
use crate::pass::{Blend, Draw, Load, Pass};
use crate::shaders::uniforms;

/// The paper's discs.
pub struct Paper;

impl Pass for Paper {
    const TARGET: Image = Image::Picture;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::Particles;
    type Uniforms = uniforms::Paper;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.shows(DisplayMode::Paper)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Paper {
        let parameters = frame.parameters;
        // The classic model's discs have one size and one colour, as in the paper. Those of the
        // combustion model show the spacing and the temperature of the gas.
        let (size, hottest) = match parameters.model() {
            Model::Classic => (parameters.particle_size, frame.birth_temperature * 1e-3),
            Model::Combustion => (parameters.spacing(), 0.0),
        };
        let radius = 0.5 * size;
        let [clip_scale, clip_offset] = frame.viewport.to_clip();
        let (pale, yellow) = Tint::of(parameters).pale();
        uniforms::Paper {
            clip_scale,
            clip_offset,
            count: frame.particles.count as f32,
            radius,
            pixels: radius / frame.pixel(),
            hottest,
            luminance_exponent: parameters.luminance_exponent,
            gain: frame.gain(),
            pale,
            yellow,
        }
    }
}
