//! The emitter: births of particles with random lifetimes.
//!
//! Births have a constant rate, spread over the width of the source and the length of the step.
//! Perlin noise modulates the rate in space and time (the paper's §5.3).
//!
//! A particle is born only at a minimum distance from all others. Overlapping births would
//! compress the gas at the source to many times its rest density, and its pressure would
//! explode. So a source emits at most the particles that can leave it.

use glam::Vec2;

use super::particles::{ParticleState, Particles};
use super::solids::MIN_GAP;
use crate::noise::perlin;
use crate::particle::Particle;
use crate::random::Random;
use crate::scene::SceneSource;
use crate::solids::Body;
use crate::source::{self, SourcePlace};

/// Minimum distance between a birth and any other particle, in units of the distance of
/// particles at rest, √(m/ρ₀). It limits the compression of the source to about 1/0.75² = 1.8
/// times the rest density.
const MIN_DISTANCE: f32 = 0.75;

/// Positions tried for a birth before it waits for the next step: on a line, and in the rectangle
/// around a solid, of which only those near the outline count.
const MAX_TRIES: usize = 12;
const MAX_TRIES_AROUND: usize = 96;
/// Distance from the outline of a solid within which they count, in half widths of its narrower
/// side, and at least this many rooms.
const BAND_WIDTH: f32 = 0.1;
const MIN_BAND: f32 = 1.0;

/// Longest time whose births may wait \[s\].
const MAX_WAIT: f32 = 1.0 / 60.0;

/// The fractional part of the golden ratio: its multiples modulo one fill an interval more
/// evenly than random numbers do.
const GOLDEN_RATIO_PART: f32 = 0.618_034;

/// Lattice cells of the emission noise per metre of the source.
const NOISE_PER_METRE: f32 = 12.0;
/// Lattice cells of the emission noise per second.
const NOISE_PER_SECOND: f64 = 3.0;

/// The emitter of one source.
#[derive(Clone, Debug, Default)]
pub(crate) struct Emitter {
    /// Births that are due.
    pub backlog: f32,
    /// Position of the next birth along the source, 0–1.
    along: f32,
    /// Positions near the source, births included.
    near: Vec<Vec2>,
}

crate::state! { Emitter: backlog along; near }

impl Emitter {
    /// The births that are due at `time`, `passed` seconds after the last ones.
    pub fn due(&mut self, values: &SceneSource<'_>, passed: f32, time: f64) -> f32 {
        let flicker = perlin(values.seed, 0.5, time * NOISE_PER_SECOND);
        let rate = values.rate * (1.0 + values.noise * flicker);
        // The backlog is at least the births of one step and a fraction of a birth.
        let max_backlog = 1.0 + rate * values.world.time_step.max(MAX_WAIT);
        self.backlog = (self.backlog + rate * passed).min(max_backlog);
        self.backlog
    }

    /// Emits the particles that are due, until there are `most`.
    pub fn emit(
        &mut self,
        particles: &mut Particles,
        (values, solid): (&SceneSource<'_>, &[Body]),
        most: usize,
        random: &mut Random,
        time: f64,
    ) {
        if self.backlog < 1.0 {
            return;
        }

        let source = Source::new(values, solid, time);
        self.find_near(particles, &source);
        while self.backlog >= 1.0 && particles.len() < most {
            let Some(particle) = self.try_spawn(values, &source, random) else {
                break;
            };
            self.near.push(particle.position);
            particles.push(particle);
            self.backlog -= 1.0;
        }
    }

    /// Finds the particles near the source.
    fn find_near(&mut self, particles: &Particles, source: &Source) {
        let Source {
            middle,
            half_width,
            room,
            rise,
            ..
        } = *source;
        let reach = match source.axis {
            None => Vec2::new(half_width + room, rise + room),
            Some(_) => Vec2::splat(half_width + rise + room),
        };
        self.near.clear();
        self.near.extend(
            particles
                .iter()
                .map(ParticleState::position)
                .filter(|&position| {
                    let offset = (position - middle).abs();
                    let on_line = offset.x < reach.x && offset.y < reach.y;
                    let mut solid = source.solid.iter();
                    match source.solid {
                        [] => on_line,
                        _ => solid.any(|body| body.may_touch(position, rise + 2.0 * room)),
                    }
                }),
        );
    }

    fn try_spawn(
        &mut self,
        values: &SceneSource<'_>,
        source: &Source,
        random: &mut Random,
    ) -> Option<Particle> {
        let tries = match source.solid {
            [] => MAX_TRIES,
            _ => MAX_TRIES_AROUND,
        };
        for _ in 0..tries {
            let Some(place) = self.place(values, source, random) else {
                continue;
            };
            let intensity = source.intensity(values, place.along);
            if random.unit() * (1.0 + values.noise) > intensity {
                continue;
            }

            // The spread turns the jet by at most 45° and only reduces its speed, so that the
            // emission speed is the maximum.
            let sideways = values.spread * random.between(-1.0, 1.0);
            let inward = -0.5 * values.taper * place.across / source.half_width;
            let slower = 1.0 - 0.5 * values.spread * random.unit();
            let speed = values.speed * slower * intensity.min(1.0);
            let velocity = Vec2::new(sideways + inward, 1.0).normalize() * speed;

            let age = random.unit() * values.world.time_step;
            let from = Vec2::new(place.across, velocity.y * age);
            let (position, velocity) = match place.axis {
                None => (place.from + from, velocity),
                Some(axis) => (place.from + axis.rotate(from), axis.rotate(velocity)),
            };
            if place.axis.is_some() && !source::contains(values.world, position) {
                continue;
            }
            let room = source.room * source.room;
            if self
                .near
                .iter()
                .any(|other| other.distance_squared(position) < room)
            {
                continue;
            }
            let longest_life = source.longest_life(values, place.across);
            return Some(Particle {
                velocity,
                temperature: values.birth_temperature,
                age,
                lifetime: random.between(values.life_min, longest_life),
                ..Particle::at(position)
            });
        }
        None
    }

    /// The place of a birth; `None` if it is not near the outline of the solid.
    fn place(
        &mut self,
        values: &SceneSource<'_>,
        source: &Source,
        random: &mut Random,
    ) -> Option<Place> {
        self.along = (self.along + GOLDEN_RATIO_PART).fract();
        let across = 2.0 * self.along - 1.0;
        let part = match source.solid.len() {
            0 | 1 => 0,
            parts => random.bits() as usize % parts,
        };
        let Some(body) = source.solid.get(part) else {
            let x = across * source.half_width;
            return Some(Place {
                from: source.middle,
                axis: source.axis,
                across: x,
                along: x,
            });
        };
        let frame = &body.surface.frame;
        let size = frame.half + frame.radius;
        let band = BAND_WIDTH * size.min_element() + MIN_BAND * source.room;
        let local = (size + band) * Vec2::new(across, random.between(-1.0, 1.0));
        let position = frame.centre + frame.axis.rotate(local);
        let (distance, normal) = body.surface.distance(position);
        (distance > 0.0 && distance < band).then(|| Place {
            from: position - normal * (distance - MIN_GAP * values.world.smoothing_radius),
            axis: Some(-normal.perp()),
            across: 0.0,
            along: source::along(local),
        })
    }
}

/// The position and width of the source, clamped to the domain.
pub(crate) fn place(values: &SceneSource<'_>) -> SourcePlace {
    let rise = values.speed * values.world.time_step;
    let top = (values.world.domain_height - rise).max(0.0);
    let width = values.width.min(values.world.domain_width);
    SourcePlace {
        base: Vec2::new(source::middle(values, width, 0.0), values.y.min(top)),
        width,
        on_solid: false,
    }
}

/// The place of a birth.
struct Place {
    /// A point of the source \[m\].
    from: Vec2,
    /// Direction of the source there if it is turned.
    axis: Option<Vec2>,
    /// Distance from that point along a line \[m\].
    across: f32,
    /// How far along the source it is for the noise \[m\].
    along: f32,
}

/// The source during one step.
struct Source<'a> {
    middle: Vec2,
    half_width: f32,
    /// Direction of its width if it is turned.
    axis: Option<Vec2>,
    /// The solid whose surface it is, and its images; empty if it is a line.
    solid: &'a [Body],
    /// Largest rise of a particle in the step of its birth \[m\].
    rise: f32,
    /// Minimum distance from another particle \[m\].
    room: f32,
    /// Time of the fire \[s\].
    time: f64,
}

impl Source<'_> {
    fn new<'a>(values: &SceneSource<'_>, solid: &'a [Body], time: f64) -> Source<'a> {
        let place = place(values);
        Source {
            middle: place.base,
            half_width: 0.5 * place.width,
            axis: source::axis(values),
            solid,
            rise: values.speed * values.world.time_step,
            room: MIN_DISTANCE * (values.world.particle_mass / values.world.rest_density).sqrt(),
            time,
        }
    }

    /// Longest life of a particle born at `x` \[s\].
    fn longest_life(&self, values: &SceneSource<'_>, x: f32) -> f32 {
        let longest = values.life_max.max(values.life_min);
        let off_centre = (x / self.half_width).abs();
        longest - values.taper * off_centre * (longest - values.life_min)
    }

    /// Relative emission rate at `x`, one on average.
    fn intensity(&self, values: &SceneSource<'_>, x: f32) -> f32 {
        // Not the seed of the flicker, so that the two are independent.
        let noise = perlin(
            values.seed ^ 0x5EED,
            x * NOISE_PER_METRE,
            self.time * NOISE_PER_SECOND,
        );
        1.0 + values.noise * noise
    }
}
