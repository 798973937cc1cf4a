//! The warm-up of a fire, and its number of particles.

use hearth_core::Scene;

use super::Fire;
use crate::events::Events;
use crate::quality::Level;
use crate::requested::with_count;

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
        let scene = self.requested.at(self.particles(self.quality.level()));
        if self.is_limited(scene.settings().frame_particles()) {
            with_count(&scene, self.capacity.limit())
        } else {
            scene
        }
    }

    /// Whether the speed of the machine limits that number of particles. The levels have limits
    /// of their own.
    fn is_limited(&self, particles: u32) -> bool {
        particles > self.capacity.limit() && !self.requested.follows_level()
    }

    /// Follows the time of a step \[ms\] with the number of particles.
    pub(super) fn measure(&mut self, step: f64, events: &Events) {
        if self.requested.follows_level() {
            return;
        }
        let wanted = self.requested.number();
        // Open air holds fewer particles than would fill its frame, and the limit is one of those.
        let values = self.simulation.parameters();
        let count = match values.has_open_edges() {
            true => values.frame_particles() as usize,
            false => self.simulation.count(),
        };
        if let Some(step) = self.capacity.measure(step, count, wanted) {
            let now = wanted.min(self.capacity.limit());
            self.quality
                .explain(step, self.capacity.max_step(), now, wanted);
            events.quality(self.id, &self.quality);
            self.adapt();
        }
    }

    /// Number of particles at a level, unless a page set the number.
    pub(super) fn particles(&self, level: Level) -> u32 {
        let exact = self.quality.requested().is_some();
        if self.requested.follows_scene() {
            let number = self.requested.number();
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
        let number = self.requested.number();
        if self.is_limited(number) {
            "speed"
        } else if self.requested.follows_scene() {
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
