//! Maximum and minimum for loops over all particles.
//!
//! In wasm, `f32::max` and `f32::min` are function calls, because of NaN; in the loops over
//! pairs they took a quarter of a step. Which of two zeros they return differs between
//! machines. These functions are one comparison.

/// The maximum; `b` if either is NaN.
#[inline]
pub(crate) fn fast_max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The minimum; `b` if either is NaN.
#[inline]
pub(crate) fn fast_min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}
