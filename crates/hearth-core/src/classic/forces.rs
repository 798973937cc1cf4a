//! The body forces of the classic model: one line each in [`list`].

mod buoyancy;
mod extra_weight;
mod terminal_drag;

use super::block_force::{BlockForce, Four};
use crate::forces::BodyForce;
use crate::forces::turbulence::Turbulence;
use crate::lanes::Lanes;
use crate::params::Physics;
use buoyancy::Buoyancy;
use extra_weight::ExtraWeight;
use terminal_drag::{TerminalDrag, Vertical};

/// All body forces, in the order in which their accelerations add up; a force of the
/// caller comes first.
pub(super) fn list<'a>(
    values: &Physics,
    time: f64,
    user: Option<&'a dyn BodyForce>,
) -> impl BlockForce + 'a {
    let drag = TerminalDrag::new(values);
    (
        user.map(User),
        Turbulence::new(values, time).map(|force| drag.of(force)),
        Vertical::new((Buoyancy::new(values), ExtraWeight::new(values)), drag),
    )
}

/// A force of the caller.
struct User<'a>(&'a dyn BodyForce);

impl BlockForce for User<'_> {
    fn add(&self, four: &Four, sum: &mut [Lanes; 2]) {
        self.0.add(four, sum);
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec2;

    use super::*;
    use crate::classic::pairs::Block;
    use crate::classic::particles::Particles;
    use crate::lanes::LANES;
    use crate::params::{Input, Model, Parameters};
    use crate::particle::Particle;

    fn with(values: &[(&str, Input<'_>)]) -> Parameters {
        let mut parameters = Parameters::new(Model::Classic);
        for &(id, value) in values {
            parameters.set(id, value).expect(id);
        }
        parameters
    }

    fn buoyancy_of_one(more: &[(&str, Input<'_>)], temperature: f32, density: f32, vy: f32) -> f32 {
        let parameters = with(more);
        let mut particles = Particles::default();
        particles.push(Particle {
            temperature,
            ..Particle::at(Vec2::ZERO)
        });
        let block = Block {
            volume: Lanes::splat(1.0 / density),
            velocity: [Lanes::ZERO, Lanes::splat(vy)],
            ..Block::EMPTY
        };
        let states = [particles[0]; LANES];
        let four = Four::new(&states, &block, parameters.ambient_density);
        let mut sum = [Lanes::ZERO; 2];
        list(&parameters, 0.0, None).add(&four, &mut sum);
        assert_eq!(sum[0], Lanes::ZERO);
        sum[1].to_array()[0]
    }

    #[test]
    fn thin_gas_and_hot_gas_rise_and_dense_cold_gas_sinks() {
        assert!(buoyancy_of_one(&[], 293.0, 0.6, 0.0) > 0.0);
        assert!(buoyancy_of_one(&[], 1900.0, 1.2, 0.0) > 0.0);
        assert!(buoyancy_of_one(&[], 293.0, 1.8, 0.0) < 0.0);
        assert_eq!(
            buoyancy_of_one(&[("gravity", Input::Number(0.0))], 1900.0, 0.6, 0.0),
            0.0
        );
    }

    #[test]
    fn extra_weight_is_a_downward_acceleration() {
        let heavy = buoyancy_of_one(&[("extra_weight", Input::Number(7.0))], 293.0, 1.2, 0.0);
        assert!((heavy + 7.0).abs() < 1e-4, "{heavy}");
    }

    #[test]
    fn at_the_terminal_speed_buoyancy_vanishes() {
        let terminal = Parameters::new(Model::Classic).terminal_speed;
        let free = buoyancy_of_one(&[], 1900.0, 0.6, 0.0);
        assert!(buoyancy_of_one(&[], 1900.0, 0.6, terminal).abs() < 1e-5 * free);
        assert!(buoyancy_of_one(&[], 1900.0, 0.6, 1.3 * terminal) < 0.0);
        assert!(buoyancy_of_one(&[], 1900.0, 0.6, 0.5 * terminal) < free);
    }

    #[test]
    fn the_printed_divisor_divides_by_the_mass_and_ignores_heat() {
        let flag = ("printed_divisor", Input::Flag(true));
        let p = Parameters::new(Model::Classic);
        let expected = p.buoyancy * (p.ambient_density - 0.6) * p.gravity / p.particle_mass;
        let printed = buoyancy_of_one(&[flag], 1900.0, 0.6, 0.0);
        assert!((printed / expected - 1.0).abs() < 1e-5);
        assert_eq!(printed, buoyancy_of_one(&[flag], 293.0, 0.6, 0.0));
    }
}
