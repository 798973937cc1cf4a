//! All that is set of a fire, and the one function that changes it.

use crate::apply::{self, fields, is_of_other_model, of_object, set_values, starts_with_model};
use crate::children::child::Child;
use crate::children::{compose, divide};
use crate::file;
use crate::untrusted::{Argument, Untrusted, ValidationError, Values};
use hearth_core::params::{Input, Model};
use hearth_core::preset::Preset;
use hearth_core::resolution::Resolution;
use hearth_core::{Parameters, Scene, Simulation};

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

    /// The resolution after these values.
    fn after(mut self, values: Values<'_>) -> StatedResolution {
        for (own, id) in StatedResolution::IDS {
            for (_, value) in values.iter().filter(|(known, _)| known == id) {
                match value {
                    Untrusted::Missing => {}
                    Untrusted::Null if self != own => {}
                    Untrusted::Null => self = StatedResolution::Auto,
                    _ => self = own,
                }
            }
        }
        self
    }
}

/// A change of settings. Its values are not checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change<'a> {
    /// Values of parameters, and the list of `objects`, all or none. `undefined` states nothing, `null` restores.
    Set(Values<'a>),
    /// Such values. With another model, what attributes of the page state, the second values, applies again.
    SetModel(Values<'a>, Values<'a>),
    /// The page states such values in attributes. One that the model has no use for has no effect. The objects of
    /// children stay.
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

/// Settings: the preset that they started from, the scene, which parameter states the resolution, and the children of
/// the element.
#[derive(Clone, Debug)]
pub struct Settings {
    pub(crate) preset: &'static str,
    /// The scene of the page, without the objects of its children.
    pub(crate) page: Scene,
    pub(crate) resolution: StatedResolution,
    pub(crate) children: Vec<Child>,
    /// What burns: the scene of the page composed with its children.
    scene: Scene,
    /// The number of the list of objects. Another list may have the same ids.
    pub(crate) list: u32,
    /// Smallest id that no object of the page has had.
    pub(crate) next_id: u32,
}

impl PartialEq for Settings {
    fn eq(&self, other: &Settings) -> bool {
        let parts = |settings: &Settings| (settings.preset, settings.resolution);
        parts(self) == parts(other) && self.page == other.page && self.children == other.children
    }
}

impl Default for Settings {
    fn default() -> Settings {
        Settings::starting_from(Preset::initial())
    }
}

impl Settings {
    /// The settings of a preset.
    pub fn starting_from(preset: &'static Preset) -> Settings {
        let scene = preset.scene();
        let settings = Settings {
            preset: preset.name,
            page: scene.clone(),
            resolution: StatedResolution::Auto,
            children: Vec::new(),
            scene,
            list: 0,
            next_id: 1,
        };
        settings.composed()
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
        file::check(config).map_err(|error| vec![error])?;
        let mut settings = match Argument::read(config.field("preset")) {
            Some(name) => Settings::of_preset(name)?,
            None => Settings::default(),
        };
        let mut values = config.field("values").fields().to_vec();
        values.push(Untrusted::named(
            apply::OBJECTS,
            config.field(apply::OBJECTS).clone(),
        ));
        let mut errors = Vec::new();
        set_values(&mut settings.page, &values, &mut errors);
        if !errors.is_empty() {
            return Err(errors);
        }
        settings.resolution = StatedResolution::Auto.after(&values);
        Ok(settings.composed())
    }

    /// The settings of a file with the children that it has, whose list the element sends next.
    ///
    /// # Errors
    /// All validation errors of the file.
    pub fn of_whole(config: &Untrusted) -> Result<Settings, Vec<ValidationError>> {
        let mut settings = Settings::of_file(config)?;
        settings.children = Child::read_all(config.field(file::CHILDREN));
        Ok(settings.composed())
    }

    /// The settings after a change: the only way to change settings.
    ///
    /// # Errors
    /// All validation errors of the change.
    pub fn after(&self, change: &Change<'_>) -> Result<Settings, Vec<ValidationError>> {
        let mut settings = self.clone();
        let mut errors = Vec::new();
        match *change {
            Change::Preset(name) => return Ok(self.replaced(Settings::of_preset(name)?)),
            Change::State(values) => {
                let known = |(id, _): &&(String, Untrusted)| !is_of_other_model(&self.page, id);
                let values: Vec<_> = values.iter().filter(known).cloned().collect();
                set_values(&mut settings.page, &values, &mut errors);
                settings.state(&values);
            }
            _ => {
                let mut scene = self.scene.clone();
                self.apply(&mut scene, change, &mut errors);
                let has_model = scene.model() == self.scene.model();
                match settings.children.is_empty() {
                    true => settings.page = scene,
                    false => divide(&mut settings, change, &scene),
                }
                if let Change::Set(values) | Change::SetModel(values, _) = *change {
                    if let (false, Change::SetModel(_, attributes)) = (has_model, change) {
                        settings.resolution = StatedResolution::Auto.after(attributes);
                    }
                    settings.state(values);
                }
            }
        }
        match errors.is_empty() {
            true => Ok(settings.composed()),
            false => Err(errors),
        }
    }

    /// Applies a change to the scene that burns.
    fn apply(&self, scene: &mut Scene, change: &Change<'_>, errors: &mut Vec<ValidationError>) {
        let (done, sent) = match *change {
            Change::Set(values) => return set_values(scene, values, errors),
            Change::SetModel(values, attributes) => {
                set_values(scene, values, errors);
                if scene.model() != self.scene.model() {
                    let stated = |id: &str| values.iter().any(|(known, _)| known == id);
                    let applies = |(id, _): &&(String, Untrusted)| {
                        !stated(id) && starts_with_model(scene, id)
                    };
                    let again: Vec<_> = attributes.iter().filter(applies).cloned().collect();
                    // An attribute that is refused has been reported.
                    for value in &again {
                        set_values(scene, std::slice::from_ref(value), &mut Vec::new());
                    }
                }
                return;
            }
            Change::AddObject(sent) => {
                let mut fields = fields(sent);
                if fields.iter().all(|(name, _)| *name != "id") {
                    fields.push(("id", Input::Number(self.next_id.into())));
                }
                (scene.add(&fields).map(|_| ()), sent)
            }
            Change::ChangeObject(id, sent) => (scene.change(id, &fields(sent)), sent),
            Change::RemoveObject(id) => (scene.remove(id), [].as_slice()),
            Change::State(_) | Change::Preset(_) => return,
        };
        let refused = done.err().unwrap_or_default();
        errors.extend(refused.iter().map(|error| of_object(error, sent)));
    }

    /// Follows the resolution and the list of objects that values state.
    pub(crate) fn state(&mut self, values: Values<'_>) {
        self.resolution = self.resolution.after(values);
        let is_list =
            |(id, value): &(String, Untrusted)| id == apply::OBJECTS && !value.is_missing();
        self.list += u32::from(values.iter().any(is_list));
    }

    /// The settings of a [file](crate::file), with the children of these. [Whole](crate::whole) settings restore what
    /// calls have set of them.
    ///
    /// # Errors
    /// All validation errors of the file.
    pub fn after_file(&self, config: &Untrusted) -> Result<Settings, Vec<ValidationError>> {
        let mut settings = self.replaced(Settings::of_file(config)?);
        let children = config.field(file::CHILDREN);
        if self.children.is_empty() || children.is_missing() {
            return Ok(settings);
        }
        settings.restore_children(&Child::read_all(children));
        Ok(settings.composed())
    }

    /// Other settings of the page, with the children of these.
    fn replaced(&self, other: Settings) -> Settings {
        let mut settings = Settings {
            children: self.children.clone(),
            list: self.list + 1,
            next_id: self.next_id,
            ..other
        };
        if !settings.children.is_empty() {
            crate::children::detach_all(&mut settings);
        }
        settings.composed()
    }

    /// The settings after the valid ones of these attributes, and an error for each invalid one.
    pub fn after_valid(&self, values: Values<'_>, errors: &mut Vec<ValidationError>) -> Settings {
        let mut settings = self.clone();
        // The model decides the domains of the other parameters.
        let (models, others): (Vec<_>, Vec<_>) =
            values.iter().partition(|(id, _)| id == apply::MODEL);
        for value in models.into_iter().chain(others) {
            match settings.after(&Change::State(std::slice::from_ref(value))) {
                Ok(after) => settings = after,
                Err(refused) => errors.extend(refused),
            }
        }
        settings
    }

    /// These settings with what follows from their parts.
    pub(crate) fn composed(mut self) -> Settings {
        self.settle();
        let largest = self.page.ids().max().unwrap_or_default();
        self.next_id = self.next_id.max(largest + 1);
        self.scene = match self.children.is_empty() {
            true => self.page.clone(),
            false => compose(&self.page, &self.children, &self.scene, &mut Vec::new()),
        };
        self
    }

    /// The preset.
    pub fn preset(&self) -> &'static Preset {
        Preset::find(self.preset).unwrap_or(Preset::initial())
    }

    /// Whether the element has children.
    pub fn has_children(&self) -> bool {
        !self.children.is_empty()
    }

    /// What burns.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The values of its world.
    pub fn parameters(&self) -> &Parameters {
        self.scene.world()
    }

    /// Whether a parameter states the resolution; `None` for one that cannot.
    pub(crate) fn states(&self, id: &str) -> Option<bool> {
        let mut all = StatedResolution::IDS.iter();
        let found = all.find(|(_, known)| *known == id);
        found.map(|(own, _)| self.resolution == *own)
    }

    /// Whether the cap is another one than that of the preset.
    fn has_cap(&self) -> bool {
        self.page.get(CAP) != self.base().get(CAP)
    }

    /// Completes the resolution of a world.
    fn complete(&self, world: &mut Parameters) {
        let names = |id: &str| {
            self.states(id)
                .unwrap_or_else(|| id == CAP && self.has_cap())
        };
        self.preset().complete(world, &names);
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
        self.complete(&mut values);
        values
    }

    /// The scene of the preset in the model of these settings.
    pub(crate) fn base(&self) -> Scene {
        let mut base = self.preset().scene();
        let set = base.set(apply::MODEL, Input::Text(self.page.model().name()));
        debug_assert_eq!(set, Ok(()));
        base
    }

    /// Adapts what is not stated of the resolution to the preset and the domain, even while a closed box has no use
    /// for it.
    fn settle(&mut self) {
        if self.page.model() == Model::Classic {
            self.resolution = StatedResolution::Auto;
            return;
        }
        let mut values = self.page.world().clone();
        let put = |values: &mut Parameters, id, input: Input<'_>| {
            let set = values.set(id, input);
            debug_assert_eq!(set, Ok(()));
        };
        let mut open = values.clone();
        put(&mut open, "edges", Input::Text("open"));
        self.complete(&mut open);
        put(&mut values, SPACING, Input::Number(open.spacing.into()));
        put(&mut values, COUNT, Input::Number(open.particles.into()));
        self.page.set_world(values);
    }

    /// The scene with that [number of particles](hearth_core::resolution::ParticleCount). Only levels raise the cap, unless it is stated.
    pub fn at(&self, particles: u32) -> Scene {
        let mut values = self.completed();
        let resolution = self.resolution();
        if particles != resolution.number() {
            let cap = values.max_particles;
            values.set_domain_particles(particles);
            if values.max_particles > cap && (resolution != Resolution::Level || self.has_cap()) {
                let set = values.set(CAP, Input::Number(cap.into()));
                debug_assert_eq!(set, Ok(()));
            }
        }
        let mut scene = self.scene.clone();
        scene.set_world(values);
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
