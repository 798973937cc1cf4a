//! Water that is sprayed.

use glam::Vec2;

use super::Simulation;
use crate::combustion::{Combustion, Droplets, SprayError, SprayTotals};

impl Simulation {
    /// Sprays a mass of water [kg/m] from a place \[m\] within a twentieth of a second. Its droplets leave
    /// with about that velocity. A larger mass counts as 1 kg/m, a faster one as 20 m/s, and there are at
    /// most 2000 groups of droplets in the air. Outside of the domain, inside of solids and for what is no
    /// number it does nothing.
    ///
    /// # Errors
    /// The classic model has no water.
    pub fn spray(&mut self, place: Vec2, velocity: Vec2, mass: f32) -> Result<(), SprayError> {
        let values = self.scene.world();
        let combustion = self.solver.combustion_mut().ok_or(SprayError)?;
        combustion.spray(place, velocity, mass, values, &mut self.random);
        Ok(())
    }

    /// The droplets in the air and at the nozzle, each item so many of one size that move alike. The
    /// classic model has none.
    pub fn droplets(&self) -> &[Droplets] {
        self.solver.combustion().map_or(&[], Combustion::droplets)
    }

    /// Where all water that was sprayed is; `None` in the classic model.
    pub fn sprayed(&self) -> Option<SprayTotals> {
        self.solver.combustion().map(Combustion::sprayed)
    }
}
