//! Constants of `src/constants.rs` for shaders.

use crate::constants::{
    COLOUR_ENTRIES, COOLEST_KELVIN, FUEL_OFFSET, HOTTEST_KELVIN, MATERIAL_FACTOR, MAX_SOURCES,
    NOISE_LEVELS, PARTICLES_PER_ROW, PLANE_FACTOR, QUADS_PER_INSTANCE, TEXELS_PER_PARTICLE,
};

/// The numbers of the materials that the shader draws, in the order of `Material`; 0 is stone.
pub const MATERIALS: [&str; 7] = ["WOOD", "IRON", "BRICK", "COAL", "WAX", "GLASS", "CLOTH"];
/// The numbers of the grounds that the shader draws after stone, in the order of `Ground`.
pub const GROUNDS: [&str; 3] = ["EARTH", "SAND", "SNOW"];

/// Names and values in GLSL.
pub fn shared() -> Vec<(&'static str, String)> {
    let whole = |value: usize| value.to_string();
    // The shortest decimal that parses to this float.
    let real = |value: f32| format!("{value:?}");
    let [scale, offset] = table_coordinate();
    let mut all = vec![
        ("QUADS_PER_INSTANCE", whole(QUADS_PER_INSTANCE)),
        ("PARTICLES_PER_ROW", whole(PARTICLES_PER_ROW)),
        ("TEXELS_PER_PARTICLE", whole(TEXELS_PER_PARTICLE)),
        ("MAX_SOURCES", whole(MAX_SOURCES)),
        ("NOISE_LEVELS", real(NOISE_LEVELS as f32)),
        ("MATERIAL_FACTOR", real(MATERIAL_FACTOR)),
        ("PLANE_FACTOR", real(PLANE_FACTOR)),
        ("FUEL_OFFSET", real(FUEL_OFFSET)),
        ("TABLE_SCALE", real(scale)),
        ("TABLE_OFFSET", real(offset)),
    ];
    // Stone is the material 0 and, after no ground, the ground 1.
    let materials = MATERIALS.into_iter().zip(1_u8..);
    let numbered = materials.chain(GROUNDS.into_iter().zip(2..));
    all.extend(numbered.map(|(name, number)| (name, real(number.into()))));
    all
}

/// Scale and offset from a temperature \[kK\] to a coordinate of the colour table. The first and the
/// last entry are at the middle of their texels.
pub fn table_coordinate() -> [f32; 2] {
    let entries = COLOUR_ENTRIES as f32;
    let scale = (entries - 1.0) / entries * 1e3 / (HOTTEST_KELVIN - COOLEST_KELVIN);
    [scale, 0.5 / entries - scale * COOLEST_KELVIN * 1e-3]
}
