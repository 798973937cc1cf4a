//! Numbers that both Rust and the shaders know. `build/values.rs` gives them to the shaders.

/// Quads that one instance draws.
pub const BLOCK: usize = 64;
/// Particles in a row of their texture.
pub const ROW: usize = 512;
/// Texels of a particle.
pub const TEXELS: usize = 2;

/// Mipmap levels of the noise tile below its finest one.
pub const NOISE_LEVELS: u32 = 7;

/// Coolest temperature of the colour table \[K\].
pub const COOLEST: f32 = 600.0;
/// Hottest temperature of the colour table \[K\]. The parameters allow 2500 K.
pub const HOTTEST: f32 = 2600.0;
/// Entries of the colour table.
pub const ENTRIES: usize = 128;
