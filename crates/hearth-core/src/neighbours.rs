//! Passes over the pairs of particles within each other's kernel.
//!
//! Blocks of four particles hold each property of the four side by side ([`Block`]), with
//! positions in smoothing lengths. A pass computes one particle of a block against the four
//! of another at once. It visits each pair of blocks once and adds to the sums of both.
//!
//! The first pass sums the kernels and lists for each particle its neighbours, as blocks with
//! a bit mask. The other passes iterate over these lists. The lists keep their memory, and
//! their size is bounded.

#[cfg(test)]
mod tests;

use glam::Vec2;

use crate::grid::{Grid, Run};
use crate::kernel;
use crate::lanes::{self, LANES, Lanes};
use crate::solids::Solids;

/// Position of the lanes without a particle, in smoothing lengths: beyond every support.
pub(crate) const FAR_AWAY: f32 = 1e6;

/// Square of the support radius, in smoothing lengths.
const SUPPORT_SQUARED: Lanes = Lanes::splat(4.0);

/// Tolerance for rounding in the distance from a plane, in smoothing lengths.
const TOLERANCE: f32 = 1e-3;

/// Number of subsets of four particles.
const SUBSETS: usize = 1 << LANES;

/// One in the lanes of each subset, and zero in the others.
const KEEP: [Lanes; SUBSETS] = {
    let mut keep = [Lanes::ZERO; SUBSETS];
    let mut subset = 0;
    while subset < SUBSETS {
        let mut lanes = [0.0; LANES];
        let mut lane = 0;
        while lane < LANES {
            lanes[lane] = (subset >> lane & 1) as f32;
            lane += 1;
        }
        keep[subset] = Lanes::new(lanes);
        subset += 1;
    }
    keep
};

/// The lanes of each subset, padded with zeros, and their number.
const MEMBERS: [([u32; LANES], usize); SUBSETS] = {
    let mut members = [([0; LANES], 0); SUBSETS];
    let mut subset = 0;
    while subset < SUBSETS {
        let mut lane = 0;
        while lane < LANES {
            if subset & (1 << lane) != 0 {
                let (lanes, count) = &mut members[subset];
                lanes[*count] = lane as u32;
                *count += 1;
            }
            lane += 1;
        }
        subset += 1;
    }
    members
};

/// Four particles with the data that every pass reads.
pub(crate) trait Block: Copy {
    /// Most entries of the lists. The limit protects a browser's memory and bounds the work of
    /// a step: many particles within a large smoothing radius would have thousands of neighbours
    /// each. A hundred thousand particles reach it at some 650 neighbours.
    const MAX_ENTRIES: usize = 1 << 24;

    /// Positions, in smoothing lengths.
    fn position(&self) -> [Lanes; 2];
    /// The weight of each in the sums of its neighbours.
    fn weight(&self) -> Lanes;
    /// The sum over the neighbours of each, Σⱼ yⱼ [`kernel::w`].
    fn sum(&mut self) -> &mut Lanes;
}

/// Sums over pairs, `N` for each particle.
pub(crate) trait PairSum<const N: usize> {
    /// The blocks of the particles.
    type Block: Block;
    /// The particles that meet those of a block, lane by lane; mostly one, in all lanes.
    type Broadcast;

    /// The lanes that `pick` takes of each property of `block`, moved by `shift` smoothing lengths.
    fn broadcast(
        &self,
        block: &Self::Block,
        pick: impl Fn(Lanes) -> Lanes,
        shift: Vec2,
    ) -> Self::Broadcast;

    /// The terms that each of the four `others` adds to the sums of `one`, and the terms that
    /// `one` subtracts from the sums of the others.
    fn pair(&self, one: &Self::Broadcast, others: &Self::Block) -> ([Lanes; N], [Lanes; N]);

    /// The sums of a block.
    fn accumulator(block: &mut Self::Block) -> &mut [Lanes; N];
}

/// A block and the lists of its neighbours: without a shift, or, `shift` smoothing lengths
/// away, beyond a periodic edge.
#[derive(Clone, Copy, Debug)]
struct Sweep {
    block: u32,
    /// Whether the pairs within the block belong to this sweep.
    own: bool,
    /// Of each particle, the neighbours in later lanes of the same block, as a bit mask.
    inner: [u8; LANES],
    shift: Vec2,
    /// Start of the list of its first particle, and the distance to the next list.
    begin: u32,
    stride: u32,
    /// Number of entries in each list.
    counts: [u32; LANES],
}

impl Sweep {
    #[inline(always)]
    fn list<'a>(&self, entries: &'a [u32], lane: usize) -> &'a [u32] {
        let begin = self.begin as usize + lane * self.stride as usize;
        &entries[begin..begin + self.counts[lane] as usize]
    }

    /// The lanes whose neighbour is the next lane of the block, and those whose neighbour is the
    /// opposite one, as bit masks.
    #[inline(always)]
    fn inner_subsets(&self) -> [usize; 2] {
        let [first, second, third, _] = self.inner.map(usize::from);
        let bit = |of: usize, lane: usize| of >> lane & 1;
        let next = bit(first, 1) | bit(second, 2) << 1 | bit(third, 3) << 2 | bit(first, 3) << 3;
        let opposite = bit(first, 2) | bit(second, 3) << 1;
        [next, opposite | opposite << 2]
    }
}

/// The neighbours of every particle.
///
/// An entry is the index of a block times [`SUBSETS`], plus a bit mask of its particles.
#[derive(Clone, Debug, Default)]
pub(crate) struct Neighbours {
    sweeps: Vec<Sweep>,
    /// The lists of all sweeps.
    entries: Vec<u32>,
    used: usize,
    /// Number of particles and of blocks in the last search.
    particles: usize,
    blocks: usize,
    /// Whether solids part some pairs.
    parted: bool,
}

impl Neighbours {
    /// Makes the lists, and sums the weighted kernels over the neighbours of each particle,
    /// itself included. The blocks are in the order of `grid`; `h` is the smoothing length
    /// \[m\].
    pub fn find<B: Block>(&mut self, blocks: &mut [B], grid: &Grid, h: f32) {
        self.used = 0;
        self.parted = false;
        self.sweeps.clear();
        (self.particles, self.blocks) = (grid.len(), blocks.len());
        let inverse_h = 1.0 / h;
        let mut runs = Default::default();
        for row in 0..grid.rows() {
            for block in grid.blocks(row) {
                let (from, to) = span(blocks[block].position()[0]);
                let count = grid.runs_after(row, block, (from * h, to * h), &mut runs);
                let runs = &runs[..count];
                let unshifted = runs.iter().take_while(|run| run.shift == Vec2::ZERO);
                let (unshifted, shifted) = runs.split_at(unshifted.count());
                self.sweep(blocks, block, unshifted, Vec2::ZERO, true);
                for run in shifted {
                    let shift = run.shift * inverse_h;
                    self.sweep(blocks, block, std::slice::from_ref(run), shift, false);
                }
            }
        }
    }

    #[inline]
    fn sweep<B: Block>(
        &mut self,
        blocks: &mut [B],
        block: usize,
        mut runs: &[Run],
        shift: Vec2,
        own: bool,
    ) {
        let mut stride = runs.iter().map(Run::len).sum();
        let begin = self.used;
        if begin + LANES * stride > B::MAX_ENTRIES {
            (runs, stride) = (&[], 0);
        }
        let end = begin + LANES * stride;
        if end > self.entries.len() {
            // Grows by half, so that a growing fire seldom allocates.
            let room = end.max(self.entries.len() / 2 * 3);
            self.entries.resize(room, 0);
        }
        self.used = end;
        let (first, rest) = self.entries[begin..end].split_at_mut(stride);
        let (second, rest) = rest.split_at_mut(stride);
        let (third, fourth) = rest.split_at_mut(stride);
        let lists = [first, second, third, fourth];
        let mut counts = [0; LANES];

        let ([x, y], weight) = (blocks[block].position(), blocks[block].weight());
        // Lanes without a particle must not find each other: those of this block get another
        // position.
        let occupied = x.less_mask(Lanes::splat(0.5 * FAR_AWAY));
        // A loop, because the closure of a `map` is not inlined here.
        let mut each = [(x, y, weight); LANES];
        for (lane, (x, y, weight)) in each.iter_mut().enumerate() {
            *x = if occupied & (1 << lane) == 0 {
                Lanes::splat(-FAR_AWAY)
            } else {
                x.broadcast(lane)
            };
            (*y, *weight) = (y.broadcast(lane), weight.broadcast(lane));
        }
        let mut sums = [Lanes::ZERO; LANES];
        let mut inner = [0; LANES];
        if own {
            for lane in 0..LANES {
                let square = square(each[lane].0 - x, each[lane].1 - y);
                sums[lane] = kernel::w(square.sqrt()) * weight;
                let later = !((2 << lane) - 1);
                inner[lane] = (square.less_mask(SUPPORT_SQUARED) & later) as u8;
            }
        }
        for (x, y, _) in &mut each {
            (*x, *y) = (*x - shift.x, *y - shift.y);
        }
        for run in runs {
            for (number, others) in (run.start..).zip(&mut blocks[run.start..run.end]) {
                let ([x, y], weight) = (others.position(), others.weight());
                let mut back = [Lanes::ZERO; LANES];
                for lane in 0..LANES {
                    let (one_x, one_y, one_weight) = each[lane];
                    let square = square(one_x - x, one_y - y);
                    let w = kernel::w(square.sqrt());
                    sums[lane] += w * weight;
                    back[lane] = w * one_weight;
                    // The write is unconditional, and the count grows only for a neighbour: a
                    // mispredicted branch costs more than the write.
                    let mask = square.less_mask(SUPPORT_SQUARED);
                    lists[lane][counts[lane]] = (number * SUBSETS) as u32 + mask;
                    counts[lane] += usize::from(mask != 0);
                }
                *others.sum() += (back[0] + back[1]) + (back[2] + back[3]);
            }
        }
        *blocks[block].sum() += lanes::row_sums(sums);
        self.sweeps.push(Sweep {
            block: block as u32,
            own,
            inner,
            shift,
            begin: begin as u32,
            stride: stride as u32,
            counts: counts.map(|count| count as u32),
        });
    }

    /// Removes the pairs that a thin solid parts from the lists and from the sums of the first pass.
    /// `near` gives the thin solids near a particle, after sorting: normal, distance \[m\] and number.
    /// `h` is the smoothing length \[m\].
    pub fn part<B: Block, P: Iterator<Item = (Vec2, f32, u32)>>(
        &mut self,
        blocks: &mut [B],
        grid: &Grid,
        h: f32,
        solids: &Solids,
        near: impl Fn(usize) -> P,
    ) {
        self.parted = true;
        let entries = &mut self.entries;
        let inverse_h = 1.0 / h;
        for sweep in &mut self.sweeps {
            let (block, shift) = (sweep.block as usize, sweep.shift);
            for (lane, one) in grid.members_of(block).enumerate() {
                for (normal, distance, solid) in near(one) {
                    let from = place(&blocks[block], lane) - shift;
                    let Some(lines) = solids.lines_from(solid, (from + shift) * h) else {
                        continue;
                    };
                    // A convex solid lies behind the plane of its nearest point, and no solid is
                    // nearer than that.
                    let distance = distance * inverse_h;
                    let is_convex = lines.is_convex();
                    let plane = Lanes::splat(from.dot(normal) - distance + TOLERANCE);
                    let mut parted = |number: usize, mask: u32| {
                        let [x, y] = blocks[number].position();
                        let behind = if is_convex {
                            (x * normal.x + y * normal.y).less_mask(plane)
                        } else {
                            let circle = Lanes::splat(distance * distance);
                            circle.less_mask(square(x - from.x, y - from.y))
                        };
                        let mask = behind & mask;
                        if mask == 0 {
                            return 0;
                        }
                        let parted = lines.crossed([(x + shift.x) * h, (y + shift.y) * h], mask);
                        if parted != 0 {
                            subtract(blocks, (block, lane), from, number, parted);
                        }
                        parted
                    };
                    if sweep.own {
                        let inner = &mut sweep.inner[lane];
                        *inner -= parted(block, (*inner).into()) as u8;
                    }
                    let begin = sweep.begin as usize + lane * sweep.stride as usize;
                    for entry in &mut entries[begin..begin + sweep.counts[lane] as usize] {
                        *entry -= parted(*entry as usize / SUBSETS, *entry % SUBSETS as u32);
                    }
                }
            }
        }
    }

    /// Adds `pairs` to the sums of both ends of every pair.
    pub fn sum<const N: usize, P: PairSum<N>>(&self, pairs: &P, blocks: &mut [P::Block]) {
        for sweep in &self.sweeps {
            let block = sweep.block as usize;
            let mut added = [[Lanes::ZERO; N]; LANES];
            for (lane, result) in added.iter_mut().enumerate() {
                let one = pairs.broadcast(&blocks[block], |of| of.broadcast(lane), sweep.shift);
                // A local sum stays in registers.
                let mut sum = [Lanes::ZERO; N];
                for &entry in sweep.list(&self.entries, lane) {
                    let others = &mut blocks[entry as usize / SUBSETS];
                    let (mut terms, mut theirs) = pairs.pair(&one, others);
                    if self.parted {
                        let keep = KEEP[entry as usize % SUBSETS];
                        terms = terms.map(|term| term * keep);
                        theirs = theirs.map(|term| term * keep);
                    }
                    let accumulator = P::accumulator(others);
                    for k in 0..N {
                        sum[k] += terms[k];
                        accumulator[k] -= theirs[k];
                    }
                }
                *result = sum;
            }
            let mut inner = [Lanes::ZERO; N];
            if sweep.own {
                inner = self.inner_sums(pairs, &blocks[block], sweep);
            }
            let accumulator = P::accumulator(&mut blocks[block]);
            for (k, sum) in accumulator.iter_mut().enumerate() {
                *sum += lanes::row_sums(added.map(|sum| sum[k])) + inner[k];
            }
        }
    }

    /// The sums over the pairs within a block. All six meet in two turns: each lane meets the
    /// next one, then the one opposite.
    fn inner_sums<const N: usize, P: PairSum<N>>(
        &self,
        pairs: &P,
        block: &P::Block,
        sweep: &Sweep,
    ) -> [Lanes; N] {
        let next = pairs.broadcast(block, Lanes::rotated, Vec2::ZERO);
        let (mut of_next, mut of_each) = pairs.pair(&next, block);
        let opposite = pairs.broadcast(block, |of| of.rotated().rotated(), Vec2::ZERO);
        // A pair of opposite lanes is there twice, and each end takes what it gets.
        let (_, mut of_opposite) = pairs.pair(&opposite, block);
        if self.parted {
            let [next, opposite] = sweep.inner_subsets().map(|subset| KEEP[subset]);
            of_next = of_next.map(|term| term * next);
            of_each = of_each.map(|term| term * next);
            of_opposite = of_opposite.map(|term| term * opposite);
        }
        std::array::from_fn(|k| {
            of_next[k].rotated().rotated().rotated() - of_each[k] - of_opposite[k]
        })
    }

    /// Calls `visit` with each particle, the shift of its neighbours in smoothing lengths, and
    /// these neighbours. It visits each pair once. A particle is its index, four to a block;
    /// the index after the last block pads the neighbours to a multiple of four.
    #[inline(always)]
    pub fn each(&self, others: &mut Vec<u32>, mut visit: impl FnMut(usize, Vec2, &[u32])) {
        let padding = (LANES * self.blocks) as u32;
        for sweep in &self.sweeps {
            let first = sweep.block as usize * LANES;
            for lane in 0..LANES {
                let list = sweep.list(&self.entries, lane);
                let room = LANES * (list.len() + 2);
                if room > others.len() {
                    others.resize(room, 0);
                }
                let inner = sweep.block * SUBSETS as u32 + u32::from(sweep.inner[lane]);
                let mut count = 0;
                for &entry in std::iter::once(&inner).chain(list) {
                    let (lanes, members) = MEMBERS[entry as usize % SUBSETS];
                    let base = entry / SUBSETS as u32 * LANES as u32;
                    let written = &mut others[count..count + LANES];
                    for (index, lane) in written.iter_mut().zip(lanes) {
                        *index = base + lane;
                    }
                    count += members;
                }
                others[count..count + LANES].fill(padding);
                if count > 0 {
                    let padded = count.next_multiple_of(LANES);
                    visit(first + lane, sweep.shift, &others[..padded]);
                }
            }
        }
    }

    /// Number of entries that the last search needed, at most [`Block::MAX_ENTRIES`].
    pub fn entries(&self) -> usize {
        self.used
    }

    /// Mean and maximum number of neighbours of a particle in the last search. It counts them
    /// again.
    pub fn mean_and_max(&self) -> (f32, u32) {
        let padding = LANES * self.blocks;
        let mut counts = vec![0_u32; padding + 1];
        self.each(&mut Vec::new(), |one, _, others| {
            for &other in others {
                counts[one] += u32::from(other as usize != padding);
                counts[other as usize] += 1;
            }
        });
        let counts = &counts[..padding];
        let sum: u32 = counts.iter().sum();
        let mean = sum as f32 / self.particles.max(1) as f32;
        (mean, counts.iter().copied().max().unwrap_or(0))
    }
}

/// Takes back the kernels of the pairs of a particle, a block and a lane at a position, and some of
/// another block from the sums of the first pass.
#[inline(never)]
fn subtract<B: Block>(
    blocks: &mut [B],
    (block, lane): (usize, usize),
    from: Vec2,
    number: usize,
    some: u32,
) {
    let others = &mut blocks[number];
    let [x, y] = others.position();
    let w = kernel::w(square(x - from.x, y - from.y).sqrt()) * KEEP[some as usize % SUBSETS];
    let theirs = w * others.weight();
    let weight = blocks[block].weight().broadcast(lane);
    *blocks[number].sum() -= w * weight;
    let mut sums = blocks[block].sum().to_array();
    for their in theirs.to_array() {
        sums[lane] -= their;
    }
    *blocks[block].sum() = Lanes::new(sums);
}

/// The position in a lane.
fn place(block: &impl Block, lane: usize) -> Vec2 {
    let [x, y] = block.position().map(|at| at.to_array()[lane]);
    Vec2::new(x, y)
}

#[inline(always)]
fn square(x: Lanes, y: Lanes) -> Lanes {
    x * x + y * y
}

/// Minimum and maximum of the lanes with a particle.
#[inline]
fn span(x: Lanes) -> (f32, f32) {
    let (mut from, mut to) = (FAR_AWAY, -FAR_AWAY);
    for x in x.to_array() {
        if x < from {
            from = x;
        }
        if x > to && x < 0.5 * FAR_AWAY {
            to = x;
        }
    }
    (from, to)
}
