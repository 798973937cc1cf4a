//! Constants of Rust and of the shaders, which get them from `build/values.rs`.

/// Quads per instance.
pub const QUADS_PER_INSTANCE: usize = 64;
/// Particles per row of their texture.
pub const PARTICLES_PER_ROW: usize = 512;
/// Texels per particle.
pub const TEXELS_PER_PARTICLE: usize = 2;

/// Factor of a material in the number of a surface, above every temperature \[K\].
pub const MATERIAL_FACTOR: f32 = 4096.0;
/// Factor of a plane in the number of a surface's material.
pub const PLANE_FACTOR: f32 = 16.0;
/// Added to the number of the material of a solid with fuel. The place of its cells is then in place
/// of the temperature.
pub const FUEL_OFFSET: f32 = 64.0;

/// Sources whose flames begin at their own places; those of others begin at the nearest of these.
pub const MAX_SOURCES: usize = 16;

/// Mipmap levels of the noise tile below its finest one.
pub const NOISE_LEVELS: u32 = 7;

/// Minimum temperature of the colour table \[K\].
pub const COOLEST_KELVIN: f32 = 600.0;
/// Maximum temperature of the colour table \[K\]. Parameters go up to 2500 K.
pub const HOTTEST_KELVIN: f32 = 2600.0;
/// Entries of the colour table.
pub const COLOUR_ENTRIES: usize = 128;
