//! Real fire by smoothed particle hydrodynamics in two dimensions.
//!
//! The physics of Hearth, independent of any platform: no window, no clock, no thread.
//!
//! ```
//! # use hearth_core as hearth_fire;
//! use hearth_fire::{Scene, Simulation};
//!
//! let mut scene = Scene::default();
//! scene.set("fuel_power", 150.0)?;
//! let mut fire = Simulation::new(scene);
//! fire.advance(0.5);
//! assert!(fire.temperatures().iter().any(|&kelvin| kelvin > 1000.0));
//! # Ok::<(), hearth_fire::params::ParamError>(())
//! ```
//!
//! There are two [models](params::Model): *combustion*, in which air fills the
//! domain and fuel burns in it, and *classic*, the student paper's. All numbers are `f32`, the
//! length of a step depends only on parameters and state, and the random generator is seeded, so
//! the same seed gives the same bits, natively and in wasm.

mod bounds;
mod classic;
pub mod clock;
mod combustion;
mod direction;
mod extremes;
mod forces;
pub mod fps;
mod grid;
pub mod instance;
mod interaction;
pub mod kernel;
mod lanes;
pub mod looping;
mod neighbourhood;
mod neighbours;
mod noise;
mod order;
pub mod params;
mod particle;
pub mod preset;
pub mod random;
mod report;
pub mod resolution;
pub mod scene;
mod series;
pub mod simulation;
mod solids;
mod solver;
pub mod sound;
mod source;
pub mod state;
mod time_step;
pub mod warm_up;

pub use combustion::{
    Burner, BurningSolid, BurningState, Charred, CharredSolid, Droplets, Ember, FuelTotal,
    IgniteError, IgnitionTarget, RemovedGas, SprayError, SprayTotals,
};
pub use forces::{BodyForce, LocalGas};
pub use glam::Vec2;
pub use instance::Instance;
pub use params::Parameters;
pub use particle::Particle;
pub use report::{Stage, StepReport};
pub use scene::Scene;
pub use series::StepRecord;
pub use simulation::{Simulation, burning};
pub use solids::free::FreeSolid;
pub use source::SourcePlace;
