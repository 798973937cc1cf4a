//! The gas that fills the domain, and its lattice at the start.
//!
//! With open edges, particles are born and removed. Every particle has the same mass and its own volume. Each
//! property is an array, sorted by grid cell at every step; readers get copies in the order of the ids.

mod equation_of_state;
pub(super) mod forces;
mod interactions;
pub(super) mod number_density;
pub(super) mod pair;
pub(super) mod pairs;
mod picture;
mod pressing;
pub(super) mod removed;
pub(super) mod resample;
mod rolls;
pub(super) mod seam;
mod speed_limit;
pub(super) mod time_step;
mod vorticity_confinement;
pub(super) mod walls;

use glam::{Vec2, Vec4};

use crate::Particle;
use crate::bounds::Bounds;
use crate::extremes::fast_max;
use crate::order::in_order;
use crate::params::{Edges, Physics};
use crate::random::Random;
use equation_of_state::expansion;

/// The diffusing quantities: temperature \[K\], fuel, oxygen, soot. One vector, because they
/// have one equation.
pub(crate) type State = Vec4;

/// Random displacement of the initial lattice, in spacings: a perfect lattice would persist
/// and shear along its rows.
const JITTER: f32 = 0.1;

/// Tolerance for rounding in the number of rows.
const ROUNDING: f32 = 1e-3;

/// All particles of the gas.
#[derive(Clone, Debug, Default)]
pub(crate) struct Gas {
    pub position: Vec<Vec2>,
    pub velocity: Vec<Vec2>,
    pub state: Vec<State>,
    /// Numbers of birth.
    pub id: Vec<u64>,
    next_id: u64,
    /// Mass of each particle [kg/m].
    pub mass: f32,
    /// Particles that a closed domain lacks because of solids.
    pub missing: usize,

    // Computed at every step.
    /// Acceleration by all but pressure and artificial viscosity [m/s²].
    pub acceleration: Vec<Vec2>,
    /// Acceleration by pressure and artificial viscosity, which each part of a step renews [m/s²].
    pub pressing: Vec<Vec2>,
    /// Change of the state by diffusion [1/s].
    pub change: Vec<State>,
    /// θ, the specific volume relative to that of the air.
    pub expansion: Vec<f32>,
    /// Y = Σ yⱼ Wᵢⱼ, the number density, in mass of cold air [kg/m³].
    pub number_density: Vec<f32>,
    /// Volume \[m²\].
    pub volume: Vec<f32>,
    pub pressure: Vec<f32>,
    /// Gradient of the particle concentration, ΣV∇W [1/m].
    pub concentration_gradient: Vec<Vec2>,
    /// Viscosity of the eddies into which rolls break up [m²/s]. It moves with its particle.
    pub roll_viscosity: Vec<f32>,
    /// Fuel burnt in a second [1/s].
    pub burn: Vec<f32>,
    scratch: Scratch,
}

crate::state! {
    Gas: position velocity state id next_id mass missing acceleration pressing change expansion number_density volume
        pressure concentration_gradient roll_viscosity burn; scratch
}

/// The body for each array with a value per particle.
macro_rules! for_each_array {
    ($gas:expr, $array:ident => $body:expr) => {{
        let gas = &mut *$gas;
        for_each_array!(@each gas, $array, $body;
            position velocity state id acceleration pressing change expansion number_density volume
            pressure concentration_gradient roll_viscosity burn);
    }};
    (@each $gas:ident, $array:ident, $body:expr; $($name:ident)+) => {
        $({
            let $array = &mut $gas.$name;
            $body
        })+
    };
}

#[derive(Clone, Debug, Default)]
struct Scratch {
    vector: Vec<Vec2>,
    state: Vec<State>,
    number: Vec<f32>,
    id: Vec<u64>,
}

impl Gas {
    /// Air at rest that fills the domain.
    pub fn air(values: &Physics, spacing: f32, random: &mut Random) -> Gas {
        let mut gas = Gas::default();
        for place in lattice(values, spacing, random).points {
            gas.push(&Particle {
                temperature: values.ambient_temperature,
                velocity: Vec2::new(values.wind, 0.0),
                ..Particle::at(place)
            });
        }
        gas.set_mass_and_volume(values);
        gas
    }

    /// No gas.
    pub fn none(values: &Physics) -> Gas {
        let mut gas = Gas::default();
        gas.set_mass(values);
        gas
    }

    /// Makes room for so many particles.
    pub fn reserve(&mut self, capacity: usize) {
        for_each_array!(self, array => make_room(array, capacity));
        make_room(&mut self.scratch.vector, capacity);
        make_room(&mut self.scratch.state, capacity);
        make_room(&mut self.scratch.number, capacity);
        make_room(&mut self.scratch.id, capacity);
    }

    /// Gas of these particles.
    pub fn of(particles: &[Particle], values: &Physics) -> Gas {
        let mut gas = Gas::default();
        for particle in particles {
            gas.push(particle);
        }
        gas.set_mass_and_volume(values);
        gas
    }

    pub fn push(&mut self, particle: &Particle) {
        self.id.push(self.next_id);
        self.next_id += 1;
        self.position.push(particle.position);
        self.velocity.push(particle.velocity);
        self.state.push(Vec4::new(
            particle.temperature,
            particle.fuel,
            particle.oxygen,
            particle.soot,
        ));
        self.acceleration.push(Vec2::ZERO);
        self.pressing.push(Vec2::ZERO);
        self.change.push(Vec4::ZERO);
        self.expansion.push(1.0);
        self.number_density.push(0.0);
        self.pressure.push(0.0);
        self.concentration_gradient.push(Vec2::ZERO);
        self.roll_viscosity.push(0.0);
        self.burn.push(0.0);
    }

    /// Adds a particle of this volume \[m²\] to gas that is burning.
    pub fn insert_particle(&mut self, particle: &Particle, volume: f32) {
        self.push(particle);
        self.volume.push(volume);
    }

    /// Keeps the particles for which `stays` is true, in their order. It gets their positions
    /// and velocities.
    pub fn retain(&mut self, mut stays: impl FnMut(Vec2, Vec2) -> bool) {
        let mut kept = 0;
        for i in 0..self.len() {
            if stays(self.position[i], self.velocity[i]) {
                // Every step computes everything else again.
                self.position[kept] = self.position[i];
                self.velocity[kept] = self.velocity[i];
                self.state[kept] = self.state[i];
                self.roll_viscosity[kept] = self.roll_viscosity[i];
                self.id[kept] = self.id[i];
                kept += 1;
            }
        }
        for_each_array!(self, array => array.truncate(kept));
    }

    /// Removes a particle. The last one takes its place.
    pub fn remove(&mut self, i: usize) {
        for_each_array!(self, array => _ = array.swap_remove(i));
    }

    /// Sets the mass of a particle: with open edges that of air at the `spacing`, else so that
    /// all fill the domain with air.
    pub fn set_mass(&mut self, values: &Physics) {
        self.mass = match values.edges {
            Edges::Open => values.ambient_density * values.spacing() * values.spacing(),
            Edges::Periodic => {
                let area = values.domain_width * values.domain_height;
                values.ambient_density * area / (self.len() + self.missing).max(1) as f32
            }
        };
    }

    /// Sets the mass of a particle and estimates the volumes, which the next step computes.
    pub fn set_mass_and_volume(&mut self, values: &Physics) {
        self.set_mass(values);
        self.volume.clear();
        self.volume
            .extend(self.state.iter().map(|state| expansion(state.x, values)));
        let share = match values.edges {
            Edges::Open => values.spacing() * values.spacing(),
            Edges::Periodic => {
                let area = values.domain_width * values.domain_height;
                area / self.volume.iter().sum::<f32>().max(1e-6)
            }
        };
        for volume in &mut self.volume {
            *volume *= share;
        }
    }

    /// Adds `kelvin` to the temperature of all gas.
    pub fn add_temperature(&mut self, kelvin: f32) {
        for state in &mut self.state {
            state.x = fast_max(state.x + kelvin, 1.0);
        }
    }

    pub fn len(&self) -> usize {
        self.id.len()
    }

    pub fn particle(&self, i: usize, time: f64) -> Particle {
        let [temperature, fuel, oxygen, soot] = self.state[i].to_array();
        Particle {
            velocity: self.velocity[i],
            temperature,
            fuel,
            oxygen,
            soot,
            age: time as f32,
            ..Particle::at(self.position[i])
        }
    }

    /// Moves the particle at each index `i` to `new_indices[i]`. The arrays that every step
    /// computes stay.
    pub fn reorder(&mut self, new_indices: &[u32]) {
        let scratch = &mut self.scratch;
        scatter(&mut self.position, &mut scratch.vector, new_indices);
        scatter(&mut self.velocity, &mut scratch.vector, new_indices);
        scatter(&mut self.state, &mut scratch.state, new_indices);
        let viscosity = &mut self.roll_viscosity;
        scatter(viscosity, &mut scratch.number, new_indices);
        scatter(&mut self.id, &mut scratch.id, new_indices);
    }

    /// The indices of all particles in the order of their ids.
    pub fn by_id(&self) -> Vec<usize> {
        in_order(self.len(), self.next_id, &|i| self.id[i])
    }
}

/// Makes room for so many items.
pub(super) fn make_room<T>(array: &mut Vec<T>, capacity: usize) {
    array.reserve(capacity.saturating_sub(array.len()));
}

/// Points that fill the domain, row by row.
pub(crate) struct Lattice {
    pub points: Vec<Vec2>,
    pub columns: usize,
}

impl Lattice {
    /// A lattice of this spacing over a rectangle.
    pub fn even(corner: Vec2, size: Vec2, spacing: f32) -> Lattice {
        let [columns, rows] = (size / spacing).to_array().map(|count| count as usize);
        let mut points = Vec::with_capacity(columns * rows);
        for row in 0..rows {
            for column in 0..columns {
                let cell = Vec2::new(column as f32, row as f32);
                points.push(corner + (cell + 0.5) * spacing);
            }
        }
        Lattice { points, columns }
    }
}

/// A lattice of this spacing, slightly disturbed. The number of rows gives the nearest number
/// of points that is not too large.
pub(crate) fn lattice(values: &Physics, spacing: f32, random: &mut Random) -> Lattice {
    let (width, height) = (values.domain_width, values.domain_height);
    let columns = ((width / spacing) as usize).max(1);
    let count = width * height / (spacing * spacing);
    let rows = ((count / columns as f32 + ROUNDING) as usize).max(1);
    let cell = Vec2::new(width / columns as f32, height / rows as f32);
    let corner = Vec2::new(-0.5 * width, 0.0);
    let bounds = periodic_bounds(values);
    let mut points = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        for column in 0..columns {
            let mut place = |at: usize| at as f32 + 0.5 + random.between(-JITTER, JITTER);
            points.push(bounds.wrap(corner + Vec2::new(place(column), place(row)) * cell));
        }
    }
    Lattice { points, columns }
}

fn scatter<T: Copy + Default>(values: &mut Vec<T>, scratch: &mut Vec<T>, new_indices: &[u32]) {
    scratch.resize(values.len(), T::default());
    for (&value, &index) in values.iter().zip(new_indices) {
        scratch[index as usize] = value;
    }
    std::mem::swap(values, scratch);
}

/// The closed domain of the combustion model, periodic in both directions.
pub(super) fn periodic_bounds(values: &Physics) -> Bounds {
    Bounds {
        bottom: 0.0,
        width: values.domain_width,
        height: values.domain_height,
        periodic_x: true,
        periodic_y: true,
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::params::{Model, Parameters};
    use crate::scene::Scene;

    /// The world of [`scene_with`].
    pub fn with(values: &[(&str, f64)]) -> Parameters {
        scene_with(values).world().clone()
    }

    /// The defaults in a closed domain of 3000 particles, with these values changed.
    pub fn scene_with(values: &[(&str, f64)]) -> Scene {
        let mut scene = Scene::of_model(Model::Combustion);
        let closed = [("particles", 3000.0)];
        assert_eq!(scene.set("edges", "periodic"), Ok(()));
        for &(id, value) in closed.iter().chain(values) {
            assert_eq!(scene.set(id, value), Ok(()));
        }
        scene
    }

    /// Gas in random motion, of every temperature and mixture.
    pub fn random_gas(parameters: &Parameters, seed: u32) -> Gas {
        let mut random = Random::new(seed);
        let mut gas = Gas::air(parameters, parameters.spacing(), &mut random);
        for (velocity, state) in gas.velocity.iter_mut().zip(&mut gas.state) {
            let mut between = |low, high| random.between(low, high);
            *velocity = Vec2::new(between(-1.0, 1.0), between(-1.0, 1.0));
            *state = State::new(
                between(300.0, 2000.0),
                between(0.0, 1.0),
                between(0.0, 1.0),
                between(0.0, 1.0),
            );
        }
        gas
    }

    #[test]
    fn air_fills_the_domain_with_nearly_all_particles() {
        for (width, height, n) in [(1.2, 1.8, 3000.0), (0.1, 6.0, 1000.0), (6.0, 0.3, 5000.0)] {
            let parameters = with(&[
                ("domain_width", width),
                ("domain_height", height),
                ("particles", n),
            ]);
            let gas = Gas::air(&parameters, parameters.spacing(), &mut Random::new(1));
            let count = gas.len() as f64;
            assert!(count <= n && count > 0.8 * n, "{count} of {n}");
            let mass = f64::from(gas.mass) * count;
            let air = width * height * f64::from(parameters.ambient_density);
            assert!((mass / air - 1.0).abs() < 1e-4);
            assert!(
                gas.position
                    .iter()
                    .all(|&at| periodic_bounds(&parameters).contains(at))
            );
        }
    }
}
