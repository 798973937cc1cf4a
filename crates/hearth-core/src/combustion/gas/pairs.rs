//! The passes over the pairs of the gas: the neighbour search with the number density, the mixing in
//! rolls, the interactions and the vorticity confinement.

use super::Gas;
use super::interactions::Interactions;
use super::number_density::NumberDensity;
use super::pair::Context;
use super::pressing::Later;
use super::rolls::Rolls;
use super::vorticity_confinement::VorticityConfinement;
use super::walls::Walls;
use crate::bounds::Bounds;
use crate::combustion::fires::Fires;
use crate::grid::Grid;
use crate::kernel::Kernel;
use crate::neighbours::Neighbours;
use crate::solids::Solids;

/// The grid and the neighbours of the gas, and the memory of each pass.
///
/// No pass is inlined: in one function of all passes, the compilers of browsers keep fewer values in
/// registers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pairs {
    grid: Grid,
    neighbours: Neighbours,
    number_density: NumberDensity,
    interactions: Interactions,
    later: Later,
    vorticity_confinement: VorticityConfinement,
    pub rolls: Rolls,
}

crate::state! { Pairs: rolls; grid neighbours number_density interactions later vorticity_confinement }

impl Pairs {
    /// Makes room for so many particles within `bounds`, with kernels of this support radius \[m\].
    pub fn reserve(&mut self, particles: usize, bounds: &Bounds, support: f32) {
        self.grid.reserve(particles, bounds, support);
        let blocks = self.grid.max_blocks(particles);
        self.number_density.reserve(blocks);
        self.interactions.reserve(blocks);
        self.later.reserve(blocks);
        self.vorticity_confinement.reserve(blocks);
        self.rolls.reserve(blocks);
    }

    /// Sorts the gas into the cells of the grid.
    #[inline(never)]
    pub fn sort(&mut self, gas: &mut Gas, bounds: &Bounds, kernel: &Kernel) {
        let positions = gas.position.iter().copied();
        let new_indices = self.grid.sort(positions, bounds, kernel.support());
        gas.reorder(new_indices);
    }

    /// The cells of the sorted gas.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Finds all pairs that no thin solid separates, and sums the number density without that of the
    /// walls. Returns its mean with walls that have this mean.
    #[inline(never)]
    pub fn find_and_sum(
        &mut self,
        gas: &mut Gas,
        (walls, solids): (&Walls, &Solids),
        context: &Context,
    ) -> f32 {
        let (grid, neighbours) = (&self.grid, &mut self.neighbours);
        self.number_density
            .find_and_sum(gas, grid, neighbours, context, (walls, solids))
    }

    /// Finds the viscosity of the rolls of these fires.
    #[inline(never)]
    pub fn find_rolls(&mut self, gas: &mut Gas, fires: &Fires, context: &Context) {
        let (grid, neighbours) = (&self.grid, &self.neighbours);
        self.rolls.find(gas, grid, neighbours, fires, context);
    }

    /// Sums accelerations, diffusion and concentration gradient over the pairs.
    #[inline(never)]
    pub fn interact(&mut self, gas: &mut Gas, context: &Context) {
        let (grid, neighbours) = (&self.grid, &self.neighbours);
        self.interactions.sum(gas, grid, neighbours, context);
    }

    /// Sums the number density where the gas is now, without that of the walls.
    #[inline(never)]
    pub fn sum_number_density(&mut self, gas: &mut Gas, context: &Context) {
        let (grid, neighbours) = (&self.grid, &self.neighbours);
        self.number_density.sum(gas, grid, neighbours, context);
    }

    /// Sums the acceleration by pressure and artificial viscosity, and the concentration gradient, where the gas
    /// is now.
    #[inline(never)]
    pub fn press(&mut self, gas: &mut Gas, context: &Context) {
        let (grid, neighbours) = (&self.grid, &self.neighbours);
        self.later.sum(gas, grid, neighbours, context);
    }

    /// Adds the force that keeps eddies from fading, from what [`interact`](Self::interact) packed.
    #[inline(never)]
    pub fn confine_vorticity(&mut self, gas: &mut Gas, context: &Context) {
        let (grid, neighbours) = (&self.grid, &self.neighbours);
        let (packed, strength) = (
            self.interactions.blocks(),
            context.values.vorticity_confinement,
        );
        self.vorticity_confinement
            .add(gas, grid, neighbours, packed, context.kernel, strength);
    }

    /// Mean and largest number of neighbours.
    pub fn mean_and_max_neighbours(&self) -> (f32, u32) {
        self.neighbours.mean_and_max()
    }
}
