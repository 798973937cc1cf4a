//! The heat of a solid that conducts it: one temperature throughout. It gains what the gas beside
//! it loses, and radiates.

use crate::extremes::fast_max;
use crate::params::Solid;
use crate::scene::Surface;

/// Emissivity of a surface times the constant of Stefan and Boltzmann [kW/(m²·K⁴)].
const RADIATION_COEFFICIENT: f32 = 0.9 * 5.670_374e-11;

/// What flows to a solid in a step: conductance [kW/K] from gas, and its product with the
/// temperature of the gas.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Inflow {
    conductance: f32,
    heat: f32,
}

impl Inflow {
    /// Adds gas of a temperature \[K\] at a conductance [kW/K].
    pub fn add(&mut self, conductance: f32, temperature: f32) {
        self.conductance += conductance;
        self.heat += conductance * temperature;
    }

    /// Adds what flows to another part of the same solid.
    pub fn join(&mut self, other: Inflow) {
        self.conductance += other.conductance;
        self.heat += other.heat;
    }
}

/// The heat of a solid, per metre of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Store {
    /// The temperature that the scene gives it \[K\].
    pub first: f32,
    /// Heat capacity [kJ/K].
    capacity: f32,
    /// Circumference \[m\].
    circumference: f32,
    /// What flows in during the present step.
    pub inflow: Inflow,
}

crate::state! { Inflow: conductance heat, Store: first capacity circumference inflow }

impl Store {
    pub fn of(solid: &Solid, surface: &Surface) -> Store {
        let (area, circumference) = surface.measures();
        Store {
            first: solid.temperature,
            // Finite for a solid without any area, such as an empty mask.
            capacity: fast_max(solid.heat_capacity * area, 1e-6),
            circumference,
            inflow: Inflow::default(),
        }
    }

    /// Heat that it stores above a temperature [kJ/m].
    pub fn heat_above(&self, temperature: f32, base: f32) -> f32 {
        self.capacity * (temperature - base)
    }

    /// The temperature \[K\] after it has lost that heat [kJ/m].
    pub fn cooled(&self, temperature: f32, heat: f32) -> f32 {
        temperature - heat / self.capacity
    }

    /// The temperature \[K\] after a step with that inflow in air of a temperature \[K\].
    pub fn warmed(&self, temperature: f32, inflow: Inflow, dt: f32, air: f32) -> f32 {
        // ε σ A (T⁴ − T_air⁴), as a conductance.
        let radiated = RADIATION_COEFFICIENT
            * self.circumference
            * (temperature * temperature + air * air)
            * (temperature + air);
        let share = dt / self.capacity;
        // Implicit, so that a light solid does not overshoot.
        (temperature + share * (inflow.heat + radiated * air))
            / (1.0 + share * (inflow.conductance + radiated))
    }
}
