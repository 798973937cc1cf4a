//! A new fire that burns before it is shown, and its number of particles.

use hearth_core::Scene;

use super::Fire;
use crate::events::Events;
use crate::quality::Level;

impl Fire {
    /// Sets how long a new fire burns before it is shown. The answer to `request` follows
    /// when it is shown, or when nobody looks.
    pub fn warm(&mut self, seconds: Option<f64>, request: u32) {
        if let Some(seconds) = seconds {
            self.warm.set(seconds);
        }
        self.pending.add(0, 0.0, request);
    }

    /// Begins a new fire, which burns before it is shown.
    pub(super) fn begin(&mut self, events: &Events) {
        self.begins = true;
        self.stale = true;
        self.restart_clock();
        if self.begun {
            events.warming(self.id);
        }
    }

    /// Whether it burns and is not shown yet.
    pub(super) fn is_warming(&self) -> bool {
        self.begins || self.warm.is_on()
    }

    /// The scene at its level and size.
    pub(super) fn scene(&self) -> Scene {
        self.requested.at(self.particles(self.quality.level()))
    }

    /// Its number of particles at that level, where a page did not set it.
    pub(super) fn particles(&self, level: Level) -> u32 {
        let exact = self.quality.wish().is_some();
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

    /// What its number of particles follows from, in words; empty: a page set it.
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
