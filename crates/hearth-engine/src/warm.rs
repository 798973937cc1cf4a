//! A fire that burns before it is shown.
//!
//! A fire that is just lit is a mushroom cloud. One that is to be warm burns some seconds
//! first, or takes up where a kept fire burnt. Steps cost a power of 1.5 of the number of
//! particles, so most of the time it burns with few, and the full number takes over for
//! the last part.

use hearth_core::burning::BurningError;
use hearth_core::params::Model;
use hearth_core::{Scene, Simulation};

use crate::requested::with_count;

/// Seconds of fire for which all particles burn.
const FINE: f64 = 0.9;
/// Part of the particles that burn before, and how many at least.
const FEW: u32 = 4;
const FEWEST: u32 = 600;

/// How long a fire burns before it is shown.
#[derive(Debug, Default)]
pub struct Warm {
    seconds: f64,
    /// What is left of it.
    left: f64,
    /// A kept fire.
    kept: Vec<u8>,
}

impl Warm {
    /// So many seconds, or a kept fire where its values are those that are wanted.
    pub fn new(seconds: f64, kept: Vec<u8>) -> Warm {
        Warm {
            seconds,
            left: 0.0,
            kept,
        }
    }

    /// Another time, for the next fire.
    pub fn set(&mut self, seconds: f64) {
        self.seconds = seconds;
    }

    /// Whether a new fire burns before it is shown.
    pub fn is_wanted(&self) -> bool {
        self.seconds > 0.0
    }

    /// Whether it still does.
    pub fn is_on(&self) -> bool {
        self.left > 0.0
    }

    /// A new fire of these values begins. Returns what is wrong with the kept one.
    pub fn begin(&mut self, simulation: &mut Simulation, scene: &Scene) -> Option<&'static str> {
        self.left = 0.0;
        *simulation = Simulation::new(scene.clone());
        if !self.is_wanted() {
            return None;
        }
        let mut wrong = None;
        if !self.kept.is_empty() {
            match simulation.restore_burning(&self.kept) {
                Ok(()) => return None,
                Err(BurningError::OtherValues) => {}
                Err(BurningError::Damaged(words)) => {
                    self.kept.clear();
                    wrong = Some(words);
                }
            }
        }
        self.left = self.seconds;
        *simulation = Simulation::new(self.coarse(scene));
        wrong
    }

    /// A step of that length was made; whether the fire is warm now.
    pub fn burnt(&mut self, length: f64, simulation: &mut Simulation, wanted: &Scene) -> bool {
        let was_coarse = self.left > FINE;
        self.left -= length;
        if was_coarse && self.left <= FINE {
            simulation.set_scene(wanted.clone());
        }
        self.left <= 0.0
    }

    /// The scene that it burns with for now where this one is requested.
    pub fn coarse(&self, requested: &Scene) -> Scene {
        let settings = requested.settings();
        let few = (settings.max_particles / FEW).max(FEWEST);
        let fewer = settings.model() == Model::Combustion && few < settings.max_particles;
        if self.left > FINE && fewer {
            with_count(requested, few)
        } else {
            requested.clone()
        }
    }
}
