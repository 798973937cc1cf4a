//! Number density, volume and pressure of the gas.
//!
//! Hot gas expands. Each particle has the weight y = m θ, and the number density Y = Σ yⱼ Wᵢⱼ
//! does not depend on the mixture. So the volume V = y/Y and the pressure p = c₀² (Y − Ȳ) are
//! smooth across the edge of a flame, where p(ρ, T) would act as an artificial surface tension
//! (density-independent SPH: Saitoh & Makino, ApJ 768, 2013). In a closed domain, Ȳ is the mean over the
//! particles: the uniform pressure of hot gas moves nothing, but its noise would damp every instability. In
//! open air, Ȳ is the density of the air. Pressure below Ȳ attracts particles, and shifting spreads them
//! again; so shifting cannot be turned off.

use glam::Vec2;

use super::equation_of_state::expansion;
use super::pair::Context;
use super::walls::Walls;
use super::{Gas, make_room};
use crate::grid::Grid;
use crate::kernel;
use crate::lanes::{LANES, Lanes};
use crate::neighbours::{self, FAR_AWAY, Neighbours, PairSum};
use crate::params::Physics;
use crate::solids::Solids;

/// Distance up to which particles are pairs, in smoothing lengths. In the later part of a step, some come within
/// the support that were beyond it in the search. Without them, noise that changes its sign from part to part grows.
pub(super) const REACH: f32 = 2.05;

/// Four particles for the neighbour search.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    /// Position, in smoothing lengths.
    position: [Lanes; 2],
    /// θ, the weight of each in the sums.
    weight: Lanes,
    /// Σ θⱼ w(q).
    sum: [Lanes; 1],
}

impl neighbours::Block for Block {
    /// Gas fills the domain evenly: even twice the maximum number of particles stays below, at
    /// any smoothing ratio.
    const MAX_ENTRIES: usize = 1 << 23;
    const REACH: f32 = REACH;

    #[inline(always)]
    fn position(&self) -> [Lanes; 2] {
        self.position
    }
    #[inline(always)]
    fn weight(&self) -> Lanes {
        self.weight
    }
    #[inline(always)]
    fn sum(&mut self) -> &mut Lanes {
        &mut self.sum[0]
    }
}

/// Σ θⱼ w(q) over the others.
struct OfOthers;

impl PairSum<1> for OfOthers {
    type Block = Block;
    /// Position and weight of a particle in all lanes.
    type Broadcast = ([Lanes; 2], Lanes);

    #[inline(always)]
    fn broadcast(
        &self,
        block: &Block,
        pick: impl Fn(&Lanes) -> Lanes,
        by: Vec2,
    ) -> Self::Broadcast {
        let [x, y] = &block.position;
        ([pick(x) + by.x, pick(y) + by.y], pick(&block.weight))
    }

    #[inline(always)]
    fn pair(
        &self,
        ([x, y], weight): &Self::Broadcast,
        others: &Block,
        keep: Lanes,
    ) -> ([Lanes; 1], [Lanes; 1]) {
        let (x, y) = (*x - others.position[0], *y - others.position[1]);
        let w = keep * kernel::w((x * x + y * y).sqrt());
        ([w * others.weight], [-(w * *weight)])
    }

    #[inline(always)]
    fn accumulator(block: &mut Block) -> &mut [Lanes; 1] {
        &mut block.sum
    }
}

/// The memory of the pass.
#[derive(Clone, Debug, Default)]
pub(crate) struct NumberDensity {
    blocks: Vec<Block>,
}

impl NumberDensity {
    /// Makes room for so many blocks of particles.
    pub fn reserve(&mut self, blocks: usize) {
        make_room(&mut self.blocks, blocks);
    }

    /// Finds all pairs of sorted gas that no thin solid separates, and sums the number density over them
    /// in the same pass, without the walls. Returns its mean with walls that have this mean.
    pub fn find_and_sum(
        &mut self,
        gas: &mut Gas,
        grid: &Grid,
        neighbours: &mut Neighbours,
        context: &Context,
        (walls, solids): (&Walls, &Solids),
    ) -> f32 {
        let h = context.kernel.smoothing_length();
        expand(gas, context.values);
        self.pack(gas, grid, 1.0 / h);
        neighbours.find_and_sum(&mut self.blocks, grid, h);
        if walls.any_thin() {
            remove_pairs_across_solids(&mut self.blocks, grid, neighbours, h, (walls, solids));
        }
        let sum = self.unpack(gas, grid, gas.mass * context.kernel.w_norm());
        // Σ (Y − Γ Ȳ) = Σ Ȳ (1 − Γ)
        let free = gas.len().max(1) as f64 - walls.gamma();
        (sum / if free > 1.0 { free } else { 1.0 }) as f32
    }

    /// Sums the number density of gas that has moved and burnt since the search, without the walls.
    pub fn sum(&mut self, gas: &mut Gas, grid: &Grid, neighbours: &Neighbours, context: &Context) {
        expand(gas, context.values);
        self.pack(gas, grid, 1.0 / context.kernel.smoothing_length());
        let own = kernel::w(Lanes::ZERO);
        for block in &mut self.blocks {
            block.sum[0] = own * block.weight;
        }
        neighbours.sum_of_search(&OfOthers, &mut self.blocks);
        self.unpack(gas, grid, gas.mass * context.kernel.w_norm());
    }

    /// Packs the gas into blocks, with empty sums.
    fn pack(&mut self, gas: &Gas, grid: &Grid, inverse_h: f32) {
        // Not cleared: the loop overwrites every block.
        self.blocks.resize(grid.block_count(), Block::default());
        for (block, members) in self.blocks.iter_mut().zip(grid.members()) {
            let mut position = [[FAR_AWAY; LANES]; 2];
            let mut weight = [0.0; LANES];
            for (lane, i) in members.enumerate() {
                let at = gas.position[i] * inverse_h;
                (position[0][lane], position[1][lane]) = (at.x, at.y);
                weight[lane] = gas.expansion[i];
            }
            *block = Block {
                position: position.map(Lanes::new),
                weight: Lanes::new(weight),
                sum: [Lanes::ZERO],
            };
        }
    }

    /// Writes the number densities, `unit` times the sums, into the gas. Returns their sum.
    fn unpack(&self, gas: &mut Gas, grid: &Grid, unit: f32) -> f64 {
        let mut sum = 0.0;
        for (block, members) in self.blocks.iter().zip(grid.members()) {
            let number_density = (block.sum[0] * unit).to_array();
            for (i, number_density) in members.zip(number_density) {
                gas.number_density[i] = number_density;
                sum += f64::from(number_density);
            }
        }
        sum
    }
}

/// Computes θ of the gas from its temperature.
fn expand(gas: &mut Gas, values: &Physics) {
    for (theta, state) in gas.expansion.iter_mut().zip(&gas.state) {
        *theta = expansion(state.x, values);
    }
}

/// Removes the pairs that a thin solid separates.
fn remove_pairs_across_solids(
    blocks: &mut [Block],
    grid: &Grid,
    neighbours: &mut Neighbours,
    h: f32,
    (walls, solids): (&Walls, &Solids),
) {
    let thin_near = |particle| walls.thin_near(particle);
    neighbours.remove_pairs_across_solids(blocks, grid, h, solids, thin_near);
}

/// Computes volume and pressure from the number density; the pressure is zero at `reference`.
pub(crate) fn set_pressure(gas: &mut Gas, reference: f32, sound: f32) {
    for (i, &number_density) in gas.number_density.iter().enumerate() {
        gas.volume[i] = gas.mass * gas.expansion[i] / number_density;
        gas.pressure[i] = sound * sound * (number_density - reference);
    }
}
