//! All that is set of a fire, and the one function that changes it.

use crate::apply::{of_model, with_object, with_values};
use crate::untrusted::{Ids, Untrusted, ValidationError, Values};
use crate::{apply, file};
use hearth_core::params::{Input, Model};
use hearth_core::preset::Preset;
use hearth_core::resolution::Resolution;
use hearth_core::{Parameters, Scene, Simulation};

/// Id of the number of particles.
const COUNT: &str = "max_particles";
/// Id of the spacing of particles.
const SPACING: &str = "spacing";

/// The parameter that states the resolution of the combustion model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StatedResolution {
    /// None: the resolution follows the scene or the quality.
    #[default]
    Auto,
    /// The number of particles that would fill the domain.
    Count,
    /// The spacing of particles in open air. The number of particles is a cap.
    Spacing,
}

impl StatedResolution {
    /// Whether the resolution decides whether this parameter is a difference from the preset.
    pub(crate) fn is_part(id: &str) -> bool {
        [SPACING, COUNT].contains(&id)
    }

    /// Whether values with these ids state the resolution, and which of them does.
    pub(crate) fn among(names: &dyn Fn(&str) -> bool) -> Option<StatedResolution> {
        match [SPACING, COUNT].map(names) {
            [true, _] => Some(StatedResolution::Spacing),
            [_, true] => Some(StatedResolution::Count),
            _ => None,
        }
    }
}

/// A change of settings. Its values are not checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change<'a> {
    /// Values of parameters, and the list of `objects`, all or none. `undefined` states nothing, `null`
    /// restores.
    Set(Values<'a>),
    /// The defaults of parameters with these ids.
    Restore(Ids<'a>),
    /// An object is added.
    AddObject(Values<'a>),
    /// Properties of the object with this id change.
    ChangeObject(u32, Values<'a>),
    /// The object with this id is removed.
    RemoveObject(u32),
    /// A preset replaces all settings.
    Preset(&'a str),
    /// A [settings file](crate::file) replaces all settings.
    Import(&'a Untrusted),
}

impl Change<'_> {
    /// Whether it replaces all settings.
    pub fn replaces(&self) -> bool {
        matches!(self, Change::Preset(_) | Change::Import(_))
    }
}

/// Settings: the parameters of both models, the objects, the preset that they started from, and which
/// parameter states the resolution.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    preset: &'static str,
    scene: Scene,
    resolution: StatedResolution,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings::starting_from(&Preset::all()[0])
    }
}

impl Settings {
    /// The settings of a preset.
    pub fn starting_from(preset: &'static Preset) -> Settings {
        let mut settings = Settings {
            preset: preset.name,
            scene: preset.scene(),
            resolution: StatedResolution::Auto,
        };
        settings.settle();
        settings
    }

    /// The settings of the preset with this name.
    ///
    /// # Errors
    /// No preset has that name.
    pub fn of_preset(name: &str) -> Result<Settings, Vec<ValidationError>> {
        let preset = apply::preset(name).map_err(|error| vec![error])?;
        Ok(Settings::starting_from(preset))
    }

    /// The settings of a [file](crate::file).
    ///
    /// # Errors
    /// All validation errors of the file.
    pub fn of_file(file: &Untrusted) -> Result<Settings, Vec<ValidationError>> {
        file::read(file)
    }

    /// These settings with another scene, whose resolution is stated so.
    pub(crate) fn with(&self, scene: Scene, resolution: StatedResolution) -> Settings {
        let preset = self.preset;
        let mut settings = Settings {
            preset,
            scene,
            resolution,
        };
        settings.settle();
        settings
    }

    /// The settings after a change: the only way to change settings.
    ///
    /// # Errors
    /// All validation errors of the change.
    pub fn after(&self, change: &Change<'_>) -> Result<Settings, Vec<ValidationError>> {
        let with_object = |id, fields| {
            let scene = with_object(&self.scene, id, fields)?;
            Ok(self.with(scene, self.resolution))
        };
        match *change {
            Change::Preset(name) => Settings::of_preset(name),
            Change::Import(config) => Settings::of_file(config),
            Change::Set(values) => self.after_values(values),
            Change::Restore(ids) => {
                let null = |id: &Untrusted| (id.text().to_owned(), Untrusted::Null);
                self.after_values(&ids.iter().map(null).collect::<Vec<_>>())
            }
            Change::AddObject(fields) => with_object(None, Some(fields)),
            Change::ChangeObject(id, fields) => with_object(Some(id), Some(fields)),
            Change::RemoveObject(id) => with_object(Some(id), None),
        }
    }

    fn after_values(&self, values: Values<'_>) -> Result<Settings, Vec<ValidationError>> {
        let scene = with_values(&self.scene, values)?;
        // The classic model has a number of its own.
        let combustion = scene.settings().model() == Model::Combustion;
        let gives = |id: &str, null: bool| {
            let mut given = values
                .iter()
                .filter(|(known, value)| known == id && !value.is_missing());
            (id == SPACING || combustion)
                && given.any(|(_, value)| (*value == Untrusted::Null) == null)
        };
        use StatedResolution::{Auto, Count, Spacing};
        let kept = match self.resolution {
            // Without the spacing, a cap is the number.
            Spacing if gives(SPACING, true) && self.states(COUNT) && !gives(COUNT, true) => Count,
            Spacing if gives(SPACING, true) => Auto,
            Count if gives(COUNT, true) => Auto,
            kept => kept,
        };
        let resolution = match StatedResolution::among(&|id| gives(id, false)) {
            // Beside a spacing, the number is a cap.
            Some(Count) if kept == Spacing => Spacing,
            stated => stated.unwrap_or(kept),
        };
        Ok(self.with(scene, resolution))
    }

    /// The settings after the valid ones of these values, and an error for each invalid one.
    pub fn after_valid(&self, values: Values<'_>, errors: &mut Vec<ValidationError>) -> Settings {
        let mut settings = self.clone();
        // The model decides the domains of the other parameters.
        for of_model in [true, false] {
            for value in values.iter().filter(|(id, _)| (id == "model") == of_model) {
                match settings.after(&Change::Set(std::slice::from_ref(value))) {
                    Ok(after) => settings = after,
                    Err(refused) => errors.extend(refused),
                }
            }
        }
        settings
    }

    /// The preset.
    pub fn preset(&self) -> &'static Preset {
        Preset::find(self.preset).unwrap_or(&Preset::all()[0])
    }

    /// The parameters and the objects.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The parameters.
    pub fn parameters(&self) -> &Parameters {
        self.scene.settings()
    }

    /// Whether a value states the resolution or, beside a spacing, the cap.
    pub(crate) fn states(&self, id: &str) -> bool {
        match self.resolution {
            StatedResolution::Auto => false,
            StatedResolution::Count => id == COUNT,
            StatedResolution::Spacing => {
                let cap = |values: &Parameters| of_model(values, Model::Combustion).max_particles;
                let differs = || cap(self.parameters()) != cap(&self.preset().parameters());
                id == SPACING || id == COUNT && differs()
            }
        }
    }

    /// The number of particles that the settings state.
    pub fn resolution(&self) -> Resolution {
        let (values, preset) = (self.parameters(), self.preset());
        let number = || self.completed().domain_particles();
        let is_stated = match self.resolution {
            StatedResolution::Auto => false,
            StatedResolution::Count => true,
            StatedResolution::Spacing => values.has_open_edges() || self.states(COUNT),
        };
        if values.model() == Model::Classic {
            Resolution::Classic(number())
        } else if is_stated {
            Resolution::Page(number())
        } else if preset.names(COUNT) && values.get(COUNT) == preset.parameters().get(COUNT) {
            Resolution::Scene(number())
        } else {
            Resolution::Level
        }
    }

    /// The parameters with the resolution that follows from what the settings and the preset state.
    pub fn completed(&self) -> Parameters {
        let mut values = self.parameters().clone();
        let [spacing, count] = [SPACING, COUNT].map(|id| self.states(id));
        self.preset().complete(&mut values, spacing, count);
        values
    }

    /// Adapts what is not stated of the resolution to the preset and the domain, even while a closed box has no use
    /// for it. While the classic model burns, it is the default.
    fn settle(&mut self) {
        let model = self.parameters().model();
        let mut values = of_model(self.parameters(), Model::Combustion);
        let put = |values: &mut Parameters, id, input| {
            let set = values.set(id, input);
            debug_assert_eq!(set, Ok(()));
        };
        if self.resolution == StatedResolution::Auto {
            let cap = of_model(&self.preset().parameters(), Model::Combustion).max_particles;
            put(&mut values, COUNT, Input::Number(cap.into()));
        }
        if model == Model::Combustion {
            let mut open = values.clone();
            put(&mut open, "edges", Input::Text("open"));
            let [spacing, count] = [SPACING, COUNT].map(|id| self.states(id));
            self.preset().complete(&mut open, spacing, count);
            put(&mut values, SPACING, Input::Number(open.spacing.into()));
        } else if !self.states(SPACING) {
            let restored = values.restore(SPACING);
            debug_assert_eq!(restored, Ok(()));
        }
        self.scene.set_settings(of_model(&values, model));
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
    pub fn costs_like(&self, other: &Settings) -> bool {
        let cost = |settings: &Settings| {
            let values = settings.parameters();
            let resolution = (values.max_particles, values.domain_particles());
            (values.model(), resolution, values.time_scale)
        };
        let follows_level = |settings: &Settings| settings.resolution() == Resolution::Level;
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
