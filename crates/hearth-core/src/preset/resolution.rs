//! The resolution of settings that start from a preset.

use super::definition::Preset;
use crate::params::{IN_DOMAIN, Parameters};

impl Preset {
    /// [Completes](Parameters::complete) settings that started from this preset. If it names its
    /// `spacing`, settings without one keep it in the same domain, and have as many particles in
    /// another. If it names its number of particles, a closed domain keeps that.
    pub fn complete(&self, settings: &mut Parameters, spacing: bool, max_particles: bool) {
        let base = self.parameters();
        let own = self.names("spacing");
        let id = "max_particles";
        let number = !own && self.names(id) && settings.get(id) == base.get(id);
        let domain = |values: &Parameters| (values.domain_width, values.domain_height);
        let kept = own && !spacing && !max_particles && domain(settings) == domain(&base);
        if kept {
            settings.set_within("spacing", base.spacing.into());
        }
        let in_domain = if own {
            base.domain_particles()
        } else {
            IN_DOMAIN
        };
        settings.complete(spacing || kept, max_particles || number, in_domain);
    }
}
