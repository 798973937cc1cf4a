//! The number of particles of a fire, and its warm-up.

use hearth_core::Scene;

use super::Fire;
use crate::events::Events;
use hearth_core::resolution::Level;
use hearth_core::resolution::{CountInputs, ParticleCount, Resolution};
use hearth_settings::adapt;

impl Fire {
    /// Sets the duration of the warm-up of new fires. The answer to `request` follows when the
    /// fire is shown or cannot be drawn.
    pub fn set_warm_up(&mut self, seconds: Option<f64>, request: u32) {
        if let Some(seconds) = seconds {
            self.warm_up.set(seconds);
        }
        self.step_requests.add(0, 0.0, request);
    }

    /// Starts a new fire with a warm-up before the next step.
    pub(super) fn start(&mut self, events: &Events) {
        self.starts = true;
        self.stale = true;
        self.restart_clock();
        if self.drawn {
            events.warming(self.id);
        }
    }

    /// Starts the warm-up of a new fire, or resumes the saved one.
    pub(super) fn begin_warm_up(&mut self, events: &Events) {
        self.starts = false;
        self.history.clear();
        let scene = self.scene_with(self.count_at(self.quality.level(), false));
        if let Some(error) = self.warm_up.begin(&mut self.simulation, scene) {
            events.warn(self.id, &error.to_string());
        }
        if self.warm_up.is_on() {
            let scene = self.scene();
            adapt(&mut self.simulation, scene);
        }
        self.set_visible_area();
        self.stale = true;
    }

    /// Whether the fire is warming up.
    pub(super) fn is_warming(&self) -> bool {
        self.starts || self.warm_up.is_on()
    }

    /// The scene with the present number of particles.
    pub(super) fn scene(&self) -> Scene {
        self.scene_with(self.particle_count())
    }

    fn scene_with(&self, count: ParticleCount) -> Scene {
        self.settings.at(count.number)
    }

    /// The present number of particles, and what limits it.
    pub(crate) fn particle_count(&self) -> ParticleCount {
        self.count_at(self.quality.level(), self.warm_up.is_coarse())
    }

    /// The number of particles at a level.
    fn count_at(&self, level: Level, is_coarse: bool) -> ParticleCount {
        ParticleCount::of(&CountInputs {
            settings: self.settings.resolution(),
            level,
            is_level_requested: self.quality.requested().is_some(),
            size: self.size_limit,
            machine: self.machine_limit.particles(),
            is_coarse,
        })
    }

    /// The number of particles at each level, if the level decides it.
    pub(super) fn counts_of_levels(&self) -> Option<[u32; 3]> {
        let follows = self.settings.resolution() == Resolution::Level;
        follows.then(|| Level::ALL.map(|level| self.count_at(level, false).number))
    }

    /// Adapts the number of particles to the time of a step \[ms\].
    pub(super) fn measure(&mut self, step: f64, events: &Events) {
        let resolution = self.settings.resolution();
        if resolution == Resolution::Level {
            return;
        }
        let requested = resolution.number();
        // Open air has fewer particles than would fill its domain, and the limit is one of those.
        let values = self.simulation.parameters();
        let count = match values.has_open_edges() {
            true => values.domain_particles() as usize,
            false => self.simulation.count(),
        };
        if let Some(step) = self.machine_limit.measure(step, count, requested) {
            let now = requested.min(self.machine_limit.particles());
            self.quality
                .explain(step, self.machine_limit.max_step(), now, requested);
            events.quality(self.id, &self.quality);
            self.adapt();
        }
    }
}
