//! The settings that a page requests, and the scene that follows from them at a level of
//! quality.

use crate::apply;
use crate::untrusted::{ValidationError, Values};
use hearth_core::params::{Input, Model};
use hearth_core::preset::Preset;
use hearth_core::resolution::Resolution;
use hearth_core::{Parameters, Scene, Simulation};

/// Id of the number of particles, which follows the quality unless a page sets it.
pub const COUNT: &str = "max_particles";
/// Id of the spacing of particles, likewise.
pub const SPACING: &str = "spacing";

/// Requested settings.
#[derive(Clone, Debug, PartialEq)]
pub struct Requested {
    /// Parameters and objects.
    pub scene: Scene,
    /// Whether a page set the combustion model's number of particles. The fire then keeps it at
    /// every quality, even the default number.
    pub count_overridden: bool,
    /// Whether a page set the spacing of particles in open air. The fire then keeps it at every
    /// quality, and the number of particles is a cap.
    pub spacing_overridden: bool,
    /// The preset that the settings started from.
    pub preset: &'static str,
}

impl Default for Requested {
    fn default() -> Requested {
        Requested {
            scene: Scene::default(),
            count_overridden: false,
            spacing_overridden: false,
            preset: Preset::all()[0].name,
        }
    }
}

impl Requested {
    /// The settings of a preset.
    ///
    /// # Errors
    /// No preset has that name.
    pub fn of_preset(name: &str) -> Result<Requested, Vec<ValidationError>> {
        let preset = apply::preset(name).map_err(|error| vec![error])?;
        Ok(Requested {
            scene: preset.scene(),
            preset: preset.name,
            ..Requested::default()
        })
    }

    /// These settings with other values, all of them or none.
    ///
    /// # Errors
    /// Every invalid value.
    pub fn with_values(&self, values: Values<'_>) -> Result<Requested, Vec<ValidationError>> {
        let names = |name: &str| values.iter().any(|(id, _)| id == name);
        let scene = apply::with_values(&self.scene, values)?;
        Ok(self.with_scene(scene, [COUNT, SPACING].map(|id| names(id).then_some(true))))
    }

    /// These settings with another scene, and whether it sets or restores the number of particles and
    /// their spacing.
    pub fn with_scene(&self, scene: Scene, overridden: [Option<bool>; 2]) -> Requested {
        // The classic model's number never follows the quality.
        let combustion = scene.settings().model() == Model::Combustion;
        let [count, spacing] = overridden.map(|named| named.filter(|_| combustion));
        let mut requested = Requested {
            scene,
            count_overridden: count.unwrap_or(self.count_overridden),
            spacing_overridden: spacing.unwrap_or(self.spacing_overridden),
            preset: self.preset,
        };
        requested.follow_domain();
        requested
    }

    /// The preset.
    pub fn preset(&self) -> &'static Preset {
        Preset::find(self.preset).unwrap_or(&Preset::all()[0])
    }

    /// The parameters.
    pub fn parameters(&self) -> &Parameters {
        self.scene.settings()
    }

    /// Whether exported settings include the number of particles even if it is the default.
    pub fn exports_count(&self) -> bool {
        self.count_overridden && self.parameters().model() == Model::Combustion
    }

    /// Whether a page set the resolution: the number of particles, or their spacing.
    fn is_fixed(&self) -> bool {
        self.count_overridden || self.spacing_overridden && self.parameters().has_open_edges()
    }

    /// The number of particles that the settings request.
    pub fn resolution(&self) -> Resolution {
        let (values, preset) = (self.parameters(), self.preset());
        let number = || self.completed().domain_particles();
        if values.model() == Model::Classic {
            Resolution::Classic(number())
        } else if self.is_fixed() {
            Resolution::Page(number())
        } else if preset.names(COUNT) && values.get(COUNT) == preset.parameters().get(COUNT) {
            Resolution::Scene(number())
        } else {
            Resolution::Level
        }
    }

    /// The parameters with the resolution that follows from what the page and the preset name.
    pub fn completed(&self) -> Parameters {
        let mut values = self.parameters().clone();
        let (spacing, count) = (self.spacing_overridden, self.count_overridden);
        self.preset().complete(&mut values, spacing, count);
        values
    }

    /// Adapts the spacing to the domain and the number of particles, unless a page set it.
    pub fn follow_domain(&mut self) {
        let now = self.completed().spacing;
        if self.parameters().has_open_edges() && now != self.parameters().spacing {
            let mut settings = self.parameters().clone();
            let set = settings.set(SPACING, Input::Number(now.into()));
            debug_assert_eq!(set, Ok(()));
            self.scene.set_settings(settings);
        }
    }

    /// The scene with that [number of particles](hearth_core::resolution::ParticleCount). Only levels raise the cap.
    pub fn at(&self, particles: u32) -> Scene {
        let mut values = self.completed();
        let resolution = self.resolution();
        if particles != resolution.number() {
            let cap = values.max_particles;
            values.set_domain_particles(particles);
            if values.max_particles > cap && resolution != Resolution::Level {
                let set = values.set(COUNT, Input::Number(cap.into()));
                debug_assert_eq!(set, Ok(()));
            }
        }
        let mut scene = self.scene.clone();
        scene.set_settings(values);
        scene
    }

    /// Whether frames cost as much as those of `other` at the same level. If not, measured
    /// times do not predict the next ones.
    pub fn costs_like(&self, other: &Requested) -> bool {
        let cost = |requested: &Requested| {
            let values = requested.parameters();
            let resolution = (values.max_particles, values.domain_particles());
            (values.model(), resolution, values.time_scale)
        };
        let follows_level = |requested: &Requested| requested.resolution() == Resolution::Level;
        cost(self) == cost(other) && follows_level(self) == follows_level(other)
    }
}

/// Applies a scene to a simulation. A burning fire is resampled if the number of particles
/// changes. A fire without a step is created again, so that the guess for the machine does not
/// influence it.
pub fn adapt(simulation: &mut Simulation, scene: Scene) {
    if simulation.time() > 0.0 {
        simulation.set_scene(scene);
    } else {
        *simulation = Simulation::new(scene);
    }
}
