//! Passes over the pairs of particles within each other's kernel.
//!
//! Blocks of four particles hold each property of the four side by side ([`Block`]), with
//! positions in smoothing lengths. A pass computes one particle of a block against the four
//! of another at once. It visits each pair of blocks once and adds to the sums of both.
//!
//! The first pass sums the kernels and lists for each particle its neighbours, as blocks with
//! a bit mask. The other passes iterate over these lists. The lists keep their memory, and
//! their size is bounded.

mod entry;
mod separation;
#[cfg(test)]
mod tests;

use std::ops::Range;

use entry::{Entry, KEEP, MEMBERS};
use glam::Vec2;

use crate::extremes::fast_min;
use crate::grid::{Grid, Run};
use crate::kernel;
use crate::lanes::{self, LANES, Lanes};

/// Position of the lanes without a particle, in smoothing lengths: beyond every support.
pub(crate) const FAR_AWAY: f32 = 1e6;

/// Square of the support radius, in smoothing lengths.
const SUPPORT_SQUARED: Lanes = Lanes::splat(4.0);

/// Four particles with the data that every pass reads.
pub(crate) trait Block: Copy {
    /// Most candidates, and entries of the lists. The limit protects a browser's memory and bounds the work of
    /// a step: many particles within a large smoothing radius would have thousands of neighbours
    /// each. A hundred thousand particles reach it at some 650 neighbours.
    const MAX_ENTRIES: usize = 1 << 24;
    /// Distance up to which particles are pairs, in smoothing lengths: the support radius, or more for passes
    /// over particles that have moved since the search. The grid has to have it too.
    const REACH: f32 = 2.0;

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
    /// The particles that are paired with those of a block, lane by lane; mostly the same one in all lanes.
    type Broadcast;

    /// The lanes that `pick` takes of each property of `block`, at positions moved `by` smoothing lengths.
    fn broadcast(
        &self,
        block: &Self::Block,
        pick: impl Fn(&Lanes) -> Lanes,
        by: Vec2,
    ) -> Self::Broadcast;

    /// The terms that each of the four `others` adds to the sums of `particle`, and the terms that
    /// `particle` subtracts from the sums of the others. `keep` is a factor of every term: 1 in the lanes that
    /// are pairs, and 0 in the others.
    fn pair(
        &self,
        particle: &Self::Broadcast,
        others: &Self::Block,
        keep: Lanes,
    ) -> ([Lanes; N], [Lanes; N]);

    /// The sums of a block.
    fn accumulator(block: &mut Self::Block) -> &mut [Lanes; N];
}

/// A block and the list of its neighbours: without a shift, or, `shift` smoothing lengths
/// away, beyond a periodic edge.
#[derive(Clone, Copy, Debug)]
struct Sweep {
    block: u32,
    /// Whether the pairs within the block belong to this sweep.
    own: bool,
    /// Of each particle, the neighbours in later lanes of the same block, as a bit mask.
    inner: [u8; LANES],
    shift: Vec2,
    /// The range of its entries.
    begin: u32,
    end: u32,
}

impl Sweep {
    #[inline(always)]
    fn range(&self) -> Range<usize> {
        self.begin as usize..self.end as usize
    }

    /// The neighbours of each particle in later lanes of the same block.
    #[inline(always)]
    fn inner_entries(&self) -> impl Iterator<Item = Entry> {
        (0..LANES).map(|lane| Entry::new(lane, self.block as usize, self.inner[lane].into()))
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
#[derive(Clone, Debug, Default)]
pub(crate) struct Neighbours {
    sweeps: Vec<Sweep>,
    /// The lists of all sweeps, one after the other. A list has the entries of the four particles
    /// of its block among each other, so that a pass has one loop for a block: the end of a loop is
    /// a mispredicted branch.
    entries: Vec<Entry>,
    /// Number of candidates of the last search, for which the lists have room.
    candidates: usize,
    /// Number of particles and of blocks in the last search.
    particles: usize,
    blocks: usize,
    /// Whether solids separate some pairs, so that entries lack lanes.
    is_masked: bool,
}

impl Neighbours {
    /// Makes the lists, and sums the weighted kernels over the neighbours of each particle,
    /// itself included. The blocks are in the order of `grid`; `h` is the smoothing length
    /// \[m\].
    pub fn find_and_sum<B: Block>(&mut self, blocks: &mut [B], grid: &Grid, h: f32) {
        self.candidates = 0;
        self.is_masked = false;
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
        let mut candidates = LANES * runs.iter().map(Run::len).sum::<usize>();
        if self.candidates + candidates > B::MAX_ENTRIES {
            (runs, candidates) = (&[], 0);
        }
        self.candidates += candidates;
        let begin = self.sweeps.last().map_or(0, |sweep| sweep.end as usize);
        let end = begin + candidates;
        if end > self.entries.len() {
            // Grows by half, so that a growing fire seldom allocates.
            let room = end.max(self.entries.len() / 2 * 3);
            self.entries.resize(room, Entry::default());
        }
        let list = &mut self.entries[begin..end];
        let mut count = 0;

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
        let reach = Lanes::splat(B::REACH * B::REACH);
        let mut sums = [Lanes::ZERO; LANES];
        let mut inner = [0; LANES];
        if own {
            for lane in 0..LANES {
                let square = square(each[lane].0 - x, each[lane].1 - y);
                sums[lane] = kernel::w(square.sqrt()) * weight;
                let later = !((2 << lane) - 1);
                inner[lane] = (square.less_mask(reach) & later) as u8;
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
                    let (own_x, own_y, own_weight) = each[lane];
                    let square = square(own_x - x, own_y - y);
                    let w = kernel::w(square.sqrt());
                    sums[lane] += w * weight;
                    back[lane] = w * own_weight;
                    // The write is unconditional, and the count grows only for a neighbour: a
                    // mispredicted branch costs more than the write.
                    let mask = square.less_mask(reach);
                    list[count] = Entry::new(lane, number, mask);
                    count += usize::from(mask != 0);
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
            end: (begin + count) as u32,
        });
    }

    /// Adds `pairs` to the sums of both ends of every pair, where the search found the particles: kernels are
    /// zero beyond their support, so lanes that are no pairs add nothing.
    pub fn sum<const N: usize, P: PairSum<N>>(&self, pairs: &P, blocks: &mut [P::Block]) {
        if self.is_masked {
            self.sum_pairs::<N, P, true>(pairs, blocks);
        } else {
            self.sum_pairs::<N, P, false>(pairs, blocks);
        }
    }

    /// Adds `pairs` to the sums of both ends of every pair of the search, wherever the particles are now.
    pub fn sum_of_search<const N: usize, P: PairSum<N>>(&self, pairs: &P, blocks: &mut [P::Block]) {
        self.sum_pairs::<N, P, true>(pairs, blocks);
    }

    fn sum_pairs<const N: usize, P: PairSum<N>, const MASKED: bool>(
        &self,
        pairs: &P,
        blocks: &mut [P::Block],
    ) {
        // Emptied where it is read: in wasm, an array that is zeroed for each block is a call of C.
        let mut added = [[Lanes::ZERO; N]; LANES];
        for sweep in &self.sweeps {
            let block = sweep.block as usize;
            for &entry in &self.entries[sweep.range()] {
                let lane = entry.lane();
                let particle =
                    pairs.broadcast(&blocks[block], |of| of.broadcast(lane), -sweep.shift);
                let others = &mut blocks[entry.number()];
                let (terms, theirs) = pairs.pair(&particle, others, keep::<MASKED>(entry.mask()));
                let accumulator = P::accumulator(others);
                for k in 0..N {
                    added[lane][k] += terms[k];
                    accumulator[k] -= theirs[k];
                }
            }
            let mut inner = [Lanes::ZERO; N];
            if sweep.own {
                inner = self.inner_sums::<N, P, MASKED>(pairs, &blocks[block], sweep);
            }
            let accumulator = P::accumulator(&mut blocks[block]);
            for (k, sum) in accumulator.iter_mut().enumerate() {
                let mut four = [Lanes::ZERO; LANES];
                for lane in 0..LANES {
                    four[lane] = added[lane][k];
                    added[lane][k] = Lanes::ZERO;
                }
                *sum += lanes::row_sums(four) + inner[k];
            }
        }
    }

    /// The sums over the pairs within a block. Two rotations cover the six pairs: the block is paired
    /// with itself rotated by one lane, then by two.
    fn inner_sums<const N: usize, P: PairSum<N>, const MASKED: bool>(
        &self,
        pairs: &P,
        block: &P::Block,
        sweep: &Sweep,
    ) -> [Lanes; N] {
        let [keep_next, keep_opposite] = sweep.inner_subsets().map(keep::<MASKED>);
        let next = pairs.broadcast(block, |of| of.rotated(), Vec2::ZERO);
        let (of_next, of_each) = pairs.pair(&next, block, keep_next);
        let opposite = pairs.broadcast(block, |of| of.rotated().rotated(), Vec2::ZERO);
        // A pair of opposite lanes is there twice, and each end takes what it gets.
        let (_, of_opposite) = pairs.pair(&opposite, block, keep_opposite);
        std::array::from_fn(|k| {
            of_next[k].rotated().rotated().rotated() - of_each[k] - of_opposite[k]
        })
    }

    /// Number of candidates that the last search compared, at most [`Block::MAX_ENTRIES`].
    pub fn candidates(&self) -> usize {
        self.candidates
    }

    /// Mean and maximum number of neighbours of a particle in the last search, whose blocks these are: those
    /// within its support. It counts them again.
    pub fn mean_and_max<B: Block>(&self, blocks: &[B]) -> (f32, u32) {
        let (mut sum, mut most) = (0_u32, 0);
        let mut counts = vec![0; LANES * self.blocks];
        let mut count = |particle: usize| {
            counts[particle] += 1;
            most = most.max(counts[particle]);
            sum += 1;
        };
        for sweep in &self.sweeps {
            let list = &self.entries[sweep.range()];
            for entry in sweep.inner_entries().chain(list.iter().copied()) {
                let [x, y] = blocks[sweep.block as usize].position();
                let [x, y] = [x - sweep.shift.x, y - sweep.shift.y];
                let [other_x, other_y] = blocks[entry.number()].position();
                let (x, y) = (x.broadcast(entry.lane()), y.broadcast(entry.lane()));
                let near = square(x - other_x, y - other_y).less_mask(SUPPORT_SQUARED);
                let (lanes, members) = MEMBERS[entry.mask() & near as usize];
                for &lane in &lanes[..members] {
                    count(sweep.block as usize * LANES + entry.lane());
                    count(entry.number() * LANES + lane as usize);
                }
            }
        }
        (sum as f32 / self.particles.max(1) as f32, most)
    }
}

/// The factor of the terms of a subset of four particles; without `MASKED`, of every subset.
#[inline(always)]
fn keep<const MASKED: bool>(subset: usize) -> Lanes {
    if MASKED {
        KEEP[subset]
    } else {
        Lanes::splat(1.0)
    }
}

#[inline(always)]
fn square(x: Lanes, y: Lanes) -> Lanes {
    x * x + y * y
}

/// Minimum and maximum of the lanes with a particle.
#[inline(always)]
fn span(x: Lanes) -> (f32, f32) {
    // Without a branch: the order of particles in a block is not predictable.
    let occupied = |x: f32| if x < 0.5 * FAR_AWAY { x } else { -FAR_AWAY };
    let [a, b, c, d] = x.to_array();
    let from = fast_min(fast_min(a, b), fast_min(c, d));
    (from, Lanes::new([a, b, c, d].map(occupied)).max_lane())
}
