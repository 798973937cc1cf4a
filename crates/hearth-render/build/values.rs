//! Constants of `src/constants.rs` for shaders.

use crate::constants::{
    BLOCK, BURNING, COOLEST, ENTRIES, FRONT, HOTTEST, NOISE_LEVELS, ROW, SURFACES, TEXELS,
};

/// The numbers of the materials that the shader draws, in the order of `Material`; 0 is stone.
pub const MATERIALS: [&str; 6] = ["WOOD", "IRON", "BRICK", "COAL", "WAX", "GLASS"];
/// The numbers of the grounds that the shader draws after stone, in the order of `Ground`.
pub const GROUNDS: [&str; 3] = ["EARTH", "SAND", "SNOW"];

/// Names and values in GLSL.
pub fn shared() -> Vec<(&'static str, String)> {
    let whole = |value: usize| value.to_string();
    // The shortest decimal that parses to this float.
    let real = |value: f32| format!("{value:?}");
    let [scale, offset] = table_coordinate();
    let mut all = vec![
        ("BLOCK", whole(BLOCK)),
        ("ROW", whole(ROW)),
        ("TEXELS", whole(TEXELS)),
        ("NOISE_LEVELS", real(NOISE_LEVELS as f32)),
        ("SURFACES", real(SURFACES)),
        ("FRONT", real(FRONT)),
        ("BURNING", real(BURNING)),
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
    let entries = ENTRIES as f32;
    let scale = (entries - 1.0) / entries * 1e3 / (HOTTEST - COOLEST);
    [scale, 0.5 / entries - scale * COOLEST * 1e-3]
}
