//! The passes over the pairs of the gas: the neighbour search with the number density, the mixing in
//! rolls, the interactions and the vorticity confinement.

use super::Gas;
use super::interactions::Interactions;
use super::number_density::{self, NumberDensity};
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
        let reach = number_density::REACH * 0.5 * support;
        self.grid.reserve(particles, bounds, reach);
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
        let reach = number_density::REACH * kernel.smoothing_length();
        let new_indices = self.grid.sort(positions, bounds, reach);
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
        self.neighbours.mean_and_max(self.interactions.blocks())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use glam::Vec2;

    use super::*;
    use crate::combustion::gas::periodic_bounds;
    use crate::combustion::gas::tests::{random_gas, with};
    use crate::random::Random;

    #[test]
    fn gas_that_has_moved_since_the_search_has_the_density_of_another_search() {
        let parameters = with(&[("particles", 1500.0)]);
        let (mut gas, bounds) = (random_gas(&parameters, 3), periodic_bounds(&parameters));
        let kernel = Kernel::new(parameters.smoothing_length());
        let context = Context::new(&gas, &parameters, &kernel, 6.0);
        let bare = (&Walls::default(), &Solids::default());
        let mut pairs = Pairs::default();
        pairs.sort(&mut gas, &bounds, &kernel);
        pairs.find_and_sum(&mut gas, bare, &context);
        let h = kernel.smoothing_length();
        let (edge, mut random) = (0.5 * bounds.width - h, Random::new(1));
        // Two that approach along a diagonal cross the rim between support and reach.
        let most = (number_density::REACH - 2.0) * h / 8.0_f32.sqrt();
        for at in &mut gas.position {
            let by = Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            if at.x.abs() < edge && (h..bounds.height - h).contains(&at.y) {
                *at += by * most;
            }
        }
        pairs.sum_number_density(&mut gas, &context);
        let by_id = |gas: &Gas| {
            let all = gas
                .id
                .iter()
                .copied()
                .zip(gas.number_density.iter().copied());
            all.collect::<BTreeMap<_, _>>()
        };
        let moved = by_id(&gas);
        pairs.sort(&mut gas, &bounds, &kernel);
        pairs.find_and_sum(&mut gas, bare, &context);
        for ((id, moved), found) in moved.into_iter().zip(by_id(&gas).into_values()) {
            assert!(
                (moved / found - 1.0).abs() < 1e-6,
                "{id}: {moved} for {found}"
            );
        }
    }
}
