//! The simulation for JavaScript, without a canvas: the wasm behind `web/sim.js`.
//!
//! A `Fire` is a simulation. The script copies a page's values into plain arrays before
//! it calls, so no code of the page runs during a call, and all results are copies.
//! Values become untrusted values of `hearth-bindings`, which the core's table checks.

// Plain logic, which needs no JavaScript and is tested without.
pub mod particles;

// What touches JavaScript.
#[cfg(target_arch = "wasm32")]
mod fire;

#[cfg(target_arch = "wasm32")]
pub use fire::Fire;
