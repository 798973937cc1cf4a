//! Removes the pairs of particles that a thin solid separates.

use glam::Vec2;

use super::entry::{KEEP, SUBSETS};
use super::{Block, Neighbours, square};
use crate::grid::Grid;
use crate::kernel;
use crate::lanes::Lanes;
use crate::solids::Solids;

/// Tolerance for rounding in the distance from a plane, in smoothing lengths.
const PLANE_TOLERANCE: f32 = 1e-3;

impl Neighbours {
    /// Removes the pairs that a thin solid separates from the lists and from the sums of the first pass.
    /// `near` gives the thin solids near a particle, after sorting: normal, distance \[m\] and number.
    /// `h` is the smoothing length \[m\].
    pub fn remove_pairs_across_solids<B: Block, P: Iterator<Item = (Vec2, f32, u32)>>(
        &mut self,
        blocks: &mut [B],
        grid: &Grid,
        h: f32,
        solids: &Solids,
        near: impl Fn(usize) -> P,
    ) {
        self.is_masked = true;
        let entries = &mut self.entries;
        let inverse_h = 1.0 / h;
        for sweep in &mut self.sweeps {
            let (block, shift) = (sweep.block as usize, sweep.shift);
            for (lane, particle) in grid.members_of(block).enumerate() {
                for (normal, distance, solid) in near(particle) {
                    let from = place(&blocks[block], lane) - shift;
                    let lines = solids.lines_from(solid, (from + shift) * h);
                    // A convex solid lies behind the plane of its nearest point, and no solid is
                    // nearer than that.
                    let distance = distance * inverse_h;
                    let is_convex = lines.is_convex();
                    let plane = Lanes::splat(from.dot(normal) - distance + PLANE_TOLERANCE);
                    let mut remove = |number: usize, mask: u32| {
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
                        let separate = lines.crossed([(x + shift.x) * h, (y + shift.y) * h], mask);
                        if separate != 0 {
                            subtract(blocks, (block, lane), from, number, separate);
                        }
                        separate
                    };
                    if sweep.own {
                        let inner = &mut sweep.inner[lane];
                        *inner -= remove(block, (*inner).into()) as u8;
                    }
                    for entry in &mut entries[sweep.range()] {
                        if entry.lane() == lane {
                            entry.remove(remove(entry.number(), entry.mask() as u32));
                        }
                    }
                }
            }
        }
    }
}

/// Takes back the kernels of the pairs of a particle, a block and a lane at a position, and some of
/// another block from the sums of the first pass.
// Rare, so it is not inlined into the loop over the pairs.
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
