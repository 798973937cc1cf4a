//! The particles of the classic model.
//!
//! The solver sorts them by position at every substep, so that neighbours in space are
//! neighbours in memory. Readers get copies in the order of the ids, the order of birth.

use std::ops::{Deref, DerefMut};

use glam::Vec2;

use crate::lanes::Lanes;
use crate::order::in_order;
use crate::particle::Particle;

/// The state of a particle. One struct, because sorting moves all of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ParticleState {
    /// Position \[m\] and velocity [m/s]: x, y, x, y.
    pub motion: Lanes,
    /// Temperature \[K\].
    pub temperature: f32,
    /// Time since birth \[s\].
    pub age: f32,
    /// Age at which it dies \[s\].
    pub lifetime: f32,
    /// Density [kg/m³] and pressure \[Pa\] of the last substep.
    pub density: f32,
    pub pressure: f32,
    /// 64 bits: a large source exhausts 32 bits in a day.
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

    /// Whether its life has not ended.
    pub fn is_alive(&self) -> bool {
        self.age < self.lifetime
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
    next_id: u64,
    /// Destination of each reordering.
    scratch: Vec<ParticleState>,
}

crate::state! {
    ParticleState: motion temperature age lifetime density pressure id,
    Particles: states next_id; scratch
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
        self.next_id = 0;
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
            id: self.next_id,
        });
        self.next_id += 1;
    }

    /// Count of all particles that were ever pushed.
    pub fn births(&self) -> u64 {
        self.next_id
    }

    /// Keeps the particles for which `alive` is true, in their order.
    pub fn retain(&mut self, alive: impl Fn(&ParticleState) -> bool) {
        self.states.retain(alive);
    }

    /// Moves the particle at each index `i` to `new_indices[i]`.
    pub fn reorder(&mut self, new_indices: &[u32]) {
        // The loop overwrites all of it.
        self.scratch.truncate(self.states.len());
        let missing = &self.states[self.scratch.len()..];
        self.scratch.extend_from_slice(missing);
        for (particle, &index) in self.states.iter().zip(new_indices) {
            self.scratch[index as usize] = *particle;
        }
        std::mem::swap(&mut self.states, &mut self.scratch);
    }

    /// The indices of all particles in the order of their ids.
    pub fn by_id(&self) -> Vec<usize> {
        in_order(self.len(), self.next_id, &|i| self[i].id)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_that_of_the_ids_at_any_size() {
        let mut particles = Particles::default();
        for next_id in [0, 3, 255, 256, 65_536, 1 << 40] {
            particles.next_id = next_id;
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
