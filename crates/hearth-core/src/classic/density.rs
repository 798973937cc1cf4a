//! Density and pressure.
//!
//! ρᵢ = Σⱼ mⱼ W(rᵢⱼ), the particle itself included, and p = k (ρ − ρ₀)
//! (Müller, Charypar, Gross, SCA 2003; the paper never prints its equation of
//! state).

use super::particles::Particles;
use crate::extremes::larger;
use crate::grid::Grid;
use crate::kernel::Kernel;
use crate::neighbours::Neighbours;
use crate::params::Values;

/// Least density that a force reckons with [kg/m³]. A particle that is nearly
/// alone sees a small part of its surroundings; dividing by what it sees would
/// fling it away.
pub(crate) const DENSITY_FLOOR: f32 = 0.3;

/// Finds all pairs and sums the density of every particle of a sorted grid.
pub(crate) fn sum_density(
    particles: &mut Particles,
    neighbours: &mut Neighbours,
    grid: &Grid,
    kernel: &Kernel,
    mass: f32,
) {
    let Particles {
        position,
        density,
        shares,
        ..
    } = particles;
    shares.clear();
    shares.resize(position.len(), mass);
    neighbours.find(position, grid, kernel, shares, density);
}

/// p = k (ρ − ρ₀), never below zero: a gas without walls pushes and does not pull.
pub(crate) fn pressure(particles: &mut Particles, values: &Values) {
    let Particles {
        density, pressure, ..
    } = particles;
    for (p, &density) in pressure.iter_mut().zip(density.iter()) {
        *p = larger(values.gas_constant * (density - values.rest_density), 0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Particle;
    use glam::Vec2;

    #[test]
    fn thin_gas_does_not_pull() {
        let parameters = crate::Parameters::new(crate::params::Model::Classic);
        let mut particles = Particles::default();
        for density in [0.1, 1.0, 2.0] {
            particles.push(Particle::at(Vec2::ZERO));
            *particles.density.last_mut().expect("just pushed") = density;
        }
        pressure(&mut particles, &parameters);
        assert_eq!(particles.pressure[..2], [0.0, 0.0]);
        assert_eq!(particles.pressure[2], parameters.gas_constant);
    }
}
