//! Particle bounds, which limit the drawn part, and the mean motion of the gas, with which the fine
//! structure rises.

use hearth_core::Instance;
use hearth_core::params::Model;

use crate::instance::{position, remaining_life, temperature, upward_speed};

/// Minimum temperature of gas that counts as flame \[K\].
const MIN_FLAME_KELVIN: f32 = 600.0;

/// Sums over all particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParticleBounds {
    /// Left, lower, right and upper edge \[m\]; left > right without particles.
    pub edges: [f32; 4],
    /// Gas of the classic model, weighted by its remaining life.
    alive: Gas,
    /// Gas of the combustion model, weighted by its heat.
    hot: Gas,
}

hearth_core::state! { ParticleBounds: edges alive hot }

/// Sums over gas: of its weights, and weighted of height \[m\] and upward speed [m/s].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Gas([f32; 3]);

hearth_core::state! { Gas(sums) }

impl Gas {
    fn add(&mut self, weight: f32, height: f32, speed: f32) {
        for (sum, of) in self.0.iter_mut().zip([1.0, height, speed]) {
            *sum += weight * of;
        }
    }
}

impl ParticleBounds {
    /// The bounds of particles of any model and embers.
    #[inline(never)]
    pub fn of(particles: &[Instance], embers: &[Instance]) -> ParticleBounds {
        let far = f32::INFINITY;
        let mut edges = [far, far, -far, -far];
        let (mut alive, mut hot) = (Gas::default(), Gas::default());
        for particle in particles {
            let ([_, y], speed) = (position(particle), upward_speed(particle));
            alive.add(remaining_life(particle), y, speed);
            hot.add(
                (temperature(particle) - MIN_FLAME_KELVIN).max(0.0),
                y,
                speed,
            );
        }
        for [x, y] in particles.iter().chain(embers).map(position) {
            edges = [
                edges[0].min(x),
                edges[1].min(y),
                edges[2].max(x),
                edges[3].max(y),
            ];
        }
        ParticleBounds { edges, alive, hot }
    }

    /// The edges of both, with the motion of the first.
    #[inline(never)]
    pub fn around(a: &ParticleBounds, b: &ParticleBounds) -> ParticleBounds {
        let ([l, d, r, u], [left, lower, right, upper]) = (a.edges, b.edges);
        ParticleBounds {
            edges: [l.min(left), d.min(lower), r.max(right), u.max(upper)],
            ..*a
        }
    }

    /// Mean height \[m\] and upward speed [m/s] of the glowing gas of a model.
    pub fn mean(&self, model: Model) -> [f32; 2] {
        let Gas([weight, height, speed]) = match model {
            Model::Classic => self.alive,
            Model::Combustion => self.hot,
        };
        [height, speed].map(|sum| sum / weight.max(f32::MIN_POSITIVE))
    }

    /// The edges with a margin \[m\].
    pub fn widened(&self, margin: f32) -> [f32; 4] {
        let [left, lower, right, upper] = self.edges;
        [
            left - margin,
            lower - margin,
            right + margin,
            upper + margin,
        ]
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// A glowing particle.
    pub fn particle(x: f32, y: f32, speed: f32) -> Instance {
        [x, y, 0.0, speed, 1500.0, 1.0, 0.1, 1.0]
    }

    #[test]
    fn the_bounds_enclose_particles_and_embers() {
        let bounds = ParticleBounds::of(&[particle(-0.3, 0.1, 1.0)], &[particle(0.2, 0.9, 1.0)]);
        assert_eq!(bounds.edges, [-0.3, 0.1, 0.2, 0.9]);
        let [left, _, right, _] = ParticleBounds::of(&[], &[]).edges;
        assert!(left > right);
    }
}
