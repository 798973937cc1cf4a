//! What the gas flows around: solids and the floor, their walls, and the gas that a moved solid finds in
//! its place.
//!
//! Gas within a spacing of the surface moves to the surface. Gas deeper inside is removed, with
//! its mass and heat: burning gas appears nowhere else.

use glam::Vec2;

use super::domain::Domain;
use super::gas::pair::Context;
use super::gas::removed::RemovedGas;
use super::gas::walls::{MIN_DISTANCE, Walls};
use super::gas::{Gas, Lattice};
use super::reaction::chemistry::HEAT_CAPACITY;
use crate::params::Physics;
use crate::solids::Solids;

/// Smallest distance of a lattice from solids, in spacings: pushed to the surface, its particles
/// would crowd there.
const MIN_LATTICE_DISTANCE: f32 = 0.4;

/// The solids in the gas, and the particles near them.
#[derive(Clone, Debug, Default)]
pub(super) struct Obstacles {
    pub solids: Solids,
    pub walls: Walls,
    /// The gas that solids have taken the place of.
    pub removed: RemovedGas,
}

crate::state! { Obstacles: solids walls removed }

impl Obstacles {
    /// Adds the friction and heat of the walls to the rates of the gas.
    pub fn resist(&mut self, gas: &mut Gas, context: &Context) {
        self.walls.resist(gas, &mut self.solids, context);
    }

    /// Adds the pressure of the walls to that of the gas.
    pub fn press(&mut self, gas: &mut Gas, context: &Context) {
        self.walls.press(gas, &mut self.solids, context);
    }

    /// Moves the solids that move by themselves to a time \[s\], and the gas out of them. Returns whether
    /// a particle has no place between them and stays where it was.
    pub fn advance(&mut self, gas: &mut Gas, values: &Physics, time: f64, dt: f32) -> bool {
        self.solids.advance(time);
        let stays = self.keep_outside(gas, values, dt);
        self.solids.warm(dt, values.ambient_temperature);
        self.solids.end_motions(dt);
        stays
    }

    /// Moves the gas out of the solids and the floor in a step of the length `dt`. Returns whether a particle has no
    /// place between them and stays where it was.
    pub fn keep_outside(&mut self, gas: &mut Gas, values: &Physics, dt: f32) -> bool {
        (self.walls).keep_outside(gas, &mut self.solids, values.spacing(), dt)
    }

    /// Moves the gas up to this `depth` in solids out of them \[m\], and removes the rest.
    pub fn displace(&mut self, gas: &mut Gas, domain: &Domain, values: &Physics, depth: f32) {
        if !self.solids.is_empty() {
            self.push_out(gas, domain, values, depth);
        }
    }

    fn push_out(&mut self, gas: &mut Gas, domain: &Domain, values: &Physics, depth: f32) {
        let floor = domain.has_floor();
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
        domain.wrap(gas, values);
    }

    /// Removes the gas of a new lattice that is in solids, or too near. It is not counted.
    pub fn displace_lattice(&mut self, gas: &mut Gas, domain: &Domain, values: &Physics) {
        let removed = self.removed;
        let depth = -MIN_LATTICE_DISTANCE * values.spacing();
        self.displace(gas, domain, values, depth);
        self.removed = removed;
    }

    /// Lets gas that a caller gives fill the closed domain outside of solids, as a new lattice does.
    pub fn leave_out(&self, gas: &mut Gas, domain: &Domain, values: &Physics) {
        if !domain.is_open() && !self.solids.is_empty() {
            self.fill_around(gas, values);
        }
    }

    fn fill_around(&self, gas: &mut Gas, values: &Physics) {
        let size = Vec2::new(values.domain_width, values.domain_height);
        let corner = Vec2::new(-0.5 * size.x, 0.0);
        let places = Lattice::even(corner, size, 0.5 * values.spacing()).points;
        let taken = places.iter().filter(|at| self.solids.touch(**at, 0.0));
        let taken = taken.count();
        let left = (places.len() - taken).max(1);
        gas.missing = gas.len() * taken / left;
        gas.set_mass(values);
    }
}
