//! A free solid that burns through: each part goes on as a body of its own.
//!
//! Cells that hold matter and share a side or a corner hold together. What was apart at first, as the
//! letters of a word, holds together as long as nothing of it burns through. Of every region of the
//! shape at first, the heaviest rest stays with the body, and the others break off. A part has a grid
//! with cells of the same size, so each cell keeps its state.

use glam::Vec2;

use super::cells::{Account, Burning, Cell};
use crate::solids::Solids;
use crate::solids::free::{FreeBodies, Piece};

/// How much of a part stands at least, in cells. A smaller one is ash.
const MIN_PART_CELLS: f32 = 2.0;
/// No region.
const NONE: u32 = u32::MAX;

impl Burning {
    /// Breaks off what no longer holds together, and appends it to `parts`. Calls `crumble` with the
    /// place of each cell that turns to ash.
    pub(super) fn fall_apart(
        &mut self,
        solids: &mut Solids,
        air: f32,
        parts: &mut Vec<Burning>,
        crumble: &mut dyn FnMut(Vec2),
    ) {
        let free = solids.free.as_ref();
        let Some(mut room) = free.and_then(|free| free.room_for_parts_of(self.id)) else {
            return;
        };
        self.unbroken = 0;
        let now = self.regions(|cell| cell.mass() > 0.0);
        let stays = self.staying(&now);
        let mut changes = false;
        for (region, &of) in (0..).zip(&now) {
            if of != region || stays.contains(&region) {
                continue;
            }
            let part = self.part(&now, region);
            if part.is_some() && room == 0 {
                self.unbroken += 1;
                continue;
            }
            changes = true;
            if part.is_some() {
                // The body as it is before it breaks.
                self.weigh(solids);
            }
            for (index, _) in now.iter().enumerate().filter(|entry| *entry.1 == region) {
                match &part {
                    Some(_) => self.leave_apart(index),
                    None => {
                        self.turn_to_ash(index, air);
                        crumble(self.place(index));
                    }
                }
            }
            if let Some(mut part) = part
                && let Some(field) = part.left.clone()
            {
                let piece = Piece {
                    middle: part.origin - self.origin,
                    field,
                    left: part.moments(),
                };
                part.id = FreeBodies::break_off(solids, self.id, &self.moments(), piece);
                parts.extend(Some(part));
                self.is_broken = true;
                room -= 1;
            }
        }
        if changes {
            self.find_outline();
            self.stood = self.standing();
        }
    }

    /// For each cell that is in, the first cell of its region; else [`NONE`].
    fn regions(&self, is_in: fn(&Cell) -> bool) -> Vec<u32> {
        let cells = (0..).zip(&self.cells);
        let of = cells.map(|(index, cell)| if is_in(cell) { index } else { NONE });
        let mut of: Vec<u32> = of.collect();
        let columns = self.columns.max(1);
        let (mut changes, mut backward) = (true, false);
        while changes {
            changes = false;
            for number in 0..of.len() {
                let index = if backward {
                    of.len() - 1 - number
                } else {
                    number
                };
                let own = of[index];
                if own == NONE {
                    continue;
                }
                let column = index % columns;
                let mut least = own;
                for row in [index.wrapping_sub(columns), index, index + columns] {
                    for near in column.saturating_sub(1)..columns.min(column + 2) {
                        let near = of.get(row.wrapping_add(near).wrapping_sub(column));
                        least = near.map_or(least, |near| least.min(*near));
                    }
                }
                if least < own {
                    of[index] = least;
                    changes = true;
                }
            }
            backward = !backward;
        }
        of
    }

    /// The heaviest rest of each region of the shape at first.
    fn staying(&self, now: &[u32]) -> Vec<u32> {
        let first = self.regions(|cell| cell.first > 0.0);
        let mut mass: Vec<f32> = now.iter().map(|_| 0.0).collect();
        for (&of, cell) in now.iter().zip(&self.cells) {
            if of != NONE {
                mass[of as usize] += cell.mass();
            }
        }
        // At the first cell of each region, its heaviest rest.
        let mut heaviest: Vec<u32> = now.iter().map(|_| NONE).collect();
        for (&of, &inside) in now.iter().zip(&first) {
            if of == NONE || inside == NONE {
                continue;
            }
            let before = &mut heaviest[inside as usize];
            if *before == NONE || mass[of as usize] > mass[*before as usize] {
                *before = of;
            }
        }
        heaviest
    }

    /// A region as a solid of its own; `None` if it is too small.
    fn part(&self, now: &[u32], region: u32) -> Option<Burning> {
        let columns = self.columns.max(1);
        let (mut left, mut right, mut bottom, mut top) = (columns, 0, self.rows, 0);
        let mut standing = 0.0;
        for (index, cell) in self.cells.iter().enumerate() {
            if now[index] == region {
                let (column, row) = (index % columns, index / columns);
                (left, right) = (left.min(column), right.max(column));
                (bottom, top) = (bottom.min(row), top.max(row));
                standing += cell.standing(self.material, self.load);
            }
        }
        if standing < MIN_PART_CELLS {
            return None;
        }
        // A border of a cell shows where it ends.
        let (left, bottom) = (left.saturating_sub(1), bottom.saturating_sub(1));
        let (right, top) = ((right + 2).min(columns), (top + 2).min(self.rows));
        let (account, mut part) = (&self.account, self.clone());
        let mut number = 0;
        for row in bottom..top {
            for column in left..right {
                let index = row * columns + column;
                let cell = self.cells[index];
                let is_in = now[index] == region;
                part.cells[number] = if is_in { cell } else { cell.apart() };
                number += 1;
            }
        }
        part.cells.truncate(number);
        (part.columns, part.rows) = (right - left, top - bottom);
        part.half = 0.5 * self.side * Vec2::new(part.columns as f32, part.rows as f32);
        let corner = self.side * Vec2::new(left as f32, bottom as f32) - self.half;
        part.origin = self.origin + corner + part.half;
        part.account = Account {
            oxygen: account.oxygen,
            lit: account.lit,
            starved: account.starved,
            ..Account::default()
        };
        part.is_broken = true;
        part.stood = part.standing();
        part.find_outline();
        part.find_surface();
        let field = part.left.as_deref();
        field.is_some_and(FreeBodies::is_body).then_some(part)
    }

    /// Leaves a cell to a part.
    fn leave_apart(&mut self, index: usize) {
        self.cells[index] = self.cells[index].apart();
    }
}

impl Cell {
    /// It without anything, where another part has what was there.
    fn apart(&self) -> Cell {
        Cell {
            temperature: self.temperature,
            is_apart: self.is_apart || self.first > 0.0,
            ..Cell::default()
        }
    }
}
