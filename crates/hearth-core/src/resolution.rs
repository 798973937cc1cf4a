//! How many particles a fire has: levels of quality, small elements, slow machines.

mod level;
mod particle_count;
mod size_limit;

pub use level::Level;
pub use particle_count::{CountInputs, CountLimit, ParticleCount, Resolution};
pub use size_limit::SizeLimit;
