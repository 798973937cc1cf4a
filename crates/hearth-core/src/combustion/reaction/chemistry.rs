//! Combustion and radiation.
//!
//! One reaction, limited by its time scale, by fuel and by oxygen:
//!
//! ```text
//! burn = min(F, O/s, (T_max − T)/(ΔT (1 + s))) (1 − e^(−dt/τ))   where T > T_ign
//! F −= burn    O −= s burn    T += ΔT (1 + s) burn    S += (1 + s) burn
//! dT/dt = − K [(T/1500)⁴ − (Tₐ/1500)⁴]
//! dS/dt = − S/τ_s where it is hot, − S/τ_smoke where it is not
//! ```
//!
//! ΔT is the temperature rise of a stoichiometric mixture: its adiabatic flame temperature less
//! the temperature of the air. T_max is the temperature of the source plus ΔT: hotter gas would
//! dissociate as fast as it burns. Soot burns away where it glows; soot that leaves the flame is
//! smoke, which decays slowly.

use crate::combustion::gas::{Gas, State};
use crate::lanes::{LANES, Lanes, Real, transposed};
use crate::params::Physics;

/// Heat capacity of the gas [kJ/(kg·K)].
pub(crate) const HEAT_CAPACITY: f32 = 1.0;

/// Temperatures between which the decay of soot changes from that of smoke to that of a flame
/// \[K\].
const SOOT_BURNOUT: (f32, f32) = (850.0, 1150.0);

/// Heat of combustion of the fuel [kJ/kg], per kg of the mixture.
pub(crate) fn heat_of_combustion(values: &Physics) -> f32 {
    HEAT_CAPACITY * values.flame_rise * (1.0 + values.air_demand)
}

/// Rate at which gas of a temperature cools by radiation [K/s].
pub(crate) fn radiative_loss(kelvin: f32, values: &Physics) -> f32 {
    values.radiative_cooling * (radiated(kelvin) - radiated(values.ambient_temperature))
}

/// Integrates diffusion, combustion and radiation over `dt`; `source` is the temperature of the
/// hottest source \[K\]. Returns the power of the combustion [kW/m].
pub(crate) fn react(gas: &mut Gas, values: &Physics, source: f32, dt: f32) -> f32 {
    let demand = values.air_demand;
    let reacted = 1.0 - libm::expf(-dt / values.burn_time);
    let rise = values.flame_rise * (1.0 + demand);
    let air = values.ambient_temperature;
    let source = source.max(values.ignition_temperature);
    let equilibrium = source + values.flame_rise;
    let smoke_left = 1.0 / (1.0 + dt / values.smoke_life);
    let soot_left = 1.0 / (1.0 + dt / values.soot_life);
    let (cool, hot) = SOOT_BURNOUT;
    let from_air = radiated(air);
    let cooling = dt * values.radiative_cooling;
    let of_all = Lanes::splat;
    let mut burnt = 0.0_f64;

    // Four particles at once: the divisions of one after another take longer than a transpose.
    for first in (0..gas.len()).step_by(LANES) {
        let members = first..gas.len().min(first + LANES);
        let mut states = [Lanes::ZERO; LANES];
        for (state, i) in states.iter_mut().zip(members.clone()) {
            *state = Lanes::new((gas.state[i] + gas.change[i] * dt).to_array());
        }
        let [t, fuel, oxygen, soot] = transposed(states);
        let (fuel, oxygen) = (share(fuel), share(oxygen));
        let lacking = share((of_all(equilibrium) - t) / of_all(rise));
        let least = fuel.fast_min(oxygen / of_all(demand)).fast_min(lacking);
        let ignited = of_all(values.ignition_temperature).less_mask(t);
        let mut burn = (least * reacted).to_array();
        for ((lane, burn), i) in burn.iter_mut().enumerate().zip(members.clone()) {
            if ignited & (1 << lane) == 0 {
                *burn = 0.0;
            }
            burnt += f64::from(*burn);
            gas.burn[i] = *burn / dt;
        }
        let burn = Lanes::new(burn);

        let lost = (radiated(t) - from_air) * cooling;
        // Radiation does not cool below the temperature of the air in a long step.
        let cooled = (t - lost).fast_max(of_all(air).fast_min(t));
        let t = cooled + burn * rise;
        let glowing = share((t - cool) / of_all(hot - cool));
        let left = glowing * (soot_left - smoke_left) + smoke_left;
        let soot = soot.fast_max(Lanes::ZERO) + burn * (1.0 + demand);
        let states = transposed([t, fuel - burn, oxygen - burn * demand, soot * left]);
        for (state, i) in states.into_iter().zip(members) {
            gas.state[i] = State::from_array(state.to_array());
        }
    }
    let per_second = burnt / f64::from(dt) * f64::from(gas.mass * heat_of_combustion(values));
    per_second as f32
}

/// Numbers from 0 to 1.
#[inline(always)]
fn share(number: Lanes) -> Lanes {
    number.fast_max(Lanes::ZERO).fast_min(Lanes::splat(1.0))
}

/// (T/1500)⁴
#[inline(always)]
fn radiated<R: Real>(kelvin: R) -> R {
    let relative = kelvin * R::splat(1.0 / 1500.0);
    let square = relative * relative;
    square * square
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::with;
    use crate::params::Parameters;
    use crate::random::Random;

    /// The temperature of the source.
    const SOURCE: f32 = 700.0;

    /// Uniform gas, so that nothing diffuses.
    fn mixture(parameters: &Parameters, state: [f32; 4]) -> Gas {
        let mut gas = Gas::air(parameters, parameters.spacing(), &mut Random::new(1));
        gas.state.fill(State::from_array(state));
        gas
    }

    #[test]
    fn combustion_is_stoichiometric_and_conserves_energy() {
        let parameters = with(&[("radiative_cooling", 0.0), ("soot_life", 2.0)]);
        let mut gas = mixture(&parameters, [900.0, 0.3, 0.8, 0.0]);
        let power = react(&mut gas, &parameters, SOURCE, 0.01);
        let [t, fuel, oxygen, soot] = gas.state[0].to_array();
        let burnt = 0.3 - fuel;
        assert!(burnt > 0.01);
        let (demand, rise) = (parameters.air_demand, parameters.flame_rise);
        assert!(((0.8 - oxygen) / (demand * burnt) - 1.0).abs() < 1e-4);
        assert!(((t - 900.0) / (rise * (1.0 + demand) * burnt) - 1.0).abs() < 1e-3);
        assert!((soot / ((1.0 + demand) * burnt) - 1.0).abs() < 0.02);
        let mass = gas.mass * gas.len() as f32;
        let heat = mass * HEAT_CAPACITY * (t - 900.0);
        assert!((power * 0.01 / heat - 1.0).abs() < 1e-3);
    }

    #[test]
    fn cold_gas_fuel_alone_and_air_alone_do_not_burn() {
        let parameters = with(&[]);
        let cold = parameters.ignition_temperature - 1.0;
        for state in [
            [cold, 0.5, 0.5, 0.0],
            [1500.0, 1.0, 0.0, 0.0],
            [1500.0, 0.0, 1.0, 0.0],
        ] {
            let mut gas = mixture(&parameters, state);
            assert_eq!(react(&mut gas, &parameters, SOURCE, 0.01), 0.0, "{state:?}");
        }
    }

    #[test]
    fn a_mixture_without_losses_ends_at_its_flame_temperature() {
        let parameters = with(&[("radiative_cooling", 0.0)]);
        let demand = parameters.air_demand;
        let start = parameters.ignition_temperature + 1.0;
        let exact = [start, 1.0 / (1.0 + demand), demand / (1.0 + demand), 0.0];
        let mut gas = mixture(&parameters, exact);
        for _ in 0..3000 {
            react(&mut gas, &parameters, SOURCE, 1e-3);
        }
        let rise = gas.state[0].x - start;
        assert!((rise / parameters.flame_rise - 1.0).abs() < 0.01, "{rise}");
    }

    #[test]
    fn gas_radiates_down_to_the_air_and_the_hotter_the_faster() {
        let parameters = with(&[("radiative_cooling", 2000.0)]);
        let lost = |from: f32| {
            let mut gas = mixture(&parameters, [from, 0.0, 1.0, 0.0]);
            react(&mut gas, &parameters, SOURCE, 1e-3);
            from - gas.state[0].x
        };
        assert!(lost(2000.0) > 10.0 * lost(1000.0));
        assert_eq!(lost(parameters.ambient_temperature), 0.0);
        let mut gas = mixture(&parameters, [400.0, 0.0, 1.0, 0.0]);
        for _ in 0..1000 {
            react(&mut gas, &parameters, SOURCE, 1.0 / 60.0);
        }
        assert!(gas.state[0].x >= parameters.ambient_temperature);
    }

    #[test]
    fn soot_burns_away_in_the_flame_and_persists_as_smoke() {
        let parameters = with(&[("radiative_cooling", 0.0)]);
        let left = |temperature: f32| {
            let mut gas = mixture(&parameters, [temperature, 0.0, 1.0, 1.0]);
            for _ in 0..250 {
                react(&mut gas, &parameters, SOURCE, 1e-3);
            }
            f64::from(gas.state[0].w).ln()
        };
        let decay = |life: f32| -0.25 / f64::from(life);
        assert!((left(1500.0) / decay(parameters.soot_life) - 1.0).abs() < 0.01);
        assert!((left(400.0) / decay(parameters.smoke_life) - 1.0).abs() < 0.01);
    }
}
