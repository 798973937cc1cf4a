//! The state of the water.

use super::bed::Bed;
use super::report::{Droplets, SprayTotals};
use super::steam::Steam;

/// Water at a fire.
#[derive(Clone, Debug, Default)]
pub(crate) struct Water {
    pub(super) parcels: Vec<Droplets>,
    pub(super) beds: Vec<Bed>,
    pub(super) steam: Steam,
    pub(super) account: SprayTotals,
    /// Cooling of the gas that is less than the last digit of a temperature \[K\].
    pub(super) rounding: f32,
    /// Height of the domain, by which pictures are scaled \[m\].
    pub(super) height: f32,
    /// Room for the particles around a place.
    pub(super) near: Vec<(usize, f32)>,
}

crate::state! { Water: parcels beds steam account rounding height; near }

impl Water {
    /// The droplets in the air.
    pub(crate) fn droplets(&self) -> &[Droplets] {
        &self.parcels
    }

    /// Mass of all that has become steam in the air, at solids without fuel and at sources [kg/m].
    pub(crate) fn steamed(&self) -> f64 {
        self.account.evaporated + self.account.boiled
    }

    /// The account with what is in the air and in sources now.
    pub(crate) fn sprayed(&self) -> SprayTotals {
        let flying = self.parcels.iter().map(|parcel| f64::from(parcel.mass));
        let held = self.beds.iter().map(|bed| f64::from(bed.water));
        SprayTotals {
            flying: flying.sum(),
            held: held.sum(),
            ..self.account
        }
    }
}
