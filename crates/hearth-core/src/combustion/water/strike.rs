//! Where droplets strike: solids, beds of sources, the floor and the edges of the domain.
//!
//! A solid with fuel takes the water into its cells, which dry before they burn. Hot solids without fuel
//! boil it off and lose that heat; cold ones let it run off.

use glam::Vec2;

use super::around::Around;
use super::report::Droplets;
use super::state::Water;
use crate::combustion::fuels::{BOILING, VAPORISATION, WATER_CAPACITY};
use crate::extremes::{fast_max, fast_min};
use crate::random::Random;
use crate::solids::Solids;

/// Distance from a surface at which a droplet touches it \[m\].
const TOUCH_DISTANCE: f32 = 2e-4;
/// Steps along a path at most.
const MAX_PATH_STEPS: u32 = 32;

impl Water {
    /// Moves a parcel along its path. Returns whether it still flies.
    pub(super) fn fall(
        &mut self,
        parcel: &mut Droplets,
        around: &mut Around,
        random: &mut Random,
    ) -> bool {
        if parcel.mass <= 0.0 {
            return false;
        }
        let from = parcel.position;
        let (end, struck) = trace(from, parcel.velocity * around.dt, around.solids);
        let mut beds = self.beds.iter_mut();
        let crossed = beds.find_map(|bed| bed.crossing(from, end).map(|share| (bed, share)));
        if let Some((bed, share)) = crossed {
            let (boiled, rest) = bed.take(parcel.mass);
            let place = from + (end - from) * share;
            self.account.boiled += f64::from(boiled);
            self.account.run_off += f64::from(rest);
            self.steam.rise(place, boiled / parcel.first, random);
            return false;
        }
        parcel.position = end;
        if let Some(solid) = struck {
            self.strike(parcel, solid, around, random);
            return false;
        }
        let is_on_floor = around.has_floor && end.y <= 0.0;
        if is_on_floor || !around.bounds.contains(end) {
            self.account.run_off += f64::from(parcel.mass);
            return false;
        }
        true
    }

    /// Gives the water of a parcel to a solid.
    fn strike(
        &mut self,
        parcel: &mut Droplets,
        solid: usize,
        around: &mut Around,
        random: &mut Random,
    ) {
        let body = &around.solids.bodies[solid];
        let (id, place) = (body.id(), parcel.position);
        let air = around.values.ambient_temperature;
        let mut left = parcel.mass;
        for bed in &mut self.beds {
            if bed.is_at(id, place) {
                let (boiled, rest) = bed.take(left);
                self.account.boiled += f64::from(boiled);
                self.steam.rise(place, boiled / parcel.first, random);
                left = rest;
            }
        }
        if let Some(fuels) = &mut around.fuels
            && body.burns
        {
            let own = parcel.temperature;
            let (soaked, is_hot) = fuels.wet(body, place, left, own, air, random);
            self.account.soaked += f64::from(soaked);
            left -= soaked;
            if is_hot {
                self.steam.rise(place, soaked / parcel.first, random);
            }
        } else {
            let own = parcel.temperature;
            let each = WATER_CAPACITY * fast_max(BOILING - own, 0.0) + VAPORISATION;
            let boiled = around.solids.boil(id, left, each, BOILING);
            self.account.boiled += f64::from(boiled);
            self.account.solid_heat += f64::from(boiled * each);
            left -= boiled;
            self.steam.rise(place, boiled / parcel.first, random);
        }
        self.account.run_off += f64::from(fast_max(left, 0.0));
    }
}

/// Follows a path from a place up to the first solid. Returns where it ends, and the number of the body
/// that is there.
fn trace(from: Vec2, path: Vec2, solids: &Solids) -> (Vec2, Option<usize>) {
    let length = path.length();
    let along = path / fast_max(length, 1e-9);
    let mut gone = 0.0;
    let mut at = from;
    for _ in 0..MAX_PATH_STEPS {
        at = from + along * gone;
        // A droplet that has arrived only must not touch one.
        let (mut nearest, mut body) = (fast_max(length - gone, TOUCH_DISTANCE), None);
        for (number, solid) in solids.bodies.iter().enumerate() {
            if solid.may_touch(at, nearest) {
                let (distance, _) = solid.surface.distance(at);
                if distance < nearest {
                    (nearest, body) = (distance, Some(number));
                }
            }
        }
        if nearest < TOUCH_DISTANCE {
            return (at, body);
        }
        if gone >= length {
            return (at, None);
        }
        gone = fast_min(gone + nearest, length);
    }
    (at, None)
}
