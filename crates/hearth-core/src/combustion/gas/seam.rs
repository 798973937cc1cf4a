//! The seam: strips at the top and the bottom in which gas becomes fresh air again.
//!
//! The domain is periodic: gas that leaves at the top enters at the bottom, so the number of
//! particles is constant. In the seam, velocity relaxes to the wind, and temperature, fuel,
//! oxygen and soot relax to those of air. With wind, these four also relax at the sides, so that
//! smoke does not return on the other side.

use glam::{Vec2, Vec4};

use super::Gas;
use crate::extremes::{fast_max, fast_min};
use crate::params::Physics;

/// Relaxation rates of motion and matter, times the thickness of the seam [m/s]. Gas that
/// passes through the seam leaves it as air.
const MOTION_SPEED: f32 = 3.0;
const MATTER_SPEED: f32 = 9.6;
/// Matter relaxes at the full rate in all but the inner quarter of the seam.
const MATTER_EDGE: f32 = 4.0;
/// Minimum thickness of the seam, in spacings of the particles.
const MIN_THICKNESS: f32 = 2.0;
/// Wind at which the sides relax as fast as the seam [m/s].
const FRESH_WIND: f32 = 0.5;

/// Relaxes the gas in the seam to air for `dt`.
pub(crate) fn relax_to_air(gas: &mut Gas, values: &Physics, spacing: f32, dt: f32) {
    if values.seam == 0.0 {
        return;
    }
    // In a thinner seam, particles would skip it.
    let min_thickness = MIN_THICKNESS * spacing;
    let thickness = fast_max(values.seam * values.domain_height, min_thickness);
    let side = fast_max(values.seam * values.domain_width, min_thickness);
    let air = Vec4::new(values.ambient_temperature, 0.0, 1.0, 0.0);
    let wind = Vec2::new(values.wind, 0.0);
    let (motion_rate, matter_rate) = (MOTION_SPEED / thickness * dt, MATTER_SPEED / thickness * dt);
    let sides = (values.wind.abs() / FRESH_WIND).min(1.0);
    for i in 0..gas.len() {
        let at = gas.position[i];
        let from_edge = fast_min(at.y, values.domain_height - at.y);
        let from_side = 0.5 * values.domain_width - at.x.abs();
        let depth = 1.0 - from_edge / thickness;
        if depth > 0.0 {
            let velocity = &mut gas.velocity[i];
            *velocity = wind + (*velocity - wind) / (1.0 + motion_rate * fast_min(depth, 1.0));
        }
        let depth = fast_max(depth, (1.0 - from_side / side) * sides);
        if depth > 0.0 {
            let state = &mut gas.state[i];
            let relaxation = matter_rate * fast_min(MATTER_EDGE * depth, 1.0);
            *state = air + (*state - air) / (1.0 + relaxation);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::{random_gas, with};

    #[test]
    fn gas_that_passes_through_becomes_air_and_the_middle_is_unchanged() {
        let parameters = with(&[("wind", 0.0)]);
        let (before, mut gas) = (random_gas(&parameters, 3), random_gas(&parameters, 3));
        let thickness = parameters.seam * parameters.domain_height;
        // The time in which gas at 1 m/s passes.
        for _ in 0..200 {
            relax_to_air(
                &mut gas,
                &parameters,
                parameters.spacing(),
                thickness / 100.0,
            );
        }
        for i in 0..gas.len() {
            let y = gas.position[i].y;
            let depth = thickness - y.min(parameters.domain_height - y);
            if depth <= 0.0 {
                assert_eq!(
                    (gas.velocity[i], gas.state[i]),
                    (before.velocity[i], before.state[i])
                );
            } else if depth > 0.5 * thickness {
                assert!(gas.velocity[i].length() < 0.2);
                assert!((gas.state[i].x - parameters.ambient_temperature).abs() < 1.0);
                assert!(gas.state[i].y < 1e-3 && gas.state[i].w < 1e-3);
            }
        }
    }

    #[test]
    fn the_wind_clears_the_sides() {
        let parameters = with(&[("wind", 2.0)]);
        let mut gas = random_gas(&parameters, 4);
        for _ in 0..300 {
            relax_to_air(&mut gas, &parameters, parameters.spacing(), 1e-2);
        }
        let edge = 0.5 * parameters.domain_width - 0.02;
        let mut at_side = (0..gas.len()).filter(|&i| gas.position[i].x.abs() > edge);
        assert!(at_side.all(|i| gas.state[i].x < parameters.ambient_temperature + 5.0));
    }

    #[test]
    fn without_a_seam_nothing_relaxes() {
        let parameters = with(&[("seam", 0.0), ("wind", 3.0)]);
        let (before, mut gas) = (random_gas(&parameters, 5), random_gas(&parameters, 5));
        relax_to_air(&mut gas, &parameters, parameters.spacing(), 0.01);
        assert_eq!(gas.state, before.state);
        assert_eq!(gas.velocity, before.velocity);
    }
}
