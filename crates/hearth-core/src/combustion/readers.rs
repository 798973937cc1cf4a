//! What callers read of the combustion model, and do to its embers and its solids that burn.

use glam::Vec2;

use super::reaction::chemistry;
use super::{
    BurningSolid, Charred, Combustion, Ember, FuelTotal, Gas, IgniteError, IgnitionTarget,
    RemovedGas,
};
use crate::instance::Instance;
use crate::params::Physics;
use crate::random::Random;

impl Combustion {
    /// All particles, in no particular order.
    pub fn gas(&self) -> &Gas {
        &self.gas
    }

    /// All embers.
    pub fn embers(&self) -> &[Ember] {
        self.embers.alive()
    }

    /// Throws embers from a position; none from outside of the domain.
    pub fn throw_embers(&mut self, place: Vec2, count: u32, values: &Physics, random: &mut Random) {
        if self.present_bounds(values).contains(place) {
            self.embers.throw_from(place, count, values, random);
        }
    }

    /// Power of the combustion in the last step [kW/m].
    pub fn power(&self) -> f32 {
        self.power
    }

    /// The gas that solids have taken the place of.
    pub fn removed(&self) -> RemovedGas {
        self.removed
    }

    /// Lets free solids start again.
    pub fn forget_free(&mut self) {
        self.solids.free = None;
    }

    /// The ids of the solids that conduct heat, and their temperatures \[K\].
    pub fn solid_temperatures(&self) -> impl Iterator<Item = (u32, f32)> {
        self.solids.temperatures()
    }

    /// Sets the temperatures of the solids that conduct heat, in their order \[K\].
    pub fn set_solid_temperatures(&mut self, all: &[f32]) {
        self.solids.set_temperatures(all);
    }

    /// Lights solids that have fuel, and sources that are wet.
    pub fn ignite(
        &mut self,
        at: IgnitionTarget,
        values: &Physics,
        random: &mut Random,
    ) -> Result<(), IgniteError> {
        let fuel = match &mut self.fuels {
            Some(fuels) => fuels.ignite(at, &mut self.gas, &self.solids, values),
            None => Err(IgniteError),
        };
        let water = self.water.as_mut();
        let dried = water.is_some_and(|water| water.light(at, &self.solids, random));
        if dried { Ok(()) } else { fuel }
    }

    /// Puts out solids that have fuel, and gas.
    pub fn extinguish(&mut self, at: IgnitionTarget, values: &Physics) -> Result<(), IgniteError> {
        match &mut self.fuels {
            Some(fuels) => fuels.extinguish(at, &mut self.gas, &self.solids, values),
            None => Err(IgniteError),
        }
    }

    /// The solids that have fuel.
    pub fn burning_solids(&self, values: &Physics) -> Vec<BurningSolid> {
        let heat = chemistry::heat_of_combustion(values);
        let fuels = self.fuels.as_ref();
        fuels.map_or_else(Vec::new, |fuels| {
            fuels.solids(values.ambient_temperature, heat)
        })
    }

    /// All solids that have fuel, together.
    pub fn fuel_total(&self, values: &Physics) -> FuelTotal {
        let heat = chemistry::heat_of_combustion(values);
        let fuels = self.fuels.as_ref();
        fuels.map_or_else(FuelTotal::default, |fuels| fuels.total(heat))
    }

    /// Updates what a picture shows of the solids that have fuel.
    pub fn show_fuels(&mut self) {
        if let Some(fuels) = &mut self.fuels {
            fuels.show(&self.solids);
        }
    }

    /// The solids that have fuel, for a picture, as they were when they were last updated.
    pub fn charred(&self) -> Option<&Charred> {
        self.fuels.as_ref().map(|fuels| &fuels.charred)
    }

    /// Writes the embers for the renderer.
    pub fn write_embers(&self, out: &mut Vec<Instance>) {
        self.embers.write_instances(out);
        if let Some(water) = &self.water {
            water.write_instances(out);
        }
    }
}
