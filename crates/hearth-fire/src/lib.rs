//! Real fire by smoothed particle hydrodynamics in two dimensions, for your own renderer.
#![doc = include_str!("picture.md")]
//! ```
//! use hearth_fire::{Simulation, preset::Preset};
//!
//! let campfire = Preset::find("campfire").ok_or("no such scene")?;
//! let mut fire = Simulation::new(campfire.scene());
//! while fire.time() < 0.5 {
//!     fire.step();
//! }
//! let particles = fire.positions().into_iter().zip(fire.temperatures());
//! let flame = particles.filter(|&(_, kelvin)| kelvin > 1000.0);
//! assert!(flame.count() > 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`Simulation`] is a fire, [`Parameters`] are its values, and [`preset`] has named sets of
//! values. The crate opens no window, starts no thread and reads no clock. The same seed gives
//! the same bits on every machine, natively and in wasm.

pub use hearth_core::*;

// Runs the examples of the README as doc tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadMe;
