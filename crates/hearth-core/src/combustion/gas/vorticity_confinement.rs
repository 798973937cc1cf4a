//! Vorticity confinement: a force around every vortex that restores the rotation
//! that a coarse simulation dissipates (Fedkiw, Stam, Jensen, SIGGRAPH 2001),
//! a = ε h (∇|ω|/|∇|ω|| × ω).
//!
//! It needs two more passes over the pairs: for the curl ω of the velocity, and for
//! the gradient of its magnitude.

use glam::Vec2;

use super::Gas;
use super::interactions;
use crate::grid::Grid;
use crate::interaction::Separation;
use crate::kernel::{self, Kernel};
use crate::lanes::{Lanes, Real};
use crate::neighbours::{self, Neighbours, PairSum};

/// Four particles.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    /// Position, in smoothing lengths.
    position: [Lanes; 2],
    /// Volume \[m²\].
    volume: Lanes,
    /// Velocity [m/s].
    velocity: [Lanes; 2],
    /// ω without the factor of W'.
    curl: [Lanes; 1],
    /// ∇|ω| without its factor.
    gradient: [Lanes; 2],
}

impl neighbours::Block for Block {
    fn position(&self) -> [Lanes; 2] {
        self.position
    }
    fn weight(&self) -> Lanes {
        self.volume
    }
    fn sum(&mut self) -> &mut Lanes {
        &mut self.curl[0]
    }
}

/// A particle with each property in all lanes.
struct Broadcast {
    position: [Lanes; 2],
    volume: Lanes,
    velocity: [Lanes; 2],
    curl: Lanes,
}

impl Broadcast {
    fn of(block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Broadcast {
        Broadcast {
            position: [
                pick(&block.position[0]) + by.x,
                pick(&block.position[1]) + by.y,
            ],
            volume: pick(&block.volume),
            velocity: block.velocity.each_ref().map(&pick),
            curl: pick(&block.curl[0]),
        }
    }

    /// −∇W at each of the others, without its factor.
    fn minus_gradient(&self, others: &Block, keep: Lanes) -> [Lanes; 2] {
        let Separation { x, y, q, .. } = Separation::between(self.position, others.position);
        let over_r = keep * kernel::minus_dw(q) / q;
        [x * over_r, y * over_r]
    }
}

/// ω = Σ V ∇W × v
struct Curl;

impl PairSum<1> for Curl {
    type Block = Block;
    type Broadcast = Broadcast;

    fn broadcast(&self, block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Broadcast {
        Broadcast::of(block, pick, by)
    }

    fn pair(&self, particle: &Broadcast, others: &Block, keep: Lanes) -> ([Lanes; 1], [Lanes; 1]) {
        let [x, y] = particle.minus_gradient(others, keep);
        let curl_term = x * (particle.velocity[1] - others.velocity[1])
            - y * (particle.velocity[0] - others.velocity[0]);
        (
            [curl_term * others.volume],
            [-(curl_term * particle.volume)],
        )
    }

    fn accumulator(block: &mut Block) -> &mut [Lanes; 1] {
        &mut block.curl
    }
}

/// ∇|ω| = Σ V (|ωⱼ| − |ωᵢ|) ∇W
struct CurlGradient;

impl PairSum<2> for CurlGradient {
    type Block = Block;
    type Broadcast = Broadcast;

    fn broadcast(&self, block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Broadcast {
        Broadcast::of(block, pick, by)
    }

    fn pair(&self, particle: &Broadcast, others: &Block, keep: Lanes) -> ([Lanes; 2], [Lanes; 2]) {
        let magnitude = |curl: Lanes| curl.fast_max(-curl);
        let difference = magnitude(particle.curl) - magnitude(others.curl[0]);
        let gradient = particle.minus_gradient(others, keep);
        (
            gradient.map(|along| along * difference * others.volume),
            gradient.map(|along| -(along * difference * particle.volume)),
        )
    }

    fn accumulator(block: &mut Block) -> &mut [Lanes; 2] {
        &mut block.gradient
    }
}

/// The memory of the two passes.
#[derive(Clone, Debug, Default)]
pub(crate) struct VorticityConfinement {
    blocks: Vec<Block>,
}

impl VorticityConfinement {
    /// Makes room for so many blocks of particles.
    pub fn reserve(&mut self, blocks: usize) {
        self.blocks
            .reserve(blocks.saturating_sub(self.blocks.len()));
    }

    /// Adds the force of that strength ε to the accelerations.
    pub fn add(
        &mut self,
        gas: &mut Gas,
        grid: &Grid,
        neighbours: &Neighbours,
        packed: &[interactions::Block],
        kernel: &Kernel,
        strength: f32,
    ) {
        if strength != 0.0 {
            self.act(gas, grid, neighbours, packed, kernel, strength);
        }
    }

    fn act(
        &mut self,
        gas: &mut Gas,
        grid: &Grid,
        neighbours: &Neighbours,
        packed: &[interactions::Block],
        kernel: &Kernel,
        strength: f32,
    ) {
        self.blocks.clear();
        self.blocks.extend(packed.iter().map(|packed| Block {
            position: packed.motion.position,
            volume: packed.motion.volume,
            velocity: packed.motion.velocity,
            ..Block::default()
        }));
        neighbours.sum(&Curl, &mut self.blocks);
        neighbours.sum(&CurlGradient, &mut self.blocks);
        let h = kernel.smoothing_length();
        let strength = strength * h * h * kernel.minus_dw_norm();
        for (block, members) in self.blocks.iter().zip(grid.members()) {
            let curl = block.curl[0].to_array();
            let [x, y] = block.gradient.map(Lanes::to_array);
            for (lane, i) in members.enumerate() {
                let direction = Vec2::new(x[lane], y[lane]).normalize_or_zero();
                gas.acceleration[i] +=
                    Vec2::new(direction.y, -direction.x) * (curl[lane] * strength);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::number_density;
    use crate::combustion::gas::pair::Context;
    use crate::combustion::gas::pairs::Pairs;
    use crate::combustion::gas::periodic_bounds as bounds;
    use crate::combustion::gas::tests::{random_gas, with};
    use crate::combustion::gas::walls::Walls;
    use crate::params::Input;
    use crate::scene::Scene;
    use crate::solids::Solids;

    /// Gas of random motion above y = `still`, at rest below, and what the confinement adds to
    /// its accelerations.
    fn confined(still: f32, solids: &Solids) -> (Gas, Vec<Vec2>) {
        let off = with(&[("particles", 1500.0)]);
        let on = with(&[("particles", 1500.0), ("vorticity_confinement", 0.5)]);
        let mut gas = random_gas(&off, 9);
        let kernel = Kernel::new(off.smoothing_length());
        for (at, velocity) in gas.position.iter().zip(&mut gas.velocity) {
            if at.y < still {
                *velocity = Vec2::ZERO;
            }
        }
        let (mut pairs, mut walls) = (Pairs::default(), Walls::default());
        pairs.sort(&mut gas, &bounds(&off), &kernel);
        walls.find(&gas, pairs.grid(), solids, false, &kernel);
        let context = Context::new(&gas, &off, &kernel, 6.0);
        let mean = pairs.find_and_sum(&mut gas, (&walls, solids), &context);
        number_density::set_pressure(&mut gas, mean, context.sound);
        pairs.interact(&mut gas, &context);
        gas.acceleration.fill(Vec2::ZERO);
        pairs.confine_vorticity(&mut gas, &context);
        assert!(gas.acceleration.iter().all(|&a| a == Vec2::ZERO));
        let context = Context::new(&gas, &on, &kernel, 6.0);
        pairs.confine_vorticity(&mut gas, &context);
        let added = gas.acceleration.clone();
        (gas, added)
    }

    #[test]
    fn it_accelerates_vortices_and_not_gas_at_rest() {
        let bare = Solids::default();
        let (_, moved) = confined(0.0, &bare);
        assert!(moved.iter().any(|&a| a != Vec2::ZERO));
        let (_, moved) = confined(f32::MAX, &bare);
        assert!(moved.iter().all(|&a| a == Vec2::ZERO));
    }

    #[test]
    fn it_does_not_act_through_a_thin_plate() {
        // The domain is periodic, so there is one plate at its edge too.
        let mut scene = Scene::new(with(&[("particles", 1500.0)]));
        for y in [0.0, 0.9] {
            let fields = [
                ("shape", Input::Text("line")),
                ("y", Input::Number(y)),
                ("width", Input::Number(2.0)),
                ("height", Input::Number(0.01)),
            ];
            let kind = ("kind", Input::Text("solid"));
            assert!(scene.add(&[&[kind], &fields[..]].concat()).is_ok());
        }
        let domain = bounds(scene.world());
        let plates = Solids::of(&scene, &domain, 0.2);
        for (solids, is_reached) in [(&Solids::default(), true), (&plates, false)] {
            let (gas, added) = confined(0.9, solids);
            let still = gas
                .position
                .iter()
                .zip(&added)
                .filter(|particle| particle.0.y < 0.9);
            let moved = still.filter(|particle| *particle.1 != Vec2::ZERO).count();
            assert_eq!(moved > 0, is_reached, "{moved} particles");
            assert!(added.iter().any(|&a| a != Vec2::ZERO));
        }
    }
}
