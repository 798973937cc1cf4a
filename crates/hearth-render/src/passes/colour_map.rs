//! Maps the field of a measured quantity to colours.

use hearth_core::params::Model;

use super::accumulate::MAX_WEIGHT;
use crate::frame::Frame;
use crate::image::Image;
use crate::pass::{Blend, Draw, Load, Pass};
use crate::shaders::uniforms;

/// Weight of gas that is opaque. The classic model's gas thins out to single particles; the
/// combustion model's gas fills the domain and thins out only at its edge.
const OPAQUE_CLASSIC: f32 = 0.65;
const OPAQUE_COMBUSTION: f32 = 0.45;

/// Colours of the mean quantity.
pub struct ColourMap;

impl Pass for ColourMap {
    const KEY: &'static str = "chart";
    const TARGET: Image = Image::Picture;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::Reach;
    type Uniforms = uniforms::ColourMap;

    fn applies(frame: &Frame) -> bool {
        frame.shows_quantity()
    }

    fn uniforms(frame: &Frame, _: usize) -> uniforms::ColourMap {
        let width = frame.viewport.metres[0];
        let opaque = match frame.parameters.model() {
            Model::Classic => OPAQUE_CLASSIC,
            Model::Combustion => OPAQUE_COMBUSTION,
        };
        uniforms::ColourMap {
            field_used: frame.field_used(),
            field_edge: frame.field_edge(),
            floor_x: frame.viewport.floor[0],
            half_width: 0.5 * frame.parameters.domain_width / width,
            per_fade: width / frame.kernel.radius,
            per_cover: MAX_WEIGHT / opaque,
            two_sided: frame.two_sided(),
        }
    }
}
