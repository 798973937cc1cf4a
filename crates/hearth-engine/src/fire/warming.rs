//! A new fire that burns before it is shown, and how many particles it burns with.

use hearth_core::Scene;

use super::Fire;
use crate::outbox::Outbox;
use crate::quality::Level;

impl Fire {
    /// How long a new fire burns before it is shown; the answer to `request` follows when
    /// it is, or nobody looks.
    pub fn warm(&mut self, seconds: Option<f64>, request: Option<f64>) {
        if let Some(seconds) = seconds {
            self.warm.set(seconds);
        }
        self.asked.add(0, 0.0, request);
    }

    /// A new fire is to begin, which burns before it is shown.
    pub(super) fn begin(&mut self, out: &mut Outbox) {
        self.begins = true;
        self.stale = true;
        self.restart_clock();
        if self.begun {
            out.warming(self.id);
        }
    }

    /// Whether it burns and is not shown yet.
    pub(super) fn is_warming(&self) -> bool {
        self.begins || self.warm.is_on()
    }

    /// The values that it is to burn with at its level and size.
    pub(super) fn scene(&self) -> Scene {
        self.wanted.at(self.particles(self.quality.level()))
    }

    /// Its particles at that level, where nobody set their number.
    pub(super) fn particles(&self, level: Level) -> u32 {
        let exact = self.quality.wish().is_some();
        if self.wanted.follows_scene() {
            let number = self.wanted.parameters().max_particles;
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

    /// What its number of particles follows from, in words; empty: somebody set it.
    pub(super) fn follows(&self) -> &'static str {
        let level = self.quality.level();
        if self.wanted.follows_scene() {
            let number = self.wanted.parameters().max_particles;
            if self.particles(level) < number {
                "size"
            } else {
                ""
            }
        } else if !self.wanted.follows_level() {
            ""
        } else if self.particles(level) < level.particles() {
            "size"
        } else {
            ["quality low", "quality medium", "quality high"][level as usize]
        }
    }
}
