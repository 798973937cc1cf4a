//! Solids that conduct heat: each has one temperature throughout. It gains what the gas beside it
//! loses, and radiates.

use super::{Body, Solids};
use crate::extremes::fast_max;
use crate::params::Solid;
use crate::scene::Surface;

/// Emissivity of a surface times the constant of Stefan and Boltzmann [kW/(m²·K⁴)].
const RADIATED: f32 = 0.9 * 5.670_374e-11;
/// The heat of a body that conducts it, per metre of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Store {
    /// The temperature that the scene gives it \[K\].
    first: f32,
    /// Heat capacity [kJ/K].
    capacity: f32,
    /// Circumference \[m\].
    circumference: f32,
    /// What flows in during a step: conductance [kW/K] to gas, and its product with the
    /// temperature of the gas.
    conductance: f32,
    inflow: f32,
}

impl Store {
    pub(super) fn of(solid: &Solid, surface: &Surface) -> Store {
        let (area, circumference) = surface.measures();
        Store {
            first: solid.temperature,
            // Finite for a solid without any area, such as an empty mask.
            capacity: fast_max(solid.heat_capacity * area, 1e-6),
            circumference,
            conductance: 0.0,
            inflow: 0.0,
        }
    }
}

impl Body {
    /// Notes that gas of a temperature \[K\] exchanges heat with it at that conductance [kW/K].
    #[inline]
    pub fn exchange(&mut self, conductance: f32, temperature: f32) {
        if let Some(store) = &mut self.store {
            store.conductance += conductance;
            store.inflow += conductance * temperature;
        }
    }

    /// What stores its heat, and its temperature \[K\], if it conducts heat.
    fn heated(&self) -> Option<(Store, f32)> {
        Some((self.store?, self.temperature?))
    }

    /// Keeps the temperature of the same solid before a change, unless the scene gives it another.
    pub(super) fn keep_temperature(&mut self, before: &Body) {
        if let (Some((now, _)), Some((then, temperature))) = (self.heated(), before.heated())
            && now.first == then.first
        {
            self.temperature = Some(temperature);
        }
    }
}

impl Solids {
    /// Heats the bodies that conduct heat by what came in a step. Around them is air of that
    /// temperature \[K\].
    pub fn warm(&mut self, dt: f32, air: f32) {
        for body in 0..self.bodies.len() {
            self.heat(body, dt, air);
        }
    }

    /// Heats a body and its images, which follow it, by what came in a step.
    fn heat(&mut self, first: usize, dt: f32, air: f32) {
        let Some((mut store, mut temperature)) = self.bodies[first].heated() else {
            return;
        };
        let id = self.bodies[first].id;
        if first > 0 && self.bodies[first - 1].id == id {
            return;
        }
        let images = self.bodies[first..].iter_mut();
        let images = images.take_while(|body| body.id == id);
        (store.conductance, store.inflow) = (0.0, 0.0);
        for part in images.filter_map(|body| body.store.as_mut()) {
            store.conductance += part.conductance;
            store.inflow += part.inflow;
            (part.conductance, part.inflow) = (0.0, 0.0);
        }
        // ε σ A (T⁴ − T_air⁴), as a conductance.
        let radiated = RADIATED
            * store.circumference
            * (temperature * temperature + air * air)
            * (temperature + air);
        let share = dt / store.capacity;
        // Implicit, so that a light body does not overshoot.
        temperature = (temperature + share * (store.inflow + radiated * air))
            / (1.0 + share * (store.conductance + radiated));
        for body in self.bodies[first..]
            .iter_mut()
            .take_while(|body| body.id == id)
        {
            body.temperature = Some(temperature);
        }
    }

    /// The ids of the bodies that conduct heat, and their temperatures \[K\].
    pub fn temperatures(&self) -> impl Iterator<Item = (u32, f32)> {
        let mut before = None;
        let conducting = self.bodies.iter().filter_map(|body| {
            let (_, temperature) = body.heated()?;
            Some((body.id, temperature))
        });
        conducting.filter(move |(id, _)| before.replace(*id) != Some(*id))
    }
}
