//! Embers: sparks that the fire emits and its flow carries.
//!
//! They are the paper's emitter in a domain full of air: each is born in the flames with a
//! random lifetime, is dragged by the gas, falls by its weight, cools by radiation and dies.

use glam::Vec2;

use crate::bounds::Bounds;
use crate::combustion::gas::Gas;
use crate::extremes::fast_min;
use crate::grid::Grid;
use crate::instance::{EmberParticle, Instance};
use crate::kernel::Kernel;
use crate::params::Physics;
use crate::random::Random;
use crate::solids::{Body, Solids};

/// A spark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ember {
    /// Position \[m\].
    pub position: Vec2,
    /// Velocity [m/s].
    pub velocity: Vec2,
    /// Temperature \[K\].
    pub temperature: f32,
    /// Diameter \[m\].
    pub size: f32,
    /// Time since birth \[s\].
    pub age: f32,
    /// Age at which it dies \[s\].
    pub lifetime: f32,
}

/// Temperature at birth \[K\].
const BIRTH_TEMPERATURE: f32 = 1750.0;
/// Gas hotter than this emits embers \[K\].
const FLAME_TEMPERATURE: f32 = 900.0;
/// Drag response time of an ember of 4 mm \[s\], in proportion to the size. The settling speed
/// in air is g times this.
const RESPONSE_TIME: f32 = 0.035;
const RESPONSE_SIZE: f32 = 0.004;
/// Largest ejection speed of embers, relative to the gas [m/s].
const EJECTION_SPEED: f32 = 0.8;
/// Share of the embers that a pop of the wood throws; their largest ejection speed [m/s]; and their size, as a share
/// of the parameter.
const POP_SHARE: f32 = 0.01;
const POP_SPEED: f32 = 6.0;
const POP_SIZE: f32 = 2.0;
/// Largest ejection velocity of embers that a caller throws, to each side and upwards [m/s].
const USER_EJECTION_SPEED: Vec2 = Vec2::new(0.9, 2.2);
/// Most embers after a caller throws some.
const MAX_EMBERS: usize = 4000;
/// Smallest size, as a share of the parameter.
const MIN_SIZE: f32 = 0.4;
/// Share of its speed that an ember keeps when it bounces.
const RESTITUTION: f32 = 0.5;
/// Longest time whose births may wait for flames \[s\].
const MAX_WAIT: f32 = 1.0 / 30.0;

/// All embers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Embers {
    alive: Vec<Ember>,
    /// Births that are due.
    backlog: f32,
    /// Count of all births, and the sum of their places \[m\].
    pub thrown: (f64, f64),
    /// Count of those that a pop threw.
    pub popped: f64,
}

crate::state! { Ember: position velocity temperature size age lifetime, Embers: alive backlog thrown popped }

impl Embers {
    /// Embers from a list.
    pub fn of(alive: Vec<Ember>) -> Embers {
        Embers {
            alive,
            ..Embers::default()
        }
    }

    pub fn alive(&self) -> &[Ember] {
        &self.alive
    }

    /// Emits, moves, cools and removes embers for `dt`.
    pub fn drift(&mut self, air: &Air, values: &Physics, random: &mut Random, dt: f32) {
        self.emit(air.gas, values, random, dt);
        for ember in &mut self.alive {
            let flow = air.velocity_at(ember.position);
            let response_time = RESPONSE_TIME * (ember.size / RESPONSE_SIZE);
            // Implicit, so that the drag of tiny embers is stable.
            let weight = Vec2::new(0.0, -values.gravity);
            let share = dt / response_time;
            ember.velocity = (ember.velocity + flow * share + weight * dt) / (1.0 + share);
            ember.position += ember.velocity * dt;
            ember.age += dt;
            let relative = ember.temperature / 1500.0;
            let lost = values.radiative_cooling * relative * relative * relative * relative * dt;
            ember.temperature = (ember.temperature - lost).max(values.ambient_temperature);
        }
        for ember in &mut self.alive {
            for body in &air.solids.bodies {
                if body.may_touch(ember.position, 0.0) {
                    bounce(ember, body);
                }
            }
        }
        // Embers that leave the domain are removed; they do not come back over a periodic edge.
        self.alive
            .retain(|ember| ember.age < ember.lifetime && air.bounds.contains(ember.position));
    }

    fn emit(&mut self, gas: &Gas, values: &Physics, random: &mut Random, dt: f32) {
        let max_backlog = 1.0 + values.ember_rate * MAX_WAIT;
        self.backlog = (self.backlog + values.ember_rate * dt).min(max_backlog);
        if values.ember_rate == 0.0 {
            self.backlog = 0.0;
        }
        while self.backlog >= 1.0 {
            let Some(i) = random_flame(gas, random) else {
                return;
            };
            let sideways = random.between(-0.5, 0.5);
            let upwards = random.unit();
            let pops = upwards >= 1.0 - POP_SHARE;
            let speed = if pops { POP_SPEED } else { EJECTION_SPEED };
            let thrown = Vec2::new(sideways, upwards) * speed;
            self.spawn(gas.position[i], gas.velocity[i] + thrown, values, random);
            if let Some(ember) = self.alive.last_mut().filter(|_| pops) {
                ember.size = POP_SIZE * values.ember_size;
                ember.lifetime = values.ember_life_max.max(values.ember_life_min);
                self.popped += 1.0;
            }
            self.backlog -= 1.0;
        }
    }

    /// Throws this number of embers from a position, up to [`MAX_EMBERS`] in total.
    pub fn throw_from(&mut self, place: Vec2, count: u32, values: &Physics, random: &mut Random) {
        let room = MAX_EMBERS.saturating_sub(self.alive.len());
        for _ in 0..room.min(count as usize) {
            let direction = Vec2::new(random.between(-1.0, 1.0), random.unit());
            self.spawn(place, direction * USER_EJECTION_SPEED, values, random);
        }
    }

    fn spawn(&mut self, position: Vec2, velocity: Vec2, values: &Physics, random: &mut Random) {
        let (count, moment) = self.thrown;
        self.thrown = (count + 1.0, moment + f64::from(position.x));
        let longest = values.ember_life_max.max(values.ember_life_min);
        self.alive.push(Ember {
            position,
            velocity,
            temperature: BIRTH_TEMPERATURE,
            size: values.ember_size * random.between(MIN_SIZE, 1.0),
            age: 0.0,
            lifetime: random.between(values.ember_life_min, longest),
        });
    }

    /// Writes the instances for the renderer.
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        out.extend(self.alive.iter().map(|ember| {
            Instance::from(EmberParticle {
                position: ember.position,
                velocity: ember.velocity,
                temperature: ember.temperature,
                size: ember.size,
                age: ember.age,
                life: 1.0 - ember.age / ember.lifetime,
            })
        }));
    }
}

/// Returns an ember that is in a solid to its surface.
fn bounce(ember: &mut Ember, body: &Body) {
    let (distance, normal) = body.surface.distance(ember.position);
    if distance < 0.0 {
        ember.position -= normal * distance;
        let wall = body.velocity_at(ember.position);
        let inward = fast_min((ember.velocity - wall).dot(normal), 0.0);
        ember.velocity -= normal * (inward * (1.0 + RESTITUTION));
    }
}

/// A random particle of the flames.
fn random_flame(gas: &Gas, random: &mut Random) -> Option<usize> {
    let hot = || (0..gas.len()).filter(|&i| gas.state[i].x > FLAME_TEMPERATURE);
    let chosen = (random.unit() * hot().count() as f32) as usize;
    hot().nth(chosen)
}

/// The gas around the embers, in the order of the grid.
pub(crate) struct Air<'a> {
    pub gas: &'a Gas,
    pub grid: &'a Grid,
    pub bounds: &'a Bounds,
    pub kernel: &'a Kernel,
    /// Velocity where there is no gas [m/s].
    pub wind: Vec2,
    pub solids: &'a Solids,
}

impl Air<'_> {
    /// Velocity of the gas at a position: the mean of the neighbours that no thin solid parts
    /// from it, weighted by kernel and volume (Shepard).
    fn velocity_at(&self, at: Vec2) -> Vec2 {
        let (mut sum, mut weights) = (Vec2::ZERO, 0.0);
        let support = self.kernel.support();
        let beside = self.solids.beside(at, support);
        self.grid.candidates(at, &mut |run, shift| {
            for j in run {
                let place = self.gas.position[j] + shift;
                let distance = (at - shift).distance(self.gas.position[j]);
                let weight = self.kernel.value(distance) * self.gas.volume[j];
                if weight > 0.0 && beside.separate(at, place, support) {
                    continue;
                }
                sum += self.gas.velocity[j] * weight;
                weights += weight;
            }
        });
        if weights > 0.0 {
            sum / weights
        } else {
            self.wind
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::periodic_bounds;
    use crate::combustion::gas::tests::{random_gas, with};
    use crate::params::Input;
    use crate::scene::Scene;

    #[test]
    fn gas_behind_a_thin_plate_does_not_move_an_ember() {
        let mut scene = Scene::new(with(&[]));
        let fields = [
            ("kind", Input::Text("solid")),
            ("shape", Input::Text("line")),
            ("y", Input::Number(0.9)),
            ("width", Input::Number(2.0)),
            ("height", Input::Number(0.01)),
        ];
        assert!(scene.add(&fields).is_ok());
        let values = scene.world();
        let (bounds, kernel) = (
            periodic_bounds(values),
            Kernel::new(values.smoothing_length()),
        );
        let mut gas = random_gas(values, 3);
        for (at, velocity) in gas.position.iter().zip(&mut gas.velocity) {
            let speed = if at.y > 0.9 { 1.0 } else { 0.0 };
            *velocity = Vec2::new(speed, 0.0);
        }
        let mut grid = Grid::default();
        let positions = gas.position.clone().into_iter();
        gas.reorder(grid.sort(positions, &bounds, kernel.support()));
        let plate = Solids::of(&scene, &bounds, kernel.support());
        for (solids, is_reached) in [(&Solids::default(), true), (&plate, false)] {
            let air = Air {
                gas: &gas,
                grid: &grid,
                bounds: &bounds,
                kernel: &kernel,
                wind: Vec2::ZERO,
                solids,
            };
            let speed = air.velocity_at(Vec2::new(0.1, 0.89)).x;
            assert_eq!(speed > 0.0, is_reached, "{speed} m/s");
        }
    }
}
