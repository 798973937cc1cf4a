//! The trait of the models.

use crate::bounds::Bounds;
use crate::forces::BodyForce;
use crate::instance::{Instance, Measured};
use crate::params::{DisplayMode, Physics};
use crate::particle::Particle;
use crate::random::Random;
use crate::report::{Stage, StepReport};
use crate::scene::Scene;
use crate::solids::Solids;

/// Declares the trait, and implements it for [`Either`] by delegation: unlike those of a
/// `dyn Solver`, its calls for each particle are inlined.
macro_rules! solver {
    (
        &mut $this:ident { $(
            $(#[$doc:meta])+
            fn $write:ident($($in:ident: $in_type:ty),* $(,)?) $(-> $out:ty)?;
        )+ }
        &$me:ident { $(
            $(#[$read_doc:meta])+
            fn $read:ident($($arg:ident: $arg_type:ty),* $(,)?) $(-> $type:ty)?;
        )+ }
    ) => {
        /// The gas of a model and its time step.
        pub(crate) trait Solver { $(
            $(#[$doc])+
            fn $write(&mut $this, $($in: $in_type),*) $(-> $out)?;
        )+ $(
            $(#[$read_doc])+
            fn $read(&$me, $($arg: $arg_type),*) $(-> $type)?;
        )+ }

        impl<A: Solver, B: Solver> Solver for Either<A, B> { $(
            #[inline]
            fn $write(&mut $this, $($in: $in_type),*) $(-> $out)? {
                match $this {
                    Either::Classic(solver) => solver.$write($($in),*),
                    Either::Combustion(solver) => solver.$write($($in),*),
                }
            }
        )+ $(
            #[inline]
            fn $read(&$me, $($arg: $arg_type),*) $(-> $type)? {
                match $me {
                    Either::Classic(solver) => solver.$read($($arg),*),
                    Either::Combustion(solver) => solver.$read($($arg),*),
                }
            }
        )+ }
    };
}

solver! {
    &mut self {
        /// Makes one step from `time`, with the force `user` besides the model's own. Returns
        /// the length of the step \[s\].
        fn step(
            scene: &Scene,
            random: &mut Random,
            time: f64,
            user: Option<&dyn BodyForce>,
            on_stage: &mut dyn FnMut(Stage),
        ) -> f64;

        /// Applies changed values at `time`.
        fn adapt(scene: &Scene, random: &mut Random, time: f64);

        /// Replaces all particles.
        fn set_particles(particles: &[Particle], values: &Physics);
    }

    &self {
        /// The rule that a number of particles breaks, if any.
        fn broken_count_rule(count: usize, values: &Physics) -> Option<&'static str>;

        /// The domain.
        fn bounds(values: &Physics) -> Bounds;

        /// The solids.
        fn solids() -> &Solids;

        /// Speed of sound [m/s].
        fn sound_speed(scene: &Scene) -> f32;

        /// Estimated length of the next step \[s\].
        fn step_length(scene: &Scene) -> f64;

        /// A report of the last step.
        fn report(values: &Physics) -> StepReport;

        /// Number of particles.
        fn count() -> usize;

        /// Most particles for which a reader makes room at once.
        fn capacity(values: &Physics) -> usize;

        /// The indices of all particles in the order of their ids, the order of birth.
        fn by_id() -> Vec<usize>;

        /// The id of a particle.
        fn id(i: usize) -> u64;

        /// A particle at `time`.
        fn particle(i: usize, time: f64) -> Particle;

        /// Density of a particle [kg/m³], as the last step found it.
        fn density(i: usize) -> f32;

        /// Pressure of a particle \[Pa\], as the last step found it.
        fn pressure(i: usize) -> f32;

        /// Copies out the particles that the display of the fire shows.
        fn write_fire(out: &mut Vec<Instance>);

        /// A particle with the quantity of a display mode.
        fn measured(i: usize, values: &Physics, mode: DisplayMode) -> Measured;
    }
}

/// One of two solvers.
// There is one value of this type, so its size does not matter.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Debug)]
pub(crate) enum Either<A, B> {
    Classic(A),
    Combustion(B),
}
