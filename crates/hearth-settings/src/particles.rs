//! The number of particles that settings state.

use crate::resolution::{CAP, COUNT, SPACING, StatedResolution};
use crate::settings::Settings;
use hearth_core::params::{Input, Model};
use hearth_core::resolution::Resolution;
use hearth_core::{Parameters, Scene};

impl Settings {
    /// Whether a parameter states the resolution; `None` for one that cannot.
    pub(crate) fn states(&self, id: &str) -> Option<bool> {
        let mut all = StatedResolution::IDS.iter();
        let found = all.find(|(_, known)| *known == id);
        found.map(|(own, _)| self.resolution == *own)
    }

    /// Whether the cap is another one than that of the preset.
    fn has_cap(&self) -> bool {
        self.page.get(CAP) != self.base().get(CAP)
    }

    /// Completes the resolution of a world.
    fn complete(&self, world: &mut Parameters) {
        let names = |id: &str| {
            self.states(id)
                .unwrap_or_else(|| id == CAP && self.has_cap())
        };
        self.preset().complete(world, &names);
    }

    /// The number of particles that the settings state.
    pub fn resolution(&self) -> Resolution {
        let (values, preset) = (self.parameters(), self.preset());
        let number = || self.completed().domain_particles();
        let is_stated = match self.resolution {
            StatedResolution::Auto => false,
            StatedResolution::Count => true,
            StatedResolution::Spacing => values.has_open_edges(),
        };
        if values.model() == Model::Classic {
            Resolution::Classic(number())
        } else if is_stated {
            Resolution::Page(number())
        } else if preset.names(COUNT) {
            Resolution::Scene(number())
        } else {
            Resolution::Level
        }
    }

    /// The parameters with the resolution that follows from what the settings and the preset state.
    pub fn completed(&self) -> Parameters {
        let mut values = self.parameters().clone();
        self.complete(&mut values);
        values
    }

    /// Adapts what is not stated of the resolution to the preset and the domain, even while a closed box has no use
    /// for it.
    pub(crate) fn settle(&mut self) {
        if self.page.model() == Model::Classic {
            self.resolution = StatedResolution::Auto;
            return;
        }
        let mut values = self.page.world().clone();
        let put = |values: &mut Parameters, id, input: Input<'_>| {
            let set = values.set(id, input);
            debug_assert_eq!(set, Ok(()));
        };
        let mut open = values.clone();
        put(&mut open, "edges", Input::Text("open"));
        self.complete(&mut open);
        put(&mut values, SPACING, Input::Number(open.spacing.into()));
        put(&mut values, COUNT, Input::Number(open.particles.into()));
        self.page.set_world(values);
    }

    /// The scene with that [number of particles](hearth_core::resolution::ParticleCount). Only levels raise the cap, unless it is stated.
    pub fn at(&self, particles: u32) -> Scene {
        let mut values = self.completed();
        let resolution = self.resolution();
        if particles != resolution.number() {
            let cap = values.max_particles;
            values.set_domain_particles(particles);
            if values.max_particles > cap && (resolution != Resolution::Level || self.has_cap()) {
                let set = values.set(CAP, Input::Number(cap.into()));
                debug_assert_eq!(set, Ok(()));
            }
        }
        let mut scene = self.scene().clone();
        scene.set_world(values);
        scene
    }

    /// Whether frames cost as much as those of `other` at the same level. If not, measured
    /// times do not predict the next ones.
    pub fn costs_like(&self, other: &Settings) -> bool {
        let cost = |settings: &Settings| {
            let values = settings.parameters();
            let resolution = (values.max_particles, values.domain_particles());
            (values.model(), resolution, values.time_scale)
        };
        let follows_level = |settings: &Settings| settings.resolution() == Resolution::Level;
        cost(self) == cost(other) && follows_level(self) == follows_level(other)
    }
}
