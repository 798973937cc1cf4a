//! Where the particles are kept.
//!
//! One array a property, and the arrays are private to the solver: it sorts
//! them by grid cell at every substep, so that neighbours in space are
//! neighbours in memory. Whoever reads particles gets copies in the order of
//! their ids, which is the order of their birth and never changes.

use glam::Vec2;

use crate::particle::Particle;

/// All particles that are alive.
#[derive(Clone, Debug, Default)]
pub(crate) struct Particles {
    pub position: Vec<Vec2>,
    pub velocity: Vec<Vec2>,
    pub acceleration: Vec<Vec2>,
    pub temperature: Vec<f32>,
    pub age: Vec<f32>,
    pub lifetime: Vec<f32>,
    pub density: Vec<f32>,
    pub pressure: Vec<f32>,
    pub id: Vec<u64>,
    /// What each gives to the density around it, its mass [kg/m].
    pub shares: Vec<f32>,
    /// Never runs out: a large source would have used up 32 bits in a day.
    born: u64,
    /// The second half of each reordering.
    scratch: Scratch,
}

#[derive(Clone, Debug, Default)]
struct Scratch {
    vector: Vec<Vec2>,
    scalar: Vec<f32>,
    id: Vec<u64>,
}

impl Particles {
    pub fn len(&self) -> usize {
        self.id.len()
    }

    /// Forgets every particle, and that there ever was one.
    pub fn clear(&mut self) {
        self.keep_first(0);
        self.born = 0;
    }

    pub fn push(&mut self, particle: Particle) {
        self.position.push(particle.position);
        self.velocity.push(particle.velocity);
        self.acceleration.push(Vec2::ZERO);
        self.temperature.push(particle.temperature);
        self.age.push(particle.age);
        self.lifetime.push(particle.lifetime);
        self.density.push(0.0);
        self.pressure.push(0.0);
        self.id.push(self.born);
        self.born += 1;
    }

    pub fn get(&self, i: usize) -> Particle {
        Particle {
            position: self.position[i],
            velocity: self.velocity[i],
            temperature: self.temperature[i],
            age: self.age[i],
            lifetime: self.lifetime[i],
            ..Particle::at(self.position[i])
        }
    }

    /// Adds the accelerations `push` of a position and a velocity.
    pub fn push_by(&mut self, push: &impl Fn(Vec2, Vec2) -> Vec2) {
        for (i, acceleration) in self.acceleration.iter_mut().enumerate() {
            *acceleration += push(self.position[i], self.velocity[i]);
        }
    }

    /// Keeps the particles for which `alive` says so, in their order.
    pub fn retain(&mut self, alive: impl Fn(&Particles, usize) -> bool) {
        let mut kept = 0;
        for i in 0..self.len() {
            if alive(self, i) {
                if kept < i {
                    self.move_down(i, kept);
                }
                kept += 1;
            }
        }
        self.keep_first(kept);
    }

    fn move_down(&mut self, from: usize, to: usize) {
        self.position[to] = self.position[from];
        self.velocity[to] = self.velocity[from];
        self.acceleration[to] = self.acceleration[from];
        self.temperature[to] = self.temperature[from];
        self.age[to] = self.age[from];
        self.lifetime[to] = self.lifetime[from];
        self.density[to] = self.density[from];
        self.pressure[to] = self.pressure[from];
        self.id[to] = self.id[from];
    }

    fn keep_first(&mut self, n: usize) {
        self.position.truncate(n);
        self.velocity.truncate(n);
        self.acceleration.truncate(n);
        self.temperature.truncate(n);
        self.age.truncate(n);
        self.lifetime.truncate(n);
        self.density.truncate(n);
        self.pressure.truncate(n);
        self.id.truncate(n);
    }

    /// Puts the particles into the order `order`: what was at `order[i]` comes
    /// to `i`. Acceleration, density and pressure are made anew after a sort,
    /// so they stay where they are.
    pub fn reorder(&mut self, order: &[u32]) {
        let Scratch { vector, scalar, id } = &mut self.scratch;
        gather(&mut self.position, vector, order);
        gather(&mut self.velocity, vector, order);
        gather(&mut self.temperature, scalar, order);
        gather(&mut self.age, scalar, order);
        gather(&mut self.lifetime, scalar, order);
        gather(&mut self.id, id, order);
    }

    /// The indices of all particles in the order of their ids.
    pub fn by_id(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.len()).collect();
        order.sort_unstable_by_key(|&i| self.id[i]);
        order
    }
}

fn gather<T: Copy>(values: &mut Vec<T>, scratch: &mut Vec<T>, order: &[u32]) {
    scratch.clear();
    scratch.extend(order.iter().map(|&from| values[from as usize]));
    std::mem::swap(values, scratch);
}
