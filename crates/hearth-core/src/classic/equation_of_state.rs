//! Pressure: p = k (ρ − ρ₀) (Müller, Charypar, Gross, SCA 2003; the paper does not
//! print its equation of state).

use crate::lanes::Real;
use crate::params::Physics;

/// Minimum density in forces [kg/m³]. The density of a nearly isolated particle is far too
/// low, and dividing by it would give huge accelerations.
pub(crate) const DENSITY_FLOOR: f32 = 0.3;

/// p = k (ρ − ρ₀) \[Pa\], at least 0: the gas repels and does not
/// attract.
#[inline(always)]
pub(crate) fn pressure<T: Real>(density: T, values: &Physics) -> T {
    let compressed = density - T::splat(values.rest_density);
    (T::splat(values.gas_constant) * compressed).fast_max(T::splat(0.0))
}

/// Specific volume for forces [m³/kg].
#[inline(always)]
pub(crate) fn volume<T: Real>(density: T) -> T {
    T::splat(1.0) / density.fast_max(T::splat(DENSITY_FLOOR))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{Model, Parameters};

    #[test]
    fn thin_gas_does_not_attract() {
        let parameters = Parameters::new(Model::Classic);
        let at = |density: f32| pressure(density, &parameters);
        assert_eq!([at(0.1), at(1.0)], [0.0, 0.0]);
        assert_eq!(at(2.0), parameters.gas_constant);
    }

    #[test]
    fn the_density_of_isolated_particles_is_limited() {
        assert_eq!(volume(0.01_f32), 1.0 / DENSITY_FLOOR);
        assert_eq!(volume(2.0_f32), 0.5);
    }
}
