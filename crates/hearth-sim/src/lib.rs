//! The simulation for JavaScript, without a canvas: the wasm behind `web/sim.js`.
//!
//! A `Fire` is a simulation. The script copies a page's values into plain arrays before
//! each call, so no code of the page runs during a call, and all results are copies.
//! Values become untrusted values, which the core checks.

// Native tests cover this module, which needs no JavaScript.
pub mod particles;

#[cfg(target_arch = "wasm32")]
mod fire;
#[cfg(target_arch = "wasm32")]
mod sound;

#[cfg(target_arch = "wasm32")]
pub use fire::Fire;
#[cfg(target_arch = "wasm32")]
pub use sound::Synthesis;
