//! Water that strikes a solid with fuel: a cell takes what it can hold, and the rest runs down the surface.

use glam::Vec2;

use super::cells::{Burning, Cell};
use super::material::{BOILING, WATER_CAPACITY};
use super::state::Fuels;
use crate::extremes::fast_min;
use crate::random::Random;
use crate::solids::Body;

/// Most water in a cell over its dry mass: what light wood holds (Wood Handbook 2010, 4.2).
const MAX_WATER_SHARE: f32 = 1.0;
/// Cells along which water runs at most.
const MAX_FILM_CELLS: u32 = 128;
/// Weight of the direction of a film, and of a cell that is not full, against a fall by a cell; and the
/// steepest way, in cells, that a film does not climb.
const AHEAD_WEIGHT: f32 = 0.4;
const OPEN_WEIGHT: f32 = 0.7;
const MIN_FALL: f32 = -0.35;

impl Fuels {
    /// Gives water of a mass [kg/m] and a temperature \[K\] to a body at a place of its surface. Returns
    /// what its cells take, and whether one of them is hot enough to boil it.
    pub fn wet(
        &mut self,
        body: &Body,
        place: Vec2,
        mass: f32,
        temperature: f32,
        air: f32,
        random: &mut Random,
    ) -> (f32, bool) {
        let (distance, out) = body.surface.distance(place);
        let frame = &body.surface.frame;
        let surface = frame.local(place - out * distance);
        let normal = Vec2::new(frame.axis.dot(out), frame.axis.perp_dot(out));
        let mut all = self.all.iter_mut();
        let Some(burning) = all.find(|burning| burning.id == body.id()) else {
            return (0.0, false);
        };
        let Some(index) = burning.one_below(surface, normal, random.unit()) else {
            return (0.0, false);
        };
        let sideways = if random.unit() < 0.5 { -1 } else { 1 };
        let upward = Vec2::new(frame.axis.y, frame.axis.x);
        let (mut at, mut left, mut boils) = ((index, [sideways, 0]), mass, false);
        for _ in 0..MAX_FILM_CELLS {
            let soaked = burning.soak(at.0, left, temperature, air);
            left -= soaked;
            boils |= soaked > 0.0 && burning.cells[at.0].temperature > BOILING;
            let next = burning.downstream(at, upward);
            let Some(next) = next.filter(|_| left > 0.0) else {
                break;
            };
            at = next;
        }
        (mass - left, boils)
    }
}

impl Burning {
    /// Gives water of a mass [kg/m] and a temperature \[K\] to a cell. Returns what that takes.
    fn soak(&mut self, index: usize, mass: f32, temperature: f32, air: f32) -> f32 {
        let material = self.material;
        let cell = &mut self.cells[index];
        let taken = fast_min(mass, cell.room());
        if taken <= 0.0 {
            return 0.0;
        }
        let capacity = cell.capacity(material);
        let added = WATER_CAPACITY * taken;
        cell.water += taken;
        cell.temperature = (capacity * cell.temperature + added * temperature) / (capacity + added);
        self.account.gained += f64::from(added * (temperature - air));
        taken
    }

    /// The neighbour at the surface to which a film of water flows from a cell that it has reached by
    /// that step, and the step to it; `None` where it drips off.
    fn downstream(&self, (from, by): Flow, upward: Vec2) -> Option<Flow> {
        let columns = self.columns.max(1);
        let (column, row) = (from % columns, from / columns);
        let mut best = (MIN_FALL, None);
        for side in -1..=1_i32 {
            for up in -1..=1_i32 {
                let to = (
                    column.checked_add_signed(side as isize),
                    row.checked_add_signed(up as isize),
                );
                let (Some(x), Some(y)) = to else { continue };
                if x >= columns || y >= self.rows {
                    continue;
                }
                let index = y * columns + x;
                let cell = &self.cells[index];
                let is_here = side == 0 && up == 0;
                let returns = side == -by[0] && up == -by[1];
                if is_here || returns || cell.length <= 0.0 || cell.mass() <= 0.0 {
                    continue;
                }
                let step = Vec2::new(side as f32, up as f32);
                let ahead = (side * by[0] + up * by[1]) as f32;
                let falls = -step.dot(upward);
                let open = if cell.room() > 0.0 { OPEN_WEIGHT } else { 0.0 };
                let rank = falls + AHEAD_WEIGHT * ahead + open;
                if falls > MIN_FALL && rank > best.0 {
                    best = (rank, Some((index, [side, up])));
                }
            }
        }
        best.1
    }
}

/// A cell, and the columns and rows by which it was reached.
type Flow = (usize, [i32; 2]);

impl Cell {
    /// Water that it can still take [kg/m].
    fn room(&self) -> f32 {
        MAX_WATER_SHARE * (self.fuel + self.char) - self.water
    }
}
