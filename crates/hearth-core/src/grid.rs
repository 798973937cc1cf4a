//! Fast neighbour search: a uniform grid.
//!
//! Rows are as high as a kernel reaches, so a particle's neighbours are in its own
//! row and the two beside it. A counting sort puts the particles of a row, from
//! left to right in narrow bins, next to each other in memory: the candidates of a
//! particle are then three runs of consecutive particles.
//!
//! The solver takes four consecutive particles of a row at a time, a block, and the
//! candidates of a block by whole blocks; if each pair is to be seen once, these are
//! two runs, and few more beyond a periodic edge.

#[cfg(test)]
mod tests;

use std::ops::Range;

use glam::Vec2;

use crate::bounds::Bounds;
use crate::lanes::{LANES, Lanes, Real};

/// Width of a bin, in reaches: the narrower, the fewer particles are looked at in
/// vain, and the more bins there are to count.
const BIN: f32 = 0.125;
/// Largest number of bins for each particle.
const MAX_BINS: usize = 4;

/// Particles sorted into rows, and along them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Grid {
    rows: usize,
    /// Bins of a row.
    bins: usize,
    /// From places, three across and one up, to bins and to a row.
    scale: Lanes,
    offset: Lanes,
    last: Lanes,
    left: f32,
    reach: f32,
    width: f32,
    /// After so many metres a periodic row or column begins again.
    across: Option<f32>,
    up: Option<f32>,
    /// Where each bin's particles begin; one more entry closes the last one.
    starts: Vec<u32>,
    /// The first block of each row; one more entry closes the last row.
    blocks: Vec<u32>,
    /// From where to where the particles of each block lie.
    members: Vec<[u32; 2]>,
    /// The bin of each particle, then its place.
    places: Vec<u32>,
}

/// A run of blocks, and what is to be added to the positions in it, which is not
/// zero beyond a periodic edge.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Run {
    pub start: usize,
    pub end: usize,
    pub shift: Vec2,
}

impl Run {
    /// How many blocks it has.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.end - self.start
    }
}

/// Largest number of runs with neighbours of one block: two in its row, three in the next.
pub(crate) const MAX_RUNS: usize = 5;

impl Grid {
    /// Sorts particles whose kernels end at `reach`. Returns their places: what is
    /// at `i` belongs to `places[i]`. Whoever keeps the particles puts them
    /// so; the grid then speaks of their new places.
    // Not inlined: each of its callers would carry a copy.
    #[inline(never)]
    pub fn sort(
        &mut self,
        positions: impl ExactSizeIterator<Item = Vec2>,
        bounds: &Bounds,
        reach: f32,
    ) -> &[u32] {
        self.lay_out(bounds, reach, positions.len());

        self.starts.clear();
        self.starts.resize(self.bins * self.rows + 1, 0);
        let mut places = std::mem::take(&mut self.places);
        places.clear();
        places.extend(positions.map(|position| {
            let ([bin, ..], row) = self.indices([position.x, 0.0, 0.0], position.y);
            let bin = row * self.bins + bin;
            self.starts[bin + 1] += 1;
            bin as u32
        }));
        let mut sum = 0;
        for start in &mut self.starts[1..] {
            (*start, sum) = (sum, sum + *start);
        }
        // Each bin's start is kept one bin ahead and serves as its cursor; so it
        // ends as the start of the next.
        for place in &mut places {
            let cursor = &mut self.starts[*place as usize + 1];
            *place = *cursor;
            *cursor += 1;
        }
        self.places = places;

        self.form_blocks();
        &self.places
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
            let four = |start: usize| [start, (start + LANES).min(particles.end)];
            let fours = particles.clone().step_by(LANES).map(four);
            members.extend(fours.map(|four| four.map(|place| place as u32)));
        }
        blocks.push(members.len() as u32);
        (self.blocks, self.members) = (blocks, members);
    }

    fn lay_out(&mut self, bounds: &Bounds, reach: f32, particles: usize) {
        let parts = |length: f32, part: f32| ((length / part).floor() as usize).max(1);
        self.rows = parts(bounds.height, reach);
        let most = (MAX_BINS * particles / self.rows).max(1);
        self.bins = parts(bounds.width, BIN * reach).min(most);
        self.across = bounds.periodic.then_some(bounds.width);
        self.up = bounds.endless.then_some(bounds.height);
        self.left = -0.5 * bounds.width;
        self.width = bounds.width;
        self.reach = reach;
        let (bins, rows) = (self.bins as f32, self.rows as f32);
        let (bin, row) = (bins / bounds.width, rows / bounds.height);
        self.scale = Lanes::new([bin, bin, bin, row]);
        // Rounded to the nearest whole number, which takes less than rounding down.
        let middle = -self.left * bin - 0.5;
        self.offset = Lanes::new([middle, middle, middle, -0.5]);
        self.last = Lanes::new([bins - 1.0, bins - 1.0, bins - 1.0, rows - 1.0]);
    }

    /// The bins of three places across and the row of one up. What is outside, or
    /// not a number, comes to an edge.
    #[inline(always)]
    fn indices(&self, across: [f32; 3], up: f32) -> ([usize; 3], usize) {
        let [a, b, c] = across;
        let at = Lanes::new([a, b, c, up]) * self.scale + self.offset;
        let inside = at.fast_max(Lanes::ZERO).fast_min(self.last);
        let [a, b, c, row] = inside.nearest_whole().map(|index| index as usize);
        ([a, b, c], row)
    }

    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The particles of a row.
    pub fn particles(&self, row: usize) -> Range<usize> {
        let base = row * self.bins;
        self.starts[base] as usize..self.starts[base + self.bins] as usize
    }

    /// The blocks of a row: four particles each, the last one fewer.
    pub fn blocks(&self, row: usize) -> Range<usize> {
        self.blocks[row] as usize..self.blocks[row + 1] as usize
    }

    /// How many particles there are.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// How many blocks there are.
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

    /// The particles of a row whose bins a stretch of it touches.
    fn stretch(&self, row: usize, from: f32, to: f32) -> Range<usize> {
        let base = row * self.bins;
        let ([first, last, _], _) = self.indices([from, to, 0.0], 0.0);
        self.starts[base + first] as usize..self.starts[base + last + 1] as usize
    }

    /// The blocks of a row that its bins from `first` to `last` touch.
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

    /// The runs that hold every neighbour of the particles in `block`, which is
    /// in `row` and spans `from..=to` across, outside of it, such that each pair of
    /// blocks is seen from one of its two ends only. Those without a shift come
    /// first. Returns how many there are.
    #[inline]
    pub fn runs_after(
        &self,
        row: usize,
        block: usize,
        (from, to): (f32, f32),
        runs: &mut [Run; MAX_RUNS],
    ) -> usize {
        let mut found = 0;
        let mut see = |run: Run| {
            runs[found] = run;
            found += usize::from(run.start < run.end);
        };
        let (low, high) = (from - self.reach, to + self.reach);
        let ([first, last, _], _) = self.indices([low, high, 0.0], 0.0);
        see(Run {
            start: block + 1,
            ..self.run(row, [last, last], Vec2::ZERO)
        });
        let above = if row + 1 < self.rows {
            Some((row + 1, 0.0))
        } else {
            self.up.map(|height| (0, height))
        };
        if let Some((row, up)) = above {
            see(self.run(row, [first, last], Vec2::new(0.0, up)));
        }
        if let Some(width) = self.across {
            // What is beyond the right edge lies at the left one, and so on.
            let ([right, left, _], _) = self.indices([high - width, low + width, 0.0], 0.0);
            let (beyond, before) = ([0, right], [left, self.bins - 1]);
            let is_beyond = high > self.left + self.width;
            if is_beyond {
                see(self.run(row, beyond, Vec2::new(width, 0.0)));
            }
            if let Some((row, up)) = above {
                if is_beyond {
                    see(self.run(row, beyond, Vec2::new(width, up)));
                }
                if low < self.left {
                    see(self.run(row, before, Vec2::new(-width, up)));
                }
            }
        }
        found
    }

    /// Calls `see` with runs of particles that hold every particle within the
    /// reach of `position`, wherever that is; with each run, what is to be
    /// added to the positions in it.
    pub fn candidates(&self, position: Vec2, mut see: impl FnMut(Range<usize>, Vec2)) {
        let (_, row) = self.indices([0.0; 3], position.y);
        self.see_row(row, position.x, 0.0, &mut see);
        if row + 1 < self.rows {
            self.see_row(row + 1, position.x, 0.0, &mut see);
        } else if let Some(height) = self.up {
            self.see_row(0, position.x, height, &mut see);
        }
        if row > 0 {
            self.see_row(row - 1, position.x, 0.0, &mut see);
        } else if let Some(height) = self.up {
            self.see_row(self.rows - 1, position.x, -height, &mut see);
        }
    }

    /// What of a row is within the reach of `x`.
    #[inline]
    fn see_row(&self, row: usize, x: f32, up: f32, see: &mut impl FnMut(Range<usize>, Vec2)) {
        let (low, high) = (x - self.reach, x + self.reach);
        see(self.stretch(row, low, high), Vec2::new(0.0, up));
        let Some(width) = self.across else {
            return;
        };
        let right = self.left + width;
        if high > right {
            let run = self.stretch(row, self.left, high - width);
            see(run, Vec2::new(width, up));
        }
        if low < self.left {
            let run = self.stretch(row, low + width, right);
            see(run, Vec2::new(-width, up));
        }
    }
}
