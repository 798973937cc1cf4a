//! A burning fire as bytes, so that a page can start with one.
//!
//! [`Simulation::burning`] writes a fire of the combustion model,
//! [`Simulation::restore_burning`] reads it. The format is small and lossy: a coordinate has 16
//! bits, every other quantity 8. All numbers are little-endian.
//!
//! | bytes | content |
//! |---|---|
//! | 4 | `Fire` |
//! | 2, 2 | [`VERSION`]; number of embers |
//! | 8 | [`digest`] of its values |
//! | 4, 4 | its `particles` or, with open edges, its spacing \[m\]; number of particles |
//! | 8 | time \[s\] |
//! | 4 × 6 | largest velocity, excess temperature and soot; of embers, velocity, size and life |
//! | particles × 10 | x, y (2 each), u, v, temperature, fuel, oxygen, soot (1 each), column by column |
//! | embers × 10 | x, y (2 each), u, v, temperature, size, age, life (1 each), column by column |
//! | solids × 4 | temperature \[K\] of each that conducts heat, in the order of the objects |
//! | free solids × 32 | place x, y, cosine and sine of the angle, velocity u, v, spin, 1 if it sleeps |
//!
//! What solids with fuel have lost is not in it: a restored fire has them whole and cold.
//!
//! A velocity is the root of its share of the largest, so that slow gas is precise.

mod digest;
mod format;
#[cfg(test)]
mod tests;

use glam::Vec2;

use super::Simulation;
use crate::bounds::Bounds;
use crate::combustion::{Discretisation, Ember, SavedFire};
use crate::params::{Motion, Solid, Thermal};
use crate::particle::Particle;
use crate::random::Random;
use format::{
    BODY, BYTES_PER_PARTICLE, Bytes, Columns, EMBERS, HEADER, Header, MAGIC, OUT_OF_RANGE,
    WRONG_LENGTH, quantised, quantised_signed,
};

pub use digest::digest;
pub use format::{BurningError, VERSION};

/// Largest distance of a free solid from the middle \[m\], its largest speed [m/s], and its largest
/// spin [1/s].
const MAX_PLACE: f32 = 100.0;
const MAX_SPEED: f32 = 10.0;
const MAX_SPIN: f32 = 1e5;
/// Largest temperature of an ember \[K\].
const MAX_EMBER_TEMPERATURE: f32 = 2500.0;

impl Simulation {
    /// This fire as bytes, with the gas in and around its frame; `None` in the classic model.
    pub fn burning(&self) -> Option<Vec<u8>> {
        let combustion = self.solver.combustion()?;
        let air = self.scene.world().ambient_temperature;
        let discretisation = combustion.discretisation();
        let bounds = crate::combustion::bounds(self.scene.world(), discretisation);
        let (mut particles, mut embers) = (self.particles(), self.embers().to_vec());
        particles.retain(|particle| bounds.contains(particle.position));
        embers.retain(|ember| bounds.contains(ember.position));
        embers.truncate(EMBERS);
        let max = |all: &mut dyn Iterator<Item = f32>| all.fold(0.0, f32::max);
        let speed = |velocity: Vec2| velocity.abs().max_element();
        let scales = [
            max(&mut particles.iter().map(|particle| speed(particle.velocity))),
            max(&mut particles.iter().map(|particle| particle.temperature - air)),
            max(&mut particles.iter().map(|particle| particle.soot)),
            max(&mut embers.iter().map(|ember| speed(ember.velocity))),
            max(&mut embers.iter().map(|ember| ember.size)),
            max(&mut embers.iter().map(|ember| ember.lifetime)),
        ];
        let [velocity, excess, soot, ember_velocity, size, life] = scales;

        let mut out =
            Vec::with_capacity(HEADER + BYTES_PER_PARTICLE * (particles.len() + embers.len()));
        out.extend(MAGIC);
        out.extend(VERSION.to_le_bytes());
        out.extend((embers.len() as u16).to_le_bytes());
        out.extend(digest(&self.scene).to_le_bytes());
        out.extend(discretisation.resolution_key().to_le_bytes());
        out.extend((particles.len() as u32).to_le_bytes());
        out.extend(self.time.to_le_bytes());
        for scale in scales {
            out.extend(scale.to_le_bytes());
        }
        let positions = particles.iter().map(|particle| particle.position);
        write_positions(&mut out, &bounds, positions);
        write_column(&mut out, &particles, |particle| {
            quantised_signed(particle.velocity.x, velocity)
        });
        write_column(&mut out, &particles, |particle| {
            quantised_signed(particle.velocity.y, velocity)
        });
        write_column(&mut out, &particles, |particle| {
            quantised(particle.temperature - air, excess)
        });
        write_column(&mut out, &particles, |particle| {
            quantised(particle.fuel, 1.0)
        });
        write_column(&mut out, &particles, |particle| {
            quantised(particle.oxygen, 1.0)
        });
        write_column(&mut out, &particles, |particle| {
            quantised(particle.soot, soot)
        });
        write_positions(&mut out, &bounds, embers.iter().map(|ember| ember.position));
        write_column(&mut out, &embers, |ember| {
            quantised_signed(ember.velocity.x, ember_velocity)
        });
        write_column(&mut out, &embers, |ember| {
            quantised_signed(ember.velocity.y, ember_velocity)
        });
        write_column(&mut out, &embers, |ember| {
            quantised(ember.temperature, MAX_EMBER_TEMPERATURE)
        });
        write_column(&mut out, &embers, |ember| quantised(ember.size, size));
        write_column(&mut out, &embers, |ember| quantised(ember.age, life));
        write_column(&mut out, &embers, |ember| quantised(ember.lifetime, life));
        let temperatures = combustion.solid_temperatures();
        out.extend(temperatures.flat_map(|(_, kelvin)| kelvin.to_le_bytes()));
        // What has broken off a solid is whole again in a restored fire.
        let bodies = self.free_solid_numbers();
        let (bodies, _) = bodies.as_chunks::<11>();
        for body in bodies.iter().filter(|body| body[0] == body[10]) {
            let numbers = body[1..8].iter().chain([&body[9]]);
            out.extend(numbers.flat_map(|number| number.to_le_bytes()));
        }
        Some(out)
    }

    /// Continues from these bytes, with this fire's seed, resampled to its number of particles.
    /// An error changes nothing.
    ///
    /// # Errors
    /// The bytes are damaged, of another version, or those of a fire with other values.
    pub fn restore_burning(&mut self, bytes: &[u8]) -> Result<(), BurningError> {
        let mut bytes = Bytes(bytes);
        let header = Header::read(&mut bytes)?;
        let Some(combustion) = self.solver.combustion_mut() else {
            return Err(BurningError::OtherValues);
        };
        if header.digest != digest(&self.scene) {
            return Err(BurningError::OtherValues);
        }
        let parameters = self.scene.world();
        let [velocity, excess, soot, ember_velocity, size, life] = header.scales;
        let air = parameters.ambient_temperature;
        let discretisation = Discretisation::with_resolution_key(header.resolution_key, parameters);
        let bounds = crate::combustion::bounds(parameters, discretisation);

        let columns = Columns::of(&mut bytes, header.particles);
        let particles: Vec<Particle> = (0..header.particles)
            .map(|i| Particle {
                velocity: columns.velocity(i, velocity),
                temperature: air + columns.share(2, i) * excess,
                fuel: columns.share(3, i),
                oxygen: columns.share(4, i),
                soot: columns.share(5, i) * soot,
                ..Particle::at(columns.position(i, &bounds))
            })
            .collect();
        if particles
            .iter()
            .any(|particle| particle.broken_rule(&bounds).is_some())
        {
            return Err(BurningError::Damaged(OUT_OF_RANGE));
        }
        let columns = Columns::of(&mut bytes, header.embers);
        let embers = (0..header.embers).map(|i| Ember {
            position: columns.position(i, &bounds),
            velocity: columns.velocity(i, ember_velocity),
            temperature: columns.share(2, i) * MAX_EMBER_TEMPERATURE,
            size: columns.share(3, i) * size,
            age: columns.share(4, i) * life,
            lifetime: columns.share(5, i) * life,
        });
        let embers = embers.filter(|ember| ember.size > 0.0 && ember.age < ember.lifetime);
        let embers = embers.collect();
        let numbers = bytes.numbers();
        let conducting = |solid: &&Solid| solid.thermal == Thermal::Conducting;
        let conducting = self.scene.solids().filter(conducting).count();
        let is_free = |solid: &&Solid| solid.motion == Motion::Free;
        let free = self.scene.solids().filter(is_free).count();
        if numbers.len() != conducting + BODY * free {
            return Err(BurningError::Damaged(WRONG_LENGTH));
        }
        let (temperatures, bodies) = numbers.split_at(conducting);
        let is_temperature = |kelvin: &f32| (1.0..=1e5).contains(kelvin);
        if !(temperatures.iter().all(is_temperature) && bodies.chunks(BODY).all(is_body)) {
            return Err(BurningError::Damaged(OUT_OF_RANGE));
        }

        self.random = Random::new(parameters.seed);
        self.time = header.time;
        combustion.forget_free();
        let saved = SavedFire {
            particles: &particles,
            discretisation,
            embers,
            bodies,
        };
        combustion.resume(saved, &self.scene, &mut self.random, self.time);
        combustion.set_solid_temperatures(temperatures);
        Ok(())
    }
}

/// Whether the numbers are those of a free solid.
fn is_body(numbers: &[f32]) -> bool {
    let &[x, y, cosine, sine, u, v, spin, asleep] = numbers else {
        return false;
    };
    let within = |number: f32, most: f32| (-most..=most).contains(&number);
    within(x, MAX_PLACE)
        && within(y, MAX_PLACE)
        && within(Vec2::new(cosine, sine).length() - 1.0, 0.01)
        && within(u, MAX_SPEED)
        && within(v, MAX_SPEED)
        && within(spin, MAX_SPIN)
        && (asleep == 0.0 || asleep == 1.0)
}

/// Writes a byte for each.
fn write_column<T>(out: &mut Vec<u8>, all: &[T], byte: impl Fn(&T) -> u8) {
    out.extend(all.iter().map(byte));
}

fn write_positions(
    out: &mut Vec<u8>,
    bounds: &Bounds,
    positions: impl Iterator<Item = Vec2> + Clone,
) {
    let coordinate = |part: f32| (part * 65_536.0).clamp(0.0, 65_535.0) as u16;
    out.extend(
        positions
            .clone()
            .flat_map(|at| coordinate(at.x / bounds.width + 0.5).to_le_bytes()),
    );
    let part = |at: Vec2| coordinate((at.y - bounds.bottom) / bounds.height);
    out.extend(positions.flat_map(|at| part(at).to_le_bytes()));
}
