//! The settings that a page requests for a fire, and what it burns with at a level of
//! quality.

use hearth_bindings::{Untrusted, ValidationError, settings};
use hearth_core::params::{Input, Model};
use hearth_core::preset::{PRESETS, Preset};
use hearth_core::{Parameters, Simulation};

use crate::commands::{Command, Start};
use crate::config::Config;
use crate::quality::Level;

/// The number of particles, which follows the quality unless a page sets it.
pub(crate) const COUNT: &str = "max_particles";

/// Requested settings.
#[derive(Clone, Debug, PartialEq)]
pub struct Requested {
    /// The values.
    pub parameters: Parameters,
    /// Whether the combustion model's number of particles was set: the default number,
    /// too, is then kept at every quality.
    pub count_overridden: bool,
    /// The preset that the values started from.
    pub preset: &'static str,
}

impl Default for Requested {
    fn default() -> Requested {
        Requested {
            parameters: Parameters::default(),
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
            parameters: preset.parameters(),
            preset: preset.name,
            count_overridden: false,
        })
    }

    /// The values of its preset alone.
    pub fn of_its_preset(&self) -> Parameters {
        Preset::find(self.preset).map_or_else(Parameters::default, Preset::parameters)
    }

    /// Whether the number of particles counts although it is the default one.
    pub fn names_count(&self) -> bool {
        self.count_overridden && self.parameters.model() == Model::Combustion
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
            settings::set_good(&mut requested.parameters, values, &mut errors);
        }
        (requested, errors)
    }

    /// What is requested after a command; nothing where the command is about something
    /// else.
    ///
    /// # Errors
    /// What is refused of it.
    pub fn after(&self, command: &Command<'_>) -> Option<Result<Requested, Vec<ValidationError>>> {
        let (parameters, overridden) = match command {
            Command::Set { values, .. } => {
                let named = values.iter().any(|(id, _)| id == COUNT);
                let set = settings::with_values(&self.parameters, values);
                (set, named.then_some(true))
            }
            Command::Restore { ids, .. } => {
                let named = ids.iter().any(|id| id.text() == COUNT);
                let ids: Vec<_> = ids
                    .iter()
                    .map(|id| (id.text().to_owned(), Untrusted::Missing))
                    .collect();
                let restored = settings::with_defaults(&self.parameters, &ids);
                (restored, named.then_some(false))
            }
            Command::Preset { name, .. } => return Some(Requested::of_preset(name)),
            Command::Import { config, .. } => return Some(Config::requested_by(config)),
            _ => return None,
        };
        Some(parameters.map(|parameters| {
            // The classic model's number is another one, which does not follow quality.
            let overridden = overridden.filter(|_| parameters.model() == Model::Combustion);
            Requested {
                parameters,
                count_overridden: overridden.unwrap_or(self.count_overridden),
                preset: self.preset,
            }
        }))
    }

    /// Whether the number of particles follows the level.
    pub fn follows_level(&self) -> bool {
        self.parameters.model() == Model::Combustion
            && !self.count_overridden
            && self.parameters.max_particles == Level::Medium.particles()
    }

    /// Whether the number of particles is that of its scene.
    pub fn follows_scene(&self) -> bool {
        self.parameters.model() == Model::Combustion
            && !self.count_overridden
            && !self.follows_level()
    }

    /// The values, with so many particles where their number was not set.
    pub fn at(&self, particles: u32) -> Parameters {
        let mut parameters = self.parameters.clone();
        if self.follows_level() || self.follows_scene() {
            let particles = Input::Number(particles.into());
            let set = parameters.set(COUNT, particles);
            debug_assert_eq!(set, Ok(()));
        }
        parameters
    }

    /// Whether a second of the clock is as much work at the same level: if not,
    /// what frames took says nothing about those to come.
    pub fn works_like(&self, other: &Requested) -> bool {
        let work = |requested: &Requested| {
            let values = &requested.parameters;
            (values.model(), values.max_particles, values.time_scale)
        };
        work(self) == work(other) && self.follows_level() == other.follows_level()
    }
}

/// Gives a fire these values. Where the number of particles changes, a burning fire is
/// resampled. A fire that has not begun is created again, so that it is the same on every
/// machine, whatever was the guess for it.
pub fn adapt(simulation: &mut Simulation, parameters: Parameters) {
    if simulation.time() > 0.0 {
        simulation.set_parameters(parameters);
    } else {
        *simulation = Simulation::new(parameters);
    }
}
