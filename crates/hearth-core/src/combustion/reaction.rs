//! Where fuel enters, and how it burns: burners, the reaction with its soot, and embers.

pub(super) mod burner;
pub(super) mod chemistry;
pub(super) mod embers;

use super::gas::time_step::{PART, PARTS};
use super::gas::{Gas, make_room};
use crate::scene::Scene;
use crate::solids::Solids;
use burner::{Burner, BurnerParticle};
use embers::Embers;

/// The embers, and what burns.
#[derive(Clone, Debug, Default)]
pub(super) struct Reaction {
    pub embers: Embers,
    /// Power of the combustion in the last step, the mean of its parts [kW/m].
    pub power: f32,
    /// That of each part [kW/m].
    pub powers: [f32; PARTS],
    /// Power of the heating at the sources in the last step, the mean of its parts [kW/m].
    pub preheat: f32,
    /// The particles at a burner.
    burner_particles: Vec<BurnerParticle>,
}

crate::state! { Reaction: embers power powers preheat; burner_particles }

impl Reaction {
    /// Makes room for so many particles at a burner.
    pub fn reserve(&mut self, particles: usize) {
        make_room(&mut self.burner_particles, particles);
    }

    /// Removes the embers; nothing burns.
    pub fn extinguish(&mut self) {
        self.embers = Embers::default();
        self.begin(0.0);
    }

    /// Begins a step. The flames in the film at solids have the power `film` [kW/m].
    pub fn begin(&mut self, film: f32) {
        (self.power, self.powers, self.preheat) = (film, [film; PARTS], 0.0);
    }

    /// Burns the gas for the part of this number of a step.
    pub fn burn(&mut self, gas: &mut Gas, scene: &Scene, number: usize, dt: f32) {
        let hottest = scene.sources().map(|source| source.temperature);
        let hottest = hottest.fold(0.0, f32::max);
        let power = chemistry::react(gas, scene.world(), hottest, dt);
        self.power += PART * power;
        self.powers[number] += power;
    }

    /// Feeds the gas at each source whose index `feeds`, from `time` on for `dt`.
    pub fn feed(
        &mut self,
        gas: &mut Gas,
        scene: &Scene,
        solids: &Solids,
        (time, dt): (f64, f32),
        mut feeds: impl FnMut(usize) -> bool,
    ) {
        let spacing = scene.world().spacing();
        for (index, source) in scene.sources().enumerate() {
            if feeds(index)
                && let Some(burner) = Burner::new(&source, spacing)
            {
                let (bodies, particles) = (solids.parts(&source), &mut self.burner_particles);
                let heat = burner.feed(gas, &source, (time, dt), bodies, particles);
                self.preheat += PART * heat / dt;
            }
        }
    }
}
