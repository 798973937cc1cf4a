//! Warm-up: a fire burns before it is shown.
//!
//! A fire that was just lit looks like a mushroom cloud. A warm fire first burns for some
//! seconds, or resumes a saved fire, which burns on until its second slice has a past. The
//! cost of a step grows as the particle count to the power of 1.5, so most of the warm-up uses few
//! particles. The full number replaces them for the last part
//! ([`ParticleCount`](crate::resolution::ParticleCount)).

use crate::burning::BurningError;
use crate::{Scene, Simulation};

/// Duration of the last part, with all particles [s of fire].
const FINE_SECONDS: f64 = 0.9;

/// Time that a saved fire burns on [s of fire]: more than the lag of the second slice of a picture. The first picture
/// comes early, and the other slices fade into it.
const PAST_SECONDS: f64 = 0.5;

/// The warm-up of a fire.
#[derive(Clone, Debug, Default)]
pub struct WarmUp {
    duration: f64,
    /// Remaining duration [s of fire].
    left: f64,
    /// A saved fire.
    saved: Vec<u8>,
}

impl WarmUp {
    /// A warm-up of that duration [s of fire], or a saved fire if its settings match.
    pub fn new(duration: f64, saved: Vec<u8>) -> WarmUp {
        WarmUp {
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

    /// Whether the fire is in the first part, with few particles.
    pub fn is_coarse(&self) -> bool {
        self.left > FINE_SECONDS
    }

    /// Starts a new fire of a scene with all its particles, or resumes the saved one. If it [is on](WarmUp::is_on)
    /// after that, the caller replaces a new fire by a coarse one, or resamples a burning one. Returns what is wrong with the saved fire.
    pub fn begin(&mut self, simulation: &mut Simulation, scene: Scene) -> Option<BurningError> {
        self.left = 0.0;
        simulation.begin(scene);
        if !self.is_enabled() {
            return None;
        }
        let mut wrong = None;
        if !self.saved.is_empty() {
            match simulation.restore_burning(&self.saved) {
                Ok(()) => {
                    self.left = PAST_SECONDS;
                    return None;
                }
                Err(BurningError::OtherValues) => {}
                Err(error) => {
                    self.saved.clear();
                    wrong = Some(error);
                }
            }
        }
        self.left = self.duration;
        wrong
    }

    /// Counts a step of that length [s of fire]. Returns whether the number of particles changes.
    pub fn advance(&mut self, length: f64) -> bool {
        let was_coarse = self.is_coarse();
        self.left -= length;
        was_coarse && !self.is_coarse()
    }
}
