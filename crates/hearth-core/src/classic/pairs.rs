//! The particles as the passes over pairs take them: four to a block.
//!
//! During a substep the blocks are where the gas is reckoned with; at its end what
//! has moved is written back to [`Particles`].

use std::ops::Range;

use super::equation_of_state;
use super::particles::{ParticleState, Particles};
use crate::bounds::Bounds;
use crate::grid::Grid;
use crate::kernel::Kernel;
use crate::lanes::{LANES, Lanes, transposed};
use crate::neighbours::{self, NOWHERE, Neighbours, PairSum};
use crate::params::Physics;

/// Four particles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    /// Position, in smoothing lengths.
    pub place: [Lanes; 2],
    /// What the first pass sums; then the volume of a unit of mass [m³/kg].
    pub volume: Lanes,
    /// Pressure, times the factor that every pressure force has: m h, times that of W'.
    pub pressure: Lanes,
    /// Velocity [m/s].
    pub velocity: [Lanes; 2],
    /// Sum of the accelerations [m/s²].
    pub acceleration: [Lanes; 2],
}

impl Block {
    /// Lanes without a particle: nowhere, and of no consequence.
    pub const EMPTY: Block = Block {
        place: [Lanes::splat(NOWHERE); 2],
        volume: Lanes::ZERO,
        pressure: Lanes::ZERO,
        velocity: [Lanes::ZERO; 2],
        acceleration: [Lanes::ZERO; 2],
    };
}

impl neighbours::Block for Block {
    #[inline(always)]
    fn place(&self) -> [Lanes; 2] {
        self.place
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

/// m h, times the factor of W': what every pressure force has [kg/m · 1/m³].
fn pressure_factor(kernel: &Kernel, mass: f32) -> f32 {
    mass * kernel.smoothing_length() * kernel.minus_dw_norm()
}

/// The blocks, where they lie, and which are near which.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pairs {
    grid: Grid,
    blocks: Vec<Block>,
    neighbours: Neighbours,
}

impl Pairs {
    /// Puts the particles into the order of their places, and into blocks.
    pub fn sort(&mut self, particles: &mut Particles, bounds: &Bounds, kernel: &Kernel) {
        let Pairs { grid, blocks, .. } = self;
        let positions = particles.iter().map(ParticleState::position);
        let places = grid.sort(positions, bounds, kernel.support());
        particles.reorder(places);
        // Not cleared: every block is written as a whole.
        blocks.resize(grid.block_count(), Block::EMPTY);
        let inverse_h = 1.0 / kernel.smoothing_length();
        let units = Lanes::new([inverse_h, inverse_h, 1.0, 1.0]);
        let nowhere = Lanes::new([NOWHERE, NOWHERE, 0.0, 0.0]);
        for (block, members) in blocks.iter_mut().zip(grid.members()) {
            let mut motions = [nowhere; LANES];
            for (motion, particle) in motions.iter_mut().zip(&particles[members]) {
                *motion = particle.motion * units;
            }
            let [x, y, vx, vy] = transposed(motions);
            *block = Block {
                place: [x, y],
                velocity: [vx, vy],
                ..Block::EMPTY
            };
        }
    }

    /// Finds all pairs of sorted particles, and fills in every density,
    /// ρᵢ = Σⱼ mⱼ W(rᵢⱼ), the particle itself included, and every pressure.
    pub fn sum_density(&mut self, particles: &mut Particles, kernel: &Kernel, values: &Physics) {
        let Pairs {
            grid,
            blocks,
            neighbours,
        } = self;
        neighbours.find(blocks, grid, kernel.smoothing_length());
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

    /// Each block and which particles it holds.
    #[inline(always)]
    pub fn each(&mut self) -> impl Iterator<Item = (&mut Block, Range<usize>)> {
        self.blocks.iter_mut().zip(self.grid.members())
    }

    /// Neighbours of a particle, on average, and the largest number of one.
    pub fn mean_and_max(&self) -> (f32, u32) {
        self.neighbours.mean_and_max()
    }
}

#[cfg(test)]
use glam::Vec2;

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

    /// Gives every particle the pressure `of` its place.
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
