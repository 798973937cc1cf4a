//! Real fire by smoothed particle hydrodynamics in two dimensions, for your own renderer.
#![doc = include_str!("picture.md")]
//! ```
//! use hearth_fire::{Simulation, preset::Preset};
//!
//! let campfire = Preset::find("campfire")?.scene();
//! let mut fire = Simulation::new(campfire);
//! fire.set("wind", 0.5)?;
//! fire.advance(0.5);
//! let particles = fire.positions().into_iter().zip(fire.temperatures());
//! let flame = particles.filter(|&(_, kelvin)| kelvin > 1000.0);
//! assert!(flame.count() > 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`Simulation`] is a fire. A [`Scene`] has its sources, its solids and its [`Parameters`], and [`preset`] has
//! scenes by name. The crate opens no window, starts no thread and reads no clock. The same seed gives
//! the same bits on every machine, natively and in wasm.

#[doc(inline)]
pub use hearth_core::*;

// Runs the examples of the README as doc tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadMe;
