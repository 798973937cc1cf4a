//! A scene: the settings of a fire and the objects in it.
//!
//! The objects are its sources. The parameters of a source (`source_x`, `fuel_power`, …)
//! *are* the properties of the first one: setting either sets both. Every other source
//! has properties of its own. [`KINDS`] lists what an object can be given; ranges,
//! defaults and units are those of the parameters.

mod kinds;
#[cfg(test)]
mod tests;

use crate::params::{Input, ParamError, ParamErrorKind, Parameters};

pub use kinds::{KINDS, Kind, Property};

/// Most objects of a scene.
pub const MAX_OBJECTS: usize = 64;

/// Largest id of an object.
const MAX_ID: f64 = 1e6;

/// The fields of an object that are no property.
const KIND: &str = "kind";
const ID: &str = "id";

/// Settings and objects: all that a fire starts from. Every value is in range.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    settings: Parameters,
    /// The first source has its values in `settings`, or will have them: they are
    /// kept while there is no source.
    sources: Vec<Source>,
}

/// A source by its id, with the settings as they hold for it.
#[derive(Clone, Debug, PartialEq)]
struct Source {
    id: u32,
    /// The settings with this source's properties; `None` for the first, which is
    /// described by the settings themselves.
    values: Option<Box<Parameters>>,
}

/// An object as somebody sent it: its `kind`, an `id` where it shall have one of its own,
/// and its properties.
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

    /// The settings as they hold for each source, in the order of the objects. Every
    /// source has a seed of its own.
    pub fn sources(&self) -> impl Iterator<Item = &Parameters> {
        self.sources
            .iter()
            .map(|one| one.values.as_deref().unwrap_or(&self.settings))
    }

    /// Power of all sources together [kW/m], in the combustion model.
    pub fn power(&self) -> f32 {
        self.sources().map(|values| values.fuel_power).sum()
    }

    /// The objects, in their order: the id, the kind, and the settings as they hold for
    /// the object, whose properties are the [parameters](Property::id) of that kind.
    pub fn objects(&self) -> impl ExactSizeIterator<Item = (u32, &'static Kind, &Parameters)> {
        self.sources.iter().map(|one| {
            let values = one.values.as_deref().unwrap_or(&self.settings);
            (one.id, &KINDS[0], values)
        })
    }

    /// Adds an object and returns its id. Properties that `fields` does not name have
    /// their defaults or, in the only source, the settings' values.
    ///
    /// # Errors
    /// Every field that is refused. Nothing changes then.
    pub fn add(&mut self, fields: &Fields<'_>) -> Result<u32, Vec<ParamError>> {
        self.try_to(&mut |new, refused| new.insert(fields, refused))?;
        Ok(self.sources.last().map_or(0, |last| last.id))
    }

    /// Changes properties of an object, all of them or none.
    ///
    /// # Errors
    /// There is no object of that id; or every field that is refused.
    pub fn change(&mut self, id: u32, fields: &Fields<'_>) -> Result<(), Vec<ParamError>> {
        self.try_to(&mut |new, refused| {
            if let Some(index) = new.find(id, refused) {
                new.write(index, fields, refused);
            }
        })
    }

    /// Removes an object. The source after the first becomes the first, and the
    /// settings take on its properties; with no source left they keep theirs for the
    /// next one.
    ///
    /// # Errors
    /// There is no object of that id.
    pub fn remove(&mut self, id: u32) -> Result<(), Vec<ParamError>> {
        self.try_to(&mut |new, refused| {
            if let Some(index) = new.find(id, refused) {
                new.sources.remove(index);
                let first = new.sources.first_mut();
                if let Some(values) = first.and_then(|first| first.values.take()) {
                    new.set_settings(with_properties_of(&new.settings, &values));
                }
            }
        })
    }

    /// Removes all objects. The settings keep the values of the first source for the next.
    pub fn clear(&mut self) {
        self.sources.clear();
    }

    /// Lets `act` change a copy and takes it over where nothing was refused.
    #[inline(never)]
    fn try_to(
        &mut self,
        act: &mut dyn FnMut(&mut Scene, &mut Vec<ParamError>),
    ) -> Result<(), Vec<ParamError>> {
        let mut new = self.clone();
        let mut refused = Vec::new();
        act(&mut new, &mut refused);
        if refused.is_empty() {
            *self = new;
            Ok(())
        } else {
            Err(refused)
        }
    }

    /// Adds an object, whatever is refused of it.
    #[inline(never)]
    fn insert(&mut self, fields: &Fields<'_>, refused: &mut Vec<ParamError>) {
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
        let wrong = if index >= MAX_OBJECTS {
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
        if let Some((field, input, words)) = wrong {
            let name = match field {
                "length" => "objects.length".to_owned(),
                _ => place(index, field),
            };
            refused.push(must_be(name, input, words));
            return;
        }
        let values = (index > 0).then(|| {
            let defaults = Parameters::new(self.settings.model());
            Box::new(values_of_source(&self.settings, &defaults, index))
        });
        self.sources.push(Source { id: number, values });
        self.write(index, fields, refused);
    }

    /// Writes properties of the object at `index`.
    #[inline(never)]
    fn write(&mut self, index: usize, fields: &Fields<'_>, refused: &mut Vec<ParamError>) {
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
                        error.id = place(index, field);
                        refused.push(error);
                    }
                }
                None => refused.push(must_be(
                    place(index, "property"),
                    Input::Text(field),
                    KINDS[0].allowed,
                )),
            }
        }
    }

    fn find(&self, id: u32, refused: &mut Vec<ParamError>) -> Option<usize> {
        let index = self.sources.iter().position(|one| one.id == id);
        if index.is_none() {
            let words = "the id of an object that there is";
            refused.push(must_be(ID.to_owned(), Input::Number(id.into()), words));
        }
        index
    }
}

/// `settings` with the source properties of `source`, which is not the first, and a seed
/// that depends on its `index`: no two sources flicker alike.
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

/// A field of the object at `index`, as JavaScript calls it.
#[inline(never)]
fn place(index: usize, field: &str) -> String {
    format!("objects[{index}].{field}")
}
