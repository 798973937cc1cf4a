//! Draws the light of embers.

use hearth_core::params::{Layers, Model};

use super::solid::SOLID_LUMINANCE_EXPONENT;
use crate::frame_uniforms::{FrameUniforms, wrapped};
use crate::image::Image;
use crate::pass::{Blend, Draw, Pass};
use crate::shaders::uniforms;

/// Brightness of an ember relative to gas of the same temperature: an ember is solid.
const RELATIVE_BRIGHTNESS: f32 = 12.0;
/// Minimum radius of a spark in texels of the light.
const MIN_RADIUS_TEXELS: f32 = 2.2;

/// Sparks behind the flame. In front of it they would look like dots.
pub struct Ember;

impl Pass for Ember {
    const TARGET: Image = Image::Light;
    const BLEND: Blend = Blend::Under;
    const DRAW: Draw = Draw::Embers;
    type Uniforms = uniforms::Ember;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.burns_as(Model::Combustion)
            && frame.parameters.layers != Layers::Smoke
            && !frame.sheets
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Ember {
        let [clip_scale, clip_offset] = frame.viewport.to_clip();
        let texel = frame.viewport.metres[1] / frame.layout.light[1] as f32;
        uniforms::Ember {
            clip_scale,
            clip_offset,
            count: frame.embers as f32,
            largest: frame.parameters.ember_size,
            time: wrapped(frame.time),
            smallest: MIN_RADIUS_TEXELS * texel,
            gain: RELATIVE_BRIGHTNESS * frame.gain(),
            luminance_exponent: SOLID_LUMINANCE_EXPONENT,
            light_scale: frame.format.light_scale(),
        }
    }
}
