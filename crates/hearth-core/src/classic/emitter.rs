//! The source: particles are born, each with a life of its own.
//!
//! Births come at a steady rate, spread over the source's width and over the
//! length of the step. Perlin noise lets some parts of the source burn more
//! than others, and drift (the paper's §5.3).
//!
//! A particle is born only where there is room. Births on top of each other
//! would compress the gas at the source to many times its rest density, and
//! what the pressure then does is an explosion, not a fire. So a source that
//! is asked for more than can leave it gives what can leave it.

use glam::Vec2;

use super::particles::{ParticleState, Particles};
use crate::noise::perlin;
use crate::params::Physics;
use crate::particle::Particle;
use crate::random::Random;
use crate::source;

/// Least distance between a birth and any other particle, in units of the
/// distance of particles at rest, √(m/ρ₀). It lets the source be compressed to
/// about 1/0.75² = 1.8 times the rest density.
const ROOM: f32 = 0.75;

/// Places that are tried for a birth before it has to wait.
const TRIES: usize = 12;

/// Longest time whose births may wait for room or for a place under the cap \[s\].
const PATIENCE: f32 = 1.0 / 60.0;

/// The golden ratio's fraction: successive multiples, taken modulo one, fill
/// an interval more evenly than chance does.
const GOLDEN: f32 = 0.618_034;

/// Lattice cells of the emission noise for each metre of the source.
const NOISE_PER_METRE: f32 = 12.0;
/// Lattice cells of the emission noise for each second.
const NOISE_PER_SECOND: f64 = 3.0;

/// The source of particles.
#[derive(Clone, Debug, Default)]
pub(crate) struct Emitter {
    /// Births that are due and have not happened.
    owed: f32,
    /// Where along the source the next place is, 0–1.
    along: f32,
    /// Positions near the source, the newborn included.
    near: Vec<Vec2>,
}

impl Emitter {
    /// Lets the particles be born that are due in a step from `time` on.
    pub fn emit(
        &mut self,
        particles: &mut Particles,
        values: &Physics,
        random: &mut Random,
        time: f64,
    ) {
        let flicker = perlin(values.seed, 0.5, time * NOISE_PER_SECOND);
        let rate = values.emission_rate * (1.0 + values.emission_noise * flicker);
        // What a step itself brings is never cut: beyond it, and beyond the
        // part of a birth that is left over, nothing waits longer.
        let patience = 1.0 + rate * values.time_step.max(PATIENCE);
        self.owed = (self.owed + rate * values.time_step).min(patience);
        if self.owed < 1.0 {
            return;
        }

        let source = Source::new(values, time);
        self.find_near(particles, &source);
        while self.owed >= 1.0 && particles.len() < values.max_particles as usize {
            let Some(particle) = self.newborn(values, &source, random) else {
                break;
            };
            self.near.push(particle.position);
            particles.push(particle);
            self.owed -= 1.0;
        }
    }

    /// Finds the particles that a birth could come too close to.
    fn find_near(&mut self, particles: &Particles, source: &Source) {
        let Source {
            middle,
            half_width,
            room,
            ..
        } = *source;
        let reach = Vec2::new(half_width + room, source.rise + room);
        self.near.clear();
        self.near.extend(
            particles
                .iter()
                .map(ParticleState::position)
                .filter(|&position| {
                    let offset = (position - middle).abs();
                    offset.x < reach.x && offset.y < reach.y
                }),
        );
    }

    fn newborn(
        &mut self,
        values: &Physics,
        source: &Source,
        random: &mut Random,
    ) -> Option<Particle> {
        for _ in 0..TRIES {
            self.along = (self.along + GOLDEN).fract();
            let x = (2.0 * self.along - 1.0) * source.half_width;
            let vigour = source.vigour(values, x);
            if random.unit() * (1.0 + values.emission_noise) > vigour {
                continue;
            }

            // The spread turns the jet aside, by 45° at most, and takes from its
            // speed; it never adds, so that the emission speed is the fastest.
            let aside = values.emission_spread * random.between(-1.0, 1.0);
            let inward = -0.5 * values.taper * x / source.half_width;
            let slower = 1.0 - 0.5 * values.emission_spread * random.unit();
            let speed = values.emission_speed * slower * vigour.min(1.0);
            let velocity = Vec2::new(aside + inward, 1.0).normalize() * speed;

            let age = random.unit() * values.time_step;
            let position = source.middle + Vec2::new(x, velocity.y * age);
            let room = source.room * source.room;
            if self
                .near
                .iter()
                .any(|other| other.distance_squared(position) < room)
            {
                continue;
            }
            return Some(Particle {
                velocity,
                temperature: values.maximum_temperature,
                age,
                lifetime: random.between(values.lifetime_min, source.longest_life(values, x)),
                ..Particle::at(position)
            });
        }
        None
    }
}

/// Where the source of these values is, and how wide what of it is inside the domain.
pub(crate) fn place(values: &Physics) -> source::Source {
    let rise = values.emission_speed * values.time_step;
    let top = (values.domain_height - rise).max(0.0);
    let width = values.source_width.min(values.domain_width);
    source::Source {
        base: Vec2::new(
            source::middle(values, width, 0.0),
            values.source_height.min(top),
        ),
        width,
    }
}

/// The source during one step.
struct Source {
    middle: Vec2,
    half_width: f32,
    /// How far a particle may rise within the step in which it is born \[m\].
    rise: f32,
    /// Least distance from another particle \[m\].
    room: f32,
    /// Time of the fire \[s\].
    time: f64,
}

impl Source {
    fn new(values: &Physics, time: f64) -> Source {
        let place = place(values);
        Source {
            middle: place.base,
            half_width: 0.5 * place.width,
            rise: values.emission_speed * values.time_step,
            room: ROOM * (values.particle_mass / values.rest_density).sqrt(),
            time,
        }
    }

    /// Longest life of a particle that is born at `x` \[s\].
    fn longest_life(&self, values: &Physics, x: f32) -> f32 {
        let longest = values.lifetime_max.max(values.lifetime_min);
        let off_centre = (x / self.half_width).abs();
        longest - values.taper * off_centre * (longest - values.lifetime_min)
    }

    /// How hard the source burns at `x`, one on average.
    fn vigour(&self, values: &Physics, x: f32) -> f32 {
        // Another seed than the flicker's, or both would beat in time.
        let noise = perlin(
            values.seed ^ 0x5EED,
            x * NOISE_PER_METRE,
            self.time * NOISE_PER_SECOND,
        );
        1.0 + values.emission_noise * noise
    }
}
