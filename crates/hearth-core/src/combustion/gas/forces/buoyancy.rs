//! Buoyancy: b g (1 − Tₐ/T) θ, which for the ideal gas is b g (T/Tₐ − 1), the weight of
//! the displaced air less that of the gas.

use glam::Vec2;

use crate::forces::{BodyForce, LocalGas};
use crate::params::{Edges, Physics};

/// Buoyancy of hot gas in the air of the domain.
pub(super) struct Buoyancy {
    /// Temperature of the air \[K\].
    air: f32,
    /// b g [m/s²].
    strength: f32,
}

impl Buoyancy {
    /// `None` in a closed domain without a seam, where nothing would stop rising gas.
    pub fn new(values: &Physics) -> Option<Buoyancy> {
        (values.edges == Edges::Open || values.seam != 0.0).then_some(Buoyancy {
            air: values.ambient_temperature,
            strength: values.buoyancy * values.gravity,
        })
    }
}

impl BodyForce for Buoyancy {
    #[inline]
    fn acceleration(&self, gas: &LocalGas) -> Vec2 {
        let lift = self.strength * (1.0 - self.air / gas.temperature) * gas.expansion;
        Vec2::new(0.0, lift)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::with;

    fn lift(values: &[(&str, f64)], temperature: f32, expansion: f32) -> Option<f32> {
        let gas = LocalGas {
            position: Vec2::ZERO,
            velocity: Vec2::ZERO,
            temperature,
            expansion,
        };
        Some(Buoyancy::new(&with(values))?.acceleration(&gas).y)
    }

    #[test]
    fn ideal_gas_four_times_as_hot_rises_with_three_times_gravity() {
        let found = lift(&[], 4.0 * 293.0, 4.0);
        assert!(found.is_some_and(|lift| (lift / (3.0 * 9.81) - 1.0).abs() < 1e-5));
        assert_eq!(lift(&[], 293.0, 1.0), Some(0.0));
        assert_eq!(lift(&[("gravity", 0.0)], 1500.0, 4.0), Some(0.0));
        assert_eq!(lift(&[("seam", 0.0)], 1500.0, 4.0), None);
    }
}
