//! The trait of the models.

use crate::bounds::Bounds;
use crate::forces::BodyForce;
use crate::instance::{Instance, Measured};
use crate::params::{DisplayMode, Physics};
use crate::particle::Particle;
use crate::random::Random;
use crate::report::{Stage, StepReport};
use crate::scene::Scene;
use crate::series::Totals;
use crate::solids::Solids;

/// The gas of a model and its time step.
pub(crate) trait Solver {
    /// Makes one step with the force `user` besides the model's own. The `times` are the one that it starts from,
    /// and how much is left until one ends, which [fits](crate::time_step::fitted) its length. Returns that length \[s\].
    fn step(
        &mut self,
        scene: &Scene,
        random: &mut Random,
        times: (f64, f64),
        user: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) -> f64;

    /// Applies changed values at `time`.
    fn adapt(&mut self, scene: &Scene, random: &mut Random, time: f64);

    /// Replaces all particles.
    fn set_particles(&mut self, particles: &[Particle], values: &Physics);

    /// The rule that a number of particles breaks, if any.
    fn broken_count_rule(&self, count: usize, values: &Physics) -> Option<&'static str>;

    /// The domain.
    fn bounds(&self, values: &Physics) -> Bounds;

    /// The solids.
    fn solids(&self) -> &Solids;

    /// Speed of sound [m/s].
    fn sound_speed(&self, scene: &Scene) -> f32;

    /// Estimated length of the next step \[s\].
    fn step_length(&self, scene: &Scene) -> f64;

    /// A report of the last step.
    fn report(&self, values: &Physics) -> StepReport;

    /// What has happened since the fire began.
    fn totals(&self) -> Totals;

    /// Number of particles.
    fn count(&self) -> usize;

    /// Most particles for which a reader makes room at once.
    fn capacity(&self, values: &Physics) -> usize;

    /// The indices of all particles in the order of their ids, the order of birth.
    fn by_id(&self) -> Vec<usize>;

    /// The id of a particle.
    fn id(&self, i: usize) -> u64;

    /// A particle at `time`.
    fn particle(&self, i: usize, time: f64) -> Particle;

    /// Density of a particle [kg/m³], as the last step found it.
    fn density(&self, i: usize) -> f32;

    /// Pressure of a particle \[Pa\], as the last step found it.
    fn pressure(&self, i: usize) -> f32;

    /// Copies out the particles that the display of the fire shows.
    fn write_fire(&self, out: &mut Vec<Instance>);

    /// A particle with the quantity of a display mode.
    fn measured(&self, i: usize, values: &Physics, mode: DisplayMode) -> Measured;
}
