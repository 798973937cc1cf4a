//! How much room hot gas takes: θ = (T/Tₐ)^ε.
//!
//! ε = 1 is the ideal gas (the paper's equation 8), ε = 0 the paper's own equation of
//! state, in which only density makes pressure.

use crate::params::Physics;

/// Relative excess temperature below which the expansion is practically linear.
const MAX_LINEAR_EXCESS: f32 = 2e-3;

/// θ, the specific volume relative to that of the surrounding air.
#[inline(always)]
pub(crate) fn expansion(temperature: f32, values: &Physics) -> f32 {
    let ratio = temperature / values.ambient_temperature;
    let excess = ratio - 1.0;
    // Most of the domain is air, and a power costs as much as ten pairs.
    if excess.abs() < MAX_LINEAR_EXCESS {
        1.0 + values.gas_expansion * excess
    } else if values.gas_expansion == 0.5 {
        // The default. libm's root does not use the processor's instruction.
        ratio.sqrt()
    } else {
        // `powf` to 1e-6.
        libm::expf(values.gas_expansion * libm::logf(ratio))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::with;

    #[test]
    fn hot_gas_expands_by_the_exponent() {
        for (exponent, expected) in [(0.0, 1.0), (0.5, 2.0), (1.0, 4.0)] {
            let parameters = with(&[("gas_expansion", exponent)]);
            let air = parameters.ambient_temperature;
            assert!((expansion(4.0 * air, &parameters) - expected).abs() < 1e-5);
            // The two branches are continuous.
            let edge = air * (1.0 + MAX_LINEAR_EXCESS);
            let step =
                expansion(edge * 1.0001, &parameters) - expansion(edge * 0.9999, &parameters);
            assert!(step.abs() < 3e-4, "{step}");
        }
    }
}
