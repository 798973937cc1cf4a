//! The seam: where the domain closes upon itself, gas becomes fresh air again.
//!
//! The domain has no edge: what leaves at the top comes in at the bottom, so the
//! number of particles never changes and nothing is born or lost. In the seam, a
//! strip at the top and at the bottom, velocity relaxes to the wind, and
//! temperature, fuel, oxygen and soot to those of air. Where the wind blows, these four
//! do so at the sides too, so that smoke that has left does not come back on the other side.

use glam::{Vec2, Vec4};

use super::gas::Gas;
use crate::extremes::{fast_max, fast_min};
use crate::params::Physics;

/// Speed at which the seam swallows motion and matter, in its own thickness a
/// second [m/s]: what passes through is air when it comes out.
const SWALLOWS_MOTION: f32 = 3.0;
const SWALLOWS_MATTER: f32 = 9.6;
/// Matter is swallowed at full speed in all but the inner quarter of the seam.
const MATTER_EDGE: f32 = 4.0;
/// Least thickness of the seam, in spacings of the particles.
const THINNEST: f32 = 2.0;
/// Wind at which the sides swallow as much as the seam [m/s].
const FRESH_WIND: f32 = 0.5;

/// Makes air of what is in the seam, for `dt`.
pub(crate) fn freshen(gas: &mut Gas, values: &Physics, spacing: f32, dt: f32) {
    if values.seam == 0.0 {
        return;
    }
    // Thinner than this, particles would hop over it.
    let thinnest = THINNEST * spacing;
    let thickness = fast_max(values.seam * values.domain_height, thinnest);
    let side = fast_max(values.seam * values.domain_width, thinnest);
    let air = Vec4::new(values.ambient_temperature, 0.0, 1.0, 0.0);
    let wind = Vec2::new(values.wind, 0.0);
    let (calm, clean) = (
        SWALLOWS_MOTION / thickness * dt,
        SWALLOWS_MATTER / thickness * dt,
    );
    let sides = (values.wind.abs() / FRESH_WIND).min(1.0);
    for i in 0..gas.len() {
        let at = gas.position[i];
        let from_edge = fast_min(at.y, values.domain_height - at.y);
        let from_side = 0.5 * values.domain_width - at.x.abs();
        let depth = 1.0 - from_edge / thickness;
        if depth > 0.0 {
            let velocity = &mut gas.velocity[i];
            *velocity = wind + (*velocity - wind) / (1.0 + calm * fast_min(depth, 1.0));
        }
        let depth = fast_max(depth, (1.0 - from_side / side) * sides);
        if depth > 0.0 {
            let state = &mut gas.state[i];
            let swallowed = clean * fast_min(MATTER_EDGE * depth, 1.0);
            *state = air + (*state - air) / (1.0 + swallowed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::{wild, with};

    #[test]
    fn what_passes_through_it_is_air_and_the_middle_is_left_alone() {
        let parameters = with(&[("wind", 0.0)]);
        let (before, mut gas) = (wild(&parameters, 3), wild(&parameters, 3));
        let thickness = parameters.seam * parameters.domain_height;
        // As long as gas at 1 m/s takes to pass.
        for _ in 0..200 {
            freshen(
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
        let mut gas = wild(&parameters, 4);
        for _ in 0..300 {
            freshen(&mut gas, &parameters, parameters.spacing(), 1e-2);
        }
        let edge = 0.5 * parameters.domain_width - 0.02;
        let mut at_side = (0..gas.len()).filter(|&i| gas.position[i].x.abs() > edge);
        assert!(at_side.all(|i| gas.state[i].x < parameters.ambient_temperature + 5.0));
    }

    #[test]
    fn without_it_the_domain_is_left_alone() {
        let parameters = with(&[("seam", 0.0), ("wind", 3.0)]);
        let (before, mut gas) = (wild(&parameters, 5), wild(&parameters, 5));
        freshen(&mut gas, &parameters, parameters.spacing(), 0.01);
        assert_eq!(gas.state, before.state);
        assert_eq!(gas.velocity, before.velocity);
    }
}
