//! The fires of a scene: what burns nearer to each other than its widths burns as one fire.
//!
//! The length of a line fire of the power Q' is D* = (Q'/(ρ c_p Tₐ √(b g)))^⅔.

use glam::Vec2;

use super::fuels::Fuels;
use super::reaction::burner::Burner;
use super::reaction::chemistry::HEAT_CAPACITY;
use crate::extremes::{fast_max, fast_min};
use crate::params::Physics;
use crate::scene::Scene;
use crate::solids::{Body, Solids};

/// Smallest b g of a fire [m/s²]: D* grows without bound towards none.
const MIN_LIFT: f32 = 0.1;

/// A source, or a solid that burns, as a part of a fire.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FirePart {
    /// The corners of its box \[m\].
    low: Vec2,
    high: Vec2,
    /// Its power [kW/m].
    power: f32,
    /// The fire that it belongs to.
    fire: usize,
    /// D* of this fire \[m\].
    pub length: f32,
}

/// b g, the weight that hot gas loses at most [m/s²].
pub(crate) fn lift(values: &Physics) -> f32 {
    fast_max(values.buoyancy * values.gravity, MIN_LIFT)
}

/// All that burns.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fires {
    parts: Vec<FirePart>,
    /// Whether there are several fires.
    are_several: bool,
}

crate::state! { FirePart: low high power fire length, Fires: parts are_several }

impl Fires {
    /// Finds the fires of the sources and of the solids that burn.
    pub fn find(&mut self, scene: &Scene, solids: &Solids, fuels: Option<&Fuels>) {
        let values: &Physics = scene.world();
        self.parts.clear();
        for source in scene.sources() {
            let boxes = solids.parts(&source).iter().map(Body::around);
            let around = boxes.reduce(|[low, high], [from, to]| [low.min(from), high.max(to)]);
            let block = || Burner::new(&source, values.spacing()).map(|burner| burner.around());
            if let Some(around) = around.or_else(block) {
                self.add(around, source.power);
            }
        }
        for (id, power) in fuels.into_iter().flat_map(Fuels::powers) {
            if let Some(body) = solids.first(id) {
                self.add(body.around(), power);
            }
        }
        self.measure(values);
    }

    /// Adds what burns with this power [kW/m], and unites the fires that it is near.
    pub(super) fn add(&mut self, [low, high]: [Vec2; 2], power: f32) {
        if power <= 0.0 {
            return;
        }
        let fire = self.parts.len();
        let new = FirePart {
            low,
            high,
            power,
            fire,
            length: 0.0,
        };
        self.parts.push(new);
        for i in 0..fire {
            let other = self.parts[i];
            if other.fire != fire && other.is_near(&new) {
                for part in &mut self.parts {
                    if part.fire == other.fire {
                        part.fire = fire;
                    }
                }
            }
        }
    }

    /// Gives each part the length of its fire.
    pub(super) fn measure(&mut self, values: &Physics) {
        let mut pairs = self.parts.windows(2);
        self.are_several = pairs.any(|pair| pair[0].fire != pair[1].fire);
        let heat = values.ambient_density * HEAT_CAPACITY * values.ambient_temperature;
        for i in 0..self.parts.len() {
            let fire = self.parts[i].fire;
            let parts = self.parts.iter().filter(|part| part.fire == fire);
            let flux = parts.map(|part| part.power).sum::<f32>() / heat;
            self.parts[i].length = libm::cbrtf(flux * flux / lift(values));
        }
    }

    /// The part that is nearest to a place.
    pub fn nearest(&self, place: Vec2) -> Option<&FirePart> {
        let mut nearest = self.parts.first()?;
        if self.are_several {
            let mut least = f32::MAX;
            for part in &self.parts {
                let distance = part.gap(place, place).length_squared();
                if distance < least {
                    (nearest, least) = (part, distance);
                }
            }
        }
        Some(nearest)
    }

    /// D* of the largest fire \[m\].
    pub fn greatest_length(&self) -> f32 {
        let lengths = self.parts.iter().map(|part| part.length);
        lengths.fold(0.0, fast_max)
    }
}

impl FirePart {
    /// The offset of its box from another one.
    fn gap(&self, low: Vec2, high: Vec2) -> Vec2 {
        (low - self.high).max(self.low - high).max(Vec2::ZERO)
    }

    /// Whether it is nearer to another one than the smaller width of the two.
    fn is_near(&self, other: &FirePart) -> bool {
        let width = |of: &FirePart| of.high.x - of.low.x;
        let reach = fast_min(width(self), width(other));
        self.gap(other.low, other.high).length_squared() < reach * reach
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::with;

    /// The fires of sources 0.4 m wide of 100 kW/m, with their left ends at these x.
    fn fires(lefts: &[f32]) -> Fires {
        let mut fires = Fires::default();
        for &left in lefts {
            fires.add([Vec2::new(left, 0.0), Vec2::new(left + 0.4, 0.1)], 100.0);
        }
        fires.measure(&with(&[]));
        fires
    }

    fn length(fires: &Fires, x: f32) -> f32 {
        fires
            .nearest(Vec2::new(x, 1.0))
            .map_or(0.0, |part| part.length)
    }

    #[test]
    fn sources_nearer_than_their_width_are_one_fire() {
        let alone = length(&fires(&[0.0]), 0.2);
        // (100 kW/m / (1.2 kg/m³ · 1 kJ/(kg·K) · 293 K · √(9.81 m/s²)))^⅔
        assert!((alone - 0.199).abs() < 0.01, "{alone}");
        let both = libm::cbrtf(4.0) * alone;
        for order in [[0.0, 0.7], [0.7, 0.0]] {
            let near = fires(&order);
            for x in [-1.0, 0.3, 2.0] {
                assert!((length(&near, x) / both - 1.0).abs() < 1e-5);
            }
        }
        // The one between joins the outer two, which are not near each other.
        let row = fires(&[0.0, 1.2, 0.6]);
        assert!((length(&row, 0.2) / libm::cbrtf(9.0) / alone - 1.0).abs() < 1e-5);
    }

    #[test]
    fn fires_far_apart_keep_their_own_length() {
        let far = fires(&[0.0, 0.6, 2.0]);
        let alone = length(&fires(&[0.0]), 0.2);
        assert_eq!(length(&far, 1.9), alone);
        assert!((length(&far, 1.2) / libm::cbrtf(4.0) / alone - 1.0).abs() < 1e-5);
        assert!((far.greatest_length() - length(&far, 0.0)).abs() < 1e-6);
    }

    #[test]
    fn nothing_that_burns_is_no_fire() {
        let mut none = fires(&[]);
        none.add([Vec2::ZERO, Vec2::ONE], 0.0);
        assert!(none.nearest(Vec2::ZERO).is_none());
        assert_eq!(none.greatest_length(), 0.0);
    }
}
