//! How a fire's particles become fields: the size of their kernels and of the fine structure.

use hearth_core::params::{DisplayMode, Model};
use hearth_core::{Parameters, Source};

/// Radius of a classic particle's kernel (1 − q²)² in particle sizes: its diameter at half its
/// height, 1.08 radii, is then the size.
pub const RADII_PER_SIZE: f32 = 0.92;
/// Radius of a kernel (1 − q²)² that blurs as much as the cubic spline of the same smoothing
/// length, in smoothing lengths.
const RADII_PER_LENGTH: f32 = 1.6;
/// The farthest that a drawn-out, widened classic kernel reaches, in its radii.
const CLASSIC_REACH: f32 = 2.3;
/// How far fine structure moves the gas, as a share of its size.
const CLASSIC_WARP: f32 = 0.6;
const COMBUSTION_WARP: f32 = 0.5;
/// Radius of a sprite: in sizes of the classic model's particles, and in spacings.
const SPRITE_SIZES: f32 = 1.6;
const SPRITE_SPACINGS: f32 = 4.0;

/// The kernels of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Radius \[m\].
    pub radius: f32,
    /// Size of the broadest fine structure \[m\].
    pub grain: f32,
    /// How far fine structure moves the gas \[m\].
    pub warp: f32,
    /// How far from its particle gas can be seen, except for its glow \[m\].
    pub margin: f32,
}

impl Kernel {
    /// The kernels of that fire in its display mode.
    pub fn of(parameters: &Parameters, source: &Source) -> Kernel {
        let (size, spacing) = (parameters.particle_size, parameters.spacing());
        let radius = match (parameters.display_mode, parameters.model()) {
            (DisplayMode::Fire, Model::Classic) => RADII_PER_SIZE * size,
            (DisplayMode::Sprites, Model::Classic) => SPRITE_SIZES * size,
            (DisplayMode::Sprites, Model::Combustion) => SPRITE_SPACINGS * spacing,
            _ => RADII_PER_LENGTH * parameters.smoothing_length(),
        };
        if parameters.display_mode != DisplayMode::Fire {
            return Kernel {
                radius,
                grain: 0.0,
                warp: 0.0,
                margin: radius,
            };
        }
        let (grain, warp, reach) = match parameters.model() {
            Model::Classic => ((0.35 * source.width).max(size), CLASSIC_WARP, CLASSIC_REACH),
            Model::Combustion => (
                (0.3 * source.width).max(2.5 * spacing),
                COMBUSTION_WARP,
                1.0,
            ),
        };
        let warp = parameters.detail * warp * grain;
        Kernel {
            radius,
            grain,
            warp,
            margin: reach * radius + 2.0 * warp,
        }
    }
}

/// Value in its middle of a kernel (1 − q²)² that integrates to 1 over its disc.
pub fn peak(radius: f32) -> f32 {
    3.0 / (std::f32::consts::PI * radius * radius)
}
