//! Bounds of the gas, which limit the drawn part, and its mean motion, with which the fine structure rises.

use hearth_core::Instance;
use hearth_core::instance::GasParticle;
use hearth_core::params::Model;

use crate::instance::{position, remaining_life, temperature, upward_speed};

/// Minimum temperature of gas that counts as flame \[K\].
const MIN_FLAME_KELVIN: f32 = 600.0;

/// Soot, and fuel burnt in a second [1/s], of gas that shows light or smoke: means of less are below what `flame.frag` shows.
const VISIBLE_SOOT: f32 = 0.001;
const VISIBLE_BURNING: f32 = 0.05;

/// Number of rows of bounds. A flame is narrower than its widest part nearly everywhere.
pub const ROWS: usize = 12;

/// A range without numbers.
const NOTHING: [f32; 2] = [f32::INFINITY, f32::NEG_INFINITY];

/// The smallest range with both ranges.
fn joined([low, high]: [f32; 2], [lower, higher]: [f32; 2]) -> [f32; 2] {
    [low.min(lower), high.max(higher)]
}

/// Bounds of gas: rows of equal height, each as wide as its gas.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bounds {
    /// Lower and upper edge \[m\].
    pub heights: [f32; 2],
    /// Left and right edge of each row, from the lowest \[m\]; left > right without gas.
    pub rows: [[f32; 2]; ROWS],
}

hearth_core::state! { Bounds: heights rows }

impl Bounds {
    /// The bounds of the particles of any model, or of the embers, that `counts` is true of.
    #[inline(never)]
    fn of(particles: &[Instance], counts: fn(&Instance) -> bool) -> Bounds {
        let mut bounds = Bounds {
            heights: NOTHING,
            rows: [NOTHING; ROWS],
        };
        for particle in particles {
            let [_, y] = position(particle);
            if counts(particle) {
                bounds.heights = joined(bounds.heights, [y, y]);
            }
        }
        for particle in particles {
            let [x, y] = position(particle);
            if counts(particle) {
                bounds.add([y, y], [x, x]);
            }
        }
        bounds
    }

    /// The bounds of particles of any model, or of embers.
    pub fn of_all(particles: &[Instance]) -> Bounds {
        Bounds::of(particles, |_| true)
    }

    /// Widens the rows between two heights to a range.
    fn add(&mut self, [from, to]: [f32; 2], range: [f32; 2]) {
        let [lower, upper] = self.heights;
        // `as` saturates, and makes 0 of what is no number: all places may have one height.
        let [first, last] =
            [from, to].map(|y| ((y - lower) / (upper - lower) * ROWS as f32) as usize);
        for row in first.min(ROWS - 1)..=last.min(ROWS - 1) {
            self.rows[row] = joined(self.rows[row], range);
        }
    }

    /// Height of the lower edge of a row \[m\].
    pub fn height(&self, row: usize) -> f32 {
        let [lower, upper] = self.heights;
        lower + (upper - lower) * (row as f32 / ROWS as f32)
    }

    /// The bounds of all that `bounds` enclose, with a margin \[m\].
    #[inline(never)]
    pub fn around(bounds: &[Bounds], margin: f32) -> Bounds {
        let mut all = Bounds {
            heights: NOTHING,
            rows: [NOTHING; ROWS],
        };
        let wider = |[low, high]: [f32; 2]| [low - margin, high + margin];
        for other in bounds {
            all.heights = joined(all.heights, wider(other.heights));
        }
        for other in bounds {
            for (row, range) in other.rows.iter().enumerate() {
                all.add(
                    wider([other.height(row), other.height(row + 1)]),
                    wider(*range),
                );
            }
        }
        all
    }
}

/// Sums over all particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParticleBounds {
    /// Bounds of all particles.
    pub all: Bounds,
    /// Bounds of visible gas of the combustion model.
    pub visible: Bounds,
    /// Gas of the classic model, weighted by its remaining life.
    alive: Gas,
    /// Gas of the combustion model, weighted by its heat.
    hot: Gas,
}

hearth_core::state! { ParticleBounds: all visible alive hot }

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
    /// The bounds of particles of any model.
    #[inline(never)]
    pub fn of(particles: &[Instance]) -> ParticleBounds {
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
        ParticleBounds {
            all: Bounds::of_all(particles),
            visible: Bounds::of(particles, is_visible),
            alive,
            hot,
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
}

/// Whether gas of the combustion model shows light or smoke.
fn is_visible(&gas: &Instance) -> bool {
    let gas = GasParticle::from(gas);
    gas.soot >= VISIBLE_SOOT || gas.burn_rate >= VISIBLE_BURNING
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// A glowing particle.
    pub fn particle(x: f32, y: f32, speed: f32) -> Instance {
        [x, y, 0.0, speed, 1500.0, 1.0, 0.1, 1.0]
    }

    /// The bounds of places.
    pub fn bounds_of(places: impl IntoIterator<Item = [f32; 2]>) -> Bounds {
        let places = places.into_iter().map(|[x, y]| particle(x, y, 0.0));
        Bounds::of_all(&places.collect::<Vec<_>>())
    }

    /// Whether bounds enclose a place.
    pub fn has(bounds: &Bounds, [x, y]: [f32; 2]) -> bool {
        (0..ROWS).any(|row| {
            let [left, right] = bounds.rows[row];
            (bounds.height(row)..=bounds.height(row + 1)).contains(&y) && left <= x && x <= right
        })
    }

    /// The outline of a flame that leans.
    fn places() -> impl Iterator<Item = [f32; 2]> {
        (0..200).map(|step| {
            let up = step as f32 / 200.0;
            let side = if step % 2 == 0 { -1.0 } else { 1.0 };
            [0.4 * up + 0.2 * side * (1.0 - up), 0.1 + up]
        })
    }

    #[test]
    fn the_bounds_enclose_particles_and_those_of_a_flame_its_visible_gas() {
        let mut invisible = particle(0.2, 0.9, 1.0);
        (invisible[6], invisible[7]) = (0.0, 0.0);
        let of = ParticleBounds::of(&[particle(-0.3, 0.1, 1.0), invisible]);
        assert_eq!(of.all.heights, [0.1, 0.9]);
        assert_eq!([of.all.rows[0][0], of.all.rows[ROWS - 1][1]], [-0.3, 0.2]);
        assert_eq!(of.visible.heights, [0.1, 0.1]);
        let none = ParticleBounds::of(&[]).all;
        for bounds in [none, Bounds::around(&[none, none], 0.1)] {
            assert!(bounds.rows.iter().all(|[left, right]| left > right));
        }
    }

    #[test]
    fn wider_bounds_enclose_all_within_their_margin_and_follow_the_flame() {
        let margin = 0.05;
        let bounds = Bounds::around(&[bounds_of(places())], margin);
        for [x, y] in places() {
            for (dx, dy) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.7, 0.7)] {
                let near = [x + 0.99 * margin * dx, y + 0.99 * margin * dy];
                assert!(has(&bounds, near), "{near:?}");
            }
        }
        let area = |bounds: &Bounds| {
            let row = bounds.height(1) - bounds.height(0);
            bounds.rows.iter().map(|[l, r]| row * (r - l)).sum::<f32>()
        };
        let [lower, upper] = bounds.heights;
        let widest = bounds
            .rows
            .iter()
            .fold(NOTHING, |all, row| joined(all, *row));
        assert!(area(&bounds) < 0.7 * (upper - lower) * (widest[1] - widest[0]));
    }

    #[test]
    fn joined_bounds_enclose_both() {
        let low = bounds_of(places());
        let high = bounds_of(places().map(|[x, y]| [x - 1.0, 2.0 * y]));
        let both = Bounds::around(&[low, high], 0.0);
        for [x, y] in places() {
            assert!(
                has(&both, [x, y]) && has(&both, [x - 1.0, 2.0 * y]),
                "{x}, {y}"
            );
        }
    }
}
