//! A step of the water, and what readers see of it.

use super::around::Around;
use super::exchange;
use super::report::{Droplets, SprayTotals};
use super::state::Water;
use crate::combustion::Combustion;
use crate::instance::Instance;
use crate::kernel::Kernel;
use crate::random::Random;
use crate::scene::Scene;

impl Combustion {
    /// Moves, heats and evaporates all water for `dt`, after the gas and the solids have moved.
    #[inline(never)]
    pub(in crate::combustion) fn advance_water(
        &mut self,
        scene: &Scene,
        random: &mut Random,
        dt: f32,
    ) {
        let Some(mut water) = self.water.take() else {
            return;
        };
        let values = scene.settings();
        let bounds = self.present_bounds(values);
        let mut near = std::mem::take(&mut water.near);
        let around = Around {
            gas: &mut self.gas,
            grid: &self.grid,
            kernel: &Kernel::new(values.smoothing_length()),
            bounds: &bounds,
            solids: &mut self.solids,
            fuels: self.fuels.as_deref_mut(),
            has_floor: self.open.as_ref().is_some_and(|open| open.has_floor()),
            values,
            dt,
            near: &mut near,
        };
        water.advance(scene, around, random);
        water.near = near;
        self.water = Some(water);
    }

    /// The droplets in the air.
    pub fn droplets(&self) -> &[Droplets] {
        self.water.as_ref().map_or(&[], |water| &water.parcels)
    }

    /// Where all water is.
    pub fn sprayed(&self) -> SprayTotals {
        self.water
            .as_ref()
            .map_or_else(SprayTotals::default, |water| water.sprayed())
    }
}

impl Water {
    fn advance(&mut self, scene: &Scene, mut around: Around, random: &mut Random) {
        self.set_beds(scene);
        self.height = around.values.domain_height;
        let dt = around.dt;
        for (bed, source) in self.beds.iter_mut().zip(scene.sources()) {
            let steam = bed.dry(source, around.values, dt);
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
    }

    /// Writes what a picture shows, as the embers are written.
    #[inline(never)]
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        let height = self.height;
        self.steam.write_instances(out);
        let flying = self.parcels.iter().filter(|parcel| parcel.waits <= 0.0);
        out.extend(flying.map(|parcel| parcel.instance(height)));
    }
}
