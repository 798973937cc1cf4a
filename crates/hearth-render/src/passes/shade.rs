//! Shades the field of the classic model.

use hearth_core::params::Model;

use crate::frame_uniforms::{FrameUniforms, wrapped};
use crate::image::Image;
use crate::noise;
use crate::pass::{Draw, Load, Pass};
use crate::shaders::uniforms;

/// Optical depth of the smoke in the middle of one kernel at a smoke opacity of 1.
const SMOKE_DEPTH: f32 = 2.2;

/// Light and coverage of the gas.
pub struct Shade;

impl Pass for Shade {
    const TARGET: Image = Image::Light;
    const LOAD: Load = Load::Clear;
    const DRAW: Draw = Draw::Reach;
    type Uniforms = uniforms::Shade;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.burns_as(Model::Classic)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Shade {
        let kernel = frame.kernel;
        let (source_count, sources) = frame.source_places();
        let flame = frame.flame_height.max(2.0 * kernel.noise_tile);
        let tiles = 1.0 / (noise::CELLS as f32 * kernel.noise_tile);
        // Gas leaves the domain at its top and fades there if the top is visible.
        let [above, _] = frame.viewport.shows_beyond();
        uniforms::Shade {
            field_used: frame.field_used(),
            field_edge: frame.field_edge(),
            field_range: frame.field_range(),
            picture_size: frame.viewport.metres,
            floor_middle: frame.viewport.floor,
            sources,
            source_count,
            zoom: frame.viewport.zoom,
            per_flame_height: 1.0 / flame,
            tiles,
            risen: wrapped(frame.risen * f64::from(tiles)),
            warp: kernel.warp,
            detail: frame.parameters.detail,
            air: frame.parameters.ambient_temperature * 1e-3,
            smoke: SMOKE_DEPTH * frame.smoke_opacity(),
            luminance_exponent: frame.parameters.luminance_exponent,
            gain: frame.gain(),
            light_scale: frame.format.light_scale(),
            fire_share: frame.fire_share(),
            soft_top: f32::from(above),
        }
    }
}
