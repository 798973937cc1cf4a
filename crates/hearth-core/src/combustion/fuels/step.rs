//! A step of the solids that burn.
//!
//! [`reaction`](super::reaction) has the equations of a cell. The gas loses what the cells gain.

use glam::Vec2;

use super::cells::{Burning, NONE};
use super::reaction::{PYROLYSIS, Step};
use super::state::{Beside, Fuels, Touch};
use crate::combustion::gas::Gas;
use crate::combustion::gas::walls::Near;
use crate::combustion::reaction::chemistry::{HEAT_CAPACITY, heat_of_combustion};
use crate::extremes::{fast_max, fast_min};
use crate::params::Physics;
use crate::solids::Solids;

/// Heat transfer coefficient over the fourth root of the difference in temperature by length, of
/// laminar free convection at a vertical wall (McAdams 1954): h = 1.42 (ΔT/L)^¼ W/(m²·K), with the
/// side of a cell as the length. It is a lower limit: particles do not resolve the layer between the
/// flame and the surface.
const CONVECTION: f32 = 1.42e-3;
/// Turns by which numbers in a row are spread evenly.
const GOLDEN: f64 = 0.618_033_988_749_895;
/// Conductivity of char by radiation across its cracks of 1 cm, 16/3 σ d, over the cube of the
/// temperature [kW/(m·K⁴)] (Kung 1972).
const ACROSS: f32 = 16.0 / 3.0 * 5.670_374e-11 * 1e-2;
/// Fuel in a particle beyond which it takes no more.
const FULL: f32 = 0.95;
/// Fuel that waits at a cell beyond which it gives off no more, in particles.
const WAITING: f32 = 2.0;
/// Height of a flame over its power, in m/(kW/m)^⅔, and its width over its height.
const FLAME: f32 = 0.035;
const FLAME_WIDTH: f32 = 0.5;
/// Time over which the power is averaged \[s\].
const AVERAGE: f32 = 0.3;

/// The largest power of a flame that the particles have room for [kW/m].
fn max_power(values: &Physics) -> f32 {
    let spacing = values.spacing();
    let area = values.max_particles as f32 * spacing * spacing;
    let height = (area / FLAME_WIDTH).sqrt() / FLAME;
    height * height.sqrt()
}

impl Fuels {
    /// Heats, dries, pyrolyses and burns all solids for `dt`, and gives what they lose to the gas.
    pub(super) fn exchange(
        &mut self,
        gas: &mut Gas,
        near: &[Near],
        solids: &Solids,
        values: &Physics,
        dt: f32,
    ) {
        self.meet(gas, near, solids, values);
        let limit = max_power(values);
        let throttle = fast_min(limit / fast_max(self.wanted(), 1e-6), 1.0);
        let step = Step {
            dt,
            air: values.ambient_temperature,
            throttle,
            gas_heat: heat_of_combustion(values),
            demand: values.air_demand,
            ignition: values.ignition_temperature,
            most_waiting: WAITING * gas.mass,
        };
        let mut power = 0.0;
        self.film = 0.0;
        for burning in &mut self.all {
            let beside = self.beside.get_mut(burning.first_beside..);
            let beside = beside.unwrap_or_default();
            burning.pilot(dt);
            burning.conduct(dt);
            self.film += burning.react(beside, &step);
            power += burning.account.power;
        }
        self.power = power;
        self.give(gas, near, dt);
        for burning in &mut self.all {
            let beside = self.beside.get(burning.first_beside..).unwrap_or_default();
            burning.settle(beside, step.gas_heat);
        }
    }

    /// Finds the gas beside each cell.
    fn meet(&mut self, gas: &Gas, near: &[Near], solids: &Solids, values: &Physics) {
        let h = values.smoothing_length();
        let eddy = values.eddy_viscosity * values.eddy_viscosity * h;
        self.beside.fill(Beside::default());
        self.touches.clear();
        for one in near {
            let mut touch = Touch {
                place: u32::MAX,
                conductance: 0.0,
            };
            let i = one.index as usize;
            let id = gas.id.get(i).copied().unwrap_or_default();
            let of_gas = gas.velocity.get(i).copied().unwrap_or_default();
            let kelvin = gas.state.get(i).copied().unwrap_or_default().x;
            // Different for neighbours, so that together they meet all cells.
            let chosen = (id as f64 * GOLDEN).fract() as f32;
            if let Some((place, velocity)) = self.place_of(one, solids, chosen)
                && let Some(beside) = self.beside.get_mut(place)
            {
                let mixed = eddy * (of_gas - velocity).length();
                let rate = 2.0 * (values.diffusion + mixed) * one.friction;
                touch = Touch {
                    place: place as u32,
                    conductance: rate * gas.mass * HEAT_CAPACITY,
                };
                beside.weight += one.slope;
                beside.heat += one.slope * kelvin;
            }
            self.touches.push(touch);
        }
        for burning in &self.all {
            let beside = self.beside.get_mut(burning.first_beside..);
            let side = fast_min(burning.side.x, burning.side.y);
            for (cell, beside) in burning.cells.iter().zip(beside.unwrap_or_default()) {
                if beside.weight > 0.0 {
                    let difference = beside.heat / beside.weight - cell.temperature;
                    let slope = difference.abs() / side;
                    let convection = CONVECTION * slope.sqrt().sqrt();
                    beside.convection = convection * cell.length / beside.weight;
                }
                beside.heat = 0.0;
            }
        }
        for (one, touch) in near.iter().zip(&mut self.touches) {
            if let Some(beside) = self.beside.get_mut(touch.place as usize) {
                let convection = beside.convection * one.slope;
                touch.conductance = fast_max(touch.conductance, convection);
                let state = gas.state.get(one.index as usize).copied();
                let [kelvin, _, oxygen, _] = state.unwrap_or_default().to_array();
                beside.conductance += touch.conductance;
                beside.heat += touch.conductance * kelvin;
                beside.oxygen += touch.conductance * oxygen;
            }
        }
    }

    /// The place in `beside` of the cell that gas near a wall touches, and the velocity there.
    fn place_of(&self, near: &Near, solids: &Solids, chosen: f32) -> Option<(usize, Vec2)> {
        let body = solids.bodies.get(near.solid as usize)?;
        if !body.burns {
            return None;
        }
        let burning = self.all.iter().find(|one| one.id == body.id())?;
        let frame = &body.surface.frame;
        let surface = frame.local(near.from - near.normal * near.distance);
        let normal = Vec2::new(
            frame.axis.dot(near.normal),
            frame.axis.perp_dot(near.normal),
        );
        let index = burning.one_below(surface, normal, chosen)?;
        Some((burning.first_beside + index, body.velocity_at(near.from)))
    }

    /// The power of the gas that all solids would give off [kW/m].
    fn wanted(&self) -> f32 {
        let each = |burning: &Burning| {
            let rates = burning.cells.iter().map(|cell| {
                fast_max(cell.temperature - burning.material.pyrolysis, 0.0) * cell.fuel
            });
            rates.sum::<f32>() / PYROLYSIS * burning.material.gas_heat()
        };
        self.all.iter().map(each).sum()
    }

    /// Gives the gas beside each cell what the cell has lost.
    fn give(&mut self, gas: &mut Gas, near: &[Near], dt: f32) {
        let capacity = gas.mass * HEAT_CAPACITY;
        for (one, touch) in near.iter().zip(&self.touches) {
            let Some(beside) = self.beside.get_mut(touch.place as usize) else {
                continue;
            };
            let i = one.index as usize;
            let share = one.slope / fast_max(beside.weight, 1e-12);
            let (Some(state), Some(change)) = (gas.state.get(i), gas.change.get_mut(i)) else {
                continue;
            };
            let [kelvin, fuel, oxygen, _] = state.to_array();
            change.x += touch.conductance * (beside.temperature - kelvin) / capacity;
            change.x += share * beside.carried / (capacity * dt);
            let room = fast_max(FULL - (fuel + change.y * dt), 0.0);
            let added = fast_min(share * beside.fuel / gas.mass, room);
            change.y += added / dt;
            beside.taken += added * gas.mass;
            change.z -= touch.conductance / capacity * oxygen * beside.burnt;
        }
    }
}

impl Burning {
    /// Conducts heat between neighbouring cells.
    fn conduct(&mut self, dt: f32) {
        let aspect = self.side.y / self.side.x;
        for index in 0..self.cells.len() {
            if (index + 1) % self.columns.max(1) != 0 {
                self.conduct_between(index, index + 1, aspect * dt);
            }
            self.conduct_between(index, index + self.columns, dt / aspect);
        }
    }

    fn conduct_between(&mut self, index: usize, other: usize, share: f32) {
        let material = self.material;
        let Ok([one, other]) = self.cells.get_disjoint_mut([index, other]) else {
            return;
        };
        if one.mass() <= 0.0 || other.mass() <= 0.0 {
            return;
        }
        // Radiation crosses the pores and cracks of char.
        let mean = 0.5 * (one.temperature + other.temperature);
        let porous = 0.5 * (one.charred() + other.charred());
        let radiant = ACROSS * mean * mean * mean * porous;
        let conductance = share * (material.conductivity + radiant);
        let (here, there) = (1.0 / one.capacity(material), 1.0 / other.capacity(material));
        let difference = other.temperature - one.temperature;
        let heat = conductance * difference / (1.0 + conductance * (here + there));
        one.temperature += heat * here;
        other.temperature -= heat * there;
    }

    /// Heats and burns each cell. Returns the power of the flames in the film [kW/m].
    fn react(&mut self, beside: &mut [Beside], step: &Step) -> f32 {
        let (mut power, mut gas_power, mut film) = (0.0, 0.0, 0.0);
        let (mut oxygen, mut conductance) = (0.0, 0.0);
        for index in 0..self.cells.len() {
            let Some(cell) = self.cells.get_mut(index) else {
                continue;
            };
            if cell.mass() <= 0.0 {
                continue;
            }
            if let Some(here) = beside.get_mut(index) {
                film += cell.burn_film(here, self.material, &mut self.account, step);
                power += cell.warm(here, self.material, &mut self.account, step);
                here.fuel = cell.waiting;
                oxygen += here.oxygen;
                conductance += here.conductance;
            }
            let vent = usize::from(cell.vent);
            let waiting = match vent {
                _ if cell.vent == NONE => continue,
                _ if vent == index => cell.waiting,
                _ => self.cells.get(vent).map_or(0.0, |vent| vent.waiting),
            };
            let is_open = beside.get(vent).is_some_and(|vent| vent.weight > 0.0);
            if !is_open || waiting > step.most_waiting {
                continue;
            }
            let Some(cell) = self.cells.get_mut(index) else {
                continue;
            };
            let left = cell.give_off(self.material, &mut self.account, step);
            gas_power += left.heat / step.dt;
            if let Some(vent) = beside.get_mut(vent) {
                vent.carried += left.carried;
            }
            if let Some(vent) = self.cells.get_mut(vent) {
                vent.waiting += left.gas;
            }
        }
        self.account.oxygen = if conductance > 0.0 {
            oxygen / conductance
        } else {
            1.0
        };
        let share = fast_min(step.dt / AVERAGE, 1.0);
        self.account.power += (power + gas_power - self.account.power) * share;
        film
    }

    /// Accounts for the gas that the particles have taken.
    fn settle(&mut self, beside: &[Beside], gas_heat: f32) {
        let mut taken = 0.0;
        for (cell, beside) in self.cells.iter_mut().zip(beside) {
            cell.waiting = fast_max(cell.waiting - beside.taken, 0.0);
            taken += f64::from(beside.taken);
        }
        self.account.gas += taken * f64::from(gas_heat / self.material.gas_heat());
    }
}
