//! A burning fire as bytes, so that a page can open on one.
//!
//! [`Simulation::burning`] writes a fire of the combustion model,
//! [`Simulation::restore_burning`] takes it up. The bytes are small and lose a little:
//! a place has 16 bits an axis, every other quantity 8. All numbers are little-endian.
//!
//! | bytes | what |
//! |---|---|
//! | 4 | `Fire` |
//! | 2, 2 | [`VERSION`]; number of embers |
//! | 8 | [`digest`] of the values that it burnt with |
//! | 4, 4 | `max_particles` that it burnt with; number of particles |
//! | 8 | time \[s\] |
//! | 4 × 6 | largest velocity, excess temperature and soot; of embers, velocity, size and life |
//! | particles × 10 | x, y (2 each), u, v, temperature, fuel, oxygen, soot (1 each), column by column |
//! | embers × 10 | x, y (2 each), u, v, temperature, size, age, life (1 each), column by column |
//!
//! A velocity is stored as the root of its share of the largest, so that slow gas loses
//! little.

use std::fmt;

use super::{Gas, Simulation, fault};
use crate::combustion::Ember;
use crate::params::{Parameters, Role, Value};
use crate::particle::Particle;
use crate::random::Random;
use glam::Vec2;

/// The version of the form.
pub const VERSION: u16 = 1;

const MAGIC: &[u8; 4] = b"Fire";
const HEADER: usize = 56;
/// Bytes of a particle, and of an ember.
const EACH: usize = 10;
/// Most embers that are stored.
const EMBERS: usize = 1000;
/// Temperature of an ember at birth, which only falls \[K\].
const HOTTEST_EMBER: f32 = 2500.0;
/// Longest time that is believed \[s\].
const LONGEST: f64 = 1e6;

/// A number for all values that the gas depends on: fires of the same digest burn alike.
/// Values at their default do not count, so that a new parameter changes none; nor do the
/// seed, which a fire has left behind, and the number of particles, since any number of
/// particles can take over.
pub fn digest(parameters: &Parameters) -> u64 {
    let mut hash = fnv(0xcbf2_9ce4_8422_2325, parameters.model().name().as_bytes());
    for (param, value) in parameters.changed() {
        if param.role != Role::Physics || param.id == "seed" || param.id == "max_particles" {
            continue;
        }
        hash = fnv(hash, param.id.as_bytes());
        let number = match value {
            Value::Number(x) => x.to_bits(),
            Value::Integer(n) | Value::Seed(n) => n,
            Value::Flag(on) => on.into(),
            Value::Choice(name) => {
                hash = fnv(hash, name.as_bytes());
                continue;
            }
            Value::Colour(_) => continue,
        };
        hash = fnv(hash, &number.to_le_bytes());
    }
    hash
}

/// The hash of Fowler, Noll and Vo (FNV-1a) of these bytes after those hashed before.
// Three callers: a copy in each is half a kilobyte of download.
#[inline(never)]
fn fnv(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// Why bytes are no fire that can be taken up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BurningError {
    /// They burnt with other values, or in another model: nothing is wrong with them.
    Other,
    /// They are damaged, in words.
    Damaged(&'static str),
}

impl fmt::Display for BurningError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            BurningError::Other => "the burning fire is one of other values",
            BurningError::Damaged(words) => words,
        })
    }
}

impl std::error::Error for BurningError {}

impl Simulation {
    /// This fire as bytes; none in the classic model.
    pub fn burning(&self) -> Option<Vec<u8>> {
        let Gas::Combustion(_) = &self.gas else {
            return None;
        };
        let (particles, air) = (self.particles(), self.parameters.ambient_temperature);
        let embers = &self.embers()[..self.embers().len().min(EMBERS)];
        let most = |all: &mut dyn Iterator<Item = f32>| all.fold(0.0, f32::max);
        let speed = |velocity: Vec2| velocity.abs().max_element();
        let scales = [
            most(&mut particles.iter().map(|one| speed(one.velocity))),
            most(&mut particles.iter().map(|one| one.temperature - air)),
            most(&mut particles.iter().map(|one| one.soot)),
            most(&mut embers.iter().map(|one| speed(one.velocity))),
            most(&mut embers.iter().map(|one| one.size)),
            most(&mut embers.iter().map(|one| one.lifetime)),
        ];
        let [velocity, hot, sooty, flight, size, life] = scales;

        let mut out = Vec::with_capacity(HEADER + EACH * (particles.len() + embers.len()));
        out.extend(MAGIC);
        out.extend(VERSION.to_le_bytes());
        out.extend((embers.len() as u16).to_le_bytes());
        out.extend(digest(&self.parameters).to_le_bytes());
        out.extend(self.parameters.max_particles.to_le_bytes());
        out.extend((particles.len() as u32).to_le_bytes());
        out.extend(self.time.to_le_bytes());
        for scale in scales {
            out.extend(scale.to_le_bytes());
        }
        self.write_places(&mut out, particles.iter().map(|one| one.position));
        out.extend(particles.iter().map(|one| signed(one.velocity.x, velocity)));
        out.extend(particles.iter().map(|one| signed(one.velocity.y, velocity)));
        out.extend(
            particles
                .iter()
                .map(|one| share(one.temperature - air, hot)),
        );
        out.extend(particles.iter().map(|one| share(one.fuel, 1.0)));
        out.extend(particles.iter().map(|one| share(one.oxygen, 1.0)));
        out.extend(particles.iter().map(|one| share(one.soot, sooty)));
        self.write_places(&mut out, embers.iter().map(|one| one.position));
        out.extend(embers.iter().map(|one| signed(one.velocity.x, flight)));
        out.extend(embers.iter().map(|one| signed(one.velocity.y, flight)));
        out.extend(
            embers
                .iter()
                .map(|one| share(one.temperature, HOTTEST_EMBER)),
        );
        out.extend(embers.iter().map(|one| share(one.size, size)));
        out.extend(embers.iter().map(|one| share(one.age, life)));
        out.extend(embers.iter().map(|one| share(one.lifetime, life)));
        Some(out)
    }

    fn write_places(&self, out: &mut Vec<u8>, places: impl Iterator<Item = Vec2> + Clone) {
        let (width, height) = (self.parameters.domain_width, self.parameters.domain_height);
        let across = |part: f32| (part * 65_536.0).clamp(0.0, 65_535.0) as u16;
        out.extend(
            places
                .clone()
                .flat_map(|at| across(at.x / width + 0.5).to_le_bytes()),
        );
        out.extend(places.flat_map(|at| across(at.y / height).to_le_bytes()));
    }

    /// Burns on from these bytes, with its own seed. Where they burnt with another number
    /// of particles, as many as this fire has take over. Nothing changes where they are refused.
    ///
    /// # Errors
    /// The bytes are damaged, or burnt with other values.
    pub fn restore_burning(&mut self, bytes: &[u8]) -> Result<(), BurningError> {
        let mut bytes = Bytes(bytes);
        let head = Head::read(&mut bytes).ok_or(BurningError::Damaged(NO_FIRE))?;
        head.check(bytes.0.len()).map_err(BurningError::Damaged)?;
        let Gas::Combustion(gas) = &mut self.gas else {
            return Err(BurningError::Other);
        };
        if head.digest != digest(&self.parameters) {
            return Err(BurningError::Other);
        }
        let parameters = &self.parameters;
        let [velocity, hot, sooty, flight, size, life] = head.scales;
        let air = parameters.ambient_temperature;
        let domain = Vec2::new(parameters.domain_width, parameters.domain_height);

        let columns = Columns::of(&mut bytes, head.particles);
        let particles: Vec<Particle> = (0..head.particles)
            .map(|i| Particle {
                velocity: columns.velocity(i, velocity),
                temperature: air + columns.share(2, i) * hot,
                fuel: columns.share(3, i),
                oxygen: columns.share(4, i),
                soot: columns.share(5, i) * sooty,
                ..Particle::at(columns.place(i, domain))
            })
            .collect();
        let bounds = crate::combustion::bounds(parameters);
        for particle in &particles {
            if let Some(what) = fault(particle, &bounds) {
                return Err(BurningError::Damaged(what));
            }
        }
        let columns = Columns::of(&mut bytes, head.embers);
        let embers = (0..head.embers).map(|i| Ember {
            position: columns.place(i, domain),
            velocity: columns.velocity(i, flight),
            temperature: columns.share(2, i) * HOTTEST_EMBER,
            size: columns.share(3, i) * size,
            age: columns.share(4, i) * life,
            lifetime: columns.share(5, i) * life,
        });
        let embers = embers.filter(|one| one.size > 0.0 && one.age < one.lifetime);

        self.random = Random::new(parameters.seed);
        gas.resume(
            &particles,
            embers.collect(),
            head.made_with,
            parameters,
            &mut self.random,
        );
        self.time = head.time;
        Ok(())
    }
}

const NO_FIRE: &str = "these bytes are no burning fire";

/// What stands before the columns.
struct Head {
    version: u16,
    embers: usize,
    digest: u64,
    made_with: u32,
    particles: usize,
    time: f64,
    scales: [f32; 6],
}

impl Head {
    fn read(bytes: &mut Bytes<'_>) -> Option<Head> {
        if bytes.take::<4>()? != *MAGIC {
            return None;
        }
        let version = u16::from_le_bytes(bytes.take()?);
        let embers = u16::from_le_bytes(bytes.take()?).into();
        let digest = u64::from_le_bytes(bytes.take()?);
        let made_with = u32::from_le_bytes(bytes.take()?);
        let particles = u32::from_le_bytes(bytes.take()?) as usize;
        let time = f64::from_le_bytes(bytes.take()?);
        let mut scales = [0.0; 6];
        for scale in &mut scales {
            *scale = f32::from_le_bytes(bytes.take()?);
        }
        Some(Head {
            version,
            embers,
            digest,
            made_with,
            particles,
            time,
            scales,
        })
    }

    /// What is wrong with it, where so many bytes follow.
    fn check(&self, rest: usize) -> Result<(), &'static str> {
        // Enough for any fire, and few enough that no sum below overflows.
        let few = 1..=100_000;
        if self.version != VERSION {
            return Err("the burning fire is of another version");
        }
        if !few.contains(&self.particles) || self.embers > EMBERS {
            return Err("the burning fire has no such number of particles");
        }
        if rest != EACH * (self.particles + self.embers) {
            return Err("the burning fire is cut short, or too long");
        }
        let [velocity, hot, sooty, rest @ ..] = self.scales;
        let good = (0.0..=500.0).contains(&velocity)
            && (0.0..=20_000.0).contains(&hot)
            && (0.0..=10.0).contains(&sooty)
            && rest.iter().all(|scale| (0.0..=500.0).contains(scale))
            && (0.0..=LONGEST).contains(&self.time);
        if good {
            Ok(())
        } else {
            Err("the burning fire is beyond all measure")
        }
    }
}

/// What is left to be read.
struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }

    /// The next so many; all that there are, where those are fewer.
    fn split(&mut self, count: usize) -> &'a [u8] {
        let (first, rest) = self.0.split_at(count.min(self.0.len()));
        self.0 = rest;
        first
    }
}

/// The columns of particles or of embers.
struct Columns<'a> {
    places: [&'a [u8]; 2],
    shares: [&'a [u8]; 6],
}

impl<'a> Columns<'a> {
    fn of(bytes: &mut Bytes<'a>, count: usize) -> Columns<'a> {
        Columns {
            places: std::array::from_fn(|_| bytes.split(2 * count)),
            shares: std::array::from_fn(|_| bytes.split(count)),
        }
    }

    fn share(&self, column: usize, i: usize) -> f32 {
        let byte = self.shares[column].get(i).copied().unwrap_or(0);
        f32::from(byte) / 255.0
    }

    fn place(&self, i: usize, domain: Vec2) -> Vec2 {
        let part = |axis: usize| {
            let two = self.places[axis].get(2 * i..2 * i + 2);
            let [low, high] = two.and_then(|two| two.try_into().ok()).unwrap_or([0; 2]);
            (f32::from(u16::from_le_bytes([low, high])) + 0.5) / 65_536.0
        };
        Vec2::new(part(0) - 0.5, part(1)) * domain
    }

    fn velocity(&self, i: usize, largest: f32) -> Vec2 {
        let one = |column: usize| {
            let byte = self.shares[column].get(i).copied().unwrap_or(128);
            let root = (f32::from(byte) - 128.0) / 127.0;
            root * root.abs() * largest
        };
        Vec2::new(one(0), one(1))
    }
}

/// A share of the largest in eight bits.
fn share(value: f32, largest: f32) -> u8 {
    let part = if largest > 0.0 { value / largest } else { 0.0 };
    (part * 255.0 + 0.5).clamp(0.0, 255.0) as u8
}

/// A signed share of the largest as its root, 128 for none.
fn signed(value: f32, largest: f32) -> u8 {
    let part = if largest > 0.0 { value / largest } else { 0.0 };
    let root = part.abs().sqrt().min(1.0) * 127.0;
    (128.5 + root.copysign(part)).clamp(1.0, 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{Input, Model};

    fn with(values: &[(&str, f64)]) -> Parameters {
        let mut parameters = Parameters::new(Model::Combustion);
        for &(id, value) in values {
            assert_eq!(parameters.set(id, Input::Number(value)), Ok(()));
        }
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
    fn what_is_no_matter_of_the_gas_is_a_parameter_and_changes_no_digest() {
        let usual = Parameters::new(Model::Combustion);
        for (id, value) in [("exposure", 1.0), ("seed", 7.0), ("max_particles", 1200.0)] {
            assert_eq!(digest(&with(&[(id, value)])), digest(&usual), "{id}");
        }
        for (id, value) in [("fuel_power", 100.0), ("domain_width", 2.0), ("wind", 1.0)] {
            assert_ne!(digest(&with(&[(id, value)])), digest(&usual), "{id}");
        }
        assert_ne!(digest(&Parameters::new(Model::Classic)), digest(&usual));
    }

    #[test]
    fn a_fire_that_is_taken_up_burns_on_where_it_was() {
        let values = with(&[("max_particles", 1000.0), ("ember_rate", 200.0)]);
        let fire = burnt(values.clone(), 0.8);
        let bytes = fire.burning().unwrap_or_default();
        let mut other = Simulation::new(values);
        assert_eq!(other.restore_burning(&bytes), Ok(()));
        assert_eq!((other.time(), other.count()), (fire.time(), fire.count()));
        assert_eq!(other.embers().len(), fire.embers().len());
        let hottest = |fire: &Simulation| fire.temperatures().into_iter().fold(0.0, f32::max);
        assert!((hottest(&fire) - hottest(&other)).abs() < 5.0);
        for (before, after) in fire.particles().iter().zip(other.particles()) {
            assert!(before.position.distance(after.position) < 1e-4);
            assert!(before.velocity.distance(after.velocity) < 0.05);
            assert!((before.temperature - after.temperature).abs() < 5.0);
            assert!((before.soot - after.soot).abs() < 0.01);
        }
        // And the power is the same a moment later: nothing bursts or goes out.
        let power = |mut fire: Simulation| {
            for _ in 0..50 {
                fire.step();
            }
            fire.power()
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
            let count = one.count() as f64;
            assert!((count / n - 1.0).abs() < 0.06, "{count} of {n}");
            assert!(one.temperatures().iter().any(|&kelvin| kelvin > 1000.0));
        }
    }

    #[test]
    fn other_values_and_damaged_bytes_are_refused_and_change_nothing() {
        let values = with(&[("max_particles", 1000.0)]);
        let bytes = burnt(values.clone(), 0.1).burning().unwrap_or_default();
        let mut fire = burnt(with(&[("max_particles", 1000.0), ("wind", 1.0)]), 0.05);
        let before = fire.particles();
        assert_eq!(fire.restore_burning(&bytes), Err(BurningError::Other));
        let mut classic = Simulation::new(Parameters::new(Model::Classic));
        assert_eq!(classic.restore_burning(&bytes), Err(BurningError::Other));
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
    fn whatever_the_columns_hold_is_a_fire() {
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
