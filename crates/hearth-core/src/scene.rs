//! A scene: the settings of a fire and the objects in it.
//!
//! The objects are sources. The parameters of a source (`source_x`, `fuel_power`, …) *are* the
//! properties of the first one: setting either sets both. Every other source has separate
//! properties. [`KINDS`] lists the properties of each kind; their ranges, defaults and units
//! are those of the parameters.

mod kinds;
#[cfg(test)]
mod tests;

use crate::params::{Input, ParamError, ParamErrorKind, Parameters};

pub use kinds::{KINDS, Kind, Property};

/// Most objects of a scene.
pub const MAX_OBJECTS: usize = 64;

/// Largest id of an object.
const MAX_ID: f64 = 1e6;

/// The fields of an object that are not properties.
const KIND: &str = "kind";
const ID: &str = "id";

/// Settings and objects: the input of a fire. Every value is in range.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    settings: Parameters,
    /// The values of the first source are in `settings`, which keep them while there is no
    /// source.
    sources: Vec<Source>,
}

/// A source: its id and its settings.
#[derive(Clone, Debug, PartialEq)]
struct Source {
    id: u32,
    /// The settings with this source's properties; `None` for the first source, whose properties
    /// are in the scene's settings.
    values: Option<Box<Parameters>>,
}

/// The unchecked fields of an object: its `kind`, optionally its `id`, and its properties.
pub type Fields<'a> = [(&'a str, Input<'a>)];

impl From<Parameters> for Scene {
    fn from(settings: Parameters) -> Scene {
        Scene::new(settings)
    }
}

impl Default for Scene {
    fn default() -> Scene {
        Scene::new(Parameters::default())
    }
}

impl Scene {
    /// These settings with one source.
    pub fn new(settings: Parameters) -> Scene {
        Scene {
            settings,
            sources: vec![Source {
                id: 1,
                values: None,
            }],
        }
    }

    /// The settings. Their source parameters are the first source's properties.
    pub fn settings(&self) -> &Parameters {
        &self.settings
    }

    /// Replaces the settings, the first source's properties included. The other objects
    /// stay.
    #[inline(never)]
    pub fn set_settings(&mut self, settings: Parameters) {
        self.settings = settings;
        for (index, source) in self.sources.iter_mut().enumerate() {
            if let Some(values) = source.values.as_deref_mut() {
                *values = values_of_source(&self.settings, values, index);
            }
        }
    }

    /// The settings of each source, in the order of the objects. Every source has a different
    /// seed.
    pub fn sources(&self) -> impl Iterator<Item = &Parameters> {
        self.sources
            .iter()
            .map(|one| one.values.as_deref().unwrap_or(&self.settings))
    }

    /// Total power of the sources [kW/m], in the combustion model.
    pub fn power(&self) -> f32 {
        self.sources().map(|values| values.fuel_power).sum()
    }

    /// The objects, in order: the id, the kind, and the settings of the object, in which its
    /// properties are the [parameters](Property::id) of the kind.
    pub fn objects(&self) -> impl ExactSizeIterator<Item = (u32, &'static Kind, &Parameters)> {
        self.sources.iter().map(|one| {
            let values = one.values.as_deref().unwrap_or(&self.settings);
            (one.id, &KINDS[0], values)
        })
    }

    /// Adds an object and returns its id. Missing properties have their defaults or, in the only
    /// source, the values of the settings.
    ///
    /// # Errors
    /// Every invalid field. Nothing changes then.
    pub fn add(&mut self, fields: &Fields<'_>) -> Result<u32, Vec<ParamError>> {
        self.transact(&mut |new, errors| new.insert(fields, errors))?;
        Ok(self.sources.last().map_or(0, |last| last.id))
    }

    /// Changes properties of an object, all of them or none.
    ///
    /// # Errors
    /// There is no object with this id, or every invalid field.
    pub fn change(&mut self, id: u32, fields: &Fields<'_>) -> Result<(), Vec<ParamError>> {
        self.transact(&mut |new, errors| {
            if let Some(index) = new.find(id, errors) {
                new.write(index, fields, errors);
            }
        })
    }

    /// Removes an object. If it was the first, the next source becomes the first, and the
    /// settings get its properties. Without a source, the settings keep the values for the next
    /// one.
    ///
    /// # Errors
    /// There is no object with this id.
    pub fn remove(&mut self, id: u32) -> Result<(), Vec<ParamError>> {
        self.transact(&mut |new, errors| {
            if let Some(index) = new.find(id, errors) {
                new.sources.remove(index);
                let first = new.sources.first_mut();
                if let Some(values) = first.and_then(|first| first.values.take()) {
                    new.set_settings(with_properties_of(&new.settings, &values));
                }
            }
        })
    }

    /// Removes all objects. The settings keep the values of the first source for the next one.
    pub fn clear(&mut self) {
        self.sources.clear();
    }

    /// Applies `act` to a copy, and keeps the copy if there is no error.
    #[inline(never)]
    fn transact(
        &mut self,
        act: &mut dyn FnMut(&mut Scene, &mut Vec<ParamError>),
    ) -> Result<(), Vec<ParamError>> {
        let mut new = self.clone();
        let mut errors = Vec::new();
        act(&mut new, &mut errors);
        if errors.is_empty() {
            *self = new;
            Ok(())
        } else {
            Err(errors)
        }
    }

    /// Adds an object and appends its errors.
    #[inline(never)]
    fn insert(&mut self, fields: &Fields<'_>, errors: &mut Vec<ParamError>) {
        let index = self.sources.len();
        let is_free = |id: f64| self.sources.iter().all(|one| f64::from(one.id) != id);
        let free = (1..).find(|&id| is_free(f64::from(id)));
        let mut kind = Input::Text("undefined");
        let mut id = Input::Number(free.unwrap_or_default().into());
        for &(field, input) in fields {
            match field {
                KIND => kind = input,
                ID => id = input,
                _ => {}
            }
        }
        let number = match id {
            Input::Number(x) if is_free(x) && (1.0..=MAX_ID).contains(&x) => x as u32,
            _ => 0,
        };
        let problem = if index >= MAX_OBJECTS {
            let count = Input::Number(index as f64 + 1.0);
            Some(("length", count, "at most 64"))
        } else if kind != Input::Text(KINDS[0].name) {
            Some((KIND, kind, KINDS[0].name))
        } else if id != Input::Number(number.into()) {
            let words = "a whole number from 1 to 1000000 that no other object has";
            Some((ID, id, words))
        } else {
            None
        };
        if let Some((field, input, words)) = problem {
            let name = match field {
                "length" => "objects.length".to_owned(),
                _ => path(index, field),
            };
            errors.push(must_be(name, input, words));
            return;
        }
        let values = (index > 0).then(|| {
            let defaults = Parameters::new(self.settings.model());
            Box::new(values_of_source(&self.settings, &defaults, index))
        });
        self.sources.push(Source { id: number, values });
        self.write(index, fields, errors);
    }

    /// Writes properties of the object at `index`.
    #[inline(never)]
    fn write(&mut self, index: usize, fields: &Fields<'_>, errors: &mut Vec<ParamError>) {
        let Some(source) = self.sources.get_mut(index) else {
            return;
        };
        let id = Input::Number(source.id.into());
        let values = source.values.as_deref_mut().unwrap_or(&mut self.settings);
        for &(field, input) in fields {
            let known = [(KIND, Input::Text(KINDS[0].name)), (ID, id)];
            if known.contains(&(field, input)) {
                continue;
            }
            match KINDS[0].property(field) {
                Some(property) => {
                    if let Err(mut error) = values.set(property.id, input) {
                        error.id = path(index, field);
                        errors.push(error);
                    }
                }
                None => errors.push(must_be(
                    path(index, "property"),
                    Input::Text(field),
                    KINDS[0].allowed,
                )),
            }
        }
    }

    fn find(&self, id: u32, errors: &mut Vec<ParamError>) -> Option<usize> {
        let index = self.sources.iter().position(|one| one.id == id);
        if index.is_none() {
            let words = "the id of an object";
            errors.push(must_be(ID.to_owned(), Input::Number(id.into()), words));
        }
        index
    }
}

/// `settings` with the source properties of `source`, which is not the first, and a seed that
/// depends on its `index`, so that sources flicker independently.
fn values_of_source(settings: &Parameters, source: &Parameters, index: usize) -> Parameters {
    let mut merged = with_properties_of(settings, source);
    let seed = settings.seed ^ (index as u32).wrapping_mul(0x9E37_79B9);
    let set = merged.set("seed", Input::Number(seed.into()));
    debug_assert_eq!(set, Ok(()));
    merged
}

/// `settings` with the source properties of `source`.
#[inline(never)]
fn with_properties_of(settings: &Parameters, source: &Parameters) -> Parameters {
    let mut merged = settings.clone();
    for property in KINDS[0].properties {
        merged.copy_both_models(property.id, source);
    }
    merged
}

#[inline(never)]
fn must_be(id: String, input: Input<'_>, words: &'static str) -> ParamError {
    ParamError {
        id,
        value: input.to_string(),
        kind: ParamErrorKind::Other(words),
    }
}

/// The JavaScript path of a field of the object at `index`.
#[inline(never)]
fn path(index: usize, field: &str) -> String {
    format!("objects[{index}].{field}")
}
