//! Density and pressure.
//!
//! ρᵢ = Σⱼ mⱼ W(rᵢⱼ), the particle itself included, and p = k (ρ − ρ₀)
//! (Müller, Charypar, Gross, SCA 2003; the paper never prints its equation of
//! state). The pass over the grid also writes down the pairs that it finds, so
//! that the forces need no search of their own.

use glam::Vec2;

use crate::grid::{Bounds, Grid};
use crate::kernel::Kernel;
use crate::params::Values;
use crate::particles::Particles;

/// Least density that a force reckons with [kg/m³]. A particle that is nearly
/// alone sees a small part of its surroundings; dividing by what it sees would
/// fling it away.
pub(crate) const DENSITY_FLOOR: f32 = 0.3;

/// Most pairs that are written down. It is a net for a browser's memory: many
/// particles within a large smoothing radius would have thousands of
/// neighbours each. A hundred thousand particles reach it at 335 neighbours.
const MOST_PAIRS: usize = 1 << 24;

/// Two particles within each other's kernel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    /// The other particle.
    pub j: u32,
    /// Offset from j to i \[m\].
    pub offset: Vec2,
    /// W'(r)/r [1/m⁴].
    pub gradient: f32,
}

/// The pairs of all particles, each pair once.
#[derive(Clone, Debug, Default)]
pub(crate) struct Neighbours {
    pairs: Vec<Pair>,
    /// Where each particle's pairs end.
    ends: Vec<u32>,
    /// How many neighbours each particle has, whichever end wrote the pair down.
    pub count: Vec<u32>,
}

impl Neighbours {
    pub fn pair_count(&self) -> usize {
        self.pairs.len()
    }

    /// Every particle that wrote pairs down, with these.
    pub fn iter(&self) -> impl Iterator<Item = (usize, &[Pair])> {
        let mut begin = 0;
        self.ends.iter().enumerate().map(move |(i, &end)| {
            let pairs = &self.pairs[begin..end as usize];
            begin = end as usize;
            (i, pairs)
        })
    }
}

/// Finds all pairs and sums the density of every particle of a sorted grid.
pub(crate) fn sum_density(
    particles: &mut Particles,
    neighbours: &mut Neighbours,
    grid: &Grid,
    bounds: &Bounds,
    kernel: &Kernel,
    mass: f32,
) {
    let n = particles.len();
    let Neighbours { pairs, ends, count } = neighbours;
    pairs.clear();
    ends.clear();
    count.clear();
    count.resize(n, 0);

    let Particles {
        position, density, ..
    } = particles;
    density.fill(kernel.value(0.0));
    let support_squared = kernel.support() * kernel.support();

    for i in 0..n {
        let mut own = 0.0;
        let mut own_count = 0;
        let here = position[i];
        if pairs.len() >= MOST_PAIRS {
            ends.push(pairs.len() as u32);
            continue;
        }
        grid.later_candidates(i, here, |run| {
            for j in run {
                let offset = bounds.offset(here, position[j]);
                let distance_squared = offset.length_squared();
                if distance_squared < support_squared {
                    let distance = distance_squared.sqrt();
                    let weight = kernel.value(distance);
                    own += weight;
                    own_count += 1;
                    density[j] += weight;
                    count[j] += 1;
                    pairs.push(Pair {
                        j: j as u32,
                        offset,
                        gradient: kernel.gradient_over_r(distance),
                    });
                }
            }
        });
        density[i] += own;
        count[i] += own_count;
        ends.push(pairs.len() as u32);
    }
    for density in density.iter_mut() {
        *density *= mass;
    }
}

/// p = k (ρ − ρ₀), never below zero: a gas without walls pushes and does not pull.
pub(crate) fn pressure(particles: &mut Particles, values: &Values) {
    let Particles {
        density, pressure, ..
    } = particles;
    for (p, &density) in pressure.iter_mut().zip(density.iter()) {
        *p = (values.gas_constant * (density - values.rest_density)).max(0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::Particle;
    use crate::random::Random;

    #[test]
    fn the_grid_sums_the_density_that_comparing_all_with_all_sums() {
        for (seed, periodic) in [(1, false), (2, true)] {
            let bounds = Bounds {
                width: 0.8,
                height: 0.6,
                periodic,
            };
            let mut random = Random::new(seed);
            let mut particles = Particles::default();
            for _ in 0..500 {
                particles.push(Particle::at(Vec2::new(
                    random.between(-0.4, 0.4),
                    random.between(0.0, 0.6),
                )));
            }
            let (kernel, mass) = (Kernel::new(0.03), 1e-3);
            let (mut grid, mut neighbours) = (Grid::default(), Neighbours::default());
            grid.sort(&mut particles, &bounds, kernel.support());
            sum_density(
                &mut particles,
                &mut neighbours,
                &grid,
                &bounds,
                &kernel,
                mass,
            );
            for i in 0..particles.len() {
                let distances = particles
                    .position
                    .iter()
                    .map(|&other| bounds.offset(particles.position[i], other).length());
                let expected: f32 = distances.clone().map(|r| mass * kernel.value(r)).sum();
                assert!((particles.density[i] / expected - 1.0).abs() < 1e-5);
                let others = distances.filter(|&r| r < kernel.support()).count() - 1;
                assert_eq!(neighbours.count[i] as usize, others);
            }
        }
    }

    #[test]
    fn what_memory_cannot_hold_is_not_written_down() {
        let mut particles = Particles::default();
        let n = 6000;
        for _ in 0..n {
            particles.push(Particle::at(Vec2::new(0.0, 0.5)));
        }
        let bounds = Bounds {
            width: 1.0,
            height: 1.0,
            periodic: false,
        };
        let kernel = Kernel::new(0.02);
        let (mut grid, mut neighbours) = (Grid::default(), Neighbours::default());
        grid.sort(&mut particles, &bounds, kernel.support());
        sum_density(
            &mut particles,
            &mut neighbours,
            &grid,
            &bounds,
            &kernel,
            1e-4,
        );
        assert!((MOST_PAIRS..MOST_PAIRS + n).contains(&neighbours.pair_count()));
        assert_eq!(neighbours.iter().count(), n);
    }

    #[test]
    fn thin_gas_does_not_pull() {
        let parameters = crate::Parameters::default();
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
