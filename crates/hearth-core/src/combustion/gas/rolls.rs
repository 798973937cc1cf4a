//! Mixing in rolls. In two dimensions nothing stretches vortices, so that the rolls of a plane flow do not break
//! up but merge. The eddies into which a roll of three dimensions breaks up have an eddy diffusivity, with a
//! mixing length (Prandtl 1925) of the size of the fire:
//!
//! ```text
//! D = max(l² (|ω| − ½ √(b g/D*)) R − ν, 0)     l² = (C D*)² − (3 C_s h)²
//! R = max((ω² − s²)/(ω² + s²), 0)              ω = ∂ₓv − ∂ᵧu    s² = (∂ₓu − ∂ᵧv)² + (∂ₓv + ∂ᵧu)²
//! ```
//!
//! R is the Okubo–Weiss criterion (Okubo 1970, Weiss 1991): it is 0 where the gas strains as fast as it turns, as
//! in every shear layer. A roll that turns slower than the fire's own rate does not turn over in the life of a
//! flame. What eddies of the size of the kernel mix is in the eddy viscosity, and what molecules mix in ν.
//!
//! Rolls live for some hundred steps, so ∇v is summed in each fourth step only.

use glam::Vec2;

use super::pair::Context;
use super::{Gas, make_room};
use crate::combustion::fires::{Fires, lift};
use crate::extremes::{fast_max, fast_min};
use crate::grid::Grid;
use crate::interaction::Separation;
use crate::kernel;
use crate::lanes::{LANES, Lanes};
use crate::neighbours::{self, FAR_AWAY, Neighbours, PairSum};

/// ∇v is summed in one of so many steps.
const STEPS: u32 = 4;
/// Least vorticity of a roll that mixes, relative to √(b g/D*).
const LEAST_RATE: f32 = 0.5;
/// The size of the eddies of the eddy viscosity, in C_s h.
const RESOLVED_EDDIES: f32 = 3.0;
/// Largest diffusivity, in h c₀: with it, 0.125 h²/D is longer than the step for the sound.
const MAX_DIFFUSIVITY: f32 = 0.1;

/// Four particles.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    /// Position, in smoothing lengths.
    position: [Lanes; 2],
    /// Volume \[m²\].
    volume: Lanes,
    /// Velocity [m/s].
    velocity: [Lanes; 2],
    /// ∂ₓv − ∂ᵧu, ∂ₓu − ∂ᵧv and ∂ₓv + ∂ᵧu without the factor of W'.
    rates: [Lanes; 3],
}

impl neighbours::Block for Block {
    fn position(&self) -> [Lanes; 2] {
        self.position
    }
    fn weight(&self) -> Lanes {
        self.volume
    }
    fn sum(&mut self) -> &mut Lanes {
        &mut self.rates[0]
    }
    #[inline(always)]
    fn moved(self, by: Vec2) -> Block {
        let [x, y] = self.position;
        Block {
            position: [x + by.x, y + by.y],
            ..self
        }
    }
}

/// Rotation and strain, Σ V ∇W v.
struct VelocityGradient;

impl PairSum<3> for VelocityGradient {
    type Block = Block;
    /// Position, volume and velocity of a particle in all lanes.
    type Broadcast = ([Lanes; 2], Lanes, [Lanes; 2]);

    #[inline(always)]
    fn broadcast(&self, block: &Block, pick: impl Fn(&Lanes) -> Lanes) -> Self::Broadcast {
        (
            block.position.each_ref().map(&pick),
            pick(&block.volume),
            block.velocity.each_ref().map(&pick),
        )
    }

    #[inline(always)]
    fn pair(
        &self,
        (position, volume, velocity): &Self::Broadcast,
        others: &Block,
    ) -> ([Lanes; 3], [Lanes; 3]) {
        let Separation { x, y, q, .. } = Separation::between(*position, others.position);
        let over_r = kernel::minus_dw(q) / q;
        let (x, y) = (x * over_r, y * over_r);
        let u = velocity[0] - others.velocity[0];
        let v = velocity[1] - others.velocity[1];
        let rates = [x * v - y * u, x * u - y * v, x * v + y * u];
        (
            rates.map(|rate| rate * others.volume),
            rates.map(|rate| -(rate * *volume)),
        )
    }

    fn accumulator(block: &mut Block) -> &mut [Lanes; 3] {
        &mut block.rates
    }
}

/// The memory of the pass.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rolls {
    blocks: Vec<Block>,
    /// Steps until the next sum.
    left: u32,
}

impl Rolls {
    /// Makes room for so many blocks of particles.
    pub fn reserve(&mut self, blocks: usize) {
        make_room(&mut self.blocks, blocks);
    }

    /// Forgets when the last sum was: the next step sums.
    pub fn restart(&mut self) {
        self.left = 0;
    }

    /// Counts a step. Returns whether it is one that sums.
    pub fn is_due(&mut self) -> bool {
        let is_due = self.left == 0;
        self.left = if is_due { STEPS } else { self.left } - 1;
        is_due
    }

    /// Finds the diffusivity of the roll around each particle.
    pub fn find(
        &mut self,
        gas: &mut Gas,
        grid: &Grid,
        neighbours: &Neighbours,
        fires: &Fires,
        context: &Context,
    ) {
        let (values, h) = (context.values, context.kernel.smoothing_length());
        let resolved = RESOLVED_EDDIES * values.eddy_viscosity * h;
        if values.roll_mixing * fires.greatest_length() <= resolved {
            gas.roll_diffusivity.fill(0.0);
            return;
        }
        self.pack(gas, grid, 1.0 / h);
        neighbours.sum(&VelocityGradient, &mut self.blocks);
        let norm = context.kernel.minus_dw_norm() * h;
        let most = MAX_DIFFUSIVITY * h * context.sound;
        for (block, members) in self.blocks.iter().zip(grid.members()) {
            let rates = block.rates.map(|rate| (rate * norm).to_array());
            for (lane, i) in members.enumerate() {
                let [turn, stretch, shear] = [0, 1, 2].map(|k| rates[k][lane]);
                let (turn, strain) = (turn * turn, stretch * stretch + shear * shear);
                let mut diffusivity = 0.0;
                if turn > strain
                    && let Some(part) = fires.nearest(gas.position[i])
                {
                    let length = values.roll_mixing * part.length;
                    let square = length * length - resolved * resolved;
                    let least = LEAST_RATE * (lift(values) / part.length).sqrt();
                    let rate = (turn.sqrt() - least) * (turn - strain) / (turn + strain);
                    diffusivity = square * rate - values.kinematic_viscosity;
                }
                gas.roll_diffusivity[i] = fast_min(fast_max(diffusivity, 0.0), most);
            }
        }
    }

    /// Packs the gas into blocks, with empty sums.
    fn pack(&mut self, gas: &Gas, grid: &Grid, inverse_h: f32) {
        self.blocks.clear();
        self.blocks.extend(grid.members().map(|members| {
            let mut position = [[FAR_AWAY; LANES]; 2];
            let mut velocity = [[0.0; LANES]; 2];
            let mut volume = [0.0; LANES];
            for (lane, i) in members.enumerate() {
                let (at, v) = (gas.position[i] * inverse_h, gas.velocity[i]);
                (position[0][lane], position[1][lane]) = (at.x, at.y);
                (velocity[0][lane], velocity[1][lane]) = (v.x, v.y);
                volume[lane] = gas.volume[i];
            }
            Block {
                position: position.map(Lanes::new),
                volume: Lanes::new(volume),
                velocity: velocity.map(Lanes::new),
                ..Block::default()
            }
        }));
    }
}
