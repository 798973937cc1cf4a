//! Gas that a moved solid finds in its place.
//!
//! Gas within a spacing of the surface moves to the surface. Gas deeper inside is removed, with
//! its mass and heat: burning gas appears nowhere else.

use crate::combustion::Combustion;
use glam::Vec2;

use super::Lattice;
use super::walls::MIN_DISTANCE;
use crate::combustion::reaction::chemistry::HEAT_CAPACITY;
use crate::params::Physics;

/// Smallest distance of a lattice from solids, in spacings: pushed to the surface, its particles
/// would crowd there.
const FREE: f32 = 0.4;

impl Combustion {
    /// Removes the gas of a new lattice that is in solids, or too near. It is not counted.
    pub(crate) fn settle_lattice(&mut self, values: &Physics) {
        let removed = self.removed;
        self.settle(values, -FREE * values.spacing());
        self.removed = removed;
    }

    /// Lets gas that a caller gives fill the closed domain outside of solids, as a new lattice does.
    pub(crate) fn leave_out_solids(&mut self, values: &Physics) {
        if self.open.is_none() && !self.solids.is_empty() {
            self.fill_around(values);
        }
    }

    fn fill_around(&mut self, values: &Physics) {
        let size = Vec2::new(values.domain_width, values.domain_height);
        let corner = Vec2::new(-0.5 * size.x, 0.0);
        let places = Lattice::even(corner, size, 0.5 * values.spacing()).points;
        let taken = places.iter().filter(|at| self.solids.touch(**at, 0.0));
        let taken = taken.count();
        let left = (places.len() - taken).max(1);
        self.gas.missing = self.gas.len() * taken / left;
        self.gas.set_mass(values);
    }

    /// Moves the gas up to this `depth` in solids out of them \[m\], and removes the rest.
    pub(crate) fn settle(&mut self, values: &Physics, depth: f32) {
        if !self.solids.is_empty() {
            self.push_out(values, depth);
        }
    }

    fn push_out(&mut self, values: &Physics, depth: f32) {
        let gas = &mut self.gas;
        let floor = self.open.as_ref().is_some_and(|open| open.has_floor());
        let gap = MIN_DISTANCE * values.spacing();
        let mut i = 0;
        while i < gas.len() {
            if let Some(place) = self.solids.outside(gas.position[i], gap, depth, floor) {
                gas.position[i] = place;
                i += 1;
                continue;
            }
            let warmer = gas.state[i].x - values.ambient_temperature;
            self.removed.particles += 1;
            self.removed.mass += f64::from(gas.mass);
            self.removed.heat += f64::from(gas.mass * HEAT_CAPACITY * warmer);
            gas.missing += 1;
            gas.remove(i);
        }
        if self.open.is_none() {
            let bounds = self.present_bounds(values);
            for position in &mut self.gas.position {
                *position = bounds.wrap(*position);
            }
        }
    }
}
