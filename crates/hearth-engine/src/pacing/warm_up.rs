//! Warm-up: a fire burns before it is shown.
//!
//! A fire that was just lit looks like a mushroom cloud. A warm fire first burns for some
//! seconds, or resumes a saved fire. The cost of a step grows as the particle count to the
//! power of 1.5, so most of the warm-up uses few particles. The full number replaces them
//! for the last part.

use hearth_core::burning::BurningError;
use hearth_core::params::Model;
use hearth_core::{Scene, Simulation};

use crate::requested::with_count;

/// Duration of the last part, with all particles [s of fire].
const FINE_DURATION: f64 = 0.9;
/// Divisor of the particle count before, and its minimum.
const COARSENING: u32 = 4;
const MIN_COARSE: u32 = 600;

/// The warm-up of a fire.
#[derive(Debug, Default)]
pub struct Warm {
    duration: f64,
    /// Remaining duration [s of fire].
    left: f64,
    /// A saved fire.
    saved: Vec<u8>,
}

impl Warm {
    /// A warm-up of that duration [s of fire], or a saved fire if its settings match.
    pub fn new(duration: f64, saved: Vec<u8>) -> Warm {
        Warm {
            duration,
            left: 0.0,
            saved,
        }
    }

    /// Sets the duration for the next new fire.
    pub fn set(&mut self, duration: f64) {
        self.duration = duration;
    }

    /// Whether new fires warm up.
    pub fn is_enabled(&self) -> bool {
        self.duration > 0.0
    }

    /// Whether the fire is warming up.
    pub fn is_on(&self) -> bool {
        self.left > 0.0
    }

    /// Starts a new fire of a scene. Returns what is wrong with the saved one, as text.
    pub fn begin(&mut self, simulation: &mut Simulation, scene: &Scene) -> Option<&'static str> {
        self.left = 0.0;
        *simulation = Simulation::new(scene.clone());
        if !self.is_enabled() {
            return None;
        }
        let mut wrong = None;
        if !self.saved.is_empty() {
            match simulation.restore_burning(&self.saved) {
                Ok(()) => return None,
                Err(BurningError::OtherValues) => {}
                Err(BurningError::Damaged(message)) => {
                    self.saved.clear();
                    wrong = Some(message);
                }
            }
        }
        self.left = self.duration;
        *simulation = Simulation::new(self.coarse(scene));
        wrong
    }

    /// Counts a step of that length [s of fire]. Returns whether the warm-up is over.
    pub fn advance(&mut self, length: f64, simulation: &mut Simulation, scene: &Scene) -> bool {
        let was_coarse = self.left > FINE_DURATION;
        self.left -= length;
        if was_coarse && self.left <= FINE_DURATION {
            simulation.set_scene(scene.clone());
        }
        self.left <= 0.0
    }

    /// The scene to simulate now for a requested scene: with fewer particles in the first part.
    pub fn coarse(&self, requested: &Scene) -> Scene {
        let settings = requested.settings();
        let full = settings.frame_particles();
        let few = (full / COARSENING).max(MIN_COARSE);
        let fewer = settings.model() == Model::Combustion && few < full;
        if self.left > FINE_DURATION && fewer {
            with_count(requested, few)
        } else {
            requested.clone()
        }
    }
}
