//! The resolution of settings that start from a preset.

use super::definition::Preset;
use crate::params::{IN_FRAME, Parameters};

impl Preset {
    /// [Completes](Parameters::complete) settings that started from this preset. If it names its
    /// `spacing`, settings without one keep it in the same frame, and have as many particles in
    /// another. If it names its number of particles, a closed domain keeps that.
    pub fn complete(&self, settings: &mut Parameters, spacing: bool, max_particles: bool) {
        let base = self.parameters();
        let own = self.names("spacing");
        let id = "max_particles";
        let number = !own && self.names(id) && settings.get(id) == base.get(id);
        let frame = |values: &Parameters| (values.domain_width, values.domain_height);
        let kept = own && !spacing && !max_particles && frame(settings) == frame(&base);
        if kept {
            settings.set_within("spacing", base.spacing.into());
        }
        let in_frame = if own {
            base.frame_particles()
        } else {
            IN_FRAME
        };
        settings.complete(spacing || kept, max_particles || number, in_frame);
    }
}
