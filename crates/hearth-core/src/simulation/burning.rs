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
//! | 4, 4 | its `max_particles` or, with open edges, its spacing \[m\]; number of particles |
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

use std::fmt;

use glam::Vec2;

use super::Simulation;
use crate::bounds::Bounds;
use crate::combustion::Ember;
use crate::params::{Motion, Solid, Thermal};
use crate::particle::Particle;
use crate::random::Random;
use format::{
    BODY, Bytes, Columns, EACH, EMBERS, HEADER, Header, MAGIC, OUT_OF_RANGE, quantised,
    quantised_signed,
};

pub use digest::digest;
pub use format::VERSION;

const NO_FIRE: &str = "the bytes are not a burning fire";
/// Largest distance of a free solid from the middle \[m\], its largest speed [m/s], and its largest
/// spin [1/s].
const MAX_PLACE: f32 = 100.0;
const MAX_SPEED: f32 = 10.0;
const MAX_SPIN: f32 = 1e5;
/// Largest temperature of an ember \[K\].
const MAX_EMBER_TEMPERATURE: f32 = 2500.0;

/// An error of bytes that are not a fire of this scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BurningError {
    /// The fire has other values or another model. The bytes are valid.
    OtherValues,
    /// The bytes are damaged; the message.
    Damaged(&'static str),
}

impl fmt::Display for BurningError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            BurningError::OtherValues => "the burning fire has other values",
            BurningError::Damaged(words) => words,
        })
    }
}

impl std::error::Error for BurningError {}

impl Simulation {
    /// This fire as bytes, with the gas in and around its frame; `None` in the classic model.
    pub fn burning(&self) -> Option<Vec<u8>> {
        let gas = self.solver.combustion()?;
        let air = self.scene.settings().ambient_temperature;
        let bounds = crate::combustion::bounds(self.scene.settings(), gas.made_with());
        let (mut particles, mut embers) = (self.particles(), self.embers().to_vec());
        particles.retain(|one| bounds.contains(one.position));
        embers.retain(|one| bounds.contains(one.position));
        embers.truncate(EMBERS);
        let max = |all: &mut dyn Iterator<Item = f32>| all.fold(0.0, f32::max);
        let speed = |velocity: Vec2| velocity.abs().max_element();
        let scales = [
            max(&mut particles.iter().map(|one| speed(one.velocity))),
            max(&mut particles.iter().map(|one| one.temperature - air)),
            max(&mut particles.iter().map(|one| one.soot)),
            max(&mut embers.iter().map(|one| speed(one.velocity))),
            max(&mut embers.iter().map(|one| one.size)),
            max(&mut embers.iter().map(|one| one.lifetime)),
        ];
        let [velocity, hot, sooty, flight, size, life] = scales;

        let mut out = Vec::with_capacity(HEADER + EACH * (particles.len() + embers.len()));
        out.extend(MAGIC);
        out.extend(VERSION.to_le_bytes());
        out.extend((embers.len() as u16).to_le_bytes());
        out.extend(digest(&self.scene).to_le_bytes());
        out.extend(gas.made_with().to_le_bytes());
        out.extend((particles.len() as u32).to_le_bytes());
        out.extend(self.time.to_le_bytes());
        for scale in scales {
            out.extend(scale.to_le_bytes());
        }
        write_positions(&mut out, &bounds, particles.iter().map(|one| one.position));
        out.extend(
            particles
                .iter()
                .map(|one| quantised_signed(one.velocity.x, velocity)),
        );
        out.extend(
            particles
                .iter()
                .map(|one| quantised_signed(one.velocity.y, velocity)),
        );
        out.extend(
            particles
                .iter()
                .map(|one| quantised(one.temperature - air, hot)),
        );
        out.extend(particles.iter().map(|one| quantised(one.fuel, 1.0)));
        out.extend(particles.iter().map(|one| quantised(one.oxygen, 1.0)));
        out.extend(particles.iter().map(|one| quantised(one.soot, sooty)));
        write_positions(&mut out, &bounds, embers.iter().map(|one| one.position));
        out.extend(
            embers
                .iter()
                .map(|one| quantised_signed(one.velocity.x, flight)),
        );
        out.extend(
            embers
                .iter()
                .map(|one| quantised_signed(one.velocity.y, flight)),
        );
        out.extend(
            embers
                .iter()
                .map(|one| quantised(one.temperature, MAX_EMBER_TEMPERATURE)),
        );
        out.extend(embers.iter().map(|one| quantised(one.size, size)));
        out.extend(embers.iter().map(|one| quantised(one.age, life)));
        out.extend(embers.iter().map(|one| quantised(one.lifetime, life)));
        out.extend(gas.solid_temperatures().flat_map(|one| one.1.to_le_bytes()));
        // What has broken off a solid is whole again in a restored fire.
        let bodies = self.free_solid_numbers();
        for one in bodies.chunks(11).filter(|one| one.first() == one.last()) {
            let numbers = one.get(1..8).unwrap_or_default().iter().chain(one.get(9));
            out.extend(numbers.flat_map(|number| number.to_le_bytes()));
        }
        Some(out)
    }

    /// Continues from these bytes, with this fire's seed, resampled to its number of particles.
    /// An error changes nothing.
    ///
    /// # Errors
    /// The bytes are damaged, or those of a fire with other values.
    pub fn restore_burning(&mut self, bytes: &[u8]) -> Result<(), BurningError> {
        let mut bytes = Bytes(bytes);
        let header = Header::read(&mut bytes).ok_or(BurningError::Damaged(NO_FIRE))?;
        header.check(bytes.0.len()).map_err(BurningError::Damaged)?;
        let Some(gas) = self.solver.combustion_mut() else {
            return Err(BurningError::OtherValues);
        };
        if header.digest != digest(&self.scene) {
            return Err(BurningError::OtherValues);
        }
        let parameters = self.scene.settings();
        let [velocity, hot, sooty, flight, size, life] = header.scales;
        let air = parameters.ambient_temperature;
        let bounds = crate::combustion::bounds(parameters, header.made_with);

        let columns = Columns::of(&mut bytes, header.particles);
        let particles: Vec<Particle> = (0..header.particles)
            .map(|i| Particle {
                velocity: columns.velocity(i, velocity),
                temperature: air + columns.share(2, i) * hot,
                fuel: columns.share(3, i),
                oxygen: columns.share(4, i),
                soot: columns.share(5, i) * sooty,
                ..Particle::at(columns.position(i, &bounds))
            })
            .collect();
        if particles
            .iter()
            .any(|one| one.broken_rule(&bounds).is_some())
        {
            return Err(BurningError::Damaged(OUT_OF_RANGE));
        }
        let columns = Columns::of(&mut bytes, header.embers);
        let embers = (0..header.embers).map(|i| Ember {
            position: columns.position(i, &bounds),
            velocity: columns.velocity(i, flight),
            temperature: columns.share(2, i) * MAX_EMBER_TEMPERATURE,
            size: columns.share(3, i) * size,
            age: columns.share(4, i) * life,
            lifetime: columns.share(5, i) * life,
        });
        let embers = embers.filter(|one| one.size > 0.0 && one.age < one.lifetime);
        let embers = embers.collect();
        let solids = bytes.numbers();
        let conducting = |one: &&Solid| one.thermal == Thermal::Conducting;
        let count = self.scene.solids().filter(conducting).count();
        let is_free = |one: &&Solid| one.motion == Motion::Free;
        let free = self.scene.solids().filter(is_free).count();
        // Solids of the first version keep their temperatures, free ones of the second their places.
        let fits = match header.version {
            1 | 2 => solids.is_empty() || solids.len() == count,
            _ => solids.len() == count + BODY * free,
        };
        if !fits {
            return Err(BurningError::Damaged(
                "the burning fire has the wrong length",
            ));
        }
        let (solids, bodies) = solids.split_at(count.min(solids.len()));
        let is_hot = |kelvin: &f32| (1.0..=1e5).contains(kelvin);
        if !(solids.iter().all(is_hot) && bodies.chunks(BODY).all(is_body)) {
            return Err(BurningError::Damaged(OUT_OF_RANGE));
        }

        self.random = Random::new(parameters.seed);
        self.time = header.time;
        gas.forget_free();
        gas.resume(
            &particles,
            embers,
            bodies,
            header.made_with,
            &self.scene,
            &mut self.random,
            self.time,
        );
        gas.set_solid_temperatures(solids);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{IN_DOMAIN, Input, Model, Parameters};

    /// The defaults with these values changed and room for twice the particles of the frame.
    fn with(values: &[(&str, f64)]) -> Parameters {
        let mut parameters = Parameters::new(Model::Combustion);
        for &(id, value) in values {
            assert_eq!(parameters.set(id, Input::Number(value)), Ok(()));
        }
        let number = values.iter().any(|&(id, _)| id == "max_particles");
        parameters.complete(false, number, IN_DOMAIN);
        parameters
    }

    fn burnt(parameters: Parameters, seconds: f64) -> Simulation {
        let mut fire = Simulation::new(parameters);
        while fire.time() < seconds {
            fire.step();
        }
        fire
    }

    #[test]
    fn only_parameters_of_the_gas_change_the_digest() {
        let usual = Parameters::new(Model::Combustion);
        for (id, value) in [("exposure", 1.0), ("seed", 7.0), ("max_particles", 1200.0)] {
            assert_eq!(
                digest(&with(&[(id, value)]).into()),
                digest(&usual.clone().into()),
                "{id}"
            );
        }
        for (id, value) in [("fuel_power", 100.0), ("domain_width", 2.0), ("wind", 1.0)] {
            assert_ne!(
                digest(&with(&[(id, value)]).into()),
                digest(&usual.clone().into()),
                "{id}"
            );
        }
        assert_ne!(
            digest(&Parameters::new(Model::Classic).into()),
            digest(&usual.clone().into())
        );
    }

    #[test]
    fn a_restored_fire_continues() {
        let values = with(&[("max_particles", 1000.0), ("ember_rate", 200.0)]);
        let fire = burnt(values.clone(), 0.8);
        let bytes = fire.burning().unwrap_or_default();
        let mut other = Simulation::new(values);
        assert_eq!(other.restore_burning(&bytes), Ok(()));
        assert_eq!((other.time(), other.count()), (fire.time(), fire.count()));
        // Embers beyond the bounds are left out.
        let lost = fire.embers().len() - other.embers().len();
        assert!(50 * lost < fire.embers().len(), "{lost}");
        let hottest = |fire: &Simulation| fire.temperatures().into_iter().fold(0.0, f32::max);
        assert!((hottest(&fire) - hottest(&other)).abs() < 5.0);
        for (before, after) in fire.particles().iter().zip(other.particles()) {
            assert!(before.position.distance(after.position) < 1e-4);
            assert!(before.velocity.distance(after.velocity) < 0.05);
            assert!((before.temperature - after.temperature).abs() < 5.0);
            assert!((before.soot - after.soot).abs() < 0.01);
        }
        // The power is the same a moment later.
        let power = |mut fire: Simulation| {
            for _ in 0..50 {
                fire.step();
            }
            fire.power().unwrap_or_default()
        };
        let (before, after) = (power(fire), power(other));
        assert!(
            (after / before - 1.0).abs() < 0.2,
            "{before} and {after} kW/m"
        );
    }

    #[test]
    fn the_same_bytes_and_seed_give_the_same_bits_at_any_number_of_particles() {
        let bytes = burnt(with(&[("max_particles", 1500.0)]), 0.5).burning();
        let bytes = bytes.unwrap_or_default();
        for n in [1000.0, 1500.0, 3000.0] {
            let [one, other] = [(); 2].map(|()| {
                let mut fire = Simulation::new(with(&[("max_particles", n)]));
                assert_eq!(fire.restore_burning(&bytes), Ok(()));
                for _ in 0..20 {
                    fire.step();
                }
                fire
            });
            assert_eq!(one.particles(), other.particles());
            let found = f64::from(one.parameters().domain_particles());
            assert!((found / n - 1.0).abs() < 0.01, "{found} for {n}");
            assert!(one.temperatures().iter().any(|&kelvin| kelvin > 1000.0));
        }
    }

    #[test]
    fn other_values_and_damaged_bytes_are_errors_and_change_nothing() {
        let values = with(&[("max_particles", 1000.0)]);
        let bytes = burnt(values.clone(), 0.1).burning().unwrap_or_default();
        let mut fire = burnt(with(&[("max_particles", 1000.0), ("wind", 1.0)]), 0.05);
        let before = fire.particles();
        assert_eq!(fire.restore_burning(&bytes), Err(BurningError::OtherValues));
        let mut classic = Simulation::new(Parameters::new(Model::Classic));
        assert_eq!(
            classic.restore_burning(&bytes),
            Err(BurningError::OtherValues)
        );
        assert_eq!(classic.burning(), None);

        let mut damaged: Vec<Vec<u8>> = [0, 3, HEADER - 1, HEADER, bytes.len() - 1]
            .map(|length| bytes[..length].to_vec())
            .to_vec();
        damaged.push([&bytes[..], &[0]].concat());
        // Magic, version, embers, particles, time, and each of the scales.
        for at in [0, 4, 7, 22, 31, 35, 39, 43, 47, 51, 55] {
            let mut wrong = bytes.clone();
            wrong[at] = 0xff;
            damaged.push(wrong);
        }
        for wrong in damaged {
            let refused = fire.restore_burning(&wrong);
            assert!(matches!(refused, Err(BurningError::Damaged(words)) if !words.is_empty()));
        }
        assert_eq!(fire.particles(), before);
    }

    #[test]
    fn any_columns_restore_a_finite_fire() {
        let values = with(&[("max_particles", 1000.0), ("ember_rate", 200.0)]);
        let bytes = burnt(values.clone(), 0.2).burning().unwrap_or_default();
        let mut random = Random::new(3);
        for _ in 0..3 {
            let mut wild = bytes.clone();
            for byte in &mut wild[HEADER..] {
                *byte = random.bits() as u8;
            }
            let mut fire = Simulation::new(values.clone());
            assert_eq!(fire.restore_burning(&wild), Ok(()));
            for _ in 0..20 {
                fire.step();
            }
            assert!(fire.particles().iter().all(|one| one.position.is_finite()));
        }
    }
}
