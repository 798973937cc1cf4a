//! Fires as pictures, for tests: kept ones and ones that burn, drawn by the
//! renderer itself and read back.
//!
//! It is no part of what is shipped. `tests/look` drives it in a browser.

pub mod fires;
#[cfg(target_arch = "wasm32")]
mod painter;
pub mod snapshot;
