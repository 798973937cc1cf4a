//! Fast neighbour search: a uniform grid.
//!
//! Cells are as wide as the kernel's support, so a particle's neighbours are
//! in its own cell and the eight around it. A counting sort puts the particles
//! of a cell, and the cells of a row, next to each other in memory: the
//! candidates of a particle are then three runs of consecutive particles, and
//! two if each pair is to be seen once.

use glam::Vec2;

use crate::particles::Particles;

/// The rectangle in which the fire burns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    pub width: f32,
    pub height: f32,
    /// Whether the left and the right edge are the same place.
    pub periodic: bool,
}

impl Bounds {
    /// Whether `position` is inside; what is no number is not.
    #[inline]
    pub fn hold(&self, position: Vec2) -> bool {
        position.x.abs() <= 0.5 * self.width && (0.0..=self.height).contains(&position.y)
    }

    /// The offset from `b` to `a`, the short way round.
    #[inline]
    pub fn offset(&self, a: Vec2, b: Vec2) -> Vec2 {
        let mut offset = a - b;
        if self.periodic {
            if offset.x > 0.5 * self.width {
                offset.x -= self.width;
            } else if offset.x < -0.5 * self.width {
                offset.x += self.width;
            }
        }
        offset
    }
}

/// Particles sorted by cell.
#[derive(Clone, Debug, Default)]
pub(crate) struct Grid {
    columns: usize,
    rows: usize,
    inverse_cell: Vec2,
    left: f32,
    wraps: bool,
    /// Where each cell's particles begin; one more entry closes the last cell.
    starts: Vec<u32>,
    cell_of: Vec<u32>,
    order: Vec<u32>,
}

impl Grid {
    /// Sorts `particles` into cells at least as wide as `support`.
    pub fn sort(&mut self, particles: &mut Particles, bounds: &Bounds, support: f32) {
        self.lay_out(bounds, support);

        self.cell_of.clear();
        self.starts.clear();
        self.starts.resize(self.columns * self.rows + 1, 0);
        for &position in &particles.position {
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
        self.order.resize(particles.len(), 0);
        for (i, &cell) in self.cell_of.iter().enumerate() {
            let cursor = &mut self.starts[cell as usize];
            self.order[*cursor as usize] = i as u32;
            *cursor += 1;
        }
        for cell in (1..self.starts.len()).rev() {
            self.starts[cell] = self.starts[cell - 1];
        }
        self.starts[0] = 0;

        particles.reorder(&self.order);
    }

    fn lay_out(&mut self, bounds: &Bounds, support: f32) {
        let cells = |length: f32| ((length / support).floor() as usize).max(1);
        self.columns = cells(bounds.width);
        self.rows = cells(bounds.height);
        // With fewer than three columns the cells to the left and to the right
        // would be the same one and pairs would count twice; a single column
        // that holds everything is right, and such a domain is small.
        if bounds.periodic && self.columns < 3 {
            self.columns = 1;
        }
        self.wraps = bounds.periodic && self.columns > 1;
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
    /// particle `i` such that each pair is seen from one of its two ends only.
    #[inline]
    pub fn later_candidates(
        &self,
        i: usize,
        position: Vec2,
        mut see: impl FnMut(std::ops::Range<usize>),
    ) {
        let (column, row) = self.place(position);
        let (first, last) = (column.saturating_sub(1), (column + 1).min(self.columns - 1));
        see(i + 1..self.run(row, column, last).end);
        let above = row + 1 < self.rows;
        if above {
            see(self.run(row + 1, first, last));
        }
        if self.wraps {
            if column + 1 == self.columns {
                see(self.run(row, 0, 0));
            }
            if above && column + 1 == self.columns {
                see(self.run(row + 1, 0, 0));
            }
            if above && column == 0 {
                see(self.run(row + 1, self.columns - 1, self.columns - 1));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::Particle;
    use crate::random::Random;
    use std::collections::BTreeSet;

    fn cloud(n: usize, bounds: &Bounds, seed: u32) -> Particles {
        let mut random = Random::new(seed);
        let mut particles = Particles::default();
        for _ in 0..n {
            particles.push(Particle::at(Vec2::new(
                random.between(-0.5 * bounds.width, 0.5 * bounds.width),
                random.between(0.0, bounds.height),
            )));
        }
        particles
    }

    fn close(particles: &Particles, bounds: &Bounds, i: usize, j: usize, support: f32) -> bool {
        bounds
            .offset(particles.position[i], particles.position[j])
            .length_squared()
            < support * support
    }

    #[test]
    fn it_finds_the_pairs_that_comparing_all_with_all_finds() {
        let mut grid = Grid::default();
        for (seed, width, height, periodic) in [
            (1, 1.2, 1.5, false),
            (2, 1.2, 1.5, true),
            (3, 0.1, 3.0, false),
            (4, 0.1, 3.0, true),
            (5, 0.5, 0.1, true),
            (6, 6.0, 0.15, false),
        ] {
            let bounds = Bounds {
                width,
                height,
                periodic,
            };
            let mut particles = cloud(400, &bounds, seed);
            for support in [0.02, 0.07, 0.2] {
                grid.sort(&mut particles, &bounds, support);
                let mut found = Vec::new();
                for i in 0..particles.len() {
                    grid.later_candidates(i, particles.position[i], |run| {
                        for j in run {
                            if close(&particles, &bounds, i, j, support) {
                                found.push((i.min(j), i.max(j)));
                            }
                        }
                    });
                }
                let unique: BTreeSet<_> = found.iter().copied().collect();
                assert_eq!(unique.len(), found.len(), "a pair was seen twice");
                let all: BTreeSet<_> = (0..particles.len())
                    .flat_map(|i| (i + 1..particles.len()).map(move |j| (i, j)))
                    .filter(|&(i, j)| close(&particles, &bounds, i, j, support))
                    .collect();
                assert_eq!(unique, all, "seed {seed}, support {support}");
            }
        }
    }

    #[test]
    fn sorting_loses_no_particle() {
        let bounds = Bounds {
            width: 1.0,
            height: 1.0,
            periodic: false,
        };
        let mut particles = cloud(1000, &bounds, 9);
        let before: Vec<Particle> = (0..1000).map(|i| particles.get(i)).collect();
        Grid::default().sort(&mut particles, &bounds, 0.05);
        let after: Vec<Particle> = particles
            .by_id()
            .into_iter()
            .map(|i| particles.get(i))
            .collect();
        assert_eq!(before, after);
    }
}
