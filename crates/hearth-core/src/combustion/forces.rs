//! What the particles of the gas do to each other: pressure, viscosity, and the
//! exchange of heat, fuel, oxygen and soot.
//!
//! Hot gas takes more room. Each particle is weighted by y = m θ, θ = (T/Tₐ)^ε,
//! and Y = Σ yⱼ Wᵢⱼ says how full a place is, whatever mixture fills it. So the
//! volume V = y/Y and the pressure p = c₀² (Y − Ȳ) run smoothly across the edge of
//! a flame, where a plain p(ρ, T) would act as a false surface tension
//! (density-independent SPH: Saitoh & Makino, ApJ 768, 2013). ε = 1 is the ideal
//! gas (the paper's equation 8), ε = 0 the paper's own equation of state. Ȳ is the
//! mean over the particles: hot gas in a closed domain raises the pressure everywhere,
//! which moves nothing, but its noise damps every instability. Pressure below the mean
//! pulls particles into crowds, which shifting dissolves; so there is no gas
//! without any shifting.
//!
//! ```text
//! m aᵢ = − Σ Vᵢ Vⱼ (pᵢ + pⱼ) ∇W
//!        + Σ 2 Vᵢ Vⱼ ρ̄ (ν + ν_t) vᵢⱼ (r·∇W)/(r² + 0.01 h²)        Morris et al. 1997
//!        + Σ Vᵢ Vⱼ ρ̄ α c₀ μᵢⱼ ∇W   where particles approach         Monaghan 1992
//! m φ̇ᵢ = Σ 2 Vᵢ Vⱼ ρ̄ (D₀ + ν_t/Pr) φᵢⱼ (r·∇W)/(r² + 0.01 h²)      Cleary & Monaghan 1999
//! ```
//!
//! with the harmonic mean ρ̄ = 2 m/(Vᵢ + Vⱼ), the eddy viscosity ν_t = C_s² h |vᵢⱼ|,
//! and φ for temperature, fuel, oxygen and soot. Whatever i gains j loses.

use glam::{Vec2, Vec4};

use super::gas::{Gas, State};
use crate::extremes::smaller;
use crate::grid::Grid;
use crate::kernel::Kernel;
use crate::neighbours::Neighbours;
use crate::params::Values;

/// Prandtl and Schmidt number of the eddies: how much better they mix momentum
/// than heat and matter.
const PRANDTL: f32 = 0.7;

/// Excess over the air below which the expansion is as good as linear.
const SLIGHT: f32 = 2e-3;

/// θ = (T/Tₐ)^ε.
pub(crate) fn expansion(temperature: f32, values: &Values) -> f32 {
    let ratio = temperature / values.ambient_temperature;
    let excess = ratio - 1.0;
    // Most of the domain is air, and a power takes as long as ten pairs.
    if excess.abs() < SLIGHT {
        1.0 + values.gas_expansion * excess
    } else {
        libm::powf(ratio, values.gas_expansion)
    }
}

/// What a pair needs to know of a particle, side by side in memory.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
struct Parcel {
    state: State,
    velocity: Vec2,
    volume: f32,
    pressure: f32,
}

/// The passes over pairs, and their memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct Forces {
    pub neighbours: Neighbours,
    shares: Vec<f32>,
    parcels: Vec<Parcel>,
    curl: Vec<f32>,
    ascent: Vec<Vec2>,
}

impl Forces {
    /// Finds all pairs of a sorted grid; fills in how full every place is,
    /// and from it volume and pressure.
    pub fn fill(
        &mut self,
        gas: &mut Gas,
        grid: &Grid,
        kernel: &Kernel,
        values: &Values,
        sound: f32,
    ) {
        self.shares.clear();
        self.shares.extend(
            gas.state
                .iter()
                .map(|state| gas.mass * expansion(state.x, values)),
        );
        let shares = &self.shares;
        self.neighbours
            .find(&gas.position, grid, kernel, shares, &mut gas.filling);
        let sum: f64 = gas.filling.iter().copied().map(f64::from).sum();
        let mean = (sum / gas.len().max(1) as f64) as f32;
        for (i, &filling) in gas.filling.iter().enumerate() {
            gas.volume[i] = shares[i] / filling;
            gas.pressure[i] = sound * sound * (filling - mean);
        }
    }

    /// Sums acceleration, exchange and crowding over the pairs.
    pub fn exchange(&mut self, gas: &mut Gas, kernel: &Kernel, values: &Values, sound: f32) {
        self.parcels.clear();
        self.parcels.extend((0..gas.len()).map(|i| Parcel {
            state: gas.state[i],
            velocity: gas.velocity[i],
            volume: gas.volume[i],
            pressure: gas.pressure[i],
        }));
        gas.acceleration.fill(Vec2::ZERO);
        gas.change.fill(Vec4::ZERO);
        gas.crowding.fill(Vec2::ZERO);

        let h = kernel.smoothing_length();
        let softening = 0.01 * h * h;
        let eddy = values.eddy_viscosity * values.eddy_viscosity * h;
        let artificial = values.artificial_viscosity * sound * h;
        let parcels = &self.parcels[..];
        let mass = gas.mass;
        let acceleration = &mut gas.acceleration[..];
        let change = &mut gas.change[..];
        let crowding = &mut gas.crowding[..];
        for (i, pairs) in self.neighbours.iter() {
            let here = parcels[i];
            let mut push = Vec2::ZERO;
            let mut gain = Vec4::ZERO;
            let mut crowd = Vec2::ZERO;
            for pair in pairs {
                let j = pair.j as usize;
                let there = parcels[j];
                let slope = pair.offset * pair.gradient;
                let distance_squared = pair.offset.length_squared();
                let inverse = 1.0 / (distance_squared + softening);
                let apart = here.velocity - there.velocity;

                // Vᵢ Vⱼ ρ̄/m, both ways.
                let volumes = here.volume * there.volume;
                let common = 2.0 * volumes / (here.volume + there.volume);
                let stirred = eddy * apart.length();
                let laplacian = 2.0 * common * pair.gradient * distance_squared * inverse;
                let approach = smaller(apart.dot(pair.offset), 0.0) * inverse;

                let pressure = -volumes * (here.pressure + there.pressure) / mass;
                let force = slope * (pressure + common * artificial * approach)
                    + apart * (laplacian * (values.kinematic_viscosity + stirred));
                let flux = (here.state - there.state)
                    * (laplacian * (values.diffusion + stirred * (1.0 / PRANDTL)));

                push += force;
                gain += flux;
                crowd += slope * there.volume;
                acceleration[j] -= force;
                change[j] -= flux;
                crowding[j] -= slope * here.volume;
            }
            acceleration[i] += push;
            change[i] += gain;
            crowding[i] += crowd;
        }
    }

    /// Adds vorticity confinement: a push around every vortex that gives back
    /// the rotation that a coarse simulation loses (Fedkiw, Stam, Jensen,
    /// SIGGRAPH 2001), a = ε h (∇|ω|/|∇|ω|| × ω).
    pub fn confine(&mut self, gas: &mut Gas, kernel: &Kernel, strength: f32) {
        if strength == 0.0 {
            return;
        }
        let Forces {
            neighbours,
            parcels,
            curl,
            ascent,
            ..
        } = self;
        curl.clear();
        curl.resize(gas.len(), 0.0);
        ascent.clear();
        ascent.resize(gas.len(), Vec2::ZERO);
        for (i, pairs) in neighbours.iter() {
            for pair in pairs {
                let j = pair.j as usize;
                let apart = parcels[i].velocity - parcels[j].velocity;
                let turn = (pair.offset * pair.gradient).perp_dot(apart);
                curl[i] -= parcels[j].volume * turn;
                curl[j] -= parcels[i].volume * turn;
            }
        }
        for (i, pairs) in neighbours.iter() {
            for pair in pairs {
                let j = pair.j as usize;
                let more = pair.offset * pair.gradient * (curl[j].abs() - curl[i].abs());
                ascent[i] += more * parcels[j].volume;
                ascent[j] += more * parcels[i].volume;
            }
        }
        let strength = strength * kernel.smoothing_length();
        for (i, a) in gas.acceleration.iter_mut().enumerate() {
            let towards = ascent[i].normalize_or_zero();
            *a += Vec2::new(towards.y, -towards.x) * (curl[i] * strength);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::bounds;
    use crate::combustion::gas::tests::{wild, with};
    use crate::params::Parameters;

    /// The gas with its forces summed, and what summed them.
    fn summed(parameters: &Parameters, seed: u32) -> (Gas, Forces, Kernel) {
        let mut gas = wild(parameters, seed);
        let kernel = Kernel::new(parameters.smoothing_length());
        let (mut grid, mut forces) = (Grid::default(), Forces::default());
        gas.reorder(grid.sort(&gas.position, &bounds(parameters), kernel.support()));
        forces.fill(&mut gas, &grid, &kernel, parameters, 6.0);
        forces.exchange(&mut gas, &kernel, parameters, 6.0);
        (gas, forces, kernel)
    }

    #[test]
    fn what_one_gains_another_loses() {
        for seed in 0..3 {
            let parameters = with(&[("max_particles", 1500.0), ("gas_expansion", 1.0)]);
            let (gas, ..) = summed(&parameters, seed);
            let net: Vec2 = gas.acceleration.iter().sum();
            let all: f32 = gas.acceleration.iter().map(|a| a.length()).sum();
            assert!(net.length() < 1e-5 * all, "{net} of {all}");
            let net: Vec4 = gas.change.iter().sum();
            let all: Vec4 = gas.change.iter().map(|c| c.abs()).sum();
            assert!((net.abs() / all).max_element() < 1e-5, "{net} of {all}");
        }
    }

    #[test]
    fn viscosity_of_each_kind_takes_energy() {
        for id in [
            "kinematic_viscosity",
            "eddy_viscosity",
            "artificial_viscosity",
        ] {
            let work = |value: f64| {
                let parameters = with(&[
                    ("max_particles", 1500.0),
                    ("kinematic_viscosity", 0.0),
                    ("eddy_viscosity", 0.0),
                    ("artificial_viscosity", 0.02),
                    (id, value),
                ]);
                let (gas, ..) = summed(&parameters, 5);
                let pairs = gas.velocity.iter().zip(&gas.acceleration);
                pairs.map(|(v, a)| f64::from(v.dot(*a))).sum::<f64>()
            };
            let lowest = if id == "artificial_viscosity" {
                0.02
            } else {
                0.0
            };
            assert!(
                work(if id == "kinematic_viscosity" {
                    0.01
                } else {
                    0.4
                }) < work(lowest) - 1.0,
                "{id}"
            );
        }
    }

    #[test]
    fn hot_gas_takes_the_room_that_its_expansion_says() {
        for (expansion, expected) in [(0.0, 1.0), (0.5, 2.0), (1.0, 4.0)] {
            let parameters = with(&[("gas_expansion", expansion)]);
            let hot = 4.0 * parameters.ambient_temperature;
            assert!((super::expansion(hot, &parameters) - expected).abs() < 1e-5);
            // No step where the power takes over from the line.
            let edge = parameters.ambient_temperature * (1.0 + SLIGHT);
            let step = super::expansion(edge * 1.0001, &parameters)
                - super::expansion(edge * 0.9999, &parameters);
            assert!(step.abs() < 3e-4, "{step}");
        }
    }

    #[test]
    fn the_particles_fill_the_domain_whatever_they_are_made_of() {
        let parameters = with(&[("max_particles", 1500.0)]);
        let (gas, ..) = summed(&parameters, 7);
        let filled: f32 = gas.volume.iter().sum();
        let domain = parameters.domain_width * parameters.domain_height;
        assert!((filled / domain - 1.0).abs() < 0.03, "{filled} of {domain}");
    }

    #[test]
    fn confinement_turns_vortices_and_leaves_still_air_alone() {
        let parameters = with(&[("max_particles", 1500.0)]);
        let (mut gas, mut forces, kernel) = summed(&parameters, 9);
        let before = gas.acceleration.clone();
        forces.confine(&mut gas, &kernel, 0.0);
        assert_eq!(gas.acceleration, before);
        forces.confine(&mut gas, &kernel, 0.5);
        assert_ne!(gas.acceleration, before);

        for velocity in &mut gas.velocity {
            *velocity = Vec2::new(0.7, -0.2);
        }
        forces.exchange(&mut gas, &kernel, &parameters, 6.0);
        let before = gas.acceleration.clone();
        forces.confine(&mut gas, &kernel, 0.5);
        assert_eq!(gas.acceleration, before);
    }
}
