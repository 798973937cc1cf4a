//! A cell of a solid that burns, in a step: heat, water, pyrolysis and char.
//!
//! With the conductance g of the gas beside a cell, its exposed length l and its heat capacity C:
//!
//! ```text
//! C dT/dt = Σ g (T_gas − T) + q_radiation + q_char + Σ k (T_beside − T) − ε σ l (T⁴ − T_air⁴)
//!           − L_water dw/dt − L_fuel dm/dt
//! dw/dt: all of the heat above 373 K      dm/dt = m (T − T_pyrolysis)/(30 K s)
//! dc/dt = 0.375 · 0.232 Σ (g/c_p) O η,    η = κ/(κ + Σ g/c_p),   κ = l 254 e^(−9000 K/T)/0.375
//! ```
//!
//! The exchange with the gas is implicit in T, and the gas loses what the cell gains.

use super::cells::{Account, Cell};
use super::material::{BOILING, CHAR_HEAT, Material, VAPORISATION, WATER_CAPACITY};
use super::state::AdjacentGas;
use crate::combustion::reaction::chemistry::HEAT_CAPACITY;
use crate::extremes::{fast_max, fast_min};

/// Emissivity of a surface times the constant of Stefan and Boltzmann [kW/(m²·K⁴)].
const SURFACE_EMISSION: f32 = 0.9 * 5.670_374e-11;
/// How much hotter than its pyrolysis temperature fuel is that falls to a share of 1/e in a
/// second \[K\]: little, so that the supply of heat limits it.
pub(super) const PYROLYSIS: f32 = 30.0;
/// Share of the heat above the pyrolysis temperature that a step may use.
const MAX_HEAT_SHARE: f32 = 0.5;
/// Share of the fuel of a cell below which all of it is given off.
const MIN_FUEL_SHARE: f32 = 0.02;
/// Oxygen in air, by mass.
const OXYGEN_IN_AIR: f32 = 0.232;
/// Carbon that a mass of oxygen burns.
const CARBON_PER_OXYGEN: f32 = 0.375;
/// Rate of the reaction of char with oxygen [kg/(m²·s)], and its activation temperature \[K\]
/// (Evans & Emmons 1977).
const CHAR_RATE: f32 = 254.0;
const CHAR_ACTIVATION: f32 = 9000.0;
/// Change of a temperature in a step from which its radiation is computed again \[K\], and how often.
const RADIATION_REFRESH: f32 = 50.0;
const MAX_REFRESHES: u32 = 6;

/// What all cells have in common in a step.
pub(super) struct Step {
    pub(super) dt: f32,
    /// Temperature of the air \[K\].
    pub(super) air: f32,
    /// Share of the pyrolysis that the particles have room for.
    pub(super) throttle: f32,
    /// Heat of combustion of the fuel of the gas [kJ/kg].
    pub(super) gas_heat: f32,
    /// Oxygen that burns a mass of that fuel, relative to that of air, and the temperature from which
    /// it burns \[K\].
    pub(super) demand: f32,
    pub(super) ignition: f32,
    /// Fuel that waits at a cell at most [kg/m].
    pub(super) most_waiting: f32,
}

/// What has left a cell: heat [kJ/m], and power of gas and char [kW/m].
#[derive(Default)]
pub(super) struct Left {
    pub(super) carried: f32,
    pub(super) gas: f32,
    pub(super) heat: f32,
}

impl Cell {
    /// Burns the gas that waits here with the oxygen that comes to the surface. Returns the power
    /// [kW/m], which heats the cell.
    pub(super) fn burn_film(
        &mut self,
        beside: &mut AdjacentGas,
        material: &Material,
        account: &mut Account,
        step: &Step,
    ) -> f32 {
        let flow = beside.oxygen / HEAT_CAPACITY / step.demand;
        let hot = fast_max(
            self.temperature,
            beside.heat / fast_max(beside.conductance, 1e-9),
        );
        if self.waiting <= 0.0 || flow <= 0.0 || hot < step.ignition {
            return 0.0;
        }
        beside.burnt = fast_min(self.waiting / (step.dt * flow), 1.0);
        let fuel = fast_min(step.dt * flow, self.waiting);
        self.waiting -= fuel;
        let heat = fuel * step.gas_heat;
        beside.flame = heat;
        account.gas += f64::from(heat / material.gas_heat());
        account.gained += f64::from(heat);
        account.flames += f64::from(heat);
        heat / step.dt
    }

    /// Its radiation to air of a temperature, as a conductance [kW/(m·K)].
    pub(super) fn radiated(&self, air: f32) -> f32 {
        self.radiated_at(self.temperature, air)
    }

    fn radiated_at(&self, now: f32, air: f32) -> f32 {
        SURFACE_EMISSION * self.length * (now * now + air * air) * (now + air)
    }

    /// Exchanges heat, and burns char. Returns its power [kW/m].
    pub(super) fn warm(
        &mut self,
        beside: &mut AdjacentGas,
        material: &Material,
        account: &mut Account,
        step: &Step,
    ) -> f32 {
        let (dt, air, now) = (step.dt, step.air, self.temperature);
        let capacity = self.capacity(material);
        // The reaction of char, as fast as oxygen comes and reacts.
        let carbon = self.carbon(material);
        let flow = beside.conductance / HEAT_CAPACITY;
        let (mut burnt, mut used) = (0.0, 0.0);
        if carbon > 0.0 && flow > 0.0 {
            let reaction =
                self.length * CHAR_RATE / CARBON_PER_OXYGEN * libm::expf(-CHAR_ACTIVATION / now);
            let bare = carbon / (carbon + self.fuel);
            used = reaction / (reaction + flow) * bare * (1.0 - beside.burnt);
            burnt = dt * CARBON_PER_OXYGEN * OXYGEN_IN_AIR * beside.oxygen / HEAT_CAPACITY * used;
            if burnt > carbon {
                used *= carbon / burnt;
                burnt = carbon;
            }
        }
        beside.burnt += used;
        let from_char = burnt * CHAR_HEAT;
        let balance = |radiated: f32| {
            let inflow =
                dt * (beside.heat + self.received + radiated * air) + from_char + beside.flame;
            let outflow = dt * (beside.conductance + radiated);
            (capacity * now + inflow) / (capacity + outflow)
        };
        let (mut at, mut radiated) = (now, self.radiated(air));
        let mut next = balance(radiated);
        // The rest of a cell is so light that its radiation grows within the step. Radiation alone
        // gives a temperature as the inverse cube of the one that it is computed at.
        for _ in 0..MAX_REFRESHES {
            if (next - at).abs() < RADIATION_REFRESH {
                break;
            }
            at = (at * next).sqrt() * at;
            at = at.sqrt();
            radiated = self.radiated_at(at, air);
            next = balance(radiated);
        }
        beside.temperature = next;
        self.temperature = next;
        self.char -= burnt;
        // What burns takes its heat with it.
        let carried = burnt * material.capacity * (next - air);
        beside.carried += carried;
        let exchanged = f64::from(dt * (beside.heat - beside.conductance * next));
        account.exchanged += exchanged - f64::from(carried);
        account.gained += exchanged + f64::from(dt * self.received + from_char);
        account.lost += f64::from(dt * radiated * (next - air) + carried);
        account.oxidised += f64::from(burnt);
        from_char / dt
    }

    /// Dries, and gives off gas.
    pub(super) fn give_off(
        &mut self,
        material: &Material,
        account: &mut Account,
        step: &Step,
    ) -> Left {
        let mut left = Left::default();
        if self.temperature > BOILING && self.water > 0.0 {
            let heat = self.capacity(material) * (self.temperature - BOILING);
            let steam = fast_min(heat / VAPORISATION, self.water);
            self.water -= steam;
            left.carried += steam * WATER_CAPACITY * (self.temperature - step.air);
            self.temperature -= steam * VAPORISATION / self.capacity(material);
            account.steam += f64::from(steam);
            account.lost += f64::from(steam * VAPORISATION);
        }
        let above = self.temperature - material.pyrolysis;
        if above > 0.0 && self.fuel > 0.0 {
            let share = step.dt * step.throttle * above / PYROLYSIS;
            let heat = MAX_HEAT_SHARE * above * self.capacity(material);
            let gas = 1.0 - material.char;
            let mut lost = self.fuel * share / (1.0 + share);
            lost = fast_min(lost, heat / (gas * material.gasification));
            if self.fuel < MIN_FUEL_SHARE * self.first {
                lost = self.fuel;
            }
            self.fuel -= lost;
            self.char += material.char * lost;
            let gas = gas * lost;
            left.carried += gas * material.capacity * (self.temperature - step.air);
            self.temperature -= gas * material.gasification / self.capacity(material);
            self.temperature = fast_max(self.temperature, step.air);
            left.heat = gas * material.gas_heat();
            left.gas = left.heat / step.gas_heat;
            account.lost += f64::from(gas * material.gasification);
        }
        account.lost += f64::from(left.carried);
        account.exchanged -= f64::from(left.carried);
        left
    }
}
