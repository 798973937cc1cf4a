//! The burner: a block of gas, three spacings high, into which fuel flows.
//!
//! Its input is its power, so it burns alike at every resolution: the fuel of a step is spread
//! over the gas in the block, and what exceeds the capacity of that gas over the gas above.
//! Perlin noise modulates the fuel in space and time (the paper's §5.3) and keeps the sum.

use glam::Vec2;

use super::chemistry::{HEAT_CAPACITY, heat_of_combustion};
use super::gas::Gas;
use crate::extremes::{fast_max, fast_min};
use crate::noise::perlin;
use crate::params::{Edges, Floor, Parameters, Physics};
use crate::source;

/// Height of the block, in spacings of the particles.
const ROWS: f32 = 3.0;
/// Rate at which gas in the block relaxes to the emission velocity [1/s].
const VELOCITY_RELAXATION: f32 = 400.0;
/// Minimum width of the block, in spacings: a burner between two particles would heat
/// neither.
const MIN_WIDTH: f32 = 4.0;
/// A pilot flame: gas in the block is hotter than the ignition temperature by this factor.
const PILOT_FACTOR: f32 = 1.02;
/// Lattice cells of the emission noise across the burner.
const NOISE_CELLS: f32 = 5.0;
/// Lattice cells of the emission noise per second.
const NOISE_PER_SECOND: f64 = 3.0;

/// The block of the burner in the combustion model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Burner {
    /// Horizontal position of its middle; 0 is the middle of the domain \[m\].
    pub middle: f32,
    /// Half of its width \[m\].
    pub half_width: f32,
    /// Height of its lower edge \[m\].
    pub bottom: f32,
    /// Height of its upper edge \[m\].
    pub top: f32,
    /// Its edges \[m\]. A particle on an edge is outside, also on the edge of the domain.
    left: f32,
    right: f32,
    /// Direction of its width if it is turned about the middle of its lower edge.
    axis: Option<Vec2>,
    /// Highest top of a layer above the block that takes excess fuel \[m\].
    highest: f32,
}

impl Burner {
    /// The burner of these parameters, clamped to the frame, between the seams of periodic
    /// edges, and to a minimum width.
    pub fn of(parameters: &Parameters) -> Burner {
        Burner::at(parameters, parameters.spacing())
    }

    /// The burner of these values; `None` without power.
    pub(crate) fn new(values: &Physics, spacing: f32) -> Option<Burner> {
        (values.fuel_power > 0.0).then(|| Burner::at(values, spacing))
    }

    fn at(values: &Physics, spacing: f32) -> Burner {
        let height = ROWS * spacing;
        let seam = match values.edges {
            Edges::Periodic => values.seam,
            Edges::Open => 0.0,
        };
        let (low, high) = (seam, 1.0 - seam);
        let highest = (high * values.domain_height - height).max(0.0);
        let lowest = (low * values.domain_height).min(highest);
        let bottom = values.source_height.max(lowest).min(highest);
        let width = values
            .source_width
            .max(MIN_WIDTH * spacing)
            .min(values.domain_width);
        let (half_width, edge) = (0.5 * width, 0.5 * values.domain_width);
        let middle = source::middle(values, width, seam * values.domain_width);
        Burner {
            middle,
            half_width,
            left: (middle - half_width).max(-edge),
            right: (middle + half_width).min(edge),
            bottom,
            top: bottom + height,
            axis: source::axis(values),
            highest: high * values.domain_height,
        }
    }

    /// Lower left and upper right corner of a rectangle around it \[m\].
    pub(crate) fn around(&self) -> [Vec2; 2] {
        let base = Vec2::new(self.middle, self.bottom);
        let height = self.top - self.bottom;
        let Some(axis) = self.axis else {
            return [
                base - Vec2::new(self.half_width, 0.0),
                base + Vec2::new(self.half_width, height),
            ];
        };
        let side = axis.abs() * self.half_width;
        let up = axis.perp() * height;
        [
            base - side + up.min(Vec2::ZERO),
            base + side + up.max(Vec2::ZERO),
        ]
    }

    /// A position as if the burner were not turned.
    fn upright(&self, position: Vec2) -> Vec2 {
        let Some(axis) = self.axis else {
            return position;
        };
        let base = Vec2::new(self.middle, self.bottom);
        let from = position - base;
        base + Vec2::new(axis.dot(from), axis.perp_dot(from))
    }

    /// Adds fuel to the gas in the block for `dt`. Returns the heat that brought the gas to the
    /// temperature of the source [kJ/m], which is not part of the power.
    pub(crate) fn feed(&self, gas: &mut Gas, values: &Physics, time: f64, dt: f32) -> f32 {
        let heat = self.condition(gas, values, dt);
        let mut left = values.fuel_power / heat_of_combustion(values) * dt;
        let height = self.top - self.bottom;
        let mut above = 0.0;
        while left > 0.0 && self.top + above <= self.highest {
            left = self.add_fuel(gas, values, time, above, left);
            above += height;
        }
        heat
    }

    /// Sets the temperature, oxygen and velocity of the gas in the block. Returns the heat
    /// [kJ/m].
    fn condition(&self, gas: &mut Gas, values: &Physics, dt: f32) -> f32 {
        // A floor supplies no gas, so a burner on it must not drag the gas along.
        let on_floor = values.floor == Floor::Solid && self.bottom < self.top - self.bottom;
        let relaxation = if on_floor && values.edges == Edges::Open {
            0.0
        } else {
            (VELOCITY_RELAXATION * dt).min(1.0)
        };
        let hot = values
            .source_temperature
            .max(PILOT_FACTOR * values.ignition_temperature);
        let emitted = self.axis.map_or(Vec2::Y, Vec2::perp) * values.emission_speed;
        let mut heated = 0.0;
        for i in 0..gas.len() {
            if self.contains(gas, i, 0.0) {
                let state = &mut gas.state[i];
                heated += fast_max(hot - state.x, 0.0);
                state.x = fast_max(state.x, hot);
                // Air enters the block from below, unlike a real burner. The gas of the source
                // displaces it.
                state.z = fast_min(state.z, values.source_oxygen);
                let velocity = &mut gas.velocity[i];
                *velocity += (emitted - *velocity) * relaxation;
            }
        }
        heated * gas.mass * HEAT_CAPACITY
    }

    /// Spreads `fuel` [kg/m] over the layer `above` the block, and returns the excess over
    /// pure fuel.
    fn add_fuel(&self, gas: &mut Gas, values: &Physics, time: f64, above: f32, fuel: f32) -> f32 {
        let share = |x: f32| {
            let across = (x - self.middle) / self.half_width * (0.5 * NOISE_CELLS);
            let noise = perlin(values.seed, across, time * NOISE_PER_SECOND);
            1.0 + values.emission_noise * noise
        };
        let mut shares = 0.0;
        for i in 0..gas.len() {
            if self.contains(gas, i, above) {
                shares += share(self.upright(gas.position[i]).x);
            }
        }
        if shares <= 0.0 {
            return fuel;
        }
        let each = fuel / (gas.mass * shares);
        let mut left = 0.0;
        for i in 0..gas.len() {
            if self.contains(gas, i, above) {
                let fuelled = gas.state[i].y + each * share(self.upright(gas.position[i]).x);
                gas.state[i].y = fuelled.min(1.0);
                left += (fuelled - 1.0).max(0.0) * gas.mass;
            }
        }
        left
    }

    fn contains(&self, gas: &Gas, i: usize, above: f32) -> bool {
        let at = self.upright(gas.position[i]);
        let height = at.y - above;
        at.x > self.left && at.x < self.right && height > self.bottom && height < self.top
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::with;
    use crate::random::Random;

    fn fed(parameters: &Parameters, seconds: f32) -> Option<Gas> {
        let spacing = parameters.spacing();
        let mut gas = Gas::air(parameters, spacing, &mut Random::new(1));
        Burner::new(parameters, spacing)?.feed(&mut gas, parameters, 0.4, seconds);
        Some(gas)
    }

    #[test]
    fn its_power_is_exact_at_any_width_resolution_and_noise() {
        for (n, width, noise) in [
            (1000.0, 0.4, 0.0),
            (12_000.0, 0.4, 1.0),
            (3000.0, 1.0, 0.5),
            (3000.0, 0.01, 0.2),
        ] {
            let parameters = with(&[
                ("max_particles", n),
                ("source_width", width),
                ("emission_noise", noise),
            ]);
            let seconds = 1e-3;
            let gas = fed(&parameters, seconds).expect("a burner");
            let fuel: f32 = gas.state.iter().map(|state| state.y * gas.mass).sum();
            let power = fuel * heat_of_combustion(&parameters) / seconds;
            assert!(
                (power / parameters.fuel_power - 1.0).abs() < 1e-3,
                "{power} at {n}, {width}, {noise}"
            );
        }
    }

    #[test]
    fn it_may_be_turned_and_keeps_its_power() {
        for angle in [-180.0, -90.0, -37.0, 15.0, 90.0, 140.0] {
            let parameters = with(&[
                ("max_particles", 12_000.0),
                ("source_height", 0.8),
                ("source_angle", angle),
            ]);
            let seconds = 1e-3;
            let gas = fed(&parameters, seconds).expect("a burner");
            let fuel = |i: usize| gas.state[i].y * gas.mass;
            let all: f32 = (0..gas.len()).map(fuel).sum();
            let power = all * heat_of_combustion(&parameters) / seconds;
            assert!(
                (power / parameters.fuel_power - 1.0).abs() < 1e-3,
                "{power} at {angle}°"
            );
            // It lies on the side to which it emits, within its height of three spacings.
            let out = Vec2::from_angle((angle as f32).to_radians()).perp();
            let burner = Burner::of(&parameters);
            let [low, high] = burner.around();
            for i in (0..gas.len()).filter(|&i| fuel(i) > 0.0) {
                let at = gas.position[i];
                let depth = (at - Vec2::new(burner.middle, burner.bottom)).dot(out);
                assert!(
                    (0.0..3.01 * parameters.spacing()).contains(&depth),
                    "{depth}"
                );
                assert!(at.cmpge(low - 1e-4).all() && at.cmple(high + 1e-4).all());
                let speed = gas.velocity[i].dot(out);
                assert!(speed > 0.3 * parameters.emission_speed, "{speed} m/s");
            }
        }
    }

    #[test]
    fn its_noise_moves_with_it() {
        // The fuel by the distance from the middle of the burner.
        let fuel = |x: f64| {
            let values = [("source_x", x), ("emission_noise", 1.0)];
            let parameters = with(&[&values[..], &[("max_particles", 50_000.0)]].concat());
            let gas = fed(&parameters, 1e-3).expect("a burner");
            let middle = Burner::of(&parameters).middle;
            assert!((f64::from(middle) - x).abs() < 1e-6);
            let mut parts = [(0.0_f32, 0.0_f32); 10];
            for (position, state) in gas.position.iter().zip(&gas.state) {
                let across = (position.x - middle) / parameters.source_width + 0.5;
                if state.y > 0.0 {
                    let (sum, n) = &mut parts[(across * 10.0) as usize];
                    *sum += state.y;
                    *n += 1.0;
                }
            }
            parts.map(|(sum, n)| sum / n)
        };
        let there = fuel(0.0);
        for x in [-0.25, 0.3] {
            for (here, there) in fuel(x).into_iter().zip(there) {
                assert!((here / there - 1.0).abs() < 0.1, "{here}, {there} at {x}");
            }
        }
    }

    #[test]
    fn without_power_there_is_no_burner() {
        assert!(fed(&with(&[("fuel_power", 0.0)]), 1e-3).is_none());
    }

    #[test]
    fn its_gas_is_above_the_ignition_temperature() {
        let parameters = with(&[
            ("source_temperature", 500.0),
            ("ignition_temperature", 900.0),
        ]);
        let gas = fed(&parameters, 1e-3).expect("a burner");
        assert!(
            gas.state
                .iter()
                .any(|state| state.x > parameters.ignition_temperature)
        );
    }

    #[test]
    fn it_stays_between_the_seams() {
        for (height, seam) in [(0.0, 0.2), (1.0, 0.2), (1.0, 0.0)] {
            let parameters = with(&[
                ("source_height", height),
                ("seam", seam),
                ("domain_height", 0.5),
            ]);
            let burner = Burner::new(&parameters, parameters.spacing()).expect("a burner");
            let thickness = parameters.seam * parameters.domain_height;
            assert!(burner.bottom >= thickness - 1e-6);
            assert!(burner.top <= parameters.domain_height - thickness + 1e-6);
        }
    }

    #[test]
    fn excess_fuel_goes_to_the_gas_above() {
        // In a quarter of a second, far more fuel than the capacity of the block.
        for n in [1000.0, 3000.0, 20_000.0] {
            let parameters = with(&[
                ("fuel_power", 600.0),
                ("source_width", 0.1),
                ("emission_noise", 0.0),
                ("max_particles", n),
            ]);
            let gas = fed(&parameters, 0.25).expect("a burner");
            let fuel: f32 = gas.state.iter().map(|state| state.y * gas.mass).sum();
            let expected = 600.0 / heat_of_combustion(&parameters) * 0.25;
            assert!((fuel / expected - 1.0).abs() < 1e-3, "{fuel} of {expected}");
            assert!(gas.state.iter().all(|state| state.y <= 1.0));
        }
    }

    #[test]
    fn its_gas_has_the_oxygen_of_the_parameter() {
        for oxygen in [0.0, 0.4, 1.0] {
            let gas = fed(&with(&[("source_oxygen", oxygen)]), 1e-3).expect("a burner");
            let inside = gas.state.iter().filter(|state| state.y > 0.0);
            let max = inside.map(|state| state.z).fold(0.0, f32::max);
            assert!((f64::from(max) - oxygen).abs() < 1e-6);
        }
    }
}
