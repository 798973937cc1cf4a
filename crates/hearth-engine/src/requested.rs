//! The settings that a page requests for a fire, and what it burns with at a level of
//! quality.

use hearth_bindings::{Untrusted, ValidationError, settings};
use hearth_core::params::{Input, Model};
use hearth_core::preset::{PRESETS, Preset};
use hearth_core::{Parameters, Scene, Simulation};

use crate::commands::{Command, Start};
use crate::config::Config;
use crate::quality::Level;

/// The number of particles, which follows the quality unless a page sets it.
pub(crate) const COUNT: &str = "max_particles";

/// Requested settings.
#[derive(Clone, Debug, PartialEq)]
pub struct Requested {
    /// The values and the objects.
    pub scene: Scene,
    /// Whether the combustion model's number of particles was set: the default number,
    /// too, is then kept at every quality.
    pub count_overridden: bool,
    /// The preset that the values started from.
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
    /// The values of the preset of that name.
    ///
    /// # Errors
    /// There is no preset of that name.
    pub fn of_preset(name: &str) -> Result<Requested, Vec<ValidationError>> {
        let preset = settings::preset(name).map_err(|error| vec![error])?;
        Ok(Requested {
            scene: preset.scene(),
            preset: preset.name,
            count_overridden: false,
        })
    }

    /// The scene of its preset alone.
    pub fn of_its_preset(&self) -> Scene {
        Preset::find(self.preset).map_or_else(Scene::default, Preset::scene)
    }

    /// The values.
    pub fn parameters(&self) -> &Parameters {
        self.scene.settings()
    }

    /// Whether the number of particles counts although it is the default one.
    pub fn names_count(&self) -> bool {
        self.count_overridden && self.parameters().model() == Model::Combustion
    }

    /// What a new fire starts with, and what was refused of what was requested. Here one
    /// bad value must not keep the good ones from a fire that has no other values yet.
    pub fn at_first(start: &Start<'_>) -> (Requested, Vec<ValidationError>) {
        let mut errors = Vec::new();
        let mut requested = Requested::default();
        let preset = start.preset.map(Requested::of_preset);
        let config = (!start.config.is_missing()).then(|| Config::requested_by(start.config));
        for base in [preset, config].into_iter().flatten() {
            match base {
                Ok(base) => requested = base,
                Err(refused) => errors.extend(refused),
            }
        }
        requested.count_overridden |= start.count_overridden;
        for values in [start.kept, start.values] {
            settings::set_valid(&mut requested.scene, values, &mut errors);
        }
        (requested, errors)
    }

    /// What is requested after a command; nothing where the command is about something
    /// else.
    ///
    /// # Errors
    /// What is refused of it.
    pub fn after(&self, command: &Command<'_>) -> Option<Result<Requested, Vec<ValidationError>>> {
        let object = match command {
            Command::AddObject { object, .. } => Some((None, Some(*object))),
            Command::ChangeObject { id, values, .. } => Some((Some(id.0), Some(*values))),
            Command::RemoveObject { id, .. } => Some((Some(id.0), None)),
            _ => None,
        };
        let (scene, overridden) = match command {
            _ if let Some((id, sent)) = object => {
                (settings::with_object(&self.scene, id, sent), None)
            }
            Command::Set { values, .. } => {
                let named = values.iter().any(|(id, _)| id == COUNT);
                let set = settings::with_values(&self.scene, values);
                (set, named.then_some(true))
            }
            Command::Restore { ids, .. } => {
                let named = ids.iter().any(|id| id.text() == COUNT);
                let ids: Vec<_> = ids
                    .iter()
                    .map(|id| (id.text().to_owned(), Untrusted::Missing))
                    .collect();
                let restored = settings::with_defaults(&self.scene, &ids);
                (restored, named.then_some(false))
            }
            Command::Preset { name, .. } => return Some(Requested::of_preset(name)),
            Command::Import { config, .. } => return Some(Config::requested_by(config)),
            _ => return None,
        };
        Some(scene.map(|scene| {
            // The classic model's number is another one, which does not follow quality.
            let combustion = scene.settings().model() == Model::Combustion;
            let overridden = overridden.filter(|_| combustion);
            Requested {
                scene,
                count_overridden: overridden.unwrap_or(self.count_overridden),
                preset: self.preset,
            }
        }))
    }

    /// Whether the number of particles follows the level.
    pub fn follows_level(&self) -> bool {
        self.parameters().model() == Model::Combustion
            && !self.count_overridden
            && self.parameters().max_particles == Level::Medium.particles()
    }

    /// Whether the number of particles is that of its scene.
    pub fn follows_scene(&self) -> bool {
        self.parameters().model() == Model::Combustion
            && !self.count_overridden
            && !self.follows_level()
    }

    /// The scene, with so many particles where their number was not set.
    pub fn at(&self, particles: u32) -> Scene {
        if self.follows_level() || self.follows_scene() {
            with_count(&self.scene, particles)
        } else {
            self.scene.clone()
        }
    }

    /// Whether a second of the clock is as much work at the same level: if not,
    /// what frames took says nothing about those to come.
    pub fn works_like(&self, other: &Requested) -> bool {
        let work = |requested: &Requested| {
            let values = requested.parameters();
            (values.model(), values.max_particles, values.time_scale)
        };
        work(self) == work(other) && self.follows_level() == other.follows_level()
    }
}

/// The same scene with so many particles.
pub(crate) fn with_count(scene: &Scene, particles: u32) -> Scene {
    let mut settings = scene.settings().clone();
    let set = settings.set(COUNT, Input::Number(particles.into()));
    debug_assert_eq!(set, Ok(()));
    let mut new = scene.clone();
    new.set_settings(settings);
    new
}

/// Gives a fire this scene. Where the number of particles changes, a burning fire is
/// resampled. A fire that has not begun is created again, so that it is the same on every
/// machine, whatever was the guess for it.
pub fn adapt(simulation: &mut Simulation, scene: Scene) {
    if simulation.time() > 0.0 {
        simulation.set_scene(scene);
    } else {
        *simulation = Simulation::new(scene);
    }
}
