//! All that is set of a fire, and the one function that changes it.

use crate::apply::{of_model, with_object, with_settings, with_values};
use crate::children::overlay::{Laid, Overlay};
use crate::file::{CHILDREN, FIRST};
use crate::untrusted::{Argument, Untrusted, ValidationError, Values};
use crate::{apply, file};
use hearth_core::params::{Input, Model};
use hearth_core::preset::Preset;
use hearth_core::resolution::Resolution;
use hearth_core::{Parameters, Scene, Simulation};
use std::sync::Arc;

/// Id of the number of particles.
const COUNT: &str = "particles";
/// Id of the spacing of particles.
const SPACING: &str = "spacing";
/// Id of the largest number of particles.
const CAP: &str = "max_particles";

/// The parameter that states the resolution of the combustion model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StatedResolution {
    /// None: the resolution follows the scene or the quality.
    #[default]
    Auto,
    /// The number of particles that would fill the domain.
    Count,
    /// The spacing of particles in open air.
    Spacing,
}

impl StatedResolution {
    /// What states the resolution, and the parameters that state it. Of two, the last one wins.
    const IDS: [(StatedResolution, &str); 2] = [
        (StatedResolution::Count, COUNT),
        (StatedResolution::Spacing, SPACING),
    ];

    /// Whether the resolution decides whether this parameter is a difference from the preset.
    pub(crate) fn is_part(id: &str) -> bool {
        [SPACING, COUNT].contains(&id)
    }
}

/// A change of settings. Its values are not checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change<'a> {
    /// Values of parameters, and the list of `objects`, all or none. `undefined` states nothing, `null`
    /// restores.
    Set(Values<'a>),
    /// The page states such values. The objects of children stay.
    State(Values<'a>),
    /// An object is added.
    AddObject(Values<'a>),
    /// Properties of the object with this id change.
    ChangeObject(u32, Values<'a>),
    /// The object with this id is removed.
    RemoveObject(u32),
    /// A preset replaces all settings. Children stay.
    Preset(&'a str),
}

/// Settings: the parameters of both models, the objects, the preset that they started from, which
/// parameter states the resolution, and the children of the element.
#[derive(Clone, Debug)]
pub struct Settings {
    preset: &'static str,
    scene: Scene,
    resolution: StatedResolution,
    /// The children, behind whose table is code that is loaded with the first one.
    pub(crate) children: Option<Arc<dyn Overlay>>,
    /// The id of the first object of the preset.
    pub(crate) first_id: u32,
    /// The largest id that an object of the page had.
    pub(crate) last_id: u32,
}

impl PartialEq for Settings {
    fn eq(&self, other: &Settings) -> bool {
        let same_children = match (&self.children, &other.children) {
            (Some(children), Some(others)) => children.equals(&**others),
            (children, others) => children.is_none() && others.is_none(),
        };
        let parts = |settings: &Settings| (settings.preset, settings.first_id, settings.resolution);
        same_children && parts(self) == parts(other) && self.scene == other.scene
    }
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
            children: None,
            first_id: 1,
            last_id: 0,
        };
        settings.settle();
        settings.record_ids(0);
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

    /// The settings of a [file](crate::file), without children.
    ///
    /// # Errors
    /// All validation errors of the file.
    pub fn of_file(config: &Untrusted) -> Result<Settings, Vec<ValidationError>> {
        let fields = file::fields(config).map_err(|error| vec![error])?;
        let base = match Argument::read(config.field("preset")) {
            Some(name) => Settings::of_preset(name)?,
            None => Settings::default(),
        };
        let scene = with_settings(&base.scene, fields)?;
        let mut resolution = StatedResolution::Auto;
        for (own, id) in StatedResolution::IDS {
            for field in ["values", Model::Combustion.name()] {
                if !config.field(field).field(id).is_missing() {
                    resolution = own;
                }
            }
        }
        let mut settings = base.with(scene, resolution);
        if let Untrusted::Number(first) = config.field(FIRST) {
            settings.first_id = (*first as u32).max(1);
        }
        Ok(settings)
    }

    /// These settings with another scene, whose resolution is stated so.
    fn with(&self, scene: Scene, resolution: StatedResolution) -> Settings {
        let mut settings = Settings {
            preset: self.preset,
            scene,
            resolution,
            children: self.children.clone(),
            ..*self
        };
        settings.settle();
        if let Some(children) = &self.children {
            settings = settings.burning(children.divided(settings.scene.clone(), self.scene()));
        }
        settings.record_ids(0);
        settings
    }

    /// The settings after a change: the only way to change settings.
    ///
    /// # Errors
    /// All validation errors of the change.
    pub fn after(&self, change: &Change<'_>) -> Result<Settings, Vec<ValidationError>> {
        let with_object = |id, fields| {
            let scene = with_object(&self.scene, id, fields, self.next_id())?;
            Ok(self.with(scene, self.resolution))
        };
        match *change {
            Change::Preset(name) => {
                let preset = Settings::of_preset(name)?;
                self.replaced(Ok(self.numbered_after(&preset)), None)
            }
            Change::State(values) => self.replaced(self.bare().after_values(values), None),
            Change::Set(values) => self.after_values(values),
            Change::AddObject(fields) => with_object(None, Some(fields)),
            Change::ChangeObject(id, fields) => with_object(Some(id), Some(fields)),
            Change::RemoveObject(id) => with_object(Some(id), None),
        }
    }

    /// The settings of a [file](crate::file), with the children of these. Whole settings restore what calls have set of
    /// them.
    ///
    /// # Errors
    /// All validation errors of the file.
    pub fn after_file(&self, config: &Untrusted) -> Result<Settings, Vec<ValidationError>> {
        let file = Settings::of_file(config)?;
        match config.field(CHILDREN).is_missing() {
            true => self.replaced(Ok(self.numbered_after(&file)), None),
            false => self.replaced(Ok(file), Some(config)),
        }
    }

    /// Other settings with the children of these.
    fn replaced(
        &self,
        other: Result<Settings, Vec<ValidationError>>,
        whole: Option<&Untrusted>,
    ) -> Result<Settings, Vec<ValidationError>> {
        let mut other = other?;
        if let Some(children) = &self.children {
            other = other.burning(children.over(other.scene.clone(), self.scene(), whole));
        }
        other.record_ids(self.last_id);
        Ok(other)
    }

    /// The settings with this scene and these children.
    pub(crate) fn burning(&self, (scene, children): Laid) -> Settings {
        Settings {
            scene,
            children,
            ..*self
        }
    }

    fn after_values(&self, values: Values<'_>) -> Result<Settings, Vec<ValidationError>> {
        let scene = self.numbered_by_place(values, with_values(&self.scene, values)?);
        let mut resolution = self.resolution;
        for (own, id) in StatedResolution::IDS {
            for (_, value) in values.iter().filter(|(known, _)| known == id) {
                match value {
                    Untrusted::Missing => {}
                    Untrusted::Null if resolution != own => {}
                    Untrusted::Null => resolution = StatedResolution::Auto,
                    _ => resolution = own,
                }
            }
        }
        Ok(self.with(scene, resolution))
    }

    /// The settings after the valid ones of these values, and an error for each invalid one.
    pub fn after_valid(&self, values: Values<'_>, errors: &mut Vec<ValidationError>) -> Settings {
        let mut settings = self.clone();
        // The model decides the domains of the other parameters.
        let (models, others): (Vec<_>, Vec<_>) = values.iter().partition(|(id, _)| id == "model");
        for value in models.into_iter().chain(others) {
            match settings.after(&Change::Set(std::slice::from_ref(value))) {
                Ok(after) => settings = after,
                Err(refused) => errors.extend(refused),
            }
        }
        settings
    }

    /// The settings without the children.
    pub(crate) fn bare(&self) -> Settings {
        let own = self.children.as_ref().map(|children| children.own());
        self.burning((own.unwrap_or(&self.scene).clone(), None))
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

    /// Whether a value states the resolution or the cap.
    pub(crate) fn states(&self, id: &str) -> bool {
        match id {
            COUNT => self.resolution == StatedResolution::Count,
            SPACING => self.resolution == StatedResolution::Spacing,
            CAP => {
                let [own, of_preset] = [self.parameters(), &self.preset().parameters()]
                    .map(|values| of_model(values, Model::Combustion).max_particles);
                own != of_preset
            }
            _ => false,
        }
    }

    /// The number of particles that the settings state.
    pub fn resolution(&self) -> Resolution {
        let (values, preset) = (self.parameters(), self.preset());
        let number = || self.completed().domain_particles();
        let is_stated = match self.resolution {
            StatedResolution::Auto => false,
            StatedResolution::Count => true,
            StatedResolution::Spacing => values.has_open_edges(),
        };
        if values.model() == Model::Classic {
            Resolution::Classic(number())
        } else if is_stated {
            Resolution::Page(number())
        } else if preset.names(COUNT) {
            Resolution::Scene(number())
        } else {
            Resolution::Level
        }
    }

    /// The parameters with the resolution that follows from what the settings and the preset state.
    pub fn completed(&self) -> Parameters {
        let mut values = self.parameters().clone();
        self.preset().complete(&mut values, &|id| self.states(id));
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
        if model == Model::Combustion {
            let mut open = values.clone();
            put(&mut open, "edges", Input::Text("open"));
            self.preset().complete(&mut open, &|id| self.states(id));
            put(&mut values, SPACING, Input::Number(open.spacing.into()));
            put(&mut values, COUNT, Input::Number(open.particles.into()));
        } else {
            for id in [SPACING, COUNT].into_iter().filter(|id| !self.states(id)) {
                let restored = values.restore(id);
                debug_assert_eq!(restored, Ok(()));
            }
        }
        self.scene.set_settings(of_model(&values, model));
    }

    /// The scene with that [number of particles](hearth_core::resolution::ParticleCount). Only levels raise the cap, unless it is stated.
    pub fn at(&self, particles: u32) -> Scene {
        let mut values = self.completed();
        let resolution = self.resolution();
        if particles != resolution.number() {
            let cap = values.max_particles;
            values.set_domain_particles(particles);
            if values.max_particles > cap && (resolution != Resolution::Level || self.states(CAP)) {
                let set = values.set(CAP, Input::Number(cap.into()));
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
        simulation.begin(scene);
    }
}
