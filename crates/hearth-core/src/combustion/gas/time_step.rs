//! The time step of the combustion model and the motion in it.
//!
//! Symplectic Euler moves the particles. Particle shifting then moves them slightly from
//! dense to sparse regions (Lind et al., J. Comput. Phys. 231,
//! 2012; in proportion to the largest speed as by Sun et al., CMAME 315, 2017):
//! particles that only follow the flow line up along it and leave gaps, and the resulting noise
//! dissipates vortices. A shift transports no momentum.

use super::Gas;
use super::pair::Context;
use super::speed_limit::SPEED_LIMIT;
use crate::extremes::{fast_max, fast_min};
use crate::params::Physics;
use crate::time_step::Stability;

/// Strength of the shift with `shifting` 1, in h²/s per h/s of speed. Twice the strength adds
/// energy to a Taylor–Green vortex; with half the strength it decays 5 % too fast.
const SHIFT_STRENGTH: f32 = 8.0;
/// Largest strength in a step, in h². Shifting is a diffusion of particles, which overshoots
/// beyond a limit, measured as 0.6.
const MAX_SHIFT_STRENGTH: f32 = 0.55;
/// Largest shift of a particle in a step, in h.
const MAX_DISPLACEMENT: f32 = 0.55;
/// Courant number for the sound of the hottest gas. Noise in gas at rest decays with 1.05 too, whether cold
/// or at 3700 K.
const COURANT: f32 = 0.9;
/// Air takes the steps of gas with this expansion. In steps that are a quarter longer, the wake of a disc
/// oscillates with 0.22 u/d for 0.17.
const LEAST_EXPANSION: f32 = 1.65;
/// Parts of a step. Each has a pressure of its own, for sound, and moves and burns the gas. Neighbours, viscosity
/// and diffusion are those of the start of the step.
pub(crate) const PARTS: usize = 2;
/// The share of a step that is a part.
pub(crate) const PART: f32 = 1.0 / PARTS as f32;
/// Longest step \[s\].
const MAX_STEP: f32 = 1.0 / 60.0;

/// Minimum speed of sound, relative to the wind.
const MIN_SOUND_TO_WIND: f32 = 3.0;
/// Up to this drive [m/s²·kW/m], the speed of sound is the parameter.
const REFERENCE_DRIVE: f32 = 9.81 * 220.0;

/// The numerical speed of sound c₀ [m/s]: `stiffness`, and more for a stronger fire of `power`
/// [kW/m], so that the gas is compressed equally little: the speed of a planar plume is the cube
/// root of its drive. It is also well above the speed of the wind.
pub(crate) fn sound_speed(values: &Physics, power: f32) -> f32 {
    let drive = values.buoyancy * values.gravity * power / REFERENCE_DRIVE;
    let scaled = values.stiffness * libm::cbrtf(fast_max(drive, 1.0));
    fast_max(scaled, MIN_SOUND_TO_WIND * values.wind.abs())
}

/// The motion in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Motion {
    /// Largest speed [m/s].
    pub max_speed: f32,
    /// Particles that the speed limit slowed down.
    pub speed_limited: u32,
    /// Particles whose shift was clamped.
    pub clamped_shifts: u32,
    /// Length of the step \[s\]; 0 before the first one.
    pub length: f32,
}

crate::state! { Motion: max_speed speed_limited clamped_shifts length }

/// The longest stable part of a step \[s\] for the accelerations of the gas. `sound` is its speed in the air: in gas
/// that takes θ times the room of air, sound is √θ times as fast, because p = c₀² (Y − Ȳ) and ρ = Y/θ.
pub(crate) fn max_stable_part(gas: &Gas, context: &Context) -> f32 {
    let (values, sound) = (context.values, context.sound);
    let h = context.kernel.smoothing_length();
    let (mut speed, mut acceleration, mut expansion) = (0.0, 0.0, LEAST_EXPANSION);
    let accelerations = gas.acceleration.iter().zip(&gas.pressing);
    for ((v, (a, pressing)), &theta) in gas.velocity.iter().zip(accelerations).zip(&gas.expansion) {
        speed = fast_max(speed, v.length_squared());
        acceleration = fast_max(acceleration, (*a + *pressing).length_squared());
        expansion = fast_max(expansion, theta);
    }
    let (speed, acceleration) = (speed.sqrt(), acceleration.sqrt());
    let eddy = values.eddy_viscosity * values.eddy_viscosity * h * speed;
    let viscosity = values.kinematic_viscosity + context.artificial_viscosity * h * sound / 8.0;
    let diffusivity = viscosity.max(values.diffusion) + eddy;

    let stability = Stability {
        courant: COURANT,
        h,
        sound: sound * expansion.sqrt(),
        speed,
        acceleration,
        // Viscosity and diffusion act for the whole step at once.
        viscosity: diffusivity / PART,
        density: 1.0,
    };
    stability.longest_step().min(MAX_STEP * PART)
}

/// The longest stable step \[s\] of air at rest.
pub(crate) fn step_at_rest(h: f32, sound: f32) -> f32 {
    let part = COURANT * h / (sound * LEAST_EXPANSION.sqrt());
    fast_min(part / PART, MAX_STEP)
}

impl Motion {
    /// Accelerates every particle.
    pub fn accelerate(&mut self, gas: &mut Gas, sound: f32, dt: f32) {
        let limit = SPEED_LIMIT * sound;
        let (mut fastest, mut speed_limited) = (0.0, 0);
        let accelerations = gas.acceleration.iter().zip(&gas.pressing);
        for (velocity, (acceleration, pressing)) in gas.velocity.iter_mut().zip(accelerations) {
            *velocity += (*acceleration + *pressing) * dt;
            let square = velocity.length_squared();
            if square > limit * limit {
                *velocity *= limit / square.sqrt();
                speed_limited += 1;
            }
            fastest = fast_max(fastest, square);
        }
        (self.max_speed, self.speed_limited) = (fast_min(fastest.sqrt(), limit), speed_limited);
    }

    /// Moves every particle with its new velocity, and shifts it down the concentration gradient.
    pub fn advance(&mut self, gas: &mut Gas, shifting: f32, h: f32, dt: f32) {
        let shift = fast_min(
            SHIFT_STRENGTH * shifting * h * self.max_speed * dt,
            MAX_SHIFT_STRENGTH * h * h,
        );
        let max_displacement = MAX_DISPLACEMENT * h;
        let mut clamped = 0;
        for i in 0..gas.len() {
            let mut displacement = gas.concentration_gradient[i] * -shift;
            let length = displacement.length();
            if length > max_displacement {
                displacement *= max_displacement / length;
                clamped += 1;
            }
            gas.position[i] += gas.velocity[i] * dt + displacement;
        }
        self.clamped_shifts = clamped;
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec2;

    use super::*;
    use crate::combustion::gas::tests::{random_gas, with};
    use crate::kernel::Kernel;
    use crate::params::Parameters;

    /// The speed of sound in a fire of 220 kW/m.
    fn sound(parameters: &Parameters) -> f32 {
        sound_speed(parameters, 220.0)
    }

    fn longest_step(gas: &Gas, values: &Parameters) -> f32 {
        let kernel = Kernel::new(values.smoothing_length());
        let context = Context::new(gas, values, &kernel, sound(values));
        max_stable_part(gas, &context) / PART
    }

    #[test]
    fn a_step_keeps_all_three_limits() {
        for (speed, force, viscosity) in [
            (0.0, 0.0, 0.0),
            (8.0, 0.0, 0.0),
            (0.0, 1e4, 0.0),
            (0.0, 0.0, 0.01),
        ] {
            let parameters = with(&[("kinematic_viscosity", viscosity), ("particles", 20_000.0)]);
            let mut gas = random_gas(&parameters, 1);
            gas.velocity.fill(Vec2::new(speed, 0.0));
            gas.acceleration.fill(Vec2::new(0.0, force));
            let (h, sound) = (parameters.smoothing_length(), sound(&parameters));
            let dt = longest_step(&gas, &parameters) * 0.9999;
            assert!(PART * dt <= COURANT * h / (sound + speed));
            assert!(PART * dt <= 0.25 * (h / force.max(1e-6)).sqrt());
            assert!(dt <= 0.125 * h * h / (viscosity as f32).max(1e-9));
        }
    }

    #[test]
    fn the_hottest_gas_shortens_the_step_by_its_speed_of_sound() {
        let parameters = with(&[]);
        let mut gas = random_gas(&parameters, 1);
        gas.velocity.fill(Vec2::ZERO);
        gas.acceleration.fill(Vec2::ZERO);
        let (h, sound) = (parameters.smoothing_length(), sound(&parameters));
        let mut step = |hottest: f32| {
            gas.expansion.fill(1.0);
            gas.expansion[7] = hottest;
            longest_step(&gas, &parameters)
        };
        let hot = step(2.0);
        assert!((step(8.0) / hot - 0.5).abs() < 1e-6);
        assert_eq!(step(0.5), step_at_rest(h, sound));
        assert!(step(0.5) > hot);
    }

    #[test]
    fn a_stronger_fire_is_stiffer_and_a_weaker_one_has_the_stiffness_of_the_parameter() {
        let reference = sound(&with(&[]));
        assert_eq!(reference, with(&[]).stiffness);
        assert_eq!(sound_speed(&with(&[]), 10.0), reference);
        let strong = sound_speed(&with(&[("gravity", 19.62), ("buoyancy", 2.0)]), 440.0);
        assert!((strong / reference - 2.0).abs() < 1e-4);
        assert_eq!(sound(&with(&[("wind", -3.0)])), 9.0);
    }

    #[test]
    fn shifting_follows_the_gradient_down_and_is_limited() {
        let parameters = with(&[]);
        let mut gas = random_gas(&parameters, 2);
        gas.velocity.fill(Vec2::ZERO);
        gas.concentration_gradient.fill(Vec2::new(1.0, 0.0));
        gas.concentration_gradient[1] = Vec2::new(0.0, -1e6);
        let (h, before) = (parameters.smoothing_length(), gas.position.clone());
        gas.position[0] = Vec2::new(0.1, 0.9);
        gas.position[1] = Vec2::new(0.1, 0.9);
        let mut motion = Motion {
            max_speed: 2.0,
            ..Motion::default()
        };
        motion.advance(&mut gas, 1.0, h, 1e-3);
        assert_eq!(motion.clamped_shifts, 1);
        assert!(gas.position[0].x < 0.1);
        assert!((gas.position[1].y - 0.9 - MAX_DISPLACEMENT * h).abs() < 1e-5);
        let mut still = random_gas(&parameters, 2);
        still.velocity.fill(Vec2::ZERO);
        still.concentration_gradient.fill(Vec2::new(1.0, 0.0));
        motion.advance(&mut still, 0.0, h, 1e-3);
        assert_eq!(still.position, before);
    }
}
