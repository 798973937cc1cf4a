//! Solids that have fuel.

use super::Simulation;
use crate::combustion::{BurningSolid, Charred, FuelTotal, IgniteError, IgnitionTarget};

impl Simulation {
    /// Lights a solid that has fuel: heats all of its surface, or what is within 0.1 m of a place
    /// or within the radius, to above its pyrolysis temperature, and dries it. Dries the sources near that
    /// place too, and those at a solid there, so that those that [water](Simulation::spray) has put out burn
    /// again.
    ///
    /// # Errors
    /// There is no fuel and no source that is on; the classic model lights neither.
    pub fn ignite(&mut self, at: IgnitionTarget) -> Result<(), IgniteError> {
        match self.solver.combustion_mut() {
            Some(combustion) => combustion.ignite(at, &self.scene, &mut self.random),
            None => Err(IgniteError),
        }
    }

    /// Puts out a solid that has fuel, or all that is within a radius of a place: cools it and
    /// the gas there to the temperature of the air, and removes the fuel of that gas.
    ///
    /// # Errors
    /// There is no fuel; the classic model has none.
    pub fn extinguish(&mut self, at: IgnitionTarget) -> Result<(), IgniteError> {
        let values = self.scene.world();
        match self.solver.combustion_mut() {
            Some(combustion) => combustion.extinguish(at, values),
            None => Err(IgniteError),
        }
    }

    /// The solids that have fuel, in the order of the objects. No solid burns in the classic model.
    pub fn burning_solids(&self) -> Vec<BurningSolid> {
        let combustion = self.solver.combustion();
        combustion.map_or_else(Vec::new, |combustion| {
            combustion.burning_solids(self.scene.world())
        })
    }

    /// All solids that have fuel, together; `None` in the classic model.
    pub fn fuel_total(&self) -> Option<FuelTotal> {
        let combustion = self.solver.combustion()?;
        Some(combustion.fuel_total(self.scene.world()))
    }

    /// Writes the solids that have fuel, for a picture. The classic model has none.
    pub fn write_charred(&self, out: &mut Charred) {
        out.clear();
        if let Some(combustion) = self.solver.combustion() {
            combustion.write_charred(out);
        }
    }
}
