//! Vorticity confinement: a push around every vortex that gives back the rotation
//! that a coarse simulation loses (Fedkiw, Stam, Jensen, SIGGRAPH 2001),
//! a = ε h (∇|ω|/|∇|ω|| × ω).
//!
//! Two more passes over the pairs: for the curl ω of the velocity, and for the
//! gradient of its magnitude.

use glam::Vec2;

use super::forces::PackedParticle;
use super::gas::Gas;
use crate::grid::Grid;
use crate::kernel::{self, Kernel};
use crate::lanes::{LANES, Lanes, Real, transposed};
use crate::neighbours::{self, Neighbours, PairSum};

/// Four particles.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    /// Position, in smoothing lengths.
    place: [Lanes; 2],
    /// Volume \[m²\].
    volume: Lanes,
    /// Velocity [m/s].
    velocity: [Lanes; 2],
    /// ω, in units of the kernel's steepness.
    curl: [Lanes; 1],
    /// ∇|ω|, in such units.
    ascent: [Lanes; 2],
}

impl neighbours::Block for Block {
    fn place(&self) -> (Lanes, Lanes) {
        (self.place[0], self.place[1])
    }
    fn share(&self) -> Lanes {
        self.volume
    }
    fn sum(&mut self) -> &mut Lanes {
        &mut self.curl[0]
    }
}

/// A particle, each property of it in all lanes.
struct Broadcast {
    place: [Lanes; 2],
    volume: Lanes,
    velocity: [Lanes; 2],
    curl: Lanes,
}

impl Broadcast {
    fn of(block: &Block, lane: usize, shift: Vec2) -> Broadcast {
        let [x, y] = block.place.map(|at| at.spread(lane));
        Broadcast {
            place: [x - shift.x, y - shift.y],
            volume: block.volume.spread(lane),
            velocity: block.velocity.map(|v| v.spread(lane)),
            curl: block.curl[0].spread(lane),
        }
    }

    /// Offset from each of the others times the steepness over the distance.
    fn slope(&self, others: &Block) -> [Lanes; 2] {
        let (x, y) = (
            self.place[0] - others.place[0],
            self.place[1] - others.place[1],
        );
        let q = kernel::distance(x * x + y * y);
        let steep = kernel::minus_dw(q) / q;
        [x * steep, y * steep]
    }
}

/// ω = Σ V ∇W × v
struct Curl;

impl PairSum<1> for Curl {
    type Block = Block;
    type Broadcast = Broadcast;

    fn one(&self, block: &Block, lane: usize, shift: Vec2) -> Broadcast {
        Broadcast::of(block, lane, shift)
    }

    fn pair(&self, one: &Broadcast, others: &Block) -> ([Lanes; 1], [Lanes; 1]) {
        let [x, y] = one.slope(others);
        let turn =
            x * (one.velocity[1] - others.velocity[1]) - y * (one.velocity[0] - others.velocity[0]);
        ([turn * others.volume], [-(turn * one.volume)])
    }

    fn gains(block: &mut Block) -> &mut [Lanes; 1] {
        &mut block.curl
    }
}

/// Σ V (|ωⱼ| − |ωᵢ|) ∇W
struct Ascent;

impl PairSum<2> for Ascent {
    type Block = Block;
    type Broadcast = Broadcast;

    fn one(&self, block: &Block, lane: usize, shift: Vec2) -> Broadcast {
        Broadcast::of(block, lane, shift)
    }

    fn pair(&self, one: &Broadcast, others: &Block) -> ([Lanes; 2], [Lanes; 2]) {
        let size = |curl: Lanes| curl.fast_max(-curl);
        let more = size(one.curl) - size(others.curl[0]);
        let slope = one.slope(others);
        (
            slope.map(|along| along * more * others.volume),
            slope.map(|along| -(along * more * one.volume)),
        )
    }

    fn gains(block: &mut Block) -> &mut [Lanes; 2] {
        &mut block.ascent
    }
}

/// The memory of the two passes.
#[derive(Clone, Debug, Default)]
pub(crate) struct VorticityConfinement {
    blocks: Vec<Block>,
}

impl VorticityConfinement {
    /// Adds the push of that strength to the accelerations.
    pub fn confine(
        &mut self,
        gas: &mut Gas,
        grid: &Grid,
        neighbours: &Neighbours,
        packed: &[PackedParticle],
        kernel: &Kernel,
        strength: f32,
    ) {
        self.blocks.clear();
        let (fours, _) = packed.as_chunks::<LANES>();
        self.blocks.extend(fours.iter().map(|four| {
            let [x, y, vx, vy] = transposed(four.map(|parcel| parcel.motion));
            let [volume, ..] = transposed(four.map(|parcel| parcel.room));
            Block {
                place: [x, y],
                volume,
                velocity: [vx, vy],
                ..Block::default()
            }
        }));
        neighbours.apply(&Curl, &mut self.blocks);
        neighbours.apply(&Ascent, &mut self.blocks);
        let h = kernel.smoothing_length();
        let strength = strength * h * h * kernel.minus_dw_norm();
        for (block, members) in self.blocks.iter().zip(grid.members()) {
            let Block { curl, ascent, .. } = block;
            let curl = curl[0].to_array();
            let [x, y] = ascent.map(Lanes::to_array);
            for (lane, i) in members.enumerate() {
                let towards = Vec2::new(x[lane], y[lane]).normalize_or_zero();
                gas.acceleration[i] += Vec2::new(towards.y, -towards.x) * (curl[lane] * strength);
            }
        }
    }
}
