//! Fast neighbour search: a uniform grid.
//!
//! Cells are as wide as the kernel's support, so a particle's neighbours are
//! in its own cell and the eight around it. A counting sort puts the particles
//! of a cell, and the cells of a row, next to each other in memory: the
//! candidates of a particle are then three runs of consecutive particles, and
//! two if each pair is to be seen once.

use glam::Vec2;

/// The rectangle in which the fire burns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub width: f32,
    pub height: f32,
    /// Whether the left and the right edge are the same place.
    pub periodic: bool,
    /// Whether the lower and the upper edge are the same place.
    pub endless: bool,
}

impl Bounds {
    /// Whether `position` is inside; what is no number is not.
    #[inline]
    pub fn hold(&self, position: Vec2) -> bool {
        position.x.abs() <= 0.5 * self.width && (0.0..=self.height).contains(&position.y)
    }

    /// Brings a position that has left over a periodic edge back in.
    #[inline]
    pub fn wrap(&self, position: Vec2) -> Vec2 {
        let mut inside = position;
        if self.periodic {
            inside.x = wrap(position.x + 0.5 * self.width, self.width) - 0.5 * self.width;
        }
        if self.endless {
            inside.y = wrap(position.y, self.height);
        }
        inside
    }
}

#[cfg(test)]
impl Bounds {
    /// The offset from `b` to `a`, the short way round.
    pub fn offset(&self, a: Vec2, b: Vec2) -> Vec2 {
        let short_way = |offset: f32, turn: f32| offset - turn * (offset / turn).round();
        let mut offset = a - b;
        if self.periodic {
            offset.x = short_way(offset.x, self.width);
        }
        if self.endless {
            offset.y = short_way(offset.y, self.height);
        }
        offset
    }
}

/// `x` modulo `turn`, from 0 to it; rounding may give the end itself.
#[inline]
fn wrap(x: f32, turn: f32) -> f32 {
    if (0.0..=turn).contains(&x) {
        return x;
    }
    // `clamp` would bring the code that prints both ends where they are the wrong
    // way round: 20 KB.
    (x - turn * (x / turn).floor()).max(0.0).min(turn)
}

/// Particles sorted by cell.
#[derive(Clone, Debug, Default)]
pub(crate) struct Grid {
    columns: usize,
    rows: usize,
    inverse_cell: Vec2,
    left: f32,
    /// After so many metres a periodic row or column begins again.
    across: Option<f32>,
    up: Option<f32>,
    /// Where each cell's particles begin; one more entry closes the last cell.
    starts: Vec<u32>,
    cell_of: Vec<u32>,
    order: Vec<u32>,
}

impl Grid {
    /// Sorts particles into cells at least as wide as `support`. Returns their
    /// order: what is at `order[i]` belongs to place `i`. Whoever keeps the
    /// particles puts them so; the grid then speaks of their new places.
    pub fn sort(&mut self, positions: &[Vec2], bounds: &Bounds, support: f32) -> &[u32] {
        self.lay_out(bounds, support);

        self.cell_of.clear();
        self.starts.clear();
        self.starts.resize(self.columns * self.rows + 1, 0);
        for &position in positions {
            let cell = self.cell(position);
            self.cell_of.push(cell as u32);
            self.starts[cell + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }

        // Each cell's start serves as its cursor and is one cell ahead
        // afterwards; shifting by one puts it right again.
        self.order.clear();
        self.order.resize(positions.len(), 0);
        for (i, &cell) in self.cell_of.iter().enumerate() {
            let cursor = &mut self.starts[cell as usize];
            self.order[*cursor as usize] = i as u32;
            *cursor += 1;
        }
        for cell in (1..self.starts.len()).rev() {
            self.starts[cell] = self.starts[cell - 1];
        }
        self.starts[0] = 0;
        &self.order
    }

    fn lay_out(&mut self, bounds: &Bounds, support: f32) {
        let cells = |length: f32| ((length / support).floor() as usize).max(1);
        self.columns = cells(bounds.width);
        self.rows = cells(bounds.height);
        self.across = bounds.periodic.then_some(bounds.width);
        self.up = bounds.endless.then_some(bounds.height);
        self.left = -0.5 * bounds.width;
        self.inverse_cell = Vec2::new(
            self.columns as f32 / bounds.width,
            self.rows as f32 / bounds.height,
        );
    }

    fn place(&self, position: Vec2) -> (usize, usize) {
        let at = (position - Vec2::new(self.left, 0.0)) * self.inverse_cell;
        // The cast brings whatever is outside, or not a number, to an edge.
        (
            (at.x as usize).min(self.columns - 1),
            (at.y as usize).min(self.rows - 1),
        )
    }

    fn cell(&self, position: Vec2) -> usize {
        let (column, row) = self.place(position);
        row * self.columns + column
    }

    /// The particles of the cells `first..=last` of a row.
    fn run(&self, row: usize, first: usize, last: usize) -> std::ops::Range<usize> {
        let base = row * self.columns;
        self.starts[base + first] as usize..self.starts[base + last + 1] as usize
    }

    /// Calls `see` with runs of particles that hold every neighbour `j` of
    /// particle `i` such that each pair is seen from one of its two ends only;
    /// with each run, what is to be added to the positions in it, which is not
    /// zero beyond a periodic edge.
    #[inline]
    pub fn later_candidates(
        &self,
        i: usize,
        position: Vec2,
        mut see: impl FnMut(std::ops::Range<usize>, Vec2),
    ) {
        let (column, row) = self.place(position);
        let last = (column + 1).min(self.columns - 1);
        see(i + 1..self.run(row, column, last).end, Vec2::ZERO);
        if let (Some(width), true) = (self.across, column + 1 == self.columns) {
            see(self.run(row, 0, 0), Vec2::new(width, 0.0));
        }
        if row + 1 < self.rows {
            self.see_row(row + 1, column, 0.0, &mut see);
        } else if let Some(height) = self.up {
            self.see_row(0, column, height, &mut see);
        }
    }

    /// Calls `see` with runs of particles that hold every particle within the
    /// support of `position`, wherever that is; with each run, what is to be
    /// added to the positions in it.
    pub fn candidates(&self, position: Vec2, mut see: impl FnMut(std::ops::Range<usize>, Vec2)) {
        let (column, row) = self.place(position);
        self.see_row(row, column, 0.0, &mut see);
        if row + 1 < self.rows {
            self.see_row(row + 1, column, 0.0, &mut see);
        } else if let Some(height) = self.up {
            self.see_row(0, column, height, &mut see);
        }
        if row > 0 {
            self.see_row(row - 1, column, 0.0, &mut see);
        } else if let Some(height) = self.up {
            self.see_row(self.rows - 1, column, -height, &mut see);
        }
    }

    /// Three cells of a row around a column.
    #[inline]
    fn see_row(
        &self,
        row: usize,
        column: usize,
        up: f32,
        see: &mut impl FnMut(std::ops::Range<usize>, Vec2),
    ) {
        let (first, last) = (column.saturating_sub(1), (column + 1).min(self.columns - 1));
        see(self.run(row, first, last), Vec2::new(0.0, up));
        let Some(width) = self.across else {
            return;
        };
        let end = self.columns - 1;
        if column == end {
            see(self.run(row, 0, 0), Vec2::new(width, up));
        }
        if column == 0 {
            see(self.run(row, end, end), Vec2::new(-width, up));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use std::collections::BTreeSet;

    fn cloud(n: usize, bounds: &Bounds, seed: u32) -> Vec<Vec2> {
        let mut random = Random::new(seed);
        let mut place = || {
            Vec2::new(
                random.between(-0.5 * bounds.width, 0.5 * bounds.width),
                random.between(0.0, bounds.height),
            )
        };
        (0..n).map(|_| place()).collect()
    }

    fn bounds_to_test() -> [(u32, Bounds); 8] {
        let bounds = |width, height, periodic, endless| Bounds {
            width,
            height,
            periodic,
            endless,
        };
        [
            (1, bounds(1.2, 1.5, false, false)),
            (2, bounds(1.2, 1.5, true, false)),
            (3, bounds(0.1, 3.0, false, false)),
            (4, bounds(0.1, 3.0, true, true)),
            (5, bounds(0.5, 0.1, true, false)),
            (6, bounds(6.0, 0.15, false, true)),
            (7, bounds(1.2, 1.5, true, true)),
            (8, bounds(0.3, 0.25, true, true)),
        ]
    }

    /// Sorts `positions` and returns whether two of them are within `support`.
    fn sort(grid: &mut Grid, positions: &mut Vec<Vec2>, bounds: &Bounds, support: f32) {
        let order = grid.sort(positions, bounds, support).to_vec();
        *positions = order.iter().map(|&i| positions[i as usize]).collect();
    }

    #[test]
    fn it_finds_the_pairs_that_comparing_all_with_all_finds() {
        let mut grid = Grid::default();
        for (seed, bounds) in bounds_to_test() {
            let mut positions = cloud(400, &bounds, seed);
            for support in [0.02, 0.07, 0.2] {
                // A kernel as wide as half a ring would meet its own end.
                if bounds.endless && support > 0.5 * bounds.height
                    || bounds.periodic && support > 0.5 * bounds.width
                {
                    continue;
                }
                sort(&mut grid, &mut positions, &bounds, support);
                let close = |i: usize, j: usize| {
                    bounds.offset(positions[i], positions[j]).length_squared() < support * support
                };
                let mut found = Vec::new();
                for i in 0..positions.len() {
                    grid.later_candidates(i, positions[i], |run, shift| {
                        let near = |&j: &usize| {
                            (positions[i] - shift - positions[j]).length_squared()
                                < support * support
                        };
                        found.extend(run.filter(near).map(|j| (i.min(j), i.max(j))));
                    });
                }
                let unique: BTreeSet<_> = found.iter().copied().collect();
                assert_eq!(unique.len(), found.len(), "a pair was seen twice");
                let all: BTreeSet<_> = (0..positions.len())
                    .flat_map(|i| (i + 1..positions.len()).map(move |j| (i, j)))
                    .filter(|&(i, j)| close(i, j))
                    .collect();
                assert_eq!(unique, all, "seed {seed}, support {support}");
            }
        }
    }

    #[test]
    fn it_finds_whoever_is_near_any_place() {
        let mut grid = Grid::default();
        for (seed, bounds) in bounds_to_test() {
            let (mut positions, support) = (cloud(300, &bounds, seed), 0.05);
            sort(&mut grid, &mut positions, &bounds, support);
            for place in cloud(100, &bounds, seed + 100) {
                let near = |&j: &usize| bounds.offset(place, positions[j]).length() < support;
                let mut found = Vec::new();
                grid.candidates(place, |run, shift| {
                    let near = |&j: &usize| (place - shift).distance(positions[j]) < support;
                    found.extend(run.filter(near));
                });
                found.sort_unstable();
                let all: Vec<_> = (0..positions.len()).filter(near).collect();
                assert_eq!(found, all, "seed {seed}");
            }
        }
    }

    #[test]
    fn sorting_is_a_permutation() {
        for (seed, bounds) in bounds_to_test() {
            let positions = cloud(1000, &bounds, seed);
            let mut order = Grid::default().sort(&positions, &bounds, 0.05).to_vec();
            order.sort_unstable();
            assert!(order.iter().enumerate().all(|(i, &at)| i == at as usize));
        }
    }

    #[test]
    fn wrapping_keeps_the_place_modulo_the_turn() {
        let bounds = Bounds {
            width: 1.2,
            height: 0.7,
            periodic: true,
            endless: true,
        };
        for x in [-1.7_f32, -0.6, -0.5999, -1e-9, 0.0, 0.31, 0.6, 0.61, 1.9] {
            let wrapped = bounds.wrap(Vec2::new(x, x));
            assert!(bounds.hold(wrapped), "{x} -> {wrapped}");
            for turns in [(x - wrapped.x) / 1.2, (x - wrapped.y) / 0.7] {
                assert!((turns - turns.round()).abs() < 1e-5, "{x} -> {wrapped}");
            }
        }
    }
}
