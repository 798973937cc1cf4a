//! Where the particles are kept.
//!
//! They are private to the solver, which sorts them by place at every substep, so
//! that neighbours in space are neighbours in memory. Readers get copies in the order
//! of the ids, which is the order of birth and never changes.

use std::ops::{Deref, DerefMut};

use glam::Vec2;

use crate::lanes::Lanes;
use crate::particle::Particle;

/// The state of a particle. All of it lies together, since sorting moves all of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ParticleState {
    /// Position \[m\] and velocity [m/s]: x, y, and x, y. They move together.
    pub motion: Lanes,
    /// Temperature \[K\].
    pub temperature: f32,
    /// Time since birth \[s\].
    pub age: f32,
    /// Age at which it dies \[s\].
    pub lifetime: f32,
    /// Density [kg/m³] and pressure \[Pa\] as the last substep found them.
    pub density: f32,
    pub pressure: f32,
    /// Never runs out: a large source would have used up 32 bits in a day.
    pub id: u64,
}

impl ParticleState {
    pub fn position(&self) -> Vec2 {
        let [x, y, ..] = self.motion.to_array();
        Vec2::new(x, y)
    }

    pub fn velocity(&self) -> Vec2 {
        let [.., x, y] = self.motion.to_array();
        Vec2::new(x, y)
    }

    /// The particle as callers read it.
    pub fn particle(&self) -> Particle {
        Particle {
            velocity: self.velocity(),
            temperature: self.temperature,
            age: self.age,
            lifetime: self.lifetime,
            ..Particle::at(self.position())
        }
    }
}

/// All particles; dereferences to a slice of their states.
#[derive(Clone, Debug, Default)]
pub(crate) struct Particles {
    states: Vec<ParticleState>,
    born: u64,
    /// The second half of each reordering.
    scratch: Vec<ParticleState>,
}

impl Deref for Particles {
    type Target = [ParticleState];

    fn deref(&self) -> &[ParticleState] {
        &self.states
    }
}

impl DerefMut for Particles {
    fn deref_mut(&mut self) -> &mut [ParticleState] {
        &mut self.states
    }
}

impl Particles {
    /// Removes every particle; ids begin at 0 again.
    pub fn clear(&mut self) {
        self.states.clear();
        self.born = 0;
    }

    pub fn push(&mut self, particle: Particle) {
        let (at, v) = (particle.position, particle.velocity);
        self.states.push(ParticleState {
            motion: Lanes::new([at.x, at.y, v.x, v.y]),
            temperature: particle.temperature,
            age: particle.age,
            lifetime: particle.lifetime,
            density: 0.0,
            pressure: 0.0,
            id: self.born,
        });
        self.born += 1;
    }

    /// Keeps the particles for which `alive` says so, in their order.
    pub fn retain(&mut self, alive: impl Fn(&ParticleState) -> bool) {
        self.states.retain(alive);
    }

    /// Puts each particle in its place: that at `i` goes to `places[i]`.
    pub fn reorder(&mut self, places: &[u32]) {
        // The contents do not matter: every place is written.
        self.scratch.truncate(self.states.len());
        let missing = &self.states[self.scratch.len()..];
        self.scratch.extend_from_slice(missing);
        for (particle, &place) in self.states.iter().zip(places) {
            self.scratch[place as usize] = *particle;
        }
        std::mem::swap(&mut self.states, &mut self.scratch);
    }

    /// The indices of all particles in the order of their ids.
    // Inlined, the compiler makes it twice as large.
    #[inline(never)]
    pub fn by_id(&self) -> Vec<usize> {
        // Byte by byte, the lowest first: the standard library's sort would be 3 KB of
        // the headless library's download, and is slower.
        let mut order: Vec<usize> = (0..self.len()).collect();
        let mut sorted = order.clone();
        let mut byte = 0;
        while byte < 8 && self.born >> (8 * byte) != 0 {
            let value = |i: usize| (self[i].id >> (8 * byte)) as usize & 0xff;
            let mut places = [0; 257];
            for &i in &order {
                places[value(i) + 1] += 1;
            }
            for at in 1..places.len() {
                places[at] += places[at - 1];
            }
            for &i in &order {
                let place = &mut places[value(i)];
                sorted[*place] = i;
                *place += 1;
            }
            std::mem::swap(&mut order, &mut sorted);
            byte += 1;
        }
        order
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_that_of_the_ids_however_large_they_are() {
        let mut particles = Particles::default();
        for born in [0, 3, 255, 256, 65_536, 1 << 40] {
            particles.born = born;
            particles.push(Particle::at(Vec2::ZERO));
            particles.push(Particle::at(Vec2::ZERO));
        }
        let places: Vec<u32> = (0..12).map(|i| i * 5 % 12).collect();
        particles.reorder(&places);
        let order = particles.by_id();
        assert!(order.is_sorted_by_key(|&i| particles[i].id));
        let mut whole = order.clone();
        whole.sort_unstable();
        assert!(whole.into_iter().eq(0..12));
        assert_eq!(Particles::default().by_id(), []);
    }
}
