//! All that is set of a fire, and the one function that changes it.

use crate::apply::{
    self, fields, free_id, is_of_other_model, of_object, set_values, starts_with_model,
};
use crate::change::Change;
use crate::children::child::Child;
use crate::children::compose::compose;
use crate::children::divide::{detach_all, divide};
use crate::file;
use crate::resolution::StatedResolution;
use crate::untrusted::{Argument, Untrusted, ValidationError, Values};
use hearth_core::params::Input;
use hearth_core::preset::Preset;
use hearth_core::{Parameters, Scene};

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
    /// The id of the next object of the page: the smallest that none has had, as long as there is one.
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
        Settings::starting_from(&Preset::all()[0])
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
        values.push(Untrusted::field_of(
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
        settings.list = config.field(file::LIST).number() as u32;
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
                    false => {
                        let before = (&self.scene, &scene);
                        let (page, children) = (&mut settings.page, &mut settings.children);
                        divide(page, children, change, before);
                    }
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
            true => Ok(settings.composed().with_list_of(self)),
            false => Err(errors),
        }
    }

    /// The settings with the number of the list of others, if they have the same objects.
    fn with_list_of(mut self, before: &Settings) -> Settings {
        if self.page == before.page {
            self.list = before.list;
        }
        self
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
        if values.iter().any(is_list) {
            self.list = self.list.wrapping_add(1);
        }
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
            list: self.list.wrapping_add(1),
            next_id: self.next_id,
            ..other
        };
        if !settings.children.is_empty() {
            let (page, children) = (&mut settings.page, &mut settings.children);
            for child in &mut *children {
                child.is_beside = false;
            }
            detach_all(page, children, &mut settings.next_id);
        }
        settings.composed().with_list_of(self)
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
        self.next_id = free_id(&self.page, self.next_id);
        self.scene = match self.children.is_empty() {
            true => self.page.clone(),
            false => compose(&self.page, &self.children, &self.scene, &mut Vec::new()),
        };
        self
    }

    /// The preset.
    pub fn preset(&self) -> &'static Preset {
        Preset::find(self.preset).unwrap_or(&Preset::all()[0])
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

    /// The scene of the preset in the model of these settings.
    pub(crate) fn base(&self) -> Scene {
        let mut base = self.preset().scene();
        let set = base.set(apply::MODEL, Input::Text(self.page.model().name()));
        debug_assert_eq!(set, Ok(()));
        base
    }
}
