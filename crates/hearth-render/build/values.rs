//! Constants of `src/constants.rs` for shaders.

use crate::constants::{
    BLOCK, BURNING, COOLEST, ENTRIES, FRONT, HOTTEST, NOISE_LEVELS, ROW, SURFACES, TEXELS,
};

/// Names and values in GLSL.
pub fn shared() -> Vec<(&'static str, String)> {
    let whole = |value: usize| value.to_string();
    // The shortest decimal that parses to this float.
    let real = |value: f32| format!("{value:?}");
    let [scale, offset] = table_coordinate();
    vec![
        ("BLOCK", whole(BLOCK)),
        ("ROW", whole(ROW)),
        ("TEXELS", whole(TEXELS)),
        ("NOISE_LEVELS", real(NOISE_LEVELS as f32)),
        ("SURFACES", real(SURFACES)),
        ("FRONT", real(FRONT)),
        ("BURNING", real(BURNING)),
        ("TABLE_SCALE", real(scale)),
        ("TABLE_OFFSET", real(offset)),
    ]
}

/// Scale and offset from a temperature \[kK\] to a coordinate of the colour table. The first and the
/// last entry are at the middle of their texels.
pub fn table_coordinate() -> [f32; 2] {
    let entries = ENTRIES as f32;
    let scale = (entries - 1.0) / entries * 1e3 / (HOTTEST - COOLEST);
    [scale, 0.5 / entries - scale * COOLEST * 1e-3]
}
