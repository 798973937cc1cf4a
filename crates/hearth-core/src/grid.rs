//! Neighbour search on a uniform grid.
//!
//! The height of a row is the support radius, so a particle's neighbours are in its own row
//! and the two adjacent ones. A counting sort puts the particles of a row, from left to right
//! in narrow bins, next to each other in memory: the candidates of a particle are three runs
//! of consecutive particles.
//!
//! The solver processes blocks of four consecutive particles of a row, and the candidates of
//! a block are whole blocks. If each pair is visited once, these are two runs, and at max_bins
//! three more beyond periodic edges.

#[cfg(test)]
mod tests;

use std::ops::{Range, RangeInclusive};

use glam::Vec2;

use crate::bounds::Bounds;
use crate::lanes::{LANES, Lanes, Real};

/// Width of a bin, in support radii. Narrower bins give fewer candidates beyond the support,
/// and more bins to count.
const BIN_WIDTH: f32 = 0.125;
/// Largest number of bins per particle.
const MAX_BINS: usize = 4;

/// Particles sorted by row, and by bin within a row.
#[derive(Clone, Debug, Default)]
pub(crate) struct Grid {
    rows: usize,
    /// Number of bins in a row.
    bins: usize,
    /// Maps three x and one y to three bins and one row: `scale`, `offset`, then `last` as the
    /// upper bound.
    scale: Lanes,
    offset: Lanes,
    last: Lanes,
    left: f32,
    reach: f32,
    width: f32,
    /// Periods of the domain \[m\].
    period_x: Option<f32>,
    period_y: Option<f32>,
    /// The first particle of each bin; one more entry ends the last bin.
    starts: Vec<u32>,
    /// The first block of each row; one more entry ends the last row.
    blocks: Vec<u32>,
    /// The range of particles of each block.
    members: Vec<[u32; 2]>,
    /// The bin of each particle, then its index after sorting.
    new_indices: Vec<u32>,
}

/// Consecutive blocks, and the shift of their positions, which is nonzero beyond a periodic
/// edge.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Run {
    pub start: usize,
    pub end: usize,
    pub shift: Vec2,
}

impl Run {
    /// Number of blocks.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.end - self.start
    }
}

/// Most runs of candidates of one block: two in its row, three in the next.
pub(crate) const MAX_RUNS: usize = 5;

impl Grid {
    /// Sorts particles by position, for a support radius `reach`. Returns the new index of
    /// each particle. The caller moves the particles; the ranges of the grid are of new indices.
    pub fn sort(
        &mut self,
        positions: impl ExactSizeIterator<Item = Vec2>,
        bounds: &Bounds,
        reach: f32,
    ) -> &[u32] {
        self.resize(bounds, reach, positions.len());

        self.starts.clear();
        self.starts.resize(self.bins * self.rows + 1, 0);
        let mut new_indices = std::mem::take(&mut self.new_indices);
        new_indices.clear();
        new_indices.extend(positions.map(|position| {
            let ([bin, ..], row) = self.indices([position.x, 0.0, 0.0], position.y);
            let bin = row * self.bins + bin;
            self.starts[bin + 1] += 1;
            bin as u32
        }));
        let mut sum = 0;
        for start in &mut self.starts[1..] {
            (*start, sum) = (sum, sum + *start);
        }
        // The start of each bin, one entry ahead, is the cursor of the bin, and ends as the
        // start of the next bin.
        for index in &mut new_indices {
            let cursor = &mut self.starts[*index as usize + 1];
            *index = *cursor;
            *cursor += 1;
        }
        self.new_indices = new_indices;

        self.form_blocks();
        &self.new_indices
    }

    /// Makes room for so many particles in these bounds, so that a later sort allocates nothing.
    pub fn reserve(&mut self, particles: usize, bounds: &Bounds, reach: f32) {
        self.resize(bounds, reach, particles);
        let bins = self.bins * self.rows + 1;
        self.starts.reserve(bins.saturating_sub(self.starts.len()));
        self.new_indices
            .reserve(particles.saturating_sub(self.new_indices.len()));
        self.blocks
            .reserve((self.rows + 1).saturating_sub(self.blocks.len()));
        let members = self.max_blocks(particles);
        self.members
            .reserve(members.saturating_sub(self.members.len()));
    }

    /// Most blocks of so many particles.
    pub fn max_blocks(&self, particles: usize) -> usize {
        particles / LANES + self.rows
    }

    fn form_blocks(&mut self) {
        let (mut blocks, mut members) = (
            std::mem::take(&mut self.blocks),
            std::mem::take(&mut self.members),
        );
        blocks.clear();
        members.clear();
        for row in 0..self.rows {
            blocks.push(members.len() as u32);
            let particles = self.particles(row);
            let block = |start: usize| [start, (start + LANES).min(particles.end)];
            let blocks_of_row = particles.clone().step_by(LANES).map(block);
            members.extend(blocks_of_row.map(|block| block.map(|index| index as u32)));
        }
        blocks.push(members.len() as u32);
        (self.blocks, self.members) = (blocks, members);
    }

    fn resize(&mut self, bounds: &Bounds, reach: f32, particles: usize) {
        let divisions = |length: f32, part: f32| ((length / part).floor() as usize).max(1);
        self.rows = divisions(bounds.height, reach);
        let max_bins = (MAX_BINS * particles / self.rows).max(1);
        self.bins = divisions(bounds.width, BIN_WIDTH * reach).min(max_bins);
        self.period_x = bounds.periodic_x.then_some(bounds.width);
        self.period_y = bounds.periodic_y.then_some(bounds.height);
        self.left = -0.5 * bounds.width;
        self.width = bounds.width;
        self.reach = reach;
        let (bins, rows) = (self.bins as f32, self.rows as f32);
        let (bin, row) = (bins / bounds.width, rows / bounds.height);
        self.scale = Lanes::new([bin, bin, bin, row]);
        // Rounding to the nearest integer takes fewer instructions than rounding down.
        let middle = -self.left * bin - 0.5;
        self.offset = Lanes::new([middle, middle, middle, -bounds.bottom * row - 0.5]);
        self.last = Lanes::new([bins - 1.0, bins - 1.0, bins - 1.0, rows - 1.0]);
    }

    /// The bins of three x and the row of one y. Values outside and NaN are clamped to an
    /// edge.
    #[inline(always)]
    fn indices(&self, x: [f32; 3], y: f32) -> ([usize; 3], usize) {
        let [a, b, c] = x;
        let scaled = Lanes::new([a, b, c, y]) * self.scale + self.offset;
        let inside = scaled.fast_max(Lanes::ZERO).fast_min(self.last);
        let [a, b, c, row] = inside.nearest_integers().map(|index| index as usize);
        ([a, b, c], row)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The particles of a row.
    pub fn particles(&self, row: usize) -> Range<usize> {
        let base = row * self.bins;
        self.starts[base] as usize..self.starts[base + self.bins] as usize
    }

    /// The blocks of a row: four particles each, and fewer in the last one.
    pub fn blocks(&self, row: usize) -> Range<usize> {
        self.blocks[row] as usize..self.blocks[row + 1] as usize
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.new_indices.len()
    }

    /// Number of blocks.
    pub fn block_count(&self) -> usize {
        self.members.len()
    }

    /// The particles of each block.
    #[inline(always)]
    pub fn members(&self) -> impl Iterator<Item = Range<usize>> {
        self.members
            .iter()
            .map(|&[start, end]| start as usize..end as usize)
    }

    /// The particles of one block.
    pub fn members_of(&self, block: usize) -> Range<usize> {
        let [start, end] = self.members[block];
        start as usize..end as usize
    }

    /// The rows between two y.
    pub fn rows_between(&self, from: f32, to: f32) -> RangeInclusive<usize> {
        self.indices([0.0; 3], from).1..=self.indices([0.0; 3], to).1
    }

    /// The particles of a row in the bins between two x.
    pub fn particles_between(&self, row: usize, from: f32, to: f32) -> Range<usize> {
        let base = row * self.bins;
        let ([first, last, _], _) = self.indices([from, to, 0.0], 0.0);
        self.starts[base + first] as usize..self.starts[base + last + 1] as usize
    }

    /// [`run`](Grid::run) across a periodic edge, where few blocks are.
    #[cold]
    fn run_across(&self, row: usize, bins: [usize; 2], shift: Vec2) -> Run {
        self.run(row, bins, shift)
    }

    /// The blocks of a row with particles in the bins from `first` to `last`.
    #[inline(always)]
    fn run(&self, row: usize, [first, last]: [usize; 2], shift: Vec2) -> Run {
        let base = row * self.bins;
        let (begin, block) = (self.starts[base], self.blocks[row]);
        let start = self.starts[base + first] - begin;
        let end = self.starts[base + last + 1] - begin;
        Run {
            start: (block + start / LANES as u32) as usize,
            end: (block + end.div_ceil(LANES as u32)) as usize,
            shift,
        }
    }

    /// Finds the runs with every neighbour outside of `block`, which is in `row` and spans the
    /// x `from..=to`. Each pair of blocks is in the runs of one of the two. Runs without a
    /// shift come first. Returns the number of runs.
    #[inline]
    pub fn runs_after(
        &self,
        row: usize,
        block: usize,
        (from, to): (f32, f32),
        runs: &mut [Run; MAX_RUNS],
    ) -> usize {
        let mut found = 0;
        let mut visit = |run: Run| {
            runs[found] = run;
            found += usize::from(run.start < run.end);
        };
        let (low, high) = (from - self.reach, to + self.reach);
        let ([first, last, _], _) = self.indices([low, high, 0.0], 0.0);
        visit(Run {
            start: block + 1,
            ..self.run(row, [last, last], Vec2::ZERO)
        });
        let row_above = if row + 1 < self.rows {
            Some((row + 1, 0.0))
        } else {
            self.period_y.map(|height| (0, height))
        };
        if let Some((row, up)) = row_above {
            visit(self.run(row, [first, last], Vec2::new(0.0, up)));
        }
        if let Some(width) = self.period_x {
            // Particles beyond the right edge are at the left edge, and the reverse.
            let ([right, left, _], _) = self.indices([high - width, low + width, 0.0], 0.0);
            let (beyond, before) = ([0, right], [left, self.bins - 1]);
            let is_beyond = high > self.left + self.width;
            if is_beyond {
                visit(self.run_across(row, beyond, Vec2::new(width, 0.0)));
            }
            if let Some((row, up)) = row_above {
                if is_beyond {
                    visit(self.run_across(row, beyond, Vec2::new(width, up)));
                }
                if low < self.left {
                    visit(self.run_across(row, before, Vec2::new(-width, up)));
                }
            }
        }
        found
    }

    /// Calls `visit` with ranges that include every particle within the support radius of any
    /// `position`, each with the shift of its positions.
    pub fn candidates(&self, position: Vec2, visit: &mut dyn FnMut(Range<usize>, Vec2)) {
        let (_, row) = self.indices([0.0; 3], position.y);
        self.visit_row(row, position.x, 0.0, visit);
        if row + 1 < self.rows {
            self.visit_row(row + 1, position.x, 0.0, visit);
        } else if let Some(height) = self.period_y {
            self.visit_row(0, position.x, height, visit);
        }
        if row > 0 {
            self.visit_row(row - 1, position.x, 0.0, visit);
        } else if let Some(height) = self.period_y {
            self.visit_row(self.rows - 1, position.x, -height, visit);
        }
    }

    /// The candidates of `x` in a row.
    fn visit_row(&self, row: usize, x: f32, up: f32, visit: &mut dyn FnMut(Range<usize>, Vec2)) {
        let (low, high) = (x - self.reach, x + self.reach);
        visit(self.particles_between(row, low, high), Vec2::new(0.0, up));
        let Some(width) = self.period_x else {
            return;
        };
        let right = self.left + width;
        if high > right {
            let run = self.particles_between(row, self.left, high - width);
            visit(run, Vec2::new(width, up));
        }
        if low < self.left {
            let run = self.particles_between(row, low + width, right);
            visit(run, Vec2::new(-width, up));
        }
    }
}
