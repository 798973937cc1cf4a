//! Pressure: p = k (ρ − ρ₀) (Müller, Charypar, Gross, SCA 2003; the paper never
//! prints its equation of state).

use crate::lanes::Real;
use crate::params::Physics;

/// Least density that forces use [kg/m³]. A particle that is nearly alone samples a
/// small part of its neighbourhood; dividing by that density would fling it away.
pub(crate) const DENSITY_FLOOR: f32 = 0.3;

/// p = k (ρ − ρ₀) \[Pa\], never below zero: a gas without walls repels and does not
/// attract.
#[inline(always)]
pub(crate) fn pressure<T: Real>(density: T, values: &Physics) -> T {
    let compressed = density - T::of(values.rest_density);
    (T::of(values.gas_constant) * compressed).fast_max(T::of(0.0))
}

/// Volume of a unit of mass of that density [m³/kg], as forces use it.
#[inline(always)]
pub(crate) fn volume<T: Real>(density: T) -> T {
    T::of(1.0) / density.fast_max(T::of(DENSITY_FLOOR))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{Model, Parameters};

    #[test]
    fn thin_gas_does_not_pull() {
        let parameters = Parameters::new(Model::Classic);
        let at = |density: f32| pressure(density, &parameters);
        assert_eq!([at(0.1), at(1.0)], [0.0, 0.0]);
        assert_eq!(at(2.0), parameters.gas_constant);
    }

    #[test]
    fn what_is_nearly_alone_counts_as_no_thinner_than_the_floor() {
        assert_eq!(volume(0.01_f32), 1.0 / DENSITY_FLOOR);
        assert_eq!(volume(2.0_f32), 0.5);
    }
}
