//! The particles in blocks of four, for the passes over pairs.
//!
//! A substep computes with the blocks and writes its results back to [`Particles`].

use std::ops::Range;

#[cfg(test)]
use glam::Vec2;

use super::equation_of_state;
use super::particles::{ParticleState, Particles};
use crate::bounds::Bounds;
use crate::grid::Grid;
use crate::kernel::Kernel;
use crate::lanes::{LANES, Lanes, transposed};
use crate::neighbours::{self, FAR_AWAY, Neighbours, PairSum};
use crate::params::Physics;
use crate::solids::Solids;

/// Candidates of the neighbour search that cost as much as sorting and moving a particle.
const ENTRIES_PER_PARTICLE: usize = 16;

/// Four particles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    /// Position, in smoothing lengths.
    pub position: [Lanes; 2],
    /// The kernel sum of the first pass; then the specific volume [m³/kg].
    pub volume: Lanes,
    /// Pressure, times the common factor of the pressure forces: m h, times that of W'.
    pub pressure: Lanes,
    /// Velocity [m/s].
    pub velocity: [Lanes; 2],
    /// Sum of the accelerations [m/s²].
    pub acceleration: [Lanes; 2],
}

impl Block {
    /// Lanes without a particle.
    pub const EMPTY: Block = Block {
        position: [Lanes::splat(FAR_AWAY); 2],
        volume: Lanes::ZERO,
        pressure: Lanes::ZERO,
        velocity: [Lanes::ZERO; 2],
        acceleration: [Lanes::ZERO; 2],
    };
}

impl neighbours::Block for Block {
    #[inline(always)]
    fn position(&self) -> [Lanes; 2] {
        self.position
    }
    #[inline(always)]
    fn weight(&self) -> Lanes {
        Lanes::splat(1.0)
    }
    #[inline(always)]
    fn sum(&mut self) -> &mut Lanes {
        &mut self.volume
    }
}

/// The common factor of the pressure forces: m h, times that of W' [kg/m · 1/m³].
fn pressure_factor(kernel: &Kernel, mass: f32) -> f32 {
    mass * kernel.smoothing_length() * kernel.minus_dw_norm()
}

/// The blocks, the grid and the neighbour lists.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pairs {
    grid: Grid,
    blocks: Vec<Block>,
    neighbours: Neighbours,
}

impl Pairs {
    /// Sorts the particles by the grid and fills the blocks.
    pub fn sort(&mut self, particles: &mut Particles, bounds: &Bounds, kernel: &Kernel) {
        let Pairs { grid, blocks, .. } = self;
        let positions = particles.iter().map(ParticleState::position);
        let new_indices = grid.sort(positions, bounds, kernel.support());
        particles.reorder(new_indices);
        // Not cleared: the loop overwrites every block.
        blocks.resize(grid.block_count(), Block::EMPTY);
        let inverse_h = 1.0 / kernel.smoothing_length();
        let units = Lanes::new([inverse_h, inverse_h, 1.0, 1.0]);
        let empty = Lanes::new([FAR_AWAY, FAR_AWAY, 0.0, 0.0]);
        for (block, members) in blocks.iter_mut().zip(grid.members()) {
            let mut motions = [empty; LANES];
            for (motion, particle) in motions.iter_mut().zip(&particles[members]) {
                *motion = particle.motion * units;
            }
            let [x, y, vx, vy] = transposed(motions);
            *block = Block {
                position: [x, y],
                velocity: [vx, vy],
                ..Block::EMPTY
            };
        }
    }

    /// Finds all pairs of sorted particles that no solid parts, and computes densities,
    /// ρᵢ = Σⱼ mⱼ W(rᵢⱼ), the particle itself included, and pressures.
    pub fn sum_density(
        &mut self,
        particles: &mut Particles,
        kernel: &Kernel,
        values: &Physics,
        solids: &Solids,
    ) {
        let Pairs {
            grid,
            blocks,
            neighbours,
        } = self;
        let h = kernel.smoothing_length();
        neighbours.find_and_sum(blocks, grid, h);
        if solids.any_thin(2.0 * h) {
            neighbours.remove_pairs_across_solids(blocks, grid, h, solids, |particle| {
                solids.thin_near(particles[particle].position(), 2.0 * h)
            });
        }
        let each = values.particle_mass * kernel.w_norm();
        let factor = pressure_factor(kernel, values.particle_mass);
        for (block, members) in blocks.iter_mut().zip(grid.members()) {
            let density = block.volume * each;
            block.volume = equation_of_state::volume(density);
            let pressure = equation_of_state::pressure(density, values);
            block.pressure = pressure * factor;
            let (density, pressure) = (density.to_array(), pressure.to_array());
            for (lane, particle) in particles[members].iter_mut().enumerate() {
                (particle.density, particle.pressure) = (density[lane], pressure[lane]);
            }
        }
    }

    /// Adds `interactions` of all pairs to the accelerations.
    pub fn sum<P: PairSum<2, Block = Block>>(&mut self, interactions: &P) {
        self.neighbours.sum(interactions, &mut self.blocks);
    }

    /// Each block with the range of its particles.
    #[inline(always)]
    pub fn each(&mut self) -> impl Iterator<Item = (&mut Block, Range<usize>)> {
        self.blocks.iter_mut().zip(self.grid.members())
    }

    /// Work of a substep: the candidates of the neighbour search, about eight nanoseconds each, and
    /// the particles, which cost as much as [`ENTRIES_PER_PARTICLE`].
    pub fn work(&self) -> usize {
        self.neighbours.candidates() + ENTRIES_PER_PARTICLE * self.grid.len()
    }

    /// Mean and maximum number of neighbours of a particle.
    pub fn mean_and_max(&self) -> (f32, u32) {
        self.neighbours.mean_and_max(&self.blocks)
    }
}

#[cfg(test)]
impl Pairs {
    /// The accelerations, in the order of the sorted particles.
    pub fn accelerations(&mut self) -> Vec<Vec2> {
        let mut all = Vec::new();
        for (block, members) in self.each() {
            let [x, y] = block.acceleration.map(Lanes::to_array);
            all.extend((0..members.len()).map(|lane| Vec2::new(x[lane], y[lane])));
        }
        all
    }

    /// Sets the pressure of every particle as a function `of` its position.
    pub fn set_pressure(
        &mut self,
        particles: &Particles,
        kernel: &Kernel,
        mass: f32,
        of: impl Fn(Vec2) -> f32,
    ) {
        let factor = pressure_factor(kernel, mass);
        for (block, members) in self.each() {
            let mut pressures = [0.0; LANES];
            for (lane, particle) in particles[members].iter().enumerate() {
                pressures[lane] = of(particle.position()) * factor;
            }
            block.pressure = Lanes::new(pressures);
        }
    }
}
