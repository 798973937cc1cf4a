//! Real fire by smoothed particle hydrodynamics in 2D.
pub mod clock;
pub mod fps;
pub mod params;
pub mod preset;
pub mod simulation;

pub use params::Parameters;
pub use simulation::Simulation;
