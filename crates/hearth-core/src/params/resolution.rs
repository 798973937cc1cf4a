//! The resolution of a fire: a spacing, or the number of particles that would fill the domain.
//!
//! With open edges the resolution is the length `spacing`, and `max_particles` is a cap. Settings
//! that do not name `spacing` state the resolution as a number of particles of the domain, as the
//! closed domain does.

use super::choices::{Edges, Model};
use super::set::Parameters;
use super::table::{Param, Physics};
use super::value::Input;
use crate::extremes::{fast_max, fast_min};

/// Fewest and most particles of open air that could fill the domain: a finer `spacing` would ask
/// for more memory than a page has, and a coarser one would leave no fire.
const MIN_IN_DOMAIN: f32 = 200.0;
const MAX_IN_DOMAIN: f32 = 200_000.0;

/// Number of particles of a domain whose settings name neither `spacing` nor `max_particles`.
pub const IN_DOMAIN: u32 = 3000;

impl Physics {
    /// Distance of neighbouring particles in gas at the density of the air \[m\].
    pub fn spacing(&self) -> f32 {
        let domain = self.domain_width * self.domain_height;
        match (self.model, self.edges) {
            (Model::Classic, _) => libm::sqrtf(self.particle_mass / self.rest_density),
            (Model::Combustion, Edges::Periodic) => libm::sqrtf(domain / self.max_particles as f32),
            (Model::Combustion, Edges::Open) => {
                let [min, max] = [MAX_IN_DOMAIN, MIN_IN_DOMAIN].map(|n| libm::sqrtf(domain / n));
                fast_max(fast_min(self.spacing, max), min)
            }
        }
    }

    /// Smoothing length h, half of the support radius \[m\].
    pub fn smoothing_length(&self) -> f32 {
        match self.model {
            Model::Classic => self.smoothing_radius,
            Model::Combustion => self.smoothing_ratio * self.spacing(),
        }
    }

    /// The resolution as a number: the particles of air that would fill the domain. In the classic
    /// model, the largest number of particles.
    pub fn domain_particles(&self) -> u32 {
        if self.has_open_edges() {
            let spacing = self.spacing();
            let number = self.domain_width * self.domain_height / (spacing * spacing);
            libm::roundf(number) as u32
        } else {
            self.max_particles
        }
    }

    /// Whether the air has no box, so that `spacing` is the resolution.
    pub fn has_open_edges(&self) -> bool {
        self.model == Model::Combustion && self.edges == Edges::Open
    }
}

impl Parameters {
    /// Sets the resolution at which that number of particles would fill the domain. With open
    /// edges, this sets `spacing`, and `max_particles` to twice the number, because a fire moves
    /// air beyond the domain, too.
    pub fn set_domain_particles(&mut self, particles: u32) {
        if self.has_open_edges() {
            let domain = self.domain_width * self.domain_height;
            let spacing = libm::sqrtf(domain / particles.max(1) as f32);
            self.set_within("spacing", spacing.into());
            self.set_within("max_particles", 2.0 * f64::from(particles));
        } else {
            self.set_within("max_particles", particles.into());
        }
    }

    /// Completes the resolution of settings, whose `spacing` and `max_particles` determine whether a
    /// document, a page or a caller names the parameter. If `spacing` is not named, the resolution
    /// is the one at which `max_particles` would fill the domain, or `in_domain` if that is not named
    /// either. A cap that is not named is large enough for twice the domain.
    ///
    /// Readers call it once, after all values of a document are set. `set` alone never does.
    pub fn complete(&mut self, spacing: bool, max_particles: bool, in_domain: u32) {
        if self.model != Model::Combustion {
            return;
        }
        let number = if max_particles {
            self.max_particles
        } else {
            in_domain
        };
        if !self.has_open_edges() || !spacing {
            self.set_domain_particles(number);
        } else if !max_particles {
            let enough = self.domain_particles().saturating_mul(2);
            if self.max_particles < enough {
                self.set_within("max_particles", enough.into());
            }
        }
        // The default is a rounded length.
        let is_default = ["domain_width", "domain_height"].map(|id| self.is_default(id));
        if !spacing && number == IN_DOMAIN && is_default == [true; 2] {
            let restored = self.restore("spacing");
            debug_assert_eq!(restored, Ok(()));
        }
    }

    /// Sets a number, clamped to the range of its parameter.
    pub(crate) fn set_within(&mut self, id: &'static str, number: f64) {
        if let Some(param) = Param::find(id) {
            let (min, max) = param.any_domain(self.model).range;
            // Unlike `clamp`, a number in the range for what is no number too.
            let set = self.set(id, Input::Number(number.max(min).min(max)));
            debug_assert_eq!(set, Ok(()));
        }
    }

    fn is_default(&self, id: &str) -> bool {
        Param::find(id).is_some_and(|param| param.get(self) == param.any_domain(self.model).default)
    }
}
