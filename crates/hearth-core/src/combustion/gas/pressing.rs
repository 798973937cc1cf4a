//! Pressure and artificial viscosity, which act on sound: each part of a step sums them, at the places that the
//! gas has reached. The first part does so in the pass of all interactions.

mod artificial_viscosity;
mod pressure;

use std::ops::Range;

use glam::Vec2;

use super::pair::{Context, Motion, Pair};
use super::{Gas, make_room};
use crate::grid::Grid;
use crate::interaction::{PairInteraction, Rates};
use crate::lanes::{Lanes, transposed};
use crate::neighbours::{self, Neighbours, PairSum};

/// The interactions that each part of a step sums, in the order in which their rates add up.
fn list(context: &Context) -> impl PairInteraction<Pair> {
    (
        pressure::Pressure::new(context),
        artificial_viscosity::ArtificialViscosity::new(context),
    )
}

/// Four particles.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Block {
    motion: Motion,
    /// Acceleration [m/s²], and the concentration gradient without its factor.
    sums: [Lanes; SUMS],
}

/// Number of sums of a particle.
const SUMS: usize = 4;

impl neighbours::Block for Block {
    fn position(&self) -> [Lanes; 2] {
        self.motion.position
    }
    fn weight(&self) -> Lanes {
        self.motion.volume
    }
    fn sum(&mut self) -> &mut Lanes {
        &mut self.sums[0]
    }
}

/// The interactions of a part, with the concentration gradient.
pub(super) struct Pressing<I>(I);

impl Pressing<()> {
    /// The interactions of this step.
    pub fn new(context: &Context) -> Pressing<impl PairInteraction<Pair>> {
        Pressing(list(context))
    }
}

impl<I: PairInteraction<Pair>> Pressing<I> {
    /// The terms of both ends of a pair with these volumes.
    #[inline(always)]
    pub fn ends(&self, pair: &Pair, own: Lanes, others: Lanes) -> ([Lanes; SUMS], [Lanes; SUMS]) {
        let mut rates = Rates::NONE;
        self.0.add(pair, &mut rates);
        let along = [pair.offset.x, pair.offset.y];
        let [ax, ay] = along.map(|along| along * rates.radial);
        let [x, y] = along.map(|along| along * pair.gradient);
        ([ax, ay, x * others, y * others], [ax, ay, x * own, y * own])
    }
}

impl<I: PairInteraction<Pair>> PairSum<SUMS> for Pressing<I> {
    type Block = Block;
    type Broadcast = Motion;

    #[inline(always)]
    fn broadcast(&self, block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Motion {
        block.motion.picked(pick, by)
    }

    #[inline(always)]
    fn pair(
        &self,
        particle: &Motion,
        others: &Block,
        keep: Lanes,
    ) -> ([Lanes; SUMS], [Lanes; SUMS]) {
        let pair = Pair::new(particle, &others.motion, keep);
        self.ends(&pair, particle.volume, others.motion.volume)
    }

    #[inline(always)]
    fn accumulator(block: &mut Block) -> &mut [Lanes; SUMS] {
        &mut block.sums
    }
}

/// Writes the sums of some of the gas into it.
#[inline(always)]
pub(super) fn unpack(sums: [Lanes; SUMS], gas: &mut Gas, members: Range<usize>, context: &Context) {
    let kernel = context.kernel;
    let gradient_norm = -kernel.minus_dw_norm() * kernel.smoothing_length();
    let [ax, ay, x, y] = sums;
    let sums = transposed([ax, ay, x * gradient_norm, y * gradient_norm]);
    for (sums, i) in sums.into_iter().zip(members) {
        let [ax, ay, x, y] = sums.to_array();
        gas.pressing[i] = Vec2::new(ax, ay);
        gas.concentration_gradient[i] = Vec2::new(x, y);
    }
}

/// The memory of the pass of later parts.
#[derive(Clone, Debug, Default)]
pub(crate) struct Later {
    blocks: Vec<Block>,
}

impl Later {
    /// Makes room for so many blocks of particles.
    pub fn reserve(&mut self, blocks: usize) {
        make_room(&mut self.blocks, blocks);
    }

    /// Sums the acceleration and the concentration gradient where the gas is now.
    pub fn sum(&mut self, gas: &mut Gas, grid: &Grid, neighbours: &Neighbours, context: &Context) {
        let inverse_h = 1.0 / context.kernel.smoothing_length();
        self.blocks.resize(grid.block_count(), Block::default());
        for (block, members) in self.blocks.iter_mut().zip(grid.members()) {
            block.motion.read(gas, members, inverse_h);
            block.sums = [Lanes::ZERO; SUMS];
        }
        neighbours.sum_of_search(&Pressing::new(context), &mut self.blocks);
        for (block, members) in self.blocks.iter().zip(grid.members()) {
            unpack(block.sums, gas, members, context);
        }
    }
}
