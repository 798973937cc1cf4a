//! What somebody wants a fire to burn with, and what it burns with at a level of
//! quality.

use hearth_core::params::{Input, Model};
use hearth_core::preset::{PRESETS, Preset};
use hearth_core::{Parameters, Scene, Simulation};

use crate::config::Config;
use crate::message::{Order, Refused, Start, model_first};
use crate::quality::Level;
use crate::raw::Raw;
use crate::scene;

/// The number of particles, which is the level's affair unless somebody sets it.
pub(crate) const NUMBER: &str = "max_particles";

/// A fire's scene as somebody asked for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// The values and the objects.
    pub scene: Scene,
    /// Whether somebody set the combustion model's number of particles: the default
    /// one, too, is then kept.
    pub own_number: bool,
    /// The preset that the values started from.
    pub preset: &'static str,
}

impl Default for Wanted {
    fn default() -> Wanted {
        Wanted {
            scene: Scene::default(),
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
            scene: preset.scene(),
            preset: preset.name,
            own_number: false,
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
    pub fn names_number(&self) -> bool {
        self.own_number && self.parameters().model() == Model::Combustion
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
                let mut new = wanted.scene.clone();
                match scene::set(&mut new, std::slice::from_ref(value)) {
                    Ok(()) => wanted.scene = new,
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
        let mut own = None;
        let mut new = self.scene.clone();
        let done = match order {
            Order::Set(values) => {
                own = values.iter().any(|(id, _)| id == NUMBER).then_some(true);
                scene::set(&mut new, values)
            }
            Order::Restore(ids) => {
                own = ids.iter().any(|id| id == NUMBER).then_some(false);
                scene::restore(&mut new, ids)
            }
            Order::AddObject(object) => scene::edit(&mut new, None, Some(object)),
            Order::ChangeObject(id, values) => scene::edit(&mut new, Some(*id), Some(values)),
            Order::RemoveObject(id) => scene::edit(&mut new, Some(*id), None),
            Order::Preset(name) => return Some(Wanted::of_preset(name)),
            Order::Import(config) => return Some(config.wanted()),
            _ => return None,
        };
        Some(done.map(|()| {
            // The classic model's number is another one, and nobody else's.
            let own = own.filter(|_| new.settings().model() == Model::Combustion);
            Wanted {
                scene: new,
                own_number: own.unwrap_or(self.own_number),
                preset: self.preset,
            }
        }))
    }

    /// Whether the number of particles is the level's affair.
    pub fn follows_level(&self) -> bool {
        self.parameters().model() == Model::Combustion
            && !self.own_number
            && self.parameters().max_particles == Level::Medium.particles()
    }

    /// Whether the number of particles is that of its scene.
    pub fn follows_scene(&self) -> bool {
        self.parameters().model() == Model::Combustion && !self.own_number && !self.follows_level()
    }

    /// The scene, with so many particles where nobody set their number.
    pub fn at(&self, particles: u32) -> Scene {
        if self.follows_level() || self.follows_scene() {
            with_number(&self.scene, particles)
        } else {
            self.scene.clone()
        }
    }

    /// Whether a second of the clock is as much work at the same level: if not,
    /// what frames took says nothing about those to come.
    pub fn works_like(&self, other: &Wanted) -> bool {
        let work = |wanted: &Wanted| {
            let values = wanted.parameters();
            (values.model(), values.max_particles, values.time_scale)
        };
        work(self) == work(other) && self.follows_level() == other.follows_level()
    }
}

/// The same scene with so many particles.
pub(crate) fn with_number(scene: &Scene, particles: u32) -> Scene {
    let mut settings = scene.settings().clone();
    let set = settings.set(NUMBER, Input::Number(particles.into()));
    debug_assert_eq!(set, Ok(()));
    let mut new = scene.clone();
    new.set_settings(settings);
    new
}

/// Gives a fire this scene. One that burns is taken over by other particles where
/// their number changes; one that has not begun is made anew, so that it is the same
/// on every machine, whatever was the guess for it.
pub fn adapt(simulation: &mut Simulation, scene: Scene) {
    if simulation.time() > 0.0 {
        simulation.set_scene(scene);
    } else {
        *simulation = Simulation::new(scene);
    }
}
