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
}

impl Fires {
    /// Finds the fires of the sources and of the solids that burn.
    pub fn find(&mut self, scene: &Scene, solids: &Solids, fuels: Option<&Fuels>) {
        let values: &Physics = scene.settings();
        self.parts.clear();
        for source in scene.sources() {
            let boxes = solids.parts(source).iter().map(Body::around);
            let around = boxes.reduce(|[low, high], [from, to]| [low.min(from), high.max(to)]);
            let block = || Burner::new(source, values.spacing()).map(|burner| burner.around());
            if let Some(around) = around.or_else(block) {
                self.add(around, source.fuel_power);
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
            if other.is_near(&new) {
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
        if self.parts.len() > 1 {
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
