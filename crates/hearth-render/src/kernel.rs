//! Sizes of the kernels of particles and of the fine structure.

use hearth_core::params::{DisplayMode, Model};
use hearth_core::{Parameters, SourcePlace};

/// Radius of a classic particle's kernel (1 − q²)² in particle sizes. The full width at half
/// maximum, 1.08 radii, then equals the size.
pub const RADII_PER_SIZE: f32 = 0.92;
/// Radius of the kernel (1 − q²)² with the same blur as the cubic spline, in smoothing lengths.
const RADII_PER_LENGTH: f32 = 1.6;
/// Radius of the kernel of a parcel of two particles, in those of a particle.
const PARCEL_WIDENING: f32 = 1.1;
/// Maximum reach of a stretched classic kernel in its radii.
const CLASSIC_REACH: f32 = 2.3;
/// Displacement of the gas by fine structure, relative to the size of the structure.
const CLASSIC_WARP: f32 = 0.6;
const COMBUSTION_WARP: f32 = 0.5;
/// Radius of a sprite, in particle sizes of the classic model and in spacings of the combustion
/// model.
const SPRITE_SIZES: f32 = 1.6;
const SPRITE_SPACINGS: f32 = 4.0;

/// The kernels of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Radius \[m\].
    pub radius: f32,
    /// Width of a tile of noise, which sets the broadest fine structure \[m\].
    pub noise_tile: f32,
    /// Displacement of the gas by fine structure \[m\].
    pub warp: f32,
    /// Maximum distance of visible gas from its particle, without its glow \[m\].
    pub margin: f32,
}

impl Kernel {
    /// The kernels of a fire in its display mode.
    pub fn of(parameters: &Parameters, source: &SourcePlace) -> Kernel {
        let (size, spacing) = (parameters.particle_size, parameters.spacing());
        let radius = match (parameters.display_mode, parameters.model()) {
            (DisplayMode::Fire, Model::Classic) => RADII_PER_SIZE * size,
            (DisplayMode::Sprites, Model::Classic) => SPRITE_SIZES * size,
            (DisplayMode::Sprites, Model::Combustion) => SPRITE_SPACINGS * spacing,
            _ => gas_radius(parameters.smoothing_length()),
        };
        if parameters.display_mode != DisplayMode::Fire {
            return Kernel {
                radius,
                noise_tile: 0.0,
                warp: 0.0,
                margin: radius,
            };
        }
        let (noise_tile, warp, reach) = match parameters.model() {
            Model::Classic => ((0.35 * source.width).max(size), CLASSIC_WARP, CLASSIC_REACH),
            Model::Combustion => (
                (0.3 * source.width).max(2.5 * spacing),
                COMBUSTION_WARP,
                1.0,
            ),
        };
        let warp = parameters.detail * warp * noise_tile;
        Kernel {
            radius,
            noise_tile,
            warp,
            margin: reach * radius + 2.0 * warp,
        }
    }
}

/// Radius of the kernel of gas with that smoothing length \[m\].
pub fn gas_radius(smoothing_length: f32) -> f32 {
    RADII_PER_LENGTH * smoothing_length
}

/// The same of a parcel of two particles.
pub fn parcel_radius(smoothing_length: f32) -> f32 {
    PARCEL_WIDENING * gas_radius(smoothing_length)
}

/// Maximum of the kernel (1 − q²)² with an integral of 1.
pub fn peak(radius: f32) -> f32 {
    3.0 / (std::f32::consts::PI * radius * radius)
}
