//! The resolution of a fire: a spacing, or the number of particles that would fill the domain.
//!
//! With open edges the resolution is the length `spacing`, otherwise the number `particles`; each follows
//! the other. `max_particles` is a cap and nothing else.

use super::choices::{Edges, Model};
use super::set::Parameters;
use super::table::{Param, Physics};
use super::value::Input;
use crate::extremes::{fast_max, fast_min};

/// Fewest and most particles of open air that could fill the domain: a finer `spacing` would ask
/// for more memory than a page has, and a coarser one would leave no fire.
const MIN_IN_DOMAIN: f32 = 200.0;
const MAX_IN_DOMAIN: f32 = 200_000.0;

/// Number of particles of a domain whose settings name neither `spacing` nor `particles`.
pub const IN_DOMAIN: u32 = 3000;

impl Physics {
    /// Distance of neighbouring particles in gas at the density of the air \[m\].
    pub fn spacing(&self) -> f32 {
        let domain = self.domain_width * self.domain_height;
        match (self.model, self.edges) {
            (Model::Classic, _) => libm::sqrtf(self.particle_mass / self.rest_density),
            (Model::Combustion, Edges::Periodic) => libm::sqrtf(domain / self.capacity() as f32),
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
            self.capacity()
        }
    }

    /// The largest number of particles. A closed domain is always full, without a cap.
    pub fn capacity(&self) -> u32 {
        match (self.model, self.edges) {
            (Model::Combustion, Edges::Periodic) => self.particles,
            _ => self.max_particles,
        }
    }

    /// Whether the air has no box, so that `spacing` is the resolution.
    pub fn has_open_edges(&self) -> bool {
        self.model == Model::Combustion && self.edges == Edges::Open
    }
}

impl Parameters {
    /// Sets the resolution at which that number of particles would fill the domain, and `max_particles` to
    /// twice the number, because with open edges a fire moves air beyond the domain, too.
    pub fn set_domain_particles(&mut self, particles: u32) {
        self.set_within("particles", particles.into());
        self.set_within("max_particles", 2.0 * f64::from(particles));
        if self.has_open_edges() {
            let domain = self.domain_width * self.domain_height;
            let spacing = libm::sqrtf(domain / particles.max(1) as f32);
            self.set_within("spacing", spacing.into());
        }
    }

    /// Completes the resolution of settings. `names` says whether a document, a page or a caller names a
    /// parameter. Without a `spacing`, the resolution is the one at which `particles` would fill the domain, or
    /// `in_domain` if that is not named either. A cap that is not named is large enough for twice the domain.
    ///
    /// Readers call it once, after all values of a document are set. `set` alone never does.
    pub fn complete(&mut self, names: &dyn Fn(&str) -> bool, in_domain: u32) {
        if self.model != Model::Combustion {
            return;
        }
        let cap = self.max_particles;
        if self.has_open_edges() && names("spacing") {
            let particles = self.domain_particles();
            self.set_within("particles", particles.into());
            let enough = particles.saturating_mul(2).max(cap);
            self.set_within("max_particles", enough.into());
        } else {
            let number = if names("particles") {
                self.particles
            } else {
                in_domain
            };
            self.set_domain_particles(number);
            // The default is a rounded length.
            let is_default = ["domain_width", "domain_height"].map(|id| self.is_default(id));
            if number == IN_DOMAIN && is_default == [true; 2] {
                let restored = self.restore("spacing");
                debug_assert_eq!(restored, Ok(()));
            }
        }
        if names("max_particles") {
            self.set_within("max_particles", cap.into());
        }
    }

    /// Sets a number, clamped to the range of its parameter.
    #[inline(never)]
    pub(crate) fn set_within(&mut self, id: &'static str, number: f64) {
        if let Some(param) = Param::find(id) {
            let (min, max) = param.any_domain(self.model).range;
            // Unlike `clamp`, a number in the range for what is no number too.
            let set = self.set(id, Input::Number(number.max(min).min(max)));
            debug_assert_eq!(set, Ok(()));
        }
    }

    fn is_default(&self, id: &str) -> bool {
        Param::find(id)
            .is_some_and(|param| self.get(id) == Some(param.any_domain(self.model).default))
    }
}
