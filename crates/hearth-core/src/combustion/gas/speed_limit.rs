//! The speed limit of gas, and what gas at the limit changes.

use glam::Vec2;

use super::Gas;
use crate::extremes::fast_max;
use crate::params::Physics;

/// The speed limit, relative to the speed of sound.
pub(super) const SPEED_LIMIT: f32 = 1.5;
/// While more than one particle in this number is faster than this share of the speed limit, gas
/// has at least this artificial viscosity. In a closed domain with little viscosity and no seam,
/// shear and the noise of the particles would keep it there.
const INVERSE_FAST_SHARE: usize = 100;
const FAST_SPEED_SHARE: f32 = 0.99;
const VISCOSITY_AT_LIMIT: f32 = 0.2;

/// The coefficient α of the artificial viscosity: the parameter, and more while much gas is at
/// the speed limit.
pub(crate) fn artificial_viscosity(gas: &Gas, values: &Physics, sound: f32) -> f32 {
    let limit = FAST_SPEED_SHARE * SPEED_LIMIT * sound;
    let is_at_limit = |velocity: &Vec2| velocity.length_squared() > limit * limit;
    let fast = gas.velocity.iter().filter(|v| is_at_limit(v)).count();
    if fast * INVERSE_FAST_SHARE > gas.len() {
        fast_max(values.artificial_viscosity, VISCOSITY_AT_LIMIT)
    } else {
        values.artificial_viscosity
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::{random_gas, with};

    #[test]
    fn much_gas_at_the_speed_limit_is_more_viscous() {
        for (own, expected) in [(0.02, VISCOSITY_AT_LIMIT), (0.5, 0.5)] {
            let parameters = with(&[("artificial_viscosity", own)]);
            let (mut gas, sound) = (random_gas(&parameters, 1), 3.0);
            let limit = SPEED_LIMIT * sound;
            gas.velocity.fill(Vec2::new(0.9 * limit, 0.0));
            assert_eq!(artificial_viscosity(&gas, &parameters, sound), own as f32);
            let few = gas.len() / INVERSE_FAST_SHARE;
            gas.velocity[..few].fill(Vec2::new(0.0, -limit));
            assert_eq!(artificial_viscosity(&gas, &parameters, sound), own as f32);
            gas.velocity[few] = Vec2::new(limit, 0.0);
            assert_eq!(artificial_viscosity(&gas, &parameters, sound), expected);
        }
    }
}
