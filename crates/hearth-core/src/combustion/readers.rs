//! What callers read of the combustion model, and do to its embers, its water and its solids that burn.

use glam::Vec2;

use super::reaction::chemistry;
use super::{
    BurningSolid, Charred, Combustion, Droplets, Ember, FuelTotal, Gas, IgniteError,
    IgnitionTarget, RemovedGas, SprayTotals, Water,
};
use crate::instance::Instance;
use crate::params::Physics;
use crate::random::Random;
use crate::scene::Scene;

impl Combustion {
    /// All particles, in no particular order.
    pub fn gas(&self) -> &Gas {
        &self.gas
    }

    /// All embers.
    pub fn embers(&self) -> &[Ember] {
        self.reaction.embers.alive()
    }

    /// Throws embers from a position; none from outside of the domain.
    pub fn throw_embers(&mut self, place: Vec2, count: u32, values: &Physics, random: &mut Random) {
        if self.domain.bounds(values).contains(place) {
            self.reaction
                .embers
                .throw_from(place, count, values, random);
        }
    }

    /// Power of the combustion in the last step [kW/m].
    pub fn power(&self) -> f32 {
        self.reaction.power
    }

    /// That of each part of the step [kW/m].
    pub fn powers(&self) -> &[f32] {
        &self.reaction.powers
    }

    /// The gas that solids have taken the place of.
    pub fn removed(&self) -> RemovedGas {
        self.obstacles.removed
    }

    /// Lets free solids start again.
    // A part of the code of saved fires.
    #[inline(always)]
    pub fn forget_free(&mut self) {
        self.obstacles.solids.free = Default::default();
    }

    /// The ids of the solids that conduct heat, and their temperatures \[K\].
    pub fn solid_temperatures(&self) -> impl Iterator<Item = (u32, f32)> {
        self.obstacles.solids.temperatures()
    }

    /// Sets the temperatures of the solids that conduct heat, in their order \[K\].
    pub fn set_solid_temperatures(&mut self, all: &[f32]) {
        self.obstacles.solids.set_temperatures(all);
    }

    /// Lights solids that have fuel, and dries sources.
    pub fn ignite(
        &mut self,
        at: IgnitionTarget,
        scene: &Scene,
        random: &mut Random,
    ) -> Result<(), IgniteError> {
        let solids = &self.obstacles.solids;
        let fuel = match self.fuels.as_mut() {
            Some(fuels) => fuels.ignite(at, &mut self.gas, solids, scene.world()),
            None => Err(IgniteError),
        };
        let mut none = Water::default();
        let water = self.water.as_deref_mut().unwrap_or(&mut none);
        if water.light(at, scene, solids, random) {
            Ok(())
        } else {
            fuel
        }
    }

    /// Puts out solids that have fuel, and gas.
    pub fn extinguish(&mut self, at: IgnitionTarget, values: &Physics) -> Result<(), IgniteError> {
        match self.fuels.as_mut() {
            Some(fuels) => fuels.extinguish(at, &mut self.gas, &self.obstacles.solids, values),
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

    /// Adds the solids that have fuel, for a picture.
    pub fn write_charred(&self, out: &mut Charred) {
        if let Some(fuels) = self.fuels.as_ref() {
            fuels.write_charred(&self.obstacles.solids, out);
        }
    }

    /// Sprays a mass of water [kg/m] from a place within a twentieth of a second; none from outside
    /// of the domain or from inside of a solid.
    pub fn spray(
        &mut self,
        place: Vec2,
        velocity: Vec2,
        mass: f32,
        values: &Physics,
        random: &mut Random,
    ) {
        let is_in_gas =
            self.domain.bounds(values).contains(place) && !self.obstacles.solids.touch(place, 0.0);
        if is_in_gas && mass > 0.0 && velocity.is_finite() {
            let water = self.water.get_or_insert_with(Box::default);
            water.spray(place, velocity, mass, values.ambient_temperature, random);
        }
    }

    /// The droplets in the air.
    pub fn droplets(&self) -> &[Droplets] {
        self.water.as_ref().map_or(&[], |water| water.droplets())
    }

    /// Where all water is.
    pub fn sprayed(&self) -> SprayTotals {
        let water = self.water.as_ref();
        water.map_or_else(SprayTotals::default, |water| water.sprayed())
    }

    /// Widens the kernels of measured particles where open air ends.
    #[inline]
    pub fn widen(&self, measured: &mut [Instance]) {
        self.domain.widen(measured);
    }

    /// Writes the embers for the renderer.
    pub fn write_embers(&self, out: &mut Vec<Instance>) {
        self.reaction.embers.write_instances(out);
        if let Some(water) = self.water.as_ref() {
            water.write_instances(out);
        }
    }
}
