//! A step of the water, and what readers see of it.

use super::around::Around;
use super::exchange;
use super::state::Water;
use crate::instance::Instance;
use crate::random::Random;
use crate::scene::Scene;

impl Water {
    /// Moves, heats and evaporates all water for a step, after the gas and the solids have moved.
    pub fn advance(&mut self, scene: &Scene, mut around: Around, random: &mut Random) {
        around.near = std::mem::take(&mut self.near);
        self.set_beds(scene, around.solids);
        self.height = around.values.domain_height;
        let dt = around.dt;
        for (bed, source) in self.beds.iter_mut().zip(scene.sources()) {
            let steam = bed.dry(&source, &around);
            self.account.boiled += f64::from(steam);
            self.steam
                .rise(bed.somewhere(random), bed.relative(steam), random);
        }
        let mut parcels = std::mem::take(&mut self.parcels);
        parcels.retain_mut(|parcel| {
            if parcel.waits > 0.0 {
                parcel.waits -= dt;
                return true;
            }
            let steam =
                exchange::exchange(parcel, &mut around, &mut self.account, &mut self.rounding);
            self.steam
                .rise(parcel.position, steam / parcel.first, random);
            self.fall(parcel, &mut around, random)
        });
        self.parcels = parcels;
        self.steam.drift(&mut around);
        self.near = around.near;
    }

    /// Writes what a picture shows, as the embers are written.
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        let height = self.height;
        self.steam.write_instances(out);
        let flying = self.parcels.iter().filter(|parcel| parcel.waits <= 0.0);
        out.extend(flying.map(|parcel| parcel.instance(height)));
    }
}
