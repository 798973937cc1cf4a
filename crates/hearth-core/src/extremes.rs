//! Maximum and minimum for loops over all particles.
//!
//! In wasm `f32::max` and `f32::min` are function calls, because they treat NaN specially;
//! in the loops over pairs they took a quarter of a step. Which of two zeros they return
//! differs between machines. These functions are one comparison.

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
