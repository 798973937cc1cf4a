//! The combustion model's step: how long it may be, and the motion in it.
//!
//! Symplectic Euler moves the particles. Then they are shifted a little from
//! where they are dense to where they are sparse (Lind et al., J. Comput. Phys. 231,
//! 2012; in proportion to the largest speed as by Sun et al., CMAME 315, 2017):
//! particles that only follow the flow line up along it, leave gaps, and the
//! noise of that eats vortices. A shift moves no momentum.

use glam::Vec2;

use super::gas::Gas;
use crate::bounds::Bounds;
use crate::extremes::{fast_max, fast_min};
use crate::params::Physics;
use crate::time_step::Stability;

/// Strength of the shift, in h²/s for each h/s of speed, where `shifting` is 1.
/// Twice as much starts to add energy to a Taylor–Green vortex; half as much
/// lets it decay 5 % too fast.
const SHIFT: f32 = 8.0;
/// Most of that in a step, in h²: shifting spreads particles as diffusion spreads
/// heat, and like it overshoots beyond a limit, here measured at 0.6.
const MAX_SHIFT: f32 = 0.3;
/// Most that a particle is shifted in a step, in h.
const FARTHEST_SHIFT: f32 = 0.3;
/// The speed limit, in speeds of sound.
const FASTEST: f32 = 1.5;
/// Courant's number.
const COURANT: f32 = 0.4;
/// Longest step \[s\].
const LONGEST: f32 = 1.0 / 60.0;

/// Least speed of sound, in speeds of the wind.
const BLOWN: f32 = 3.0;
/// Driven by this much [m/s²·kW/m] and no more, the parameter is the speed of sound.
const USUAL_DRIVE: f32 = 9.81 * 220.0;

/// The numerical speed of sound c₀ [m/s]: `stiffness`, and more for a stronger fire,
/// of `power` [kW/m], so that the gas stays as hard to compress. A planar plume rises as the cube
/// root of what drives it; and no wind comes near it.
pub(crate) fn sound_speed(values: &Physics, power: f32) -> f32 {
    let drive = values.buoyancy * values.gravity * power / USUAL_DRIVE;
    let risen = values.stiffness * libm::cbrtf(fast_max(drive, 1.0));
    fast_max(risen, BLOWN * values.wind.abs())
}

/// What a step's motion came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Motion {
    /// Largest speed [m/s].
    pub fastest: f32,
    /// Particles that the speed limit slowed down.
    pub limited: u32,
}

/// The longest stable step \[s\] for the accelerations of the gas.
pub(crate) fn longest(gas: &Gas, values: &Physics, h: f32, sound: f32) -> f32 {
    let largest = |vectors: &[Vec2]| {
        let squares = vectors.iter().map(|v| v.length_squared());
        squares.fold(0.0, fast_max).sqrt()
    };
    let (speed, acceleration) = (largest(&gas.velocity), largest(&gas.acceleration));
    let eddy = values.eddy_viscosity * values.eddy_viscosity * h * speed;
    let viscosity = values.kinematic_viscosity + values.artificial_viscosity * h * sound / 8.0;
    let diffusivity = viscosity.max(values.diffusion) + eddy;

    let stability = Stability {
        courant: COURANT,
        h,
        sound,
        speed,
        acceleration,
        viscosity: diffusivity,
        density: 1.0,
    };
    stability.longest_step().min(LONGEST)
}

/// Gives every particle its new velocity.
pub(crate) fn accelerate(gas: &mut Gas, sound: f32, dt: f32) -> Motion {
    let limit = FASTEST * sound;
    let mut motion = Motion::default();
    for (velocity, acceleration) in gas.velocity.iter_mut().zip(&gas.acceleration) {
        *velocity += *acceleration * dt;
        let speed = velocity.length();
        if speed > limit {
            *velocity *= limit / speed;
            motion.limited += 1;
        }
        motion.fastest = fast_max(motion.fastest, fast_min(speed, limit));
    }
    motion
}

/// Moves every particle with its new velocity, and shifts it a little down the
/// concentration gradient; `fastest` is the largest speed. Returns how many shifts
/// [`FARTHEST_SHIFT`] cut.
pub(crate) fn advance(
    gas: &mut Gas,
    bounds: &Bounds,
    shifting: f32,
    h: f32,
    fastest: f32,
    dt: f32,
) -> u32 {
    let shift = fast_min(SHIFT * shifting * h * fastest * dt, MAX_SHIFT * h * h);
    let farthest = FARTHEST_SHIFT * h;
    let mut cut = 0;
    for i in 0..gas.len() {
        let away = gas.concentration_gradient[i] * -shift;
        cut += u32::from(away.length_squared() > farthest * farthest);
        let away = away.clamp_length_max(farthest);
        gas.position[i] = bounds.wrap(gas.position[i] + gas.velocity[i] * dt + away);
    }
    cut
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::bounds;
    use crate::combustion::gas::tests::{wild, with};
    use crate::params::Parameters;

    fn sound(parameters: &Parameters) -> f32 {
        sound_speed(parameters, parameters.fuel_power)
    }

    #[test]
    fn a_step_keeps_all_three_limits() {
        for (speed, force, viscosity) in [
            (0.0, 0.0, 0.0),
            (8.0, 0.0, 0.0),
            (0.0, 1e4, 0.0),
            (0.0, 0.0, 0.01),
        ] {
            let parameters = with(&[
                ("kinematic_viscosity", viscosity),
                ("max_particles", 20_000.0),
            ]);
            let mut gas = wild(&parameters, 1);
            gas.velocity.fill(Vec2::new(speed, 0.0));
            gas.acceleration.fill(Vec2::new(0.0, force));
            let (h, sound) = (parameters.smoothing_length(), sound(&parameters));
            let dt = longest(&gas, &parameters, h, sound) * 0.9999;
            assert!(dt <= 0.4 * h / (sound + speed));
            assert!(dt <= 0.25 * (h / force.max(1e-6)).sqrt());
            assert!(dt <= 0.125 * h * h / (viscosity as f32).max(1e-9));
        }
    }

    #[test]
    fn a_stronger_fire_is_stiffer_and_a_weaker_one_is_as_the_slider_says() {
        let usual = sound(&with(&[]));
        assert_eq!(usual, with(&[]).stiffness);
        assert_eq!(sound(&with(&[("fuel_power", 10.0)])), usual);
        let strong = sound(&with(&[
            ("gravity", 19.62),
            ("fuel_power", 440.0),
            ("buoyancy", 2.0),
        ]));
        assert!((strong / usual - 2.0).abs() < 1e-4);
        assert_eq!(sound(&with(&[("wind", -3.0)])), 9.0);
    }

    #[test]
    fn shifting_follows_the_gradient_down_and_never_far() {
        let parameters = with(&[]);
        let mut gas = wild(&parameters, 2);
        gas.velocity.fill(Vec2::ZERO);
        gas.concentration_gradient.fill(Vec2::new(1.0, 0.0));
        gas.concentration_gradient[1] = Vec2::new(0.0, -1e6);
        let (h, before) = (parameters.smoothing_length(), gas.position.clone());
        gas.position[0] = Vec2::new(0.1, 0.9);
        gas.position[1] = Vec2::new(0.1, 0.9);
        advance(&mut gas, &bounds(&parameters), 1.0, h, 2.0, 1e-3);
        assert!(gas.position[0].x < 0.1);
        assert!((gas.position[1].y - 0.9 - FARTHEST_SHIFT * h).abs() < 1e-5);
        let mut still = wild(&parameters, 2);
        still.velocity.fill(Vec2::ZERO);
        still.concentration_gradient.fill(Vec2::new(1.0, 0.0));
        advance(&mut still, &bounds(&parameters), 0.0, h, 2.0, 1e-3);
        assert_eq!(still.position, before);
    }
}
