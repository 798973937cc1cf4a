//! Motion, cooling, ageing, walls; and how long a substep may be.
//!
//! Symplectic Euler (the paper's §3.1.2): the velocity first, then the position
//! with the *new* velocity. The paper's equation 6 prints forward Euler, which
//! moves with the old one and lets energy drift; it can be chosen.

use super::density::DENSITY_FLOOR;
use super::particles::Particles;
use crate::extremes::{larger, smaller};
use crate::grid::Bounds;
use crate::params::{Values, Walls};

/// Most parts that a step is divided into. The limits ask for more only in
/// corners of the ranges where stiffness or viscosity could not be seen to grow
/// any further.
pub(crate) const MOST_SUBSTEPS: u32 = 32;

/// How a step is divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Substeps {
    pub count: u32,
    /// Length of each \[s\].
    pub length: f32,
    /// Viscosity that such a substep can bear [Pa·s].
    pub viscosity: f32,
}

impl Substeps {
    /// Divides a step by the three limits of an explicit scheme:
    ///
    /// ```text
    /// 0.35 h/(c + u)     nothing crosses a kernel in one go (Courant)
    /// 0.25 √(h/a)        no force moves a particle too far
    /// 0.125 h²/ν         viscosity damps and does not overshoot
    /// ```
    ///
    /// `fastest` and `hardest` are the largest speed and acceleration of the
    /// last substep.
    pub fn divide(values: &Values, fastest: f32, hardest: f32) -> Substeps {
        let h = values.smoothing_radius;
        let sound = values.gas_constant.sqrt();
        let courant = 0.35 * h / (sound + fastest);
        let force = 0.25 * (h / hardest.max(1e-6)).sqrt();
        let diffusion = |viscosity: f32| 0.125 * h * h * DENSITY_FLOOR / viscosity.max(1e-9);

        let longest = courant.min(force).min(diffusion(values.viscosity));
        let count = (values.time_step / longest).ceil();
        let count = (count as u32).clamp(1, MOST_SUBSTEPS);
        let length = values.time_step / count as f32;
        // Where even the shortest substep is too long for the viscosity, the
        // gas gets the stiffest viscosity that it can bear.
        let bearable = 0.125 * h * h * DENSITY_FLOOR / length;
        Substeps {
            count,
            length,
            viscosity: values.viscosity.min(bearable),
        }
    }
}

/// What a substep's motion came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Motion {
    /// Largest speed [m/s].
    pub fastest: f32,
    /// Largest acceleration [m/s²].
    pub hardest: f32,
    /// Particles that the speed limit held back.
    pub limited: u32,
}

/// Moves every particle by `dt`.
pub(crate) fn integrate(particles: &mut Particles, values: &Values, dt: f32) -> Motion {
    let mut motion = Motion::default();
    let limit = values.speed_limit;
    for i in 0..particles.len() {
        let old_velocity = particles.velocity[i];
        let acceleration = particles.acceleration[i];
        let mut velocity = old_velocity + acceleration * dt;
        let speed = velocity.length();
        if speed > limit {
            velocity *= limit / speed;
            motion.limited += 1;
        }
        particles.position[i] += dt
            * if values.printed_euler {
                old_velocity
            } else {
                velocity
            };
        particles.velocity[i] = velocity;

        motion.fastest = larger(motion.fastest, smaller(speed, limit));
        motion.hardest = larger(motion.hardest, acceleration.length());
    }
    motion
}

/// Cools and ages every particle by `dt`. It cools at a steady rate, down to
/// the temperature of the air.
pub(crate) fn cool_and_age(particles: &mut Particles, values: &Values, dt: f32) {
    for temperature in &mut particles.temperature {
        let cooled = *temperature - values.cooling_rate * dt;
        *temperature = larger(cooled, values.ambient_temperature);
    }
    for age in &mut particles.age {
        *age += dt;
    }
}

/// Applies the walls and takes away whoever has died or left.
pub(crate) fn bound(particles: &mut Particles, values: &Values, bounds: &Bounds) {
    let half = 0.5 * bounds.width;
    for i in 0..particles.len() {
        let position = &mut particles.position[i];
        let velocity = &mut particles.velocity[i];
        match values.walls {
            Walls::Open => {}
            Walls::Solid => {
                stop_at(&mut position.x, &mut velocity.x, -half, half);
                stop_at(&mut position.y, &mut velocity.y, 0.0, f32::INFINITY);
            }
            Walls::Periodic => {
                *position = bounds.wrap(*position);
                stop_at(&mut position.y, &mut velocity.y, 0.0, f32::INFINITY);
            }
        }
    }
    particles.retain(|p, i| p.age[i] < p.lifetime[i] && bounds.hold(p.position[i]));
}

fn stop_at(x: &mut f32, v: &mut f32, low: f32, high: f32) {
    // Comparisons and not `max`: which zero `max(-0.0, 0.0)` gives differs
    // between machines, and the same seed must give the same bits.
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
            let (fastest, hardest) = (3.0, 40.0);
            let substeps = Substeps::divide(&parameters, fastest, hardest);
            let h = parameters.smoothing_radius;
            let dt = substeps.length * 0.9999;
            assert!(dt <= 0.35 * h / (parameters.gas_constant.sqrt() + fastest));
            assert!(dt <= 0.25 * (h / hardest).sqrt());
            assert!(dt <= 0.125 * h * h * DENSITY_FLOOR / substeps.viscosity);
            assert!((substeps.length * substeps.count as f32 - parameters.time_step).abs() < 1e-7);
        }
    }

    #[test]
    fn a_viscosity_beyond_the_shortest_substep_is_cut_to_what_it_bears() {
        let parameters = with(&[
            ("smoothing_radius", 0.01),
            ("viscosity", 0.1),
            ("time_step", 1.0 / 60.0),
        ]);
        let substeps = Substeps::divide(&parameters, 0.0, 0.0);
        assert_eq!(substeps.count, MOST_SUBSTEPS);
        assert!(substeps.viscosity < 0.1);
    }

    fn one_falling(velocity: f32) -> Particles {
        let mut particles = Particles::default();
        particles.push(Particle {
            velocity: Vec2::new(0.0, velocity),
            temperature: 400.0,
            ..Particle::at(Vec2::new(0.0, 1.0))
        });
        particles.acceleration[0] = Vec2::new(0.0, -10.0);
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
            integrate(&mut particles, &parameters, 0.02);
            let fallen = particles.position[0].y - 1.0;
            assert!((fallen - expected).abs() < 1e-6, "{fallen}");
            assert!((particles.velocity[0].y + 0.1).abs() < 1e-6);
        }
    }

    #[test]
    fn nothing_is_faster_than_the_speed_limit_and_what_is_held_back_is_counted() {
        let parameters = Parameters::new(Model::Classic);
        let mut particles = one_falling(-100.0);
        let motion = integrate(&mut particles, &parameters, 0.01);
        assert!((particles.velocity[0].y + parameters.speed_limit).abs() < 1e-5);
        assert_eq!(motion.limited, 1);
        let mut particles = one_falling(-1.0);
        assert_eq!(integrate(&mut particles, &parameters, 0.01).limited, 0);
    }

    #[test]
    fn gas_cools_at_the_rate_that_is_set_and_not_below_the_air() {
        let parameters = with(&[("cooling_rate", 500.0), ("ambient_temperature", 300.0)]);
        let mut particles = one_falling(0.0);
        cool_and_age(&mut particles, &parameters, 0.1);
        assert!((particles.temperature[0] - 350.0).abs() < 1e-3);
        cool_and_age(&mut particles, &parameters, 0.2);
        assert_eq!(particles.temperature[0], 300.0);
        assert!((particles.age[0] - 0.3).abs() < 1e-6);
    }
}
