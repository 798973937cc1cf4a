//! The outline of what is left of a solid that burns.

use std::sync::Arc;

use glam::Vec2;

use super::cells::Burning;
use super::state::Fuels;
use crate::combustion::reaction::embers::Embers;
use crate::extremes::{fast_max, fast_min};
use crate::params::Physics;
use crate::random::Random;
use crate::scene::Field;
use crate::solids::Solids;
use crate::solids::free::Moments;

/// Shortest time between two outlines \[s\].
const MIN_INTERVAL: f32 = 0.25;
/// How much must have gone for another outline, in cells.
const MIN_LOSS: f32 = 0.25;
/// Most nodes of an outline along a side, and in all.
const MAX_NODES_ALONG: f32 = 120.0;
const MAX_NODES: f32 = 8000.0;
/// Embers that a cell throws where it falls.
const EMBERS_PER_CELL: u32 = 2;

impl Fuels {
    /// Samples the outlines again if enough mass has gone.
    pub(super) fn shrink(
        &mut self,
        solids: &mut Solids,
        embers: &mut Embers,
        values: &Physics,
        random: &mut Random,
        dt: f32,
    ) {
        self.since += dt;
        if self.since < MIN_INTERVAL {
            return;
        }
        self.since = 0.0;
        let mut parts = Vec::new();
        for burning in &mut self.all {
            burning.weigh(solids);
            let standing = burning.standing();
            if burning.stood - standing < MIN_LOSS {
                burning.find_surface();
                continue;
            }
            burning.stood = standing;
            burning.find_outline();
            let body = solids.first(burning.id);
            let frame = body.map(|body| body.surface.frame);
            let mut throw = |place: Vec2| {
                if let Some(frame) = frame
                    && values.ember_rate > 0.0
                {
                    let at = frame.centre + frame.axis * place.x + frame.axis.perp() * place.y;
                    embers.throw_from(at, EMBERS_PER_CELL, values, random);
                }
            };
            let air = values.ambient_temperature;
            for index in 0..burning.cells.len() {
                if burning.fall(index, air) {
                    throw(burning.place(index));
                }
            }
            burning.fall_apart(solids, air, &mut parts, &mut throw);
            burning.find_surface();
            burning.move_waiting();
            if let Some(field) = &burning.left {
                solids.reshape(burning.id, field);
            }
        }
        if !parts.is_empty() {
            self.all.append(&mut parts);
            self.make_room();
        }
        if let Some(free) = &mut solids.free {
            free.burn_hinges(&|object, at| self.part_at(object, at));
        }
    }

    /// The part of a solid at a place, from the middle of the solid at first; `None` where it has burnt
    /// through.
    fn part_at(&self, object: u32, at: Vec2) -> Option<u32> {
        let (mut nearest, mut found) = (f32::MAX, Some(object));
        for burning in self.all.iter().filter(|part| part.object == object) {
            for (index, cell) in burning.cells.iter().enumerate() {
                let distance = at.distance_squared(burning.origin + burning.place(index));
                if cell.first > 0.0 && distance < nearest {
                    nearest = distance;
                    found = (cell.mass() > 0.0).then_some(burning.id);
                }
            }
        }
        found
    }
}

impl Burning {
    /// Gives a free body the mass that is left.
    pub(super) fn weigh(&self, solids: &mut Solids) {
        let Some(free) = &mut solids.free else {
            return;
        };
        free.weigh(self.id, &self.moments());
    }

    /// What is left, as a share of the mass of the whole solid.
    pub(super) fn moments(&self) -> Moments {
        let whole = fast_max(self.whole * (1.0 + 0.01 * self.moisture), 1e-12);
        let places = self.cells.iter().enumerate();
        let left = places.map(|(index, cell)| (cell.mass() / whole, self.place(index)));
        Moments::of(left, self.side)
    }

    /// Finds the outline of what stands.
    pub(super) fn find_outline(&mut self) {
        // A part is sampled as the whole.
        let half = self.whole_half();
        let longest = 2.0 * fast_max(half.x, half.y);
        let area = 4.0 * half.x * half.y;
        let step = fast_max(longest / MAX_NODES_ALONG, (area / MAX_NODES).sqrt());
        let field = Field::of_opacity(self.half, step, &|place| {
            let inside = 0.5 - self.first_distance(place) / (2.0 * step);
            fast_min(fast_max(inside, 0.0), self.standing_at(place))
        });
        self.left = Some(Arc::new(field));
    }

    /// How much stands at a place, between the middles of cells.
    fn standing_at(&self, place: Vec2) -> f32 {
        let at = (place + self.half) / self.side - 0.5;
        let (column, row) = (at.x.floor(), at.y.floor());
        let (x, y) = (at.x - column, at.y - row);
        let (column, row) = (column as isize, row as isize);
        let stands = |right: isize, up: isize| self.standing_near(column + right, row + up);
        let (low, high) = (
            stands(0, 0) + (stands(1, 0) - stands(0, 0)) * x,
            stands(0, 1) + (stands(1, 1) - stands(0, 1)) * x,
        );
        low + (high - low) * y
    }

    /// How much of a cell stands; outside of the first shape, of the cells around it.
    fn standing_near(&self, column: isize, row: isize) -> f32 {
        if let Some(own) = self.standing_of(column, row) {
            return own;
        }
        let mut most = 0.0;
        for (right, up) in [
            (-1, 0),
            (1, 0),
            (0, -1),
            (0, 1),
            (-1, -1),
            (1, -1),
            (-1, 1),
            (1, 1),
        ] {
            most = fast_max(
                self.standing_of(column + right, row + up).unwrap_or(0.0),
                most,
            );
        }
        most
    }

    fn standing_of(&self, column: isize, row: isize) -> Option<f32> {
        let (columns, rows) = (self.columns as isize, self.rows as isize);
        if !((0..columns).contains(&column) && (0..rows).contains(&row)) {
            return None;
        }
        let cell = &self.cells[(row * columns + column) as usize];
        let was_there = cell.first > 0.0 || cell.is_apart;
        was_there.then(|| cell.standing(self.material, self.load))
    }

    /// Lets a cell fall that is beyond the outline. Returns whether it does.
    fn fall(&mut self, index: usize, air: f32) -> bool {
        let (distance, _) = self.distance(self.place(index));
        let deep = 0.25 * fast_min(self.side.x, self.side.y);
        let (material, load) = (self.material, self.load);
        let cell = &self.cells[index];
        // A cell at the edge of the shape at first may have its middle outside.
        let stands = cell.standing(material, load) >= 0.5 || distance < -deep;
        if cell.mass() <= 0.0 || stands {
            return false;
        }
        self.turn_to_ash(index, air);
        true
    }

    /// Books what is in a cell as fallen.
    pub(super) fn turn_to_ash(&mut self, index: usize, air: f32) {
        let material = self.material;
        let cell = &mut self.cells[index];
        let heat = cell.capacity(material) * (cell.temperature - air);
        self.account.fallen += f64::from(cell.fuel + cell.char);
        self.account.steam += f64::from(cell.water);
        self.account.lost += f64::from(heat);
        (cell.fuel, cell.water, cell.char) = (0.0, 0.0, 0.0);
        (cell.received, cell.temperature) = (0.0, air);
    }

    /// Moves gas that waits at cells that have gone to one that has not.
    fn move_waiting(&mut self) {
        let mut waiting = 0.0;
        for cell in &mut self.cells {
            if cell.mass() <= 0.0 {
                waiting += std::mem::take(&mut cell.waiting);
            }
        }
        let mut cells = self.cells.iter_mut();
        match cells.find(|cell| cell.length > 0.0) {
            Some(cell) => cell.waiting += waiting,
            None => {
                if let Some(cell) = self.cells.first_mut() {
                    cell.waiting = waiting;
                }
            }
        }
    }
}
