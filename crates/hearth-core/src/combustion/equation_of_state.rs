//! How much room hot gas takes: θ = (T/Tₐ)^ε.
//!
//! ε = 1 is the ideal gas (the paper's equation 8), ε = 0 the paper's own equation of
//! state, in which only density makes pressure.

use crate::params::Physics;

/// Excess over the air below which the expansion is as good as linear.
const SLIGHT: f32 = 2e-3;

/// θ, the volume of a unit of mass in that of the surrounding air.
pub(super) fn expansion(temperature: f32, values: &Physics) -> f32 {
    let ratio = temperature / values.ambient_temperature;
    let excess = ratio - 1.0;
    // Most of the domain is air, and a power takes as long as ten pairs.
    if excess.abs() < SLIGHT {
        1.0 + values.gas_expansion * excess
    } else if values.gas_expansion == 0.5 {
        // The default; and libm computes a root without the processor's help.
        ratio.sqrt()
    } else {
        libm::powf(ratio, values.gas_expansion)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::with;

    #[test]
    fn hot_gas_takes_the_room_that_its_expansion_says() {
        for (exponent, expected) in [(0.0, 1.0), (0.5, 2.0), (1.0, 4.0)] {
            let parameters = with(&[("gas_expansion", exponent)]);
            let air = parameters.ambient_temperature;
            assert!((expansion(4.0 * air, &parameters) - expected).abs() < 1e-5);
            // No step where the power takes over from the line.
            let edge = air * (1.0 + SLIGHT);
            let step =
                expansion(edge * 1.0001, &parameters) - expansion(edge * 0.9999, &parameters);
            assert!(step.abs() < 3e-4, "{step}");
        }
    }
}
