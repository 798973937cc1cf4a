//! What somebody wants a fire to burn with, and what it burns with at a level of
//! quality.

use hearth_core::params::{Input, Model};
use hearth_core::preset::{PRESETS, Preset};
use hearth_core::{Parameters, Simulation};

use crate::config::Config;
use crate::message::{Order, Refused, Start, model_first, with_defaults, with_values};
use crate::quality::Level;
use crate::raw::Raw;

/// The number of particles, which is the level's affair unless somebody sets it.
pub(crate) const NUMBER: &str = "max_particles";

/// A fire's values as somebody asked for them.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// The values.
    pub parameters: Parameters,
    /// Whether somebody set the combustion model's number of particles: the default
    /// one, too, is then kept.
    pub own_number: bool,
    /// The preset that the values started from.
    pub preset: &'static str,
}

impl Default for Wanted {
    fn default() -> Wanted {
        Wanted {
            parameters: Parameters::default(),
            own_number: false,
            preset: PRESETS[0].name,
        }
    }
}

impl Wanted {
    /// The values of the preset of that name.
    ///
    /// # Errors
    /// There is no preset of that name.
    pub fn of_preset(name: &str) -> Result<Wanted, Vec<Refused>> {
        let preset = Preset::find(name).ok_or_else(|| {
            let names: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
            let allowed = format!("one of {}", names.join(", "));
            vec![Refused::field("preset", &Raw::Text(name.into()), &allowed)]
        })?;
        Ok(Wanted {
            parameters: preset.parameters(),
            preset: preset.name,
            own_number: false,
        })
    }

    /// The values of its preset alone.
    pub fn of_its_preset(&self) -> Parameters {
        Preset::find(self.preset).map_or_else(Parameters::default, Preset::parameters)
    }

    /// Whether the number of particles counts although it is the default one.
    pub fn names_number(&self) -> bool {
        self.own_number && self.parameters.model() == Model::Combustion
    }

    /// What a new fire starts with, and what was refused of what was asked for. Here
    /// one bad value must not keep the good ones from a fire that has no other
    /// values yet.
    pub fn at_first(start: &Start) -> (Wanted, Vec<Refused>) {
        let mut errors = Vec::new();
        let mut wanted = Wanted::default();
        let preset = start.preset.as_deref().map(Wanted::of_preset);
        let config = match &start.config {
            Raw::Missing => None,
            config => Some(
                Config::parse(config)
                    .map_err(|error| vec![error])
                    .and_then(|config| config.wanted()),
            ),
        };
        for base in [preset, config].into_iter().flatten() {
            match base {
                Ok(base) => wanted = base,
                Err(refused) => errors.extend(refused),
            }
        }
        wanted.own_number |= start.own_number;
        for values in [&start.kept, &start.values] {
            for value in model_first(values, |(id, _)| id) {
                match with_values(&wanted.parameters, std::slice::from_ref(value)) {
                    Ok(new) => wanted.parameters = new,
                    Err(refused) => errors.extend(refused),
                }
            }
        }
        (wanted, errors)
    }

    /// What is wanted after an order; nothing where it is about something else.
    ///
    /// # Errors
    /// What is refused of it.
    pub fn after(&self, order: &Order) -> Option<Result<Wanted, Vec<Refused>>> {
        let (parameters, own) = match order {
            Order::Set(values) => {
                let own = values.iter().any(|(id, _)| id == NUMBER).then_some(true);
                (with_values(&self.parameters, values), own)
            }
            Order::Restore(ids) => {
                let own = ids.iter().any(|id| id == NUMBER).then_some(false);
                (with_defaults(&self.parameters, ids), own)
            }
            Order::Preset(name) => return Some(Wanted::of_preset(name)),
            Order::Import(config) => return Some(config.wanted()),
            _ => return None,
        };
        Some(parameters.map(|parameters| {
            // The classic model's number is another one, and nobody else's.
            let own = own.filter(|_| parameters.model() == Model::Combustion);
            Wanted {
                parameters,
                own_number: own.unwrap_or(self.own_number),
                preset: self.preset,
            }
        }))
    }

    /// Whether the number of particles is the level's affair.
    pub fn follows_level(&self) -> bool {
        self.parameters.model() == Model::Combustion
            && !self.own_number
            && self.parameters.max_particles == Level::Medium.particles()
    }

    /// Whether the number of particles is that of its scene.
    pub fn follows_scene(&self) -> bool {
        self.parameters.model() == Model::Combustion && !self.own_number && !self.follows_level()
    }

    /// The values, with so many particles where nobody set their number.
    pub fn at(&self, particles: u32) -> Parameters {
        let mut parameters = self.parameters.clone();
        if self.follows_level() || self.follows_scene() {
            let particles = Input::Number(particles.into());
            let set = parameters.set(NUMBER, particles);
            debug_assert_eq!(set, Ok(()));
        }
        parameters
    }

    /// Whether a second of the clock is as much work at the same level: if not,
    /// what frames took says nothing about those to come.
    pub fn works_like(&self, other: &Wanted) -> bool {
        let work = |wanted: &Wanted| {
            let values = &wanted.parameters;
            (values.model(), values.max_particles, values.time_scale)
        };
        work(self) == work(other) && self.follows_level() == other.follows_level()
    }
}

/// Gives a fire these values. One that burns is taken over by other particles where
/// their number changes; one that has not begun is made anew, so that it is the same
/// on every machine, whatever was the guess for it.
pub fn adapt(simulation: &mut Simulation, parameters: Parameters) {
    if simulation.time() > 0.0 {
        simulation.set_parameters(parameters);
    } else {
        *simulation = Simulation::new(parameters);
    }
}
