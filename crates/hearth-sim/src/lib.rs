//! The simulation for JavaScript, without a canvas: the wasm behind `web/sim.js`.
//!
//! One `Fire` is one simulation. The script copies what it was given into plain
//! arrays before it calls, so no code of a page runs while a call does; what is
//! read comes back as copies. Everything that a value may be is the business of
//! the core's one validator, in its own words.

// Plain logic, which needs no JavaScript and is tested without.
pub mod particles;
pub mod start;

// What touches JavaScript.
#[cfg(target_arch = "wasm32")]
mod fire;
#[cfg(target_arch = "wasm32")]
mod refusal;

#[cfg(target_arch = "wasm32")]
pub use fire::Fire;
