//! Water: a spray of droplets that the gas drags, heats and evaporates, and that wet what they strike.
//!
//! A [parcel](Droplets) stands for many droplets of one size, which move and evaporate alike. Every
//! step parcels [exchange](exchange) momentum and heat with the gas around them, fall, and
//! [strike](strike) solids, [beds](bed) of sources and the floor. A part of their vapour becomes
//! [steam](steam), which only pictures show. No fire is put out by decree: gas that is cooled below its
//! ignition temperature does not burn, and fuel that is wet dries first. The code is a part of the wasm
//! that a page loads for the first spray: nothing outside of it calls a function of it without one.

mod bed;
mod exchange;
mod report;
mod spray;
mod steam;
mod strike;

use super::Combustion;
use super::fuels::Fuels;
use super::gas::Gas;
use crate::bounds::Bounds;
use crate::grid::Grid;
use crate::held::OfPart;
use crate::instance::Instance;
use crate::kernel::Kernel;
use crate::params::Physics;
use crate::random::Random;
use crate::scene::Scene;
use crate::solids::Solids;
use bed::Bed;
use steam::Steam;

pub use report::{Droplets, NoWater, Sprayed};

/// Water at a fire.
#[derive(Clone, Debug, Default)]
pub(crate) struct Water {
    parcels: Vec<Droplets>,
    beds: Vec<Bed>,
    steam: Steam,
    account: Sprayed,
    /// Cooling of the gas that is less than the last digit of a temperature \[K\].
    rounding: f32,
    /// Height of the frame, by which pictures are scaled \[m\].
    height: f32,
    /// Room for the particles around a place.
    near: Vec<(usize, f32)>,
}

impl OfPart for Water {
    #[inline(never)]
    fn free(value: &mut Option<Box<Self>>) {
        drop(value.take());
    }
}

/// What is around droplets in a step.
struct Around<'a> {
    gas: &'a mut Gas,
    grid: &'a Grid,
    kernel: &'a Kernel,
    bounds: &'a Bounds,
    solids: &'a mut Solids,
    fuels: Option<&'a mut Fuels>,
    has_floor: bool,
    values: &'a Physics,
    dt: f32,
    /// The particles around a place, and the weight of each.
    near: &'a mut Vec<(usize, f32)>,
}

impl Combustion {
    /// Moves, heats and evaporates all water for `dt`, after the gas and the solids have moved.
    #[inline(never)]
    pub(super) fn advance_water(&mut self, scene: &Scene, random: &mut Random, dt: f32) {
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
        *self.water = Some(water);
    }

    /// The droplets in the air.
    pub fn droplets(&self) -> &[Droplets] {
        self.water.as_ref().map_or(&[], |water| &water.parcels)
    }

    /// Where all water is.
    pub fn sprayed(&self) -> Sprayed {
        self.water
            .as_ref()
            .map_or_else(Sprayed::default, |water| water.sprayed())
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
