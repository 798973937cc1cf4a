//! What the gas fills: open air, or a closed domain that is periodic in both directions.

use glam::Vec2;

use super::gas::resample::{self, Discretisation, Old};
use super::gas::{Gas, periodic_bounds, seam};
use super::open_air::{self, OpenAir, Seen};
use crate::bounds::Bounds;
use crate::instance::Instance;
use crate::params::Physics;
use crate::random::Random;
use crate::scene::Scene;
use crate::solids::Solids;

/// The place of [`Measured::number`](crate::instance::Measured::number) in an instance.
const NUMBER: usize = 6;

/// The rectangle that holds the gas of a fire with these values and this discretisation, whatever is
/// seen.
pub(crate) fn bounds(values: &Physics, discretisation: Discretisation) -> Bounds {
    match discretisation {
        Discretisation::Open { spacing } => open_air::layout(values, None, spacing).bounds(),
        Discretisation::Periodic { .. } => periodic_bounds(values),
    }
}

/// The domain of the gas.
#[derive(Clone, Debug)]
pub(super) struct Domain {
    /// The edges of open air; `None` in a closed domain.
    open: Option<Box<OpenAir>>,
    /// The part of the world that is seen.
    seen: Option<Seen>,
    /// The discretisation of the present particles.
    pub discretisation: Discretisation,
    /// Temperature of the air in the gas \[K\].
    air_temperature: f32,
}

crate::state! { Domain: open seen discretisation air_temperature }

impl Domain {
    /// The domain of these values, with nothing seen beyond the domain.
    pub fn new(values: &Physics) -> Domain {
        Domain {
            open: OpenAir::new(values, None),
            seen: None,
            discretisation: Discretisation::of(values),
            air_temperature: values.ambient_temperature,
        }
    }

    /// Air at rest, or in the wind, for the start of a fire.
    pub fn air(&mut self, scene: &Scene, solids: &Solids, random: &mut Random) -> Gas {
        let values = scene.world();
        match &mut self.open {
            None => Gas::air(values, values.spacing(), random),
            Some(open) => open.air(scene, solids),
        }
    }

    /// The edges of open air; `None` in a closed domain.
    pub fn open_mut(&mut self) -> Option<&mut OpenAir> {
        self.open.as_deref_mut()
    }

    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// The rectangle that the gas may reach.
    pub fn bounds(&self, values: &Physics) -> Bounds {
        let open = self.open.as_ref();
        open.map_or_else(|| periodic_bounds(values), |open| open.bounds())
    }

    /// Whether there is a floor at y = 0.
    pub fn has_floor(&self) -> bool {
        self.open.as_ref().is_some_and(|open| open.has_floor())
    }

    /// Share of the open air around the fire that sleeps.
    pub fn asleep(&self) -> Option<f32> {
        self.open.as_ref().map(|open| open.asleep())
    }

    /// Sets which part of the world is seen.
    pub fn set_visible_area(
        &mut self,
        seen: Option<Seen>,
        gas: &Gas,
        scene: &Scene,
        solids: &Solids,
    ) {
        self.seen = seen;
        self.fit_open_air(gas, scene, solids);
    }

    /// Replaces the map of open air if the values, or what is seen, need another.
    fn fit_open_air(&mut self, gas: &Gas, scene: &Scene, solids: &Solids) {
        let values = scene.world();
        let fits = |open: &OpenAir| open.fits(values, self.seen);
        if self.open.as_deref().is_some_and(fits) {
            return;
        }
        let old = std::mem::replace(&mut self.open, OpenAir::new(values, self.seen));
        if let Some(open) = &mut self.open {
            match old {
                Some(old) if open.has_cells_of(&old) => open.continue_from(&old),
                Some(_) => open.surround(gas, values),
                None => open.adopt(gas, scene, solids),
            }
        }
    }

    /// Fills the rest of open air around gas that a caller gives.
    pub fn surround(&mut self, gas: &Gas, values: &Physics) {
        if let Some(open) = &mut self.open {
            open.surround(gas, values);
        }
    }

    /// Gives the gas the temperature of the air, the edges and the spacing of changed values. Returns
    /// whether it has other particles.
    pub fn adapt(
        &mut self,
        gas: &mut Gas,
        scene: &Scene,
        solids: &Solids,
        random: &mut Random,
    ) -> bool {
        let parameters = scene.world();
        // A new air temperature changes all gas at once; otherwise all of the old air would rise
        // or sink.
        let warmer = parameters.ambient_temperature - self.air_temperature;
        if warmer != 0.0 {
            gas.add_temperature(warmer);
            self.air_temperature = parameters.ambient_temperature;
        }
        let discretisation = Discretisation::of(parameters);
        let resampled = discretisation != self.discretisation;
        if resampled {
            self.open = None;
        }
        self.fit_open_air(gas, scene, solids);
        if resampled {
            let old = Old::new((gas, solids), &self.discretisation, parameters, self.seen);
            *gas = match &self.open {
                None => resample::resample(&old, parameters, random),
                Some(open) => resample::resample_open(&old, parameters, open),
            };
            self.discretisation = discretisation;
        }
        gas.set_mass(parameters);
        resampled
    }

    /// Removes the gas that has left open air, and inserts the air that enters, after a step of the
    /// length `dt`.
    pub fn exchange_gas(&mut self, gas: &mut Gas, scene: &Scene, solids: &Solids, dt: f32) {
        if let Some(open) = &mut self.open {
            open.exchange_gas(gas, scene, solids, dt);
        }
    }

    /// The number density at which the pressure is zero [kg/m³]: that of the air, in a closed domain the
    /// mean of the gas.
    pub fn reference_density(&self, mean: f32, values: &Physics) -> f32 {
        match self.open {
            None => mean,
            Some(_) => values.ambient_density,
        }
    }

    /// Finds the gas near the outside of open air.
    pub fn find_rim(&mut self, gas: &Gas) {
        if let Some(open) = &mut self.open {
            open.find_rim(gas);
        }
    }

    /// Weakens the pressure towards the outside of open air.
    pub fn taper_pressure(&self, gas: &mut Gas) {
        if let Some(open) = &self.open {
            open.taper_pressure(gas);
        }
    }

    /// Removes the outward part of the shifts near the outside of open air.
    pub fn remove_outward_shift(&self, gas: &mut Gas) {
        if let Some(open) = &self.open {
            open.remove_outward_shift(gas);
        }
    }

    /// Relaxes the velocity in the rim of open air towards its flow for `dt`.
    pub fn relax_rim_velocity(&self, gas: &mut Gas, dt: f32) {
        if let Some(open) = &self.open {
            open.relax_rim_velocity(gas, dt);
        }
    }

    /// Relaxes the gas in the seam of a closed domain to air for `dt`.
    pub fn relax_seam(&self, gas: &mut Gas, values: &Physics, dt: f32) {
        if self.open.is_none() {
            seam::relax_to_air(gas, values, values.spacing(), dt);
        }
    }

    /// Completes the volumes near the outside of open air, or moves gas that has crossed an edge of a
    /// closed domain to the opposite one.
    pub fn close(&self, gas: &mut Gas, values: &Physics) {
        match &self.open {
            Some(open) => open.complete_volumes(gas, values.ambient_density),
            None => self.wrap(gas, values),
        }
    }

    /// Moves gas beyond an edge of a closed domain to the opposite one.
    pub fn wrap(&self, gas: &mut Gas, values: &Physics) {
        if self.open.is_none() {
            let bounds = periodic_bounds(values);
            for position in &mut gas.position {
                *position = bounds.wrap(*position);
            }
        }
    }

    /// Widens the kernels of measured particles where open air ends.
    #[inline]
    pub fn widen(&self, measured: &mut [Instance]) {
        if let Some(open) = &self.open {
            for instance in measured {
                instance[NUMBER] = open.widening(Vec2::new(instance[0], instance[1]));
            }
        }
    }
}
