//! Motion, cooling, ageing and walls, and the length of a substep.
//!
//! Symplectic Euler (the paper's §3.1.2): the velocity first, then the position
//! with the *new* velocity. The paper's equation 6 prints forward Euler, which
//! moves with the old one and does not conserve energy; a parameter selects it.

use super::block_force::{BlockForce, Four};
use super::equation_of_state::DENSITY_FLOOR;
use super::pairs::{Block, Pairs};
use super::particles::{ParticleState, Particles};
use super::solids::keep_all_outside;
use crate::bounds::Bounds;
use crate::extremes::fast_max;
use crate::lanes::{LANES, Lanes, Real, transposed};
use crate::params::{Physics, Walls};
use crate::solids::Solids;
use crate::time_step::{Stability, diffusion_limit};

/// Most substeps. The stability limits require more only for extreme parameters, where a higher
/// stiffness or viscosity changes nothing visible.
pub(crate) const MAX_SUBSTEPS: u32 = 32;

/// Courant number.
const COURANT: f32 = 0.35;

/// The division of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Substeps {
    pub count: u32,
    /// Length of each \[s\].
    pub length: f32,
    /// Largest stable viscosity in such a substep, at most the parameter [Pa·s].
    pub viscosity: f32,
}

impl Substeps {
    /// Divides a step of that length \[s\] into the fewest stable substeps. `last` is the motion of the last substep.
    pub fn divide(values: &Physics, step: f32, last: &Motion) -> Substeps {
        let h = values.smoothing_radius;
        let stability = Stability {
            courant: COURANT,
            h,
            sound: values.gas_constant.sqrt(),
            speed: last.max_speed,
            acceleration: last.max_acceleration,
            viscosity: values.viscosity,
            density: DENSITY_FLOOR,
        };
        let longest = stability.longest_step();
        let count = (step / longest).ceil();
        let count = (count as u32).clamp(1, MAX_SUBSTEPS);
        let length = step / count as f32;
        // If the shortest substep is too long for the viscosity, the gas gets the largest
        // stable viscosity.
        let stable = diffusion_limit(h, DENSITY_FLOOR, length);
        Substeps {
            count,
            length,
            viscosity: values.viscosity.min(stable),
        }
    }
}

/// Statistics of the motion in a substep.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Motion {
    /// Largest speed [m/s].
    pub max_speed: f32,
    /// Largest acceleration [m/s²].
    pub max_acceleration: f32,
    /// Particles that the speed limit slowed down.
    pub speed_limited: u32,
}

crate::state! { Motion: max_speed max_acceleration speed_limited }

/// Selects the position of a motion.
const POSITION: Lanes = Lanes::new([1.0, 1.0, 0.0, 0.0]);

/// Applies body forces and moves, cools and ages every particle by `dt`. Particles cool at a
/// constant rate down to the temperature of the air.
pub(crate) fn integrate(
    particles: &mut Particles,
    pairs: &mut Pairs,
    forces: &impl BlockForce,
    values: &Physics,
    dt: f32,
) -> Motion {
    let mut maxima = Maxima::default();
    for (block, members) in pairs.each() {
        let particles = &mut particles[members];
        if let Ok(four) = <&mut [ParticleState; LANES]>::try_from(&mut *particles) {
            advance(four, LANES, block, forces, values, dt, &mut maxima);
        } else if let Some(&particle) = particles.first() {
            // Copies pad the last block of a row. They do not move.
            let count = particles.len();
            let mut four = [particle; LANES];
            four[..count].copy_from_slice(particles);
            advance(&mut four, count, block, forces, values, dt, &mut maxima);
            particles.copy_from_slice(&four[..count]);
        }
    }
    Motion {
        max_speed: maxima.max_speed.max_lane().sqrt(),
        max_acceleration: maxima.max_acceleration.max_lane().sqrt(),
        speed_limited: maxima.speed_limited,
    }
}

/// Squares of the largest speeds and accelerations so far, and the number of particles that
/// the speed limit slowed down.
#[derive(Default)]
struct Maxima {
    max_speed: Lanes,
    max_acceleration: Lanes,
    speed_limited: u32,
}

/// Moves the first `count` particles of a block.
#[inline(always)]
fn advance(
    four: &mut [ParticleState; LANES],
    count: usize,
    block: &Block,
    forces: &impl BlockForce,
    values: &Physics,
    dt: f32,
    maxima: &mut Maxima,
) {
    let mut acceleration = block.acceleration;
    let local = Four::new(four, block, values.ambient_density);
    forces.add(&local, &mut acceleration);
    let [mut ax, mut ay] = acceleration;
    if count < LANES {
        (ax, ay) = (ax.keep_first(count), ay.keep_first(count));
    }
    let [old_x, old_y] = block.velocity;
    let mut velocity = [old_x + ax * dt, old_y + ay * dt];
    let mut square = velocity[0] * velocity[0] + velocity[1] * velocity[1];
    let limit = Lanes::splat(values.speed_limit);
    let too_fast = (limit * limit).less_mask(square);
    if too_fast != 0 {
        let factor = limit / square.sqrt().fast_max(limit);
        velocity = velocity.map(|v| v * factor);
        square = square.fast_min(limit * limit);
        maxima.speed_limited += too_fast.count_ones();
    }
    maxima.max_speed = square.fast_max(maxima.max_speed);
    maxima.max_acceleration = (ax * ax + ay * ay).fast_max(maxima.max_acceleration);

    let moved = if values.printed_euler {
        block.velocity
    } else {
        velocity
    };
    let motions = transposed([moved[0] * dt, moved[1] * dt, velocity[0], velocity[1]]);
    for (particle, motion) in four.iter_mut().zip(motions) {
        particle.motion = particle.motion * POSITION + motion;
        let cooled = particle.temperature - values.cooling_rate * dt;
        particle.temperature = fast_max(cooled, values.ambient_temperature);
        particle.age += dt;
    }
}

/// Applies the walls and the solids after a motion of `dt`, and removes particles that have died or
/// left.
pub(crate) fn bound(
    particles: &mut Particles,
    values: &Physics,
    solids: &mut Solids,
    bounds: &Bounds,
    dt: f32,
) {
    let walls = values.walls;
    if walls != Walls::Open {
        for particle in particles.iter_mut() {
            apply_walls(walls, bounds, particle);
        }
    }
    keep_all_outside(particles, solids, values, dt);
    particles.retain(|particle| particle.is_alive() && bounds.contains(particle.position()));
}

fn apply_walls(walls: Walls, bounds: &Bounds, particle: &mut ParticleState) {
    let half = 0.5 * bounds.width;
    let (mut at, mut v) = (particle.position(), particle.velocity());
    match walls {
        Walls::Open => return,
        Walls::Solid => stop_at(&mut at.x, &mut v.x, -half, half),
        Walls::Periodic => at = bounds.wrap(at),
    }
    stop_at(&mut at.y, &mut v.y, 0.0, f32::INFINITY);
    particle.motion = Lanes::new([at.x, at.y, v.x, v.y]);
}

fn stop_at(x: &mut f32, v: &mut f32, low: f32, high: f32) {
    // Comparisons and not `max`: the sign of `max(-0.0, 0.0)` differs between machines, and
    // the same seed must give the same bits.
    if *x < low {
        *x = low;
        if *v < 0.0 {
            *v = 0.0;
        }
    } else if *x > high {
        *x = high;
        if *v > 0.0 {
            *v = 0.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Particle;
    use crate::params::{Input, Model, Parameters};
    use glam::Vec2;

    fn with(values: &[(&str, f64)]) -> Parameters {
        let mut parameters = Parameters::new(Model::Classic);
        for &(id, value) in values {
            parameters.set(id, Input::Number(value)).expect(id);
        }
        parameters
    }

    #[test]
    fn a_substep_keeps_all_three_limits() {
        for (id, value) in [
            ("gas_constant", 6.0),
            ("viscosity", 0.1),
            ("smoothing_radius", 0.02),
        ] {
            let parameters = with(&[(id, value), ("time_step", 1.0 / 120.0)]);
            let (max_speed, max_acceleration) = (3.0, 40.0);
            let last = Motion {
                max_speed,
                max_acceleration,
                ..Motion::default()
            };
            let substeps = Substeps::divide(&parameters, parameters.time_step, &last);
            let h = parameters.smoothing_radius;
            let dt = substeps.length * 0.9999;
            assert!(dt <= 0.35 * h / (parameters.gas_constant.sqrt() + max_speed));
            assert!(dt <= 0.25 * (h / max_acceleration).sqrt());
            assert!(dt <= 0.125 * h * h * DENSITY_FLOOR / substeps.viscosity);
            assert!((substeps.length * substeps.count as f32 - parameters.time_step).abs() < 1e-7);
        }
    }

    #[test]
    fn a_viscosity_too_large_for_the_shortest_substep_is_limited() {
        let parameters = with(&[
            ("smoothing_radius", 0.01),
            ("viscosity", 0.1),
            ("time_step", 1.0 / 60.0),
        ]);
        let substeps = Substeps::divide(&parameters, parameters.time_step, &Motion::default());
        assert_eq!(substeps.count, MAX_SUBSTEPS);
        assert!(substeps.viscosity < 0.1);
    }

    /// Moves the particles for `dt` with an acceleration of 10 m/s² downwards, and
    /// no other.
    fn fall(particles: &mut Particles, parameters: &Parameters, dt: f32) -> Motion {
        let mut pairs = Pairs::default();
        let bounds = crate::classic::bounds(parameters);
        let kernel = crate::kernel::Kernel::new(parameters.smoothing_radius);
        pairs.sort(particles, &bounds, &kernel);
        let gravity = |_: Vec2, _: Vec2| Vec2::new(0.0, -10.0);
        integrate(particles, &mut pairs, &gravity, parameters, dt)
    }

    fn one_falling(velocity: f32) -> Particles {
        let mut particles = Particles::default();
        particles.push(Particle {
            velocity: Vec2::new(0.0, velocity),
            temperature: 400.0,
            ..Particle::at(Vec2::new(0.0, 1.0))
        });
        particles
    }

    #[test]
    fn the_new_velocity_moves_it_and_as_printed_the_old_one() {
        for (printed, expected) in [(false, -0.002), (true, 0.002)] {
            let mut parameters = Parameters::new(Model::Classic);
            assert_eq!(
                parameters.set("printed_euler", Input::Flag(printed)),
                Ok(())
            );
            let mut particles = one_falling(0.1);
            // From 0.1 m/s to −0.1 m/s.
            fall(&mut particles, &parameters, 0.02);
            let fallen = particles[0].position().y - 1.0;
            assert!((fallen - expected).abs() < 1e-6, "{fallen}");
            assert!((particles[0].velocity().y + 0.1).abs() < 1e-6);
        }
    }

    #[test]
    fn the_speed_limit_holds_and_counts_the_particles_it_slows() {
        let parameters = Parameters::new(Model::Classic);
        let mut particles = one_falling(-100.0);
        let motion = fall(&mut particles, &parameters, 0.01);
        assert!((particles[0].velocity().y + parameters.speed_limit).abs() < 1e-5);
        assert_eq!(motion.speed_limited, 1);
        let mut particles = one_falling(-1.0);
        assert_eq!(fall(&mut particles, &parameters, 0.01).speed_limited, 0);
    }

    #[test]
    fn gas_cools_at_the_set_rate_down_to_the_air() {
        let parameters = with(&[("cooling_rate", 500.0), ("ambient_temperature", 300.0)]);
        let mut particles = one_falling(0.0);
        fall(&mut particles, &parameters, 0.1);
        assert!((particles[0].temperature - 350.0).abs() < 1e-3);
        fall(&mut particles, &parameters, 0.2);
        assert_eq!(particles[0].temperature, 300.0);
        assert!((particles[0].age - 0.3).abs() < 1e-6);
    }
}
