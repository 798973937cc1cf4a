//! A step of the solids that burn.
//!
//! [`reaction`](super::reaction) has the equations of a cell. The gas loses what the cells gain.

use glam::Vec2;

use super::cells::{Burning, NONE};
use super::reaction::{PYROLYSIS, Step};
use super::state::{AdjacentGas, Fuels, NOTHING, Touch};
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
const GOLDEN_RATIO: f64 = 0.618_033_988_749_895;
/// Conductivity of char by radiation across its cracks of 1 cm, 16/3 σ d, over the cube of the
/// temperature [kW/(m·K⁴)] (Kung 1972).
const CRACK_CONDUCTIVITY: f32 = 16.0 / 3.0 * 5.670_374e-11 * 1e-2;
/// Fuel in a particle beyond which it takes no more.
const MAX_GAS_FUEL: f32 = 0.95;
/// Fuel that waits at a cell beyond which it gives off no more, in particles.
const MAX_WAITING: f32 = 2.0;
/// Height of a flame over its power, in m/(kW/m)^⅔, and its width over its height.
const FLAME_HEIGHT_FACTOR: f32 = 0.035;
const FLAME_WIDTH: f32 = 0.5;
/// Time over which the power is averaged \[s\].
const POWER_AVERAGING_TIME: f32 = 0.3;

/// The largest power of a flame that the particles have room for [kW/m].
fn max_power(values: &Physics) -> f32 {
    let spacing = values.spacing();
    let area = values.capacity() as f32 * spacing * spacing;
    let height = (area / FLAME_WIDTH).sqrt() / FLAME_HEIGHT_FACTOR;
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
            most_waiting: MAX_WAITING * gas.mass,
        };
        let mut power = 0.0;
        self.film = 0.0;
        for burning in &mut self.all {
            burning.pilot(dt);
            burning.conduct(dt);
            self.film += burning.react(&mut self.beside[burning.first_beside..], &step);
            power += burning.account.power;
        }
        self.power = power;
        self.give(gas, near, dt);
        for burning in &mut self.all {
            burning.settle(&self.beside[burning.first_beside..], step.gas_heat);
        }
    }

    /// Finds the gas beside each cell.
    fn meet(&mut self, gas: &Gas, near: &[Near], solids: &Solids, values: &Physics) {
        let h = values.smoothing_length();
        let eddy = values.eddy_viscosity * values.eddy_viscosity * h;
        self.beside.fill(AdjacentGas::default());
        self.touches.clear();
        for near in near {
            let mut touch = Touch {
                place: NOTHING,
                conductance: 0.0,
            };
            let i = near.index as usize;
            // Different for neighbours, so that together they touch all cells.
            let chosen = (gas.id[i] as f64 * GOLDEN_RATIO).fract() as f32;
            if let Some((place, velocity)) = self.place_of(near, solids, chosen) {
                let beside = &mut self.beside[place];
                let mixed = eddy * (gas.velocity[i] - velocity).length();
                let rate = 2.0 * (values.diffusion + mixed) * near.friction;
                touch = Touch {
                    place: place as u32,
                    conductance: rate * gas.mass * HEAT_CAPACITY,
                };
                beside.weight += near.slope;
                beside.heat += near.slope * gas.state[i].x;
            }
            self.touches.push(touch);
        }
        for burning in &self.all {
            let beside = &mut self.beside[burning.first_beside..];
            let side = fast_min(burning.side.x, burning.side.y);
            for (cell, beside) in burning.cells.iter().zip(beside) {
                if beside.weight > 0.0 {
                    let difference = beside.heat / beside.weight - cell.temperature;
                    let slope = difference.abs() / side;
                    let convection = CONVECTION * slope.sqrt().sqrt();
                    beside.convection = convection * cell.length / beside.weight;
                }
                beside.heat = 0.0;
            }
        }
        for (near, touch) in near.iter().zip(&mut self.touches) {
            if touch.place != NOTHING {
                let beside = &mut self.beside[touch.place as usize];
                let convection = beside.convection * near.slope;
                touch.conductance = fast_max(touch.conductance, convection);
                let [kelvin, _, oxygen, _] = gas.state[near.index as usize].to_array();
                beside.conductance += touch.conductance;
                beside.heat += touch.conductance * kelvin;
                beside.oxygen += touch.conductance * oxygen;
            }
        }
    }

    /// The place in `beside` of the cell that gas near a wall touches, and the velocity there.
    fn place_of(&self, near: &Near, solids: &Solids, chosen: f32) -> Option<(usize, Vec2)> {
        // The floor is no solid.
        let body = solids.bodies.get(near.solid as usize)?;
        if !body.burns {
            return None;
        }
        let burning = self.all.iter().find(|burning| burning.id == body.id())?;
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
        for (near, touch) in near.iter().zip(&self.touches) {
            if touch.place == NOTHING {
                continue;
            }
            let beside = &mut self.beside[touch.place as usize];
            let i = near.index as usize;
            let share = near.slope / fast_max(beside.weight, 1e-12);
            let [kelvin, fuel, oxygen, _] = gas.state[i].to_array();
            let change = &mut gas.change[i];
            change.x += touch.conductance * (beside.temperature - kelvin) / capacity;
            change.x += share * beside.carried / (capacity * dt);
            let room = fast_max(MAX_GAS_FUEL - (fuel + change.y * dt), 0.0);
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
            if (index + 1) % self.columns != 0 {
                self.conduct_between(index, index + 1, aspect * dt);
            }
            if index + self.columns < self.cells.len() {
                self.conduct_between(index, index + self.columns, dt / aspect);
            }
        }
    }

    /// Conducts heat between a cell and a later one.
    fn conduct_between(&mut self, index: usize, later: usize, share: f32) {
        let material = self.material;
        let (before, from_later) = self.cells.split_at_mut(later);
        let (cell, neighbour) = (&mut before[index], &mut from_later[0]);
        if cell.mass() <= 0.0 || neighbour.mass() <= 0.0 {
            return;
        }
        // Radiation crosses the pores and cracks of char.
        let mean = 0.5 * (cell.temperature + neighbour.temperature);
        let porous = 0.5 * (cell.charred() + neighbour.charred());
        let radiant = CRACK_CONDUCTIVITY * mean * mean * mean * porous;
        let conductance = share * (material.conductivity + radiant);
        let (here, there) = (
            1.0 / cell.capacity(material),
            1.0 / neighbour.capacity(material),
        );
        let difference = neighbour.temperature - cell.temperature;
        let heat = conductance * difference / (1.0 + conductance * (here + there));
        cell.temperature += heat * here;
        neighbour.temperature -= heat * there;
    }

    /// Heats and burns each cell. Returns the power of the flames in the film [kW/m].
    fn react(&mut self, beside: &mut [AdjacentGas], step: &Step) -> f32 {
        let (mut power, mut gas_power, mut film) = (0.0, 0.0, 0.0);
        let (mut oxygen, mut conductance) = (0.0, 0.0);
        for index in 0..self.cells.len() {
            let cell = &mut self.cells[index];
            if cell.mass() <= 0.0 {
                continue;
            }
            let here = &mut beside[index];
            film += cell.burn_film(here, self.material, &mut self.account, step);
            power += cell.warm(here, self.material, &mut self.account, step);
            here.fuel = cell.waiting;
            oxygen += here.oxygen;
            conductance += here.conductance;
            if cell.vent == NONE {
                continue;
            }
            let vent = usize::from(cell.vent);
            let is_open = beside[vent].weight > 0.0;
            if !is_open || self.cells[vent].waiting > step.most_waiting {
                continue;
            }
            let left = self.cells[index].give_off(self.material, &mut self.account, step);
            gas_power += left.heat / step.dt;
            beside[vent].carried += left.carried;
            self.cells[vent].waiting += left.gas;
        }
        self.account.oxygen = if conductance > 0.0 {
            oxygen / conductance
        } else {
            1.0
        };
        let share = fast_min(step.dt / POWER_AVERAGING_TIME, 1.0);
        self.account.power += (power + gas_power - self.account.power) * share;
        film
    }

    /// Accounts for the gas that the particles have taken.
    fn settle(&mut self, beside: &[AdjacentGas], gas_heat: f32) {
        let mut taken = 0.0;
        for (cell, beside) in self.cells.iter_mut().zip(beside) {
            cell.waiting = fast_max(cell.waiting - beside.taken, 0.0);
            taken += f64::from(beside.taken);
        }
        self.account.gas += taken * f64::from(gas_heat / self.material.gas_heat());
    }
}
