//! The settings that a page requests, and the scene that follows from them at a level of
//! quality.

mod change;

use hearth_bindings::{ValidationError, settings};
use hearth_core::params::{Input, Model};
use hearth_core::preset::{PRESETS, Preset};
use hearth_core::{Parameters, Scene, Simulation};

use crate::quality::Level;

/// The parameter that follows the quality unless a page sets it.
pub(crate) const COUNT: &str = "max_particles";

/// Requested settings.
#[derive(Clone, Debug, PartialEq)]
pub struct Requested {
    /// Parameters and objects.
    pub scene: Scene,
    /// Whether a page set the combustion model's number of particles. The fire then keeps it at
    /// every quality, even the default number.
    pub count_overridden: bool,
    /// The preset that the settings started from.
    pub preset: &'static str,
}

impl Default for Requested {
    fn default() -> Requested {
        Requested {
            scene: Scene::default(),
            count_overridden: false,
            preset: PRESETS[0].name,
        }
    }
}

impl Requested {
    /// The settings of a preset.
    ///
    /// # Errors
    /// No preset has that name.
    pub fn of_preset(name: &str) -> Result<Requested, Vec<ValidationError>> {
        let preset = settings::preset(name).map_err(|error| vec![error])?;
        Ok(Requested {
            scene: preset.scene(),
            preset: preset.name,
            count_overridden: false,
        })
    }

    /// The scene of the preset without changes.
    pub fn preset_scene(&self) -> Scene {
        Preset::find(self.preset).map_or_else(Scene::default, Preset::scene)
    }

    /// The parameters.
    pub fn parameters(&self) -> &Parameters {
        self.scene.settings()
    }

    /// Whether exported settings include the number of particles even if it is the default.
    pub fn exports_count(&self) -> bool {
        self.count_overridden && self.parameters().model() == Model::Combustion
    }

    /// Whether the number of particles follows the level.
    pub fn follows_level(&self) -> bool {
        self.parameters().model() == Model::Combustion
            && !self.count_overridden
            && self.parameters().max_particles == Level::Medium.particles()
    }

    /// Whether the number of particles comes from the scene.
    pub fn follows_scene(&self) -> bool {
        self.parameters().model() == Model::Combustion
            && !self.count_overridden
            && !self.follows_level()
    }

    /// The scene, with that number of particles unless a page set the number.
    pub fn at(&self, particles: u32) -> Scene {
        if self.follows_level() || self.follows_scene() {
            with_count(&self.scene, particles)
        } else {
            self.scene.clone()
        }
    }

    /// Whether frames cost as much as those of `other` at the same level. If not, measured
    /// times do not predict the next ones.
    pub fn costs_like(&self, other: &Requested) -> bool {
        let cost = |requested: &Requested| {
            let values = requested.parameters();
            (values.model(), values.max_particles, values.time_scale)
        };
        cost(self) == cost(other) && self.follows_level() == other.follows_level()
    }
}

/// A scene with another number of particles.
pub(crate) fn with_count(scene: &Scene, particles: u32) -> Scene {
    let mut settings = scene.settings().clone();
    let set = settings.set(COUNT, Input::Number(particles.into()));
    debug_assert_eq!(set, Ok(()));
    let mut new = scene.clone();
    new.set_settings(settings);
    new
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
