//! Entries of the neighbour lists, and tables over their bit masks.

use crate::lanes::{LANES, Lanes};

/// A particle of a block, and its neighbours in another block.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Entry(u32);

impl Entry {
    /// The neighbours have the index of their block and a bit mask.
    #[inline(always)]
    pub fn new(lane: usize, number: usize, mask: u32) -> Entry {
        Entry(((number * LANES + lane) * SUBSETS) as u32 + mask)
    }
    #[inline(always)]
    pub fn lane(self) -> usize {
        self.0 as usize / SUBSETS % LANES
    }
    #[inline(always)]
    pub fn number(self) -> usize {
        self.0 as usize / (SUBSETS * LANES)
    }
    #[inline(always)]
    pub fn mask(self) -> usize {
        self.0 as usize % SUBSETS
    }
    /// Removes some of the neighbours.
    #[inline(always)]
    pub fn remove(&mut self, mask: u32) {
        self.0 -= mask;
    }
}

/// Number of subsets of four particles.
pub(super) const SUBSETS: usize = 1 << LANES;

/// One in the lanes of each subset, and zero in the others.
pub(super) const KEEP: [Lanes; SUBSETS] = {
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
pub(super) const MEMBERS: [([u32; LANES], usize); SUBSETS] = {
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
