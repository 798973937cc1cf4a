//! The pair interactions of the classic model: one line each in [`list`].
//!
//! With V = m/ρ the volume of a particle, each file states the force of a pair; the
//! opposite force acts on the other particle, which conserves momentum to rounding. [`AsPublished`] has
//! the forms that the paper prints differently.

mod as_published;
mod pressure;
mod viscosity;

use glam::Vec2;

use super::pair::{Broadcast, Pair};
use super::pairs::{Block, Pairs};
use crate::interaction::{PairInteraction, Rates};
use crate::kernel::Kernel;
use crate::lanes::Lanes;
use crate::neighbours::PairSum;
use crate::params::Physics;
use as_published::AsPublished;

/// All pair interactions, in the order in which their rates add up.
fn list(kernel: &Kernel, values: &Physics, viscosity: f32) -> impl PairInteraction<Pair> {
    (
        pressure::Pressure,
        viscosity::Viscosity::new(kernel, values.particle_mass, viscosity),
    )
}

/// Adds all pair interactions to the accelerations.
///
/// `viscosity` [Pa·s] is the largest stable one of the substep, at most the parameter.
pub(super) fn sum(pairs: &mut Pairs, kernel: &Kernel, values: &Physics, viscosity: f32) {
    let published = AsPublished::new(kernel, values, viscosity);
    if published.any() {
        pairs.sum(&published);
    } else {
        pairs.sum(&Symmetric(list(kernel, values, viscosity)));
    }
}

/// Interactions with opposite accelerations of the two particles.
struct Symmetric<I>(I);

impl<I: PairInteraction<Pair>> PairSum<2> for Symmetric<I> {
    type Block = Block;
    type Broadcast = Broadcast;

    #[inline(always)]
    fn broadcast(&self, block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Broadcast {
        Broadcast::of(block, pick, by)
    }

    #[inline(always)]
    fn pair(&self, particle: &Broadcast, others: &Block, keep: Lanes) -> ([Lanes; 2], [Lanes; 2]) {
        let pair = Pair::new(particle, others, keep);
        let mut rates = Rates::NONE;
        self.0.add(&pair, &mut rates);
        let acceleration = rates.acceleration(&pair.offset, pair.velocity);
        (acceleration, acceleration)
    }

    #[inline(always)]
    fn accumulator(block: &mut Block) -> &mut [Lanes; 2] {
        &mut block.acceleration
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;

    use crate::bounds::Bounds;
    use crate::classic::particles::Particles;
    use crate::params::{Input, Model, Parameters};
    use crate::particle::Particle;
    use crate::random::Random;
    use crate::solids::Solids;

    const BOUNDS: Bounds = Bounds {
        bottom: 0.0,
        width: 1.0,
        height: 1.0,
        periodic_x: true,
        periodic_y: false,
    };

    /// A dense random cloud in random motion, with its densities and pressures.
    fn cloud(parameters: &Parameters, seed: u32) -> (Particles, Pairs, Kernel) {
        let mut random = Random::new(seed);
        let mut particles = Particles::default();
        for _ in 0..600 {
            particles.push(Particle {
                velocity: Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0)),
                temperature: random.between(300.0, 1900.0),
                ..Particle::at(Vec2::new(
                    random.between(-0.5, 0.5),
                    random.between(0.2, 0.5),
                ))
            });
        }
        let kernel = Kernel::new(parameters.smoothing_radius);
        let mut pairs = Pairs::default();
        pairs.sort(&mut particles, &BOUNDS, &kernel);
        pairs.sum_density(&mut particles, &kernel, parameters, &Solids::default());
        (particles, pairs, kernel)
    }

    fn with(values: &[(&str, Input<'_>)]) -> Parameters {
        let mut parameters = Parameters::new(Model::Classic);
        for &(id, value) in values {
            parameters.set(id, value).expect(id);
        }
        parameters
    }

    /// Pair forces alone.
    fn weightless(more: &[(&str, Input<'_>)]) -> Parameters {
        let none = Input::Number(0.0);
        let mut values = vec![
            ("buoyancy", none),
            ("thermal_buoyancy", none),
            ("smoothing_radius", Input::Number(0.04)),
            ("particle_mass", Input::Number(1e-3)),
        ];
        values.extend_from_slice(more);
        with(&values)
    }

    fn net_and_all(values: &[Vec2]) -> (f32, f32) {
        let net = values.iter().copied().sum::<Vec2>().length();
        let all = values.iter().map(|v| v.length()).sum();
        (net, all)
    }

    #[test]
    fn pair_forces_conserve_momentum() {
        let parameters = weightless(&[("viscosity", Input::Number(0.05))]);
        for seed in 0..5 {
            let (_, mut pairs, kernel) = cloud(&parameters, seed);
            sum(&mut pairs, &kernel, &parameters, parameters.viscosity);
            let (net, all) = net_and_all(&pairs.accelerations());
            assert!(all > 1.0, "nothing accelerates");
            assert!(net < 1e-6 * all, "seed {seed}: {net} of {all}");
        }
    }

    #[test]
    fn viscosity_never_adds_energy() {
        let parameters = weightless(&[("viscosity", Input::Number(0.05))]);
        for seed in 0..5 {
            let (particles, mut pairs, kernel) = cloud(&parameters, seed);
            pairs.set_pressure(&particles, &kernel, parameters.particle_mass, |_| 0.0);
            sum(&mut pairs, &kernel, &parameters, parameters.viscosity);
            let accelerations = pairs.accelerations();
            let each = particles.iter().map(|p| p.velocity()).zip(&accelerations);
            let power: f64 = each.map(|(v, a)| f64::from(v.dot(*a))).sum();
            assert!(power < 0.0, "seed {seed}: {power}");
        }
    }

    #[test]
    fn the_printed_laplacian_speeds_up_a_pair_closer_than_eight_ninths() {
        // Two particles at q = 0.4 in opposite motion: viscosity must brake
        // them; the kernel's own Laplacian is negative there and speeds them up.
        let power = |printed: bool| {
            let parameters = weightless(&[
                ("viscosity", Input::Number(0.05)),
                ("printed_viscosity", Input::Flag(printed)),
            ]);
            let kernel = Kernel::new(parameters.smoothing_radius);
            let mut particles = Particles::default();
            for side in [-1.0, 1.0] {
                particles.push(Particle {
                    velocity: Vec2::new(0.0, side),
                    ..Particle::at(Vec2::new(side * 0.2 * parameters.smoothing_radius, 0.5))
                });
            }
            let mut pairs = Pairs::default();
            pairs.sort(&mut particles, &BOUNDS, &kernel);
            pairs.sum_density(&mut particles, &kernel, &parameters, &Solids::default());
            sum(&mut pairs, &kernel, &parameters, parameters.viscosity);
            let accelerations = pairs.accelerations();
            let each = particles.iter().map(|p| p.velocity()).zip(&accelerations);
            each.map(|(v, a)| v.dot(*a)).sum::<f32>()
        };
        assert!(power(false) < 0.0);
        assert!(power(true) > 0.0);
    }

    /// A lattice with spacing `dx` whose pressure rises by 1 Pa/m along x.
    fn lattice_acceleration(parameters: &Parameters, dx: f32) -> Vec2 {
        let kernel = Kernel::new(parameters.smoothing_radius);
        let mut particles = Particles::default();
        for i in -10..=10 {
            for j in 0..=20 {
                particles.push(Particle::at(Vec2::new(i as f32 * dx, 0.1 + j as f32 * dx)));
            }
        }
        let mut pairs = Pairs::default();
        pairs.sort(&mut particles, &BOUNDS, &kernel);
        pairs.sum_density(&mut particles, &kernel, parameters, &Solids::default());
        pairs.set_pressure(&particles, &kernel, parameters.particle_mass, |at| at.x);
        sum(&mut pairs, &kernel, parameters, 0.0);
        let middle = Vec2::new(0.0, 0.1 + 10.0 * dx);
        let at = particles
            .iter()
            .position(|p| p.position().distance(middle) < 0.1 * dx);
        pairs.accelerations()[at.expect("the lattice has a middle")]
    }

    #[test]
    fn a_linear_pressure_accelerates_by_its_gradient() {
        // ρ = 1 on this lattice, so the acceleration is −∇p = −1.
        for ratio in [1.3_f32, 1.5, 2.0] {
            let dx = 0.02;
            let parameters = weightless(&[
                ("smoothing_radius", Input::Number(f64::from(ratio * dx))),
                ("particle_mass", Input::Number(f64::from(dx * dx))),
            ]);
            let a = lattice_acceleration(&parameters, dx);
            assert!(
                (a.x + 1.0).abs() < 0.03 && a.y.abs() < 1e-3,
                "h/dx = {ratio}: {a}"
            );
        }
    }

    #[test]
    fn the_printed_pressure_is_half_of_it() {
        let dx = 0.02;
        let parameters = weightless(&[
            ("smoothing_radius", Input::Number(0.03)),
            ("particle_mass", Input::Number(f64::from(dx * dx))),
            ("printed_pressure", Input::Flag(true)),
        ]);
        let a = lattice_acceleration(&parameters, dx);
        assert!((a.x + 0.5).abs() < 0.02, "{a}");
    }
}
