//! What droplets and the gas around them exchange: momentum, heat and vapour.
//!
//! ```text
//! dv/dt = g − (v − u)/τ,   τ = ρ_w d²/(18 μ (1 + 0.15 Re^0.687))          Schiller & Naumann 1933
//! q = π d λ Nu (T − T_w) ln(1 + B)/B,   Nu = 2 + 0.6 Re^½ Pr^⅓             Ranz & Marshall 1952
//! B = c_p (T − T_w)/L                                                     Spalding 1953
//! ```
//!
//! The heat warms a droplet to its boiling point, then evaporates it, so its d² falls evenly (the
//! d²-law). Each particle of the gas takes part by its share of kernel and volume; its loss is implicit,
//! so it does not become colder than the droplet, and is what the droplet gains: what rounding leaves of
//! it, the next particle loses. Vapour displaces the same
//! mass of gas, with its oxygen.

use glam::Vec2;

use super::around::Around;
use super::report::Droplets;
use super::report::SprayTotals;
use crate::combustion::fuels::{BOILING, VAPORISATION, WATER_CAPACITY};
use crate::combustion::reaction::chemistry::HEAT_CAPACITY;
use crate::extremes::{fast_max, fast_min};
use crate::instance::{EmberParticle, Instance};

/// Density of water [kg/m³].
const WATER_DENSITY: f32 = 1000.0;
/// Viscosity [kg/(m·s)] and conductivity [kW/(m·K)] of air of 293 K, which grow as T^¾.
const AIR_VISCOSITY: f32 = 1.81e-5;
const AIR_CONDUCTIVITY: f32 = 2.57e-5;
const REFERENCE_TEMPERATURE: f32 = 293.0;
/// 0.6 Pr^⅓ with Pr = 0.7.
const NUSSELT_FACTOR: f32 = 0.533;
/// Share of the mass at first below which a parcel is gone.
const MIN_MASS_SHARE: f32 = 1e-3;

/// Sums over the gas around a place, by kernel and volume.
#[derive(Default)]
struct Sums {
    weight: f32,
    square: f32,
    velocity: Vec2,
    temperature: f32,
    /// Of the gas hotter than the droplets, how much hotter.
    hotter: f32,
}

/// Drags, heats and evaporates a parcel. Returns the vapour [kg/m].
pub(super) fn exchange(
    parcel: &mut Droplets,
    around: &mut Around,
    account: &mut SprayTotals,
    rounding: &mut f32,
) -> f32 {
    around.find_near(parcel.position);
    let Around {
        gas,
        values,
        dt,
        near,
        ..
    } = around;
    let (dt, own) = (*dt, parcel.temperature);
    let mut sums = Sums::default();
    for &(j, weight) in near.iter() {
        let kelvin = gas.state[j].x;
        sums.weight += weight;
        sums.square += weight * weight;
        sums.velocity += gas.velocity[j] * weight;
        sums.temperature += kelvin * weight;
        sums.hotter += fast_max(kelvin - own, 0.0) * weight;
    }
    let is_in_gas = sums.weight > 0.0;
    let per_weight = if is_in_gas { 1.0 / sums.weight } else { 0.0 };
    let (flow, kelvin) = if is_in_gas {
        (sums.velocity * per_weight, sums.temperature * per_weight)
    } else {
        (Vec2::new(values.wind, 0.0), values.ambient_temperature)
    };

    let hot = fast_max(kelvin / REFERENCE_TEMPERATURE, 0.1).sqrt();
    let hotter = hot * hot.sqrt();
    let density = values.ambient_density * values.ambient_temperature / fast_max(kelvin, 1.0);
    let viscosity = AIR_VISCOSITY * hotter;
    let d = parcel.diameter;
    let reynolds = (parcel.velocity - flow).length() * d * density / viscosity;
    let drag = 1.0 + 0.15 * libm::expf(0.687 * libm::logf(fast_max(reynolds, 1e-6)));
    let share = dt * 18.0 * viscosity * drag / (WATER_DENSITY * d * d);
    // The gas that a parcel moves, so that the exchange is implicit in both velocities.
    let moved = parcel.mass * sums.square * per_weight * per_weight / gas.mass;
    let falling = parcel.velocity - Vec2::new(0.0, values.gravity * dt);
    let impulse = (falling - flow) * (share / (1.0 + share * (1.0 + moved)));
    parcel.velocity = falling - impulse;
    if !is_in_gas {
        return 0.0;
    }

    let nusselt = 2.0 + NUSSELT_FACTOR * reynolds.sqrt();
    let transfer = HEAT_CAPACITY * fast_max(kelvin - own, 0.0) / VAPORISATION;
    let blowing = if transfer > 1e-3 {
        libm::logf(1.0 + transfer) / transfer
    } else {
        1.0
    };
    let conductance =
        nusselt * AIR_CONDUCTIVITY * hotter * blowing * 6.0 * parcel.mass / (WATER_DENSITY * d * d);
    // No more heat than evaporates all of it.
    let most = parcel.mass * (WATER_CAPACITY * (BOILING - own) + VAPORISATION);
    let available = fast_max(sums.hotter * per_weight, 1e-6);
    let flows = fast_min(conductance * dt, most / available);
    let capacity = gas.mass * HEAT_CAPACITY;
    let boils = own >= BOILING;
    let mut heat = 0.0;
    let pushed = impulse * (parcel.mass / gas.mass);
    for &(j, weight) in near.iter() {
        let weight = weight * per_weight;
        gas.velocity[j] += pushed * weight;
        let state = &mut gas.state[j];
        let exchanged = flows * weight / capacity;
        let before = state.x;
        let lost = (before - own) * (exchanged / (1.0 + exchanged));
        // Few droplets take less than the last digit of a temperature.
        let due = lost + *rounding;
        state.x = before - due;
        *rounding = due - (before - state.x);
        heat += f64::from(lost);
        if boils {
            let vapour = fast_max(lost, 0.0) * (HEAT_CAPACITY / VAPORISATION);
            state.z *= 1.0 - fast_min(vapour, 1.0);
        }
    }
    let heat = heat * f64::from(capacity);
    account.heat += heat;
    let vapour = parcel.warm(heat as f32);
    account.evaporated += f64::from(vapour);
    if parcel.mass < MIN_MASS_SHARE * parcel.first {
        account.evaporated += f64::from(parcel.mass);
        parcel.mass = 0.0;
    }
    vapour
}

impl Around<'_> {
    /// Finds the particles of the gas around a place that no thin solid separates from it, and the weight of
    /// each by kernel and volume.
    fn find_near(&mut self, at: Vec2) {
        let support = self.kernel.support();
        let (gas, kernel, near) = (&*self.gas, self.kernel, &mut self.near);
        let beside = self.solids.beside(at, support);
        near.clear();
        self.grid.candidates(at, &mut |run, shift| {
            let last = run.end.min(gas.len());
            for j in run.start..last {
                let place = gas.position[j] + shift;
                let weight = kernel.value(at.distance(place)) * gas.volume[j];
                if weight > 0.0 && !beside.separate(at, place, support) {
                    near.push((j, weight));
                }
            }
        });
    }

    /// Velocity and temperature of the gas at a place; `None` without any.
    pub(super) fn gas_at(&mut self, at: Vec2) -> Option<(Vec2, f32)> {
        self.find_near(at);
        let (mut weights, mut velocity, mut temperature) = (0.0, Vec2::ZERO, 0.0);
        for &(j, weight) in &self.near {
            weights += weight;
            velocity += self.gas.velocity[j] * weight;
            temperature += self.gas.state[j].x * weight;
        }
        (weights > 0.0).then(|| (velocity / weights, temperature / weights))
    }
}

impl Droplets {
    /// Warms them by this heat [kJ/m], and evaporates them at their boiling point. Returns the vapour
    /// [kg/m].
    fn warm(&mut self, heat: f32) -> f32 {
        self.temperature += heat / (self.mass * WATER_CAPACITY);
        if self.temperature <= BOILING {
            return 0.0;
        }
        let above = (self.temperature - BOILING) * self.mass * WATER_CAPACITY;
        let vapour = fast_min(above / VAPORISATION, self.mass);
        self.temperature = BOILING;
        let left = (self.mass - vapour) / self.mass;
        self.mass -= vapour;
        self.diameter *= libm::expf(libm::logf(fast_max(left, 1e-6)) / 3.0);
        vapour
    }

    /// Their instance: a streak, the fainter the finer they are.
    pub(super) fn instance(&self, height: f32) -> Instance {
        let coarse = fast_min(self.diameter / OPAQUE_DIAMETER, 1.0);
        EmberParticle {
            position: self.position,
            velocity: self.velocity,
            temperature: -1.0,
            size: STREAK_WIDTH * height,
            age: MAX_OPACITY * coarse,
            life: 1.0,
        }
        .into()
    }
}

/// Width of a streak in heights of the domain, the diameter from which it is drawn in full \[m\], and its
/// opacity then.
const STREAK_WIDTH: f32 = 0.006;
const OPAQUE_DIAMETER: f32 = 0.7e-3;
const MAX_OPACITY: f32 = 0.9;
