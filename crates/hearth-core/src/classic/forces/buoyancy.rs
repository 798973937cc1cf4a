//! Buoyancy: a = [β (ρ_amb/ρ − 1) + β_T (1 − Tₐ/T)] g ŷ, or as the paper prints it,
//! a = β (ρ_amb − ρ) g/m ŷ (equations 5 and 7).

use crate::classic::block_force::{BlockForce, Four};
use crate::lanes::Lanes;
use crate::params::Physics;

/// Buoyancy of thin gas and of hot gas.
pub(super) struct Buoyancy {
    /// β and β_T.
    buoyancy: f32,
    thermal: f32,
    gravity: f32,
    air_density: f32,
    air_temperature: f32,
    /// The mass of a particle \[kg/m\], the divisor of the paper.
    published_divisor: Option<f32>,
}

impl Buoyancy {
    pub fn new(values: &Physics) -> Buoyancy {
        Buoyancy {
            buoyancy: values.buoyancy,
            thermal: values.thermal_buoyancy,
            gravity: values.gravity,
            air_density: values.ambient_density,
            air_temperature: values.ambient_temperature,
            published_divisor: values.printed_divisor.then_some(values.particle_mass),
        }
    }
}

impl BlockForce for Buoyancy {
    #[inline(always)]
    fn add(&self, four: &Four, sum: &mut [Lanes; 2]) {
        let acceleration = if let Some(mass) = self.published_divisor {
            let density = Lanes::splat(1.0) / four.volume;
            (Lanes::splat(self.air_density) - density) * (self.buoyancy / mass)
        } else {
            let heat = Lanes::splat(1.0) - Lanes::splat(self.air_temperature) / four.temperature;
            (four.expansion - 1.0) * self.buoyancy + heat * self.thermal
        };
        sum[1] += acceleration * self.gravity;
    }
}
