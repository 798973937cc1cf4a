//! Passes over the pairs of particles within each other's kernel.
//!
//! Particles come four at a time, in blocks that hold each property of the four side by
//! side ([`Block`]), with positions in smoothing lengths. A pass computes one particle of a
//! block against the four of another at once. It meets each pair of blocks from one end and
//! adds to the sums of both.
//!
//! The first pass sums the kernels and notes for each particle which particles of
//! which blocks are within its reach; what follows goes by these lists. They keep
//! their memory and are bounded.

#[cfg(test)]
mod tests;

use glam::Vec2;

use crate::grid::{Grid, Run};
use crate::kernel;
use crate::lanes::{self, LANES, Lanes};

/// Most entries that the lists may have. It is a net for a browser's memory: many
/// particles within a large smoothing radius would have thousands of
/// neighbours each. A hundred thousand particles reach it at some 650 neighbours.
const MAX_ENTRIES: usize = 1 << 24;

/// Where the lanes of a block lie that hold no particle, in smoothing lengths: out
/// of every reach.
pub(crate) const NOWHERE: f32 = 1e6;

/// Square of a kernel's reach, in smoothing lengths.
const REACH_SQUARED: Lanes = Lanes::splat(4.0);

/// How many subsets four particles have.
const SUBSETS: usize = 1 << LANES;

/// The lanes of each subset, the rest filled up, and how many they are.
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

/// Four particles, as the passes need them.
pub(crate) trait Block: Copy {
    /// Where they are, in smoothing lengths.
    fn place(&self) -> [Lanes; 2];
    /// The weight of each in the sums of those around it.
    fn weight(&self) -> Lanes;
    /// The sum of the weights around each, Σⱼ yⱼ [`kernel::w`].
    fn sum(&mut self) -> &mut Lanes;
}

/// Sums over pairs, `N` for each particle.
pub(crate) trait PairSum<const N: usize> {
    /// The blocks that it is about.
    type Block: Block;
    /// One particle, each property of it in all lanes.
    type Broadcast;

    /// The particle in a lane of `block`, moved by `shift` smoothing lengths.
    fn broadcast(&self, block: &Self::Block, lane: usize, shift: Vec2) -> Self::Broadcast;

    /// What each of the four `others` adds to the sums of `one`, and what `one` takes
    /// from theirs.
    fn pair(&self, one: &Self::Broadcast, others: &Self::Block) -> ([Lanes; N], [Lanes; N]);

    /// Where a block keeps the sums.
    fn accumulator(block: &mut Self::Block) -> &mut [Lanes; N];
}

/// A block and its neighbours: in its own part of the domain, or, moved by
/// `shift` smoothing lengths, beyond a periodic edge.
#[derive(Clone, Copy, Debug)]
struct Sweep {
    block: u32,
    /// Whether it is its own neighbour too.
    own: bool,
    /// Which of its own particles are within reach of each, from later lanes.
    inner: [u8; LANES],
    shift: Vec2,
    /// The list of its first particle begins here, each other one so much later.
    begin: u32,
    stride: u32,
    /// How many entries each list has.
    counts: [u32; LANES],
}

impl Sweep {
    #[inline(always)]
    fn list<'a>(&self, entries: &'a [u32], lane: usize) -> &'a [u32] {
        let begin = self.begin as usize + lane * self.stride as usize;
        &entries[begin..begin + self.counts[lane] as usize]
    }
}

/// Which blocks have neighbours of which particles.
///
/// An entry is the number of a block times [`SUBSETS`] and which of its particles
/// are meant, a bit each.
#[derive(Clone, Debug, Default)]
pub(crate) struct Neighbours {
    sweeps: Vec<Sweep>,
    /// The lists.
    entries: Vec<u32>,
    used: usize,
    /// How many particles the last search was for, in how many blocks.
    particles: usize,
    blocks: usize,
}

impl Neighbours {
    /// Sums what each particle gets from its neighbours, itself included, for
    /// blocks that lie in the order of `grid`, whose smoothing length is `h`
    /// \[m\]; and makes the lists.
    pub fn find<B: Block>(&mut self, blocks: &mut [B], grid: &Grid, h: f32) {
        self.used = 0;
        self.sweeps.clear();
        (self.particles, self.blocks) = (grid.len(), blocks.len());
        let inverse_h = 1.0 / h;
        let mut runs = Default::default();
        for row in 0..grid.rows() {
            for block in grid.blocks(row) {
                let (from, to) = span(blocks[block].place()[0]);
                let count = grid.runs_after(row, block, (from * h, to * h), &mut runs);
                let runs = &runs[..count];
                let near = runs.iter().take_while(|run| run.shift == Vec2::ZERO);
                let (near, beyond) = runs.split_at(near.count());
                self.sweep(blocks, block, near, Vec2::ZERO, true);
                for run in beyond {
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
        if begin + LANES * stride > MAX_ENTRIES {
            (runs, stride) = (&[], 0);
        }
        let end = begin + LANES * stride;
        if end > self.entries.len() {
            // By half as much again, so that a growing fire seldom allocates.
            let room = end.max(self.entries.len() / 2 * 3);
            self.entries.resize(room, 0);
        }
        self.used = end;
        let (first, rest) = self.entries[begin..end].split_at_mut(stride);
        let (second, rest) = rest.split_at_mut(stride);
        let (third, fourth) = rest.split_at_mut(stride);
        let lists = [first, second, third, fourth];
        let mut counts = [0; LANES];

        let ([x, y], weight) = (blocks[block].place(), blocks[block].weight());
        // Lanes that hold no particle lie all in one place: here, in another.
        let held = x.less(Lanes::splat(0.5 * NOWHERE));
        let each = [0, 1, 2, 3].map(|lane| {
            let x = if held & (1 << lane) == 0 {
                Lanes::splat(-NOWHERE)
            } else {
                x.spread(lane)
            };
            (x, y.spread(lane), weight.spread(lane))
        });
        let mut sums = [Lanes::ZERO; LANES];
        let mut inner = [0; LANES];
        if own {
            for lane in 0..LANES {
                let square = square(each[lane].0 - x, each[lane].1 - y);
                sums[lane] = kernel::w(square.sqrt()) * weight;
                let later = !((2 << lane) - 1);
                inner[lane] = (square.less(REACH_SQUARED) & later) as u8;
            }
        }
        let each = each.map(|(x, y, weight)| (x - shift.x, y - shift.y, weight));
        for run in runs {
            for (number, others) in (run.start..).zip(&mut blocks[run.start..run.end]) {
                let ([x, y], weight) = (others.place(), others.weight());
                let mut back = [Lanes::ZERO; LANES];
                for lane in 0..LANES {
                    let (one_x, one_y, one_weight) = each[lane];
                    let square = square(one_x - x, one_y - y);
                    let w = kernel::w(square.sqrt());
                    sums[lane] += w * weight;
                    back[lane] = w * one_weight;
                    // Written where the next entry belongs, and that place moves on
                    // only if it is one: a wrong guess costs more than the writing.
                    let within = square.less(REACH_SQUARED);
                    lists[lane][counts[lane]] = (number * SUBSETS) as u32 + within;
                    counts[lane] += usize::from(within != 0);
                }
                *others.sum() += (back[0] + back[1]) + (back[2] + back[3]);
            }
        }
        *blocks[block].sum() += lanes::sums(sums);
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

    /// Adds `pairs` to the sums of both ends of every pair.
    pub fn sum<const N: usize, P: PairSum<N>>(&self, pairs: &P, blocks: &mut [P::Block]) {
        for sweep in &self.sweeps {
            let block = sweep.block as usize;
            let mut own = [[Lanes::ZERO; N]; LANES];
            for (lane, sum) in own.iter_mut().enumerate() {
                let one = pairs.broadcast(&blocks[block], lane, sweep.shift);
                if sweep.own {
                    *sum = pairs.pair(&one, &blocks[block]).0;
                }
                for &entry in sweep.list(&self.entries, lane) {
                    let others = &mut blocks[entry as usize / SUBSETS];
                    let (gain, loss) = pairs.pair(&one, others);
                    let theirs = P::accumulator(others);
                    for k in 0..N {
                        sum[k] += gain[k];
                        theirs[k] -= loss[k];
                    }
                }
            }
            let accumulator = P::accumulator(&mut blocks[block]);
            for (k, sum) in accumulator.iter_mut().enumerate() {
                *sum += lanes::sums(own.map(|sum| sum[k]));
            }
        }
    }

    /// Calls `see` with each particle, the shift of its neighbours in smoothing lengths,
    /// and these neighbours, so that it meets each pair from one end. A particle is its
    /// place, four to a block; the place after the last block fills the neighbours up to a
    /// multiple of four.
    #[inline(always)]
    pub fn each(&self, others: &mut Vec<u32>, mut see: impl FnMut(usize, Vec2, &[u32])) {
        let nowhere = (LANES * self.blocks) as u32;
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
                    for (place, lane) in written.iter_mut().zip(lanes) {
                        *place = base + lane;
                    }
                    count += members;
                }
                others[count..count + LANES].fill(nowhere);
                if count > 0 {
                    let padded = count.next_multiple_of(LANES);
                    see(first + lane, sweep.shift, &others[..padded]);
                }
            }
        }
    }

    /// Neighbours of a particle, on average, and the largest number of one, as the last search
    /// found them; it counts them again.
    pub fn mean_and_max(&self) -> (f32, u32) {
        let nowhere = LANES * self.blocks;
        let mut counts = vec![0_u32; nowhere + 1];
        self.each(&mut Vec::new(), |one, _, others| {
            for &other in others {
                counts[one] += u32::from(other as usize != nowhere);
                counts[other as usize] += 1;
            }
        });
        let counts = &counts[..nowhere];
        let sum: u32 = counts.iter().sum();
        let mean = sum as f32 / self.particles.max(1) as f32;
        (mean, counts.iter().copied().max().unwrap_or(0))
    }
}

#[inline(always)]
fn square(x: Lanes, y: Lanes) -> Lanes {
    x * x + y * y
}

/// From where to where particles lie, those nowhere left out.
#[inline]
fn span(x: Lanes) -> (f32, f32) {
    let (mut from, mut to) = (NOWHERE, -NOWHERE);
    for x in x.to_array() {
        if x < from {
            from = x;
        }
        if x > to && x < 0.5 * NOWHERE {
            to = x;
        }
    }
    (from, to)
}
