//! The larger and the smaller of two numbers, for loops over all particles.
//!
//! `f32::max` and `f32::min` are calls of functions in wasm, for the sake of what is
//! no number; in the loops over pairs they took a quarter of a step. And which
//! of two zeros they prefer differs between machines. These are a comparison.

/// The larger of the two; `b` where they cannot be compared.
#[inline]
pub(crate) fn fast_max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The smaller of the two; `b` where they cannot be compared.
#[inline]
pub(crate) fn fast_min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}
