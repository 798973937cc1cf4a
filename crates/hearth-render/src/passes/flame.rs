//! Shades the field of the combustion model.

use hearth_core::params::Model;

use crate::frame_uniforms::{FrameUniforms, wrapped};
use crate::image::Image;
use crate::noise;
use crate::pass::{Blend, Draw, Load, Pass, Per};
use crate::shaders::uniforms;

/// Brightness relative to the classic model, whose gas is cooler.
const RELATIVE_BRIGHTNESS: f32 = 0.34;
/// Optical depth of cold gas with a soot of 1 at a smoke opacity of 1.
const SMOKE_DEPTH: f32 = 14.0;
/// Noise tiles per tile of fine structure, across and up: tongues of a flame are taller than wide.
const TILES_OF_TONGUES: [f32; 2] = [1.15, 0.75];
/// Maximum height above a visible floor over which gas fades, in heights of the domain.
const FLOOR_FADE_HEIGHT: f32 = 0.04;

/// Variance of squared soot under a kernel (1 − q²)², normally distributed: half of that of soot, an eighth of the squared radius.
const KERNEL_VARIANCE: f32 = 1.0 / 16.0;

/// Light and coverage of the gas of a slice, in front of the slices behind it.
pub struct Flame;

impl Pass for Flame {
    const TARGET: Image = Image::Light;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::Reach;
    const PER: Per = Per::Slice;
    type Uniforms = uniforms::Flame;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.burns_as(Model::Combustion)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Flame {
        let (kernel, slice) = (frame.kernel, &frame.slice);
        let (source_count, sources) = frame.source_places();
        let parameters = frame.parameters;
        let tiles = TILES_OF_TONGUES.map(|share| share / (noise::CELLS as f32 * kernel.noise_tile));
        let risen = if frame.advects_noise() {
            0.0
        } else {
            wrapped(frame.risen * f64::from(tiles[1]))
        };
        // At a visible floor, gas below the lowest source fades.
        let [_, below] = frame.viewport.shows_beyond();
        let heights = frame.sources.iter().map(|place| place[1]);
        let lowest = heights.fold(f32::MAX, f32::min);
        let soft = (lowest / frame.parameters.domain_height).clamp(1e-3, FLOOR_FADE_HEIGHT);
        uniforms::Flame {
            field_used: frame.field_used(),
            field_edge: frame.field_edge(),
            field_range: frame.field_range(),
            picture_size: frame.viewport.metres,
            floor_middle: frame.viewport.floor,
            sources,
            lowest,
            source_count,
            zoom: frame.viewport.zoom,
            per_domain_width: 1.0 / frame.parameters.domain_width,
            closed: f32::from(frame.is_closed()),
            picture_height: frame.viewport.whole[0],
            picture_bottom: frame.viewport.whole[1],
            tiles,
            risen,
            pattern_starts: frame.phase.offsets(slice.index),
            pattern_shares: frame.phase.shares(),
            warp: kernel.warp,
            detail: frame.parameters.detail,
            air: frame.parameters.ambient_temperature * 1e-3,
            depth: slice.depth,
            smoke: SMOKE_DEPTH * frame.smoke_opacity() * slice.smoke,
            luminance_exponent: frame.parameters.luminance_exponent,
            gain: RELATIVE_BRIGHTNESS * frame.gain(),
            light_scale: frame.format.light_scale(),
            fire_share: frame.fire_share(),
            roundness: frame.parameters.roundness,
            kernel_variance: KERNEL_VARIANCE * frame.kernel.radius.powi(2),
            premixed: if frame.is_premixed() {
                parameters.burn_time
            } else {
                0.0
            },
            soot_per_fuel: 1.0 + frame.parameters.air_demand,
            // A fade of no visible height where the floor is not visible.
            per_soft_floor: if below { 1.0 / soft } else { 1e6 },
        }
    }
}
