//! Maps the field of a measured quantity to colours.

use hearth_core::params::{DisplayMode, Model};

use super::accumulate::MAX_WEIGHT;
use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Blend, Draw, Load, Pass};
use crate::shaders::uniforms;

/// Weight of gas that is opaque. The classic model's gas thins out to single particles; the
/// combustion model's gas fills a closed domain and thins out only at its edge. Open air ends
/// over the widest part of its band.
const OPAQUE_CLASSIC: f32 = 0.65;
const OPAQUE_CLOSED: f32 = 0.45;
const OPAQUE_OPEN: f32 = 0.9;

/// Half the width of open air, in pictures.
const OPEN_AIR_HALF_WIDTH: f32 = 1e3;

/// Colours of the mean quantity.
pub struct ColourMap;

impl Pass for ColourMap {
    const TARGET: Image = Image::Picture;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::All;
    type Uniforms = uniforms::ColourMap;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.shows_quantity()
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::ColourMap {
        let width = frame.viewport.metres[0];
        let opaque = match frame.parameters.model() {
            Model::Classic => OPAQUE_CLASSIC,
            Model::Combustion if frame.is_closed() => OPAQUE_CLOSED,
            Model::Combustion => OPAQUE_OPEN,
        };
        uniforms::ColourMap {
            field_used: frame.field_used(),
            field_edge: frame.field_edge(),
            floor_x: frame.viewport.floor[0],
            half_width: if frame.is_closed() {
                0.5 * frame.parameters.domain_width / width
            } else {
                OPEN_AIR_HALF_WIDTH
            },
            per_fade: width / frame.kernel.radius,
            per_cover: MAX_WEIGHT / opaque,
            far_air: far_air(frame),
            two_sided: frame.two_sided(),
        }
    }
}

/// The displayed quantity of far air, as a share of the span; −1 in a closed domain.
fn far_air(frame: &FrameUniforms) -> f32 {
    if frame.is_closed() {
        return -1.0;
    }
    let values = frame.parameters;
    let quantity = match values.display_mode {
        DisplayMode::Temperature => values.ambient_temperature,
        DisplayMode::Density => values.ambient_density,
        DisplayMode::Velocity => values.wind.abs(),
        DisplayMode::Distance => f32::MAX,
        _ => 0.0,
    };
    let [from, per_span] = frame.span();
    ((quantity - from) * per_span).clamp(0.0, 1.0)
}
