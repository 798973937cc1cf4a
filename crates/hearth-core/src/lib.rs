//! Real fire by smoothed particle hydrodynamics in two dimensions.
//!
//! The physics of Hearth, without a platform: no window, no clock, no thread.
//!
//! ```
//! use hearth_core::{Parameters, Simulation, params::Input};
//!
//! let mut parameters = Parameters::default();
//! parameters.set("buoyancy", Input::Number(0.2))?;
//! let mut fire = Simulation::new(parameters);
//! for _ in 0..240 {
//!     fire.step();
//! }
//! assert!(fire.count() > 300);
//! # Ok::<(), hearth_core::params::ParamError>(())
//! ```
//!
//! One step is: emitter → neighbour grid → density → pressure → forces →
//! motion; [`Simulation::step`] reads that way. Everything is `f32`, the step
//! is fixed, and the one random generator is seeded, so the same seed gives the
//! same bits, natively and in wasm.

pub mod clock;
mod density;
mod emitter;
mod forces;
pub mod fps;
mod grid;
mod integrate;
pub mod kernel;
mod noise;
pub mod params;
mod particles;
pub mod preset;
mod printed;
pub mod random;
pub mod simulation;

pub use glam::Vec2;
pub use params::Parameters;
pub use particles::Particle;
pub use simulation::{Instance, Simulation, StepReport};
