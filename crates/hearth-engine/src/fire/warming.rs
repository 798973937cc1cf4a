//! The warm-up of a fire, and its number of particles.

use hearth_core::Scene;

use super::Fire;
use crate::events::Events;
use crate::quality::Level;

impl Fire {
    /// Sets the duration of the warm-up of new fires. The answer to `request` follows when the
    /// fire is shown or off stage.
    pub fn set_warm_up(&mut self, seconds: Option<f64>, request: u32) {
        if let Some(seconds) = seconds {
            self.warm.set(seconds);
        }
        self.pending.add(0, 0.0, request);
    }

    /// Starts a new fire with a warm-up.
    pub(super) fn start(&mut self, events: &Events) {
        self.starts = true;
        self.stale = true;
        self.restart_clock();
        if self.drawn {
            events.warming(self.id);
        }
    }

    /// Whether the fire is warming up.
    pub(super) fn is_warming(&self) -> bool {
        self.starts || self.warm.is_on()
    }

    /// The scene at the current level and size.
    pub(super) fn scene(&self) -> Scene {
        self.requested.at(self.particles(self.quality.level()))
    }

    /// Number of particles at a level, unless a page set the number.
    pub(super) fn particles(&self, level: Level) -> u32 {
        let exact = self.quality.requested().is_some();
        if self.requested.follows_scene() {
            let number = self.requested.parameters().max_particles;
            if exact {
                number
            } else {
                self.grain.of_scene(number)
            }
        } else if exact {
            level.particles()
        } else {
            self.grain.particles(level)
        }
    }

    /// What limits the number of particles, as in `stats`; empty if a page set the number.
    pub(crate) fn limited_by(&self) -> &'static str {
        let level = self.quality.level();
        if self.requested.follows_scene() {
            let number = self.requested.parameters().max_particles;
            if self.particles(level) < number {
                "size"
            } else {
                ""
            }
        } else if !self.requested.follows_level() {
            ""
        } else if self.particles(level) < level.particles() {
            "size"
        } else {
            ["quality low", "quality medium", "quality high"][level as usize]
        }
    }
}
