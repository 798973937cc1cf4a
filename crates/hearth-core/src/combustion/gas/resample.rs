//! Resamples a burning fire to another number of particles or another domain.
//!
//! New particles start on a new lattice with the state of the old gas at the same position: the
//! mean of the old neighbours, weighted by kernel and mass, which conserves heat and matter.
//! Outside of the old domain they are air.
//!
//! All particles have the same mass, so hot, thin gas gets fewer of them; otherwise it would be
//! too heavy and explode. The lattice is fine enough for cold air, and error diffusion selects
//! its points in proportion to the density (Floyd & Steinberg 1976).

use glam::{Vec2, Vec4};

use super::equation_of_state::expansion;
use super::{Gas, Lattice, lattice};
use crate::Particle;
use crate::bounds::Bounds;
use crate::combustion::open_air::{self, OpenAir, Seen};
use crate::grid::Grid;
use crate::kernel::Kernel;
use crate::params::{Edges, Parameters, Physics};
use crate::random::Random;
use crate::solids::Solids;
use crate::state;

/// Points of the lattice per particle of cold air, for compressed gas.
const OVERSAMPLING: f32 = 1.04;
/// Minimum density for the spacing of the lattice.
const MIN_DENSITY: f32 = 0.05;
/// Largest error that is passed on.
const MAX_ERROR: f32 = 1.0;
/// Plausible spacings of stored gas \[m\].
const MIN_SPACING: f32 = 1e-4;
const MAX_SPACING: f32 = 1.0;

/// The division of the gas into particles. A change resamples the gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Discretisation {
    /// So many particles fill a closed domain \[m\].
    Periodic {
        width: f32,
        height: f32,
        particles: u32,
    },
    /// Particles of air have this spacing \[m\].
    Open { spacing: f32 },
}

impl state::State for Discretisation {
    fn save(&self, out: &mut Vec<u8>) {
        let numbers = match *self {
            Discretisation::Open { spacing } => (None, [spacing, 0.0]),
            Discretisation::Periodic {
                width,
                height,
                particles,
            } => (Some(particles), [width, height]),
        };
        numbers.save(out);
    }

    fn load(bytes: &mut state::Bytes<'_>) -> Option<Discretisation> {
        let (particles, [width, height]) = state::State::load(bytes)?;
        Some(match particles {
            None => Discretisation::Open { spacing: width },
            Some(particles) => Discretisation::Periodic {
                width,
                height,
                particles,
            },
        })
    }
}

impl Discretisation {
    pub fn of(values: &Physics) -> Discretisation {
        match values.edges {
            Edges::Open => Discretisation::Open {
                spacing: values.spacing(),
            },
            Edges::Periodic => Discretisation::Periodic {
                width: values.domain_width,
                height: values.domain_height,
                particles: values.capacity(),
            },
        }
    }

    /// What the values of a fire do not determine, as a saved fire has it: the number of particles
    /// or, in open air, the bits of the spacing.
    pub fn resolution_key(&self) -> u32 {
        match *self {
            Discretisation::Periodic { particles, .. } => particles,
            Discretisation::Open { spacing } => spacing.to_bits(),
        }
    }

    /// The discretisation with that [key](Self::resolution_key); that of the values if the key is
    /// not plausible.
    pub fn with_resolution_key(key: u32, values: &Physics) -> Discretisation {
        match Discretisation::of(values) {
            Discretisation::Periodic { width, height, .. } => Discretisation::Periodic {
                width,
                height,
                particles: key,
            },
            Discretisation::Open { spacing } => {
                let stored = f32::from_bits(key);
                let plausible = (MIN_SPACING..=MAX_SPACING).contains(&stored);
                Discretisation::Open {
                    spacing: if plausible { stored } else { spacing },
                }
            }
        }
    }
}

/// Gas for the closed domain and number of particles of `parameters` with the state of `old` gas.
pub(crate) fn resample(old: &Old, parameters: &Parameters, random: &mut Random) -> Gas {
    let spacing = parameters.spacing() * (old.mean_density(parameters) / OVERSAMPLING).sqrt();
    let places = lattice(parameters, spacing, random);
    let mut gas = Gas::default();
    old.select(&places, parameters.capacity() as usize, &|_| true, &mut gas);
    gas.set_mass_and_volume(parameters);
    gas
}

/// Gas of the spacing of `parameters` in `open` air with the state of `old` gas.
pub(crate) fn resample_open(old: &Old, parameters: &Parameters, open: &OpenAir) -> Gas {
    let bounds = open.bounds();
    let corner = Vec2::new(-0.5 * bounds.width, bounds.bottom);
    let size = Vec2::new(bounds.width, bounds.height);
    let spacing = parameters.spacing() * (1.0 / OVERSAMPLING).sqrt();
    let mut gas = Gas::default();
    old.select(
        &Lattice::even(corner, size, spacing),
        parameters.capacity() as usize,
        &|place| open.holds(place),
        &mut gas,
    );
    gas.set_mass_and_volume(parameters);
    gas
}

/// Interpolates the old gas.
pub(crate) struct Old<'a> {
    gas: &'a Gas,
    solids: &'a Solids,
    bounds: Bounds,
    grid: Grid,
    order: Vec<usize>,
    kernel: Kernel,
    /// Number density of particles in air [1/m²].
    air_density: f32,
    air: f32,
}

impl<'a> Old<'a> {
    /// Gas of that discretisation.
    pub fn new(
        (gas, solids): (&'a Gas, &'a Solids),
        discretisation: &Discretisation,
        values: &Physics,
        seen: Option<Seen>,
    ) -> Old<'a> {
        let (bounds, spacing, air_density) = match *discretisation {
            Discretisation::Periodic { width, height, .. } => {
                let bounds = Bounds {
                    bottom: 0.0,
                    width,
                    height,
                    periodic_x: true,
                    periodic_y: true,
                };
                let spacing = (width * height / gas.len().max(1) as f32).sqrt();
                let states = gas.state.iter();
                let room: f32 = states.map(|state| expansion(state.x, values)).sum();
                (bounds, spacing, room / (width * height))
            }
            Discretisation::Open { spacing } => {
                let bounds = open_air::layout(values, seen, spacing).bounds();
                (bounds, spacing, 1.0 / (spacing * spacing))
            }
        };
        let kernel = Kernel::new(values.smoothing_ratio * spacing);
        let mut grid = Grid::default();
        let mut order = vec![0; gas.len()];
        let places = grid.sort(gas.position.iter().copied(), &bounds, kernel.support());
        for (i, &place) in places.iter().enumerate() {
            order[place as usize] = i;
        }
        Old {
            gas,
            solids,
            bounds,
            grid,
            order,
            kernel,
            air_density,
            air: values.ambient_temperature,
        }
    }

    /// Mean density of the gas in the new domain, relative to air.
    fn mean_density(&self, parameters: &Parameters) -> f32 {
        let (width, height) = (parameters.domain_width, parameters.domain_height);
        let stays = |at: &&Vec2| at.x.abs() <= 0.5 * width && at.y <= height;
        let kept = self.gas.position.iter().filter(stays).count() as f32;
        let common = width.min(self.bounds.width) * height.min(self.bounds.height);
        let area = width * height;
        // Particles that a caller put in may all be outside.
        ((kept / self.air_density + area - common) / area).max(MIN_DENSITY)
    }

    /// Adds gas at points of a lattice in proportion to its density, only where `holds` is true,
    /// and at most `max_particles`.
    pub fn select(
        &self,
        places: &Lattice,
        max_particles: usize,
        holds: &dyn Fn(Vec2) -> bool,
        gas: &mut Gas,
    ) {
        // Rounding errors for this row and for the next.
        let mut error = vec![0.0_f32; places.columns + 2];
        let mut next = error.clone();
        for row in places.points.chunks(places.columns) {
            for (column, &place) in row.iter().enumerate() {
                if !holds(place) {
                    continue;
                }
                let (particle, density) = self.at(place);
                let target = density / OVERSAMPLING + error[column + 1];
                let taken = target > 0.5;
                let remainder = target - f32::from(u8::from(taken));
                let remainder = remainder.clamp(-MAX_ERROR, MAX_ERROR);
                error[column + 2] += remainder * (7.0 / 16.0);
                next[column] += remainder * (3.0 / 16.0);
                next[column + 1] += remainder * (5.0 / 16.0);
                next[column + 2] += remainder * (1.0 / 16.0);
                if taken && gas.len() < max_particles {
                    gas.push(&particle);
                }
            }
            std::mem::swap(&mut error, &mut next);
            next.fill(0.0);
        }
    }

    /// The state of the gas at a position, and its density relative to air.
    fn at(&self, place: Vec2) -> (Particle, f32) {
        let mut particle = Particle::at(place);
        particle.temperature = self.air;
        if !self.bounds.contains(place) {
            return (particle, 1.0);
        }
        let (mut velocity, mut state) = (Vec2::ZERO, Vec4::ZERO);
        let (mut all, mut weights) = (0.0, 0.0);
        let support = self.kernel.support();
        self.grid.candidates(place, &mut |run, shift| {
            for &j in &self.order[run] {
                let old = self.gas.position[j];
                let weight = self.kernel.value((place - shift).distance(old));
                all += weight;
                // Gas behind a plate is gas of another state, but no gap.
                if weight == 0.0 || self.solids.separate(place, old + shift, support) {
                    continue;
                }
                velocity += self.gas.velocity[j] * weight;
                state += self.gas.state[j] * weight;
                weights += weight;
            }
        });
        if all <= 0.0 {
            return (particle, 1.0);
        }
        let density = all / self.air_density;
        if weights <= 0.0 {
            return (particle, density);
        }
        let [temperature, fuel, oxygen, soot] = (state / weights).to_array();
        particle.velocity = velocity / weights;
        particle.temperature = temperature;
        particle.fuel = fuel;
        particle.oxygen = oxygen;
        particle.soot = soot;
        (particle, density)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::with;

    fn air(parameters: &Parameters) -> Gas {
        Gas::air(parameters, parameters.spacing(), &mut Random::new(3))
    }

    fn taken_over(old: &Gas, old_discretisation: &Parameters, parameters: &Parameters) -> Gas {
        let discretisation = Discretisation::of(old_discretisation);
        let bare = Solids::default();
        let old = Old::new((old, &bare), &discretisation, parameters, None);
        resample(&old, parameters, &mut Random::new(4))
    }

    #[test]
    fn a_field_is_unchanged_at_another_resolution() {
        let coarse = with(&[("particles", 3000.0)]);
        let field = |at: Vec2| Vec4::new(900.0 + 500.0 * at.x + 200.0 * at.y, 0.3 * at.y, 0.5, 0.1);
        let mut old = air(&coarse);
        for i in 0..old.len() {
            old.state[i] = field(old.position[i]);
            old.velocity[i] = Vec2::new(0.5, 1.0);
        }
        for n in [1000.0, 12_000.0] {
            let parameters = with(&[("particles", n)]);
            let new = taken_over(&old, &coarse, &parameters);
            for i in 0..new.len() {
                let at = new.position[i];
                // The field is discontinuous at the periodic edges.
                if at.x.abs() < 0.5 && (0.1..1.7).contains(&at.y) {
                    let off = (new.state[i] - field(at)).abs();
                    assert!(off.x < 12.0 && off.y < 0.02, "{off} at {at}");
                    assert!(new.velocity[i].distance(Vec2::new(0.5, 1.0)) < 1e-4);
                }
            }
        }
    }

    #[test]
    fn outside_of_the_old_domain_is_air() {
        let small = with(&[]);
        let mut old = air(&small);
        old.state.fill(Vec4::new(1500.0, 0.2, 0.1, 0.5));
        let large = with(&[("domain_width", 2.4), ("domain_height", 3.0)]);
        let new = taken_over(&old, &small, &large);
        for i in 0..new.len() {
            let at = new.position[i];
            let inside = at.x.abs() < 0.6 && at.y < 1.8;
            let expected = if inside {
                1500.0
            } else {
                large.ambient_temperature
            };
            assert!((new.state[i].x - expected).abs() < 0.1, "{at}");
        }
    }

    #[test]
    fn hot_gas_conserves_mass_and_heat() {
        let parameters = with(&[("gas_expansion", 1.0)]);
        let air = parameters.ambient_temperature;
        let mut fire = crate::Simulation::new(parameters.clone());
        while fire.time() < 0.6 {
            fire.step();
        }
        let heat = |particles: &[crate::Particle], mass: f64| {
            let excess = particles.iter().map(|p| f64::from(p.temperature - air));
            mass * excess.sum::<f64>()
        };
        let each = |fire: &crate::Simulation| 1.0 / fire.count() as f64;
        let before = heat(&fire.particles(), each(&fire));
        for n in [1500.0, 6000.0, 3000.0] {
            let set = fire.set("particles", crate::params::Input::Number(n));
            assert_eq!(set, Ok(()));
            assert!(
                (fire.count() as f64 / n - 1.0).abs() < 0.06,
                "{} of {n}",
                fire.count()
            );
            let after = heat(&fire.particles(), each(&fire));
            assert!(
                (after / before - 1.0).abs() < 0.1,
                "{before} before, {after} after"
            );
        }
    }
}
