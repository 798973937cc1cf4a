//! The resolution of settings that start from a preset.

use super::definition::Preset;
use crate::params::{IN_DOMAIN, Parameters};

impl Preset {
    /// [Completes](Parameters::complete) settings that started from this preset. If it names its
    /// `spacing`, settings without one keep it in the same domain, and have as many particles in
    /// another.
    pub fn complete(&self, settings: &mut Parameters, names: &dyn Fn(&str) -> bool) {
        let base = self.world();
        let own = self.names("spacing");
        let domain = |values: &Parameters| (values.domain_width, values.domain_height);
        let is_stated = names("spacing") || names("particles");
        let kept = own && !is_stated && domain(settings) == domain(&base);
        if kept {
            settings.set_within("spacing", base.spacing.into());
        }
        let in_domain = if own {
            base.domain_particles()
        } else {
            IN_DOMAIN
        };
        settings.complete(&|id| kept && id == "spacing" || names(id), in_domain);
    }
}
