//! A scene: the settings of a fire and the objects in it.
//!
//! The objects are sources and solids. The parameters of a source (`source_x`, `fuel_power`, …)
//! *are* the properties of the first one: setting either sets both. Every other source has
//! separate properties, whose ranges, defaults and units are those of the parameters. No property
//! of a solid is a parameter. [`KINDS`] lists the properties of each kind.

mod contour;
mod distance;
mod drive;
mod field;
mod ids;
mod kinds;
mod object;
mod order;
mod poses;
mod source_properties;
mod stored;
#[cfg(test)]
mod tests;

use crate::params::{
    Fuel, Input, Motion, Name, ParamError, ParamErrorKind, Parameters, Physics, Solid,
};

pub use crate::params::Property;
pub use distance::{RoundedBox, Surface};
pub use drive::Pose;
pub(crate) use drive::{Drive, MAX_SPEED};
pub use field::Field;
use kinds::Values;
pub use kinds::{KINDS, Kind};
pub use object::Object;
use source_properties::{values_of_source, with_properties_of};
use stored::Stored;

/// Most objects of a kind in a scene.
pub const MAX_OBJECTS: usize = 64;

/// Most pixels of all masks of a scene.
const MAX_PIXELS: usize = 262_144;

/// Largest id of an object.
pub(crate) const MAX_ID: f64 = 1e6;

/// The fields of an object that are not properties.
pub(crate) const KIND: &str = "kind";
const ID: &str = "id";

/// Settings and objects: the input of a fire. Every value is in range.
#[derive(Debug, PartialEq)]
pub struct Scene {
    settings: Parameters,
    /// The values of the first source are in `settings`, which keep them while there is no
    /// source.
    objects: Vec<Stored>,
}

/// The unchecked fields of an object: its `kind`, optionally its `id`, and its properties.
pub type Fields<'a> = [(&'a str, Input<'a>)];

impl Clone for Scene {
    fn clone(&self) -> Scene {
        Scene {
            settings: self.settings.clone(),
            objects: self.objects.clone(),
        }
    }
}

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
            objects: vec![Stored {
                id: 1,
                name: Name::default(),
                values: Values::FirstSource,
            }],
        }
    }

    /// The settings. Their source parameters are the first source's properties.
    pub fn settings(&self) -> &Parameters {
        &self.settings
    }

    /// Replaces the settings, the first source's properties included. The other objects
    /// stay.
    pub fn set_settings(&mut self, settings: Parameters) {
        self.settings = settings;
        let mut index = 1;
        for object in &mut self.objects {
            if let Values::Source(values) = &mut object.values {
                **values = values_of_source(&self.settings, values, index);
                index += 1;
            }
        }
    }

    /// The settings of each source that is on, in the order of the objects. Every source has a
    /// different seed. A source on a solid that is off is off, too.
    pub fn sources(&self) -> impl Iterator<Item = &Parameters> {
        self.objects
            .iter()
            .filter_map(|object| self.source_of(object))
    }

    fn source_of<'a>(&'a self, object: &'a Stored) -> Option<&'a Parameters> {
        let source = object.values.of_source(&self.settings)?;
        let solid = source.solid_of_source();
        let mut all = self.objects.iter();
        let is_off = all.any(|object| Some(object.id) == solid && object.is_off());
        (source.source_enabled && !is_off).then_some(source)
    }

    /// The solids that are on, in the order of the objects.
    pub fn solids(&self) -> impl Iterator<Item = &Solid> {
        self.surfaces().map(|(_, solid, _)| solid)
    }

    /// The solids that are on with their ids and surfaces, in the order of the objects.
    pub fn surfaces(&self) -> impl Iterator<Item = (u32, &Solid, &Surface)> {
        self.objects.iter().filter_map(Stored::surface)
    }

    /// Whether there is a solid.
    pub fn has_solids(&self) -> bool {
        self.solids().next().is_some()
    }

    /// Whether a solid has fuel.
    pub fn has_fuel(&self) -> bool {
        self.solids().any(|solid| solid.fuel != Fuel::None)
    }

    /// Whether a solid is free to move.
    pub fn has_free(&self) -> bool {
        self.solids().any(|solid| solid.motion == Motion::Free)
    }

    /// The solid that a source is on and its surface; `None` if the source is a line.
    pub fn solid_of(&self, source: &Physics) -> Option<(&Solid, &Surface)> {
        let id = source.solid_of_source()?;
        let (_, solid, surface) = self.surfaces().find(|(known, ..)| *known == id)?;
        Some((solid, surface))
    }

    /// Total power of the sources [kW/m], in the combustion model.
    pub fn power(&self) -> f32 {
        self.sources().map(|values| values.fuel_power).sum()
    }

    /// The objects, in order.
    pub fn objects(&self) -> impl ExactSizeIterator<Item = Object<'_>> {
        let all = self.objects.iter();
        all.map(|object| Object::new(object, &self.settings))
    }

    /// Adds an object and returns its id. Missing properties have their defaults or, in the only
    /// source, the values of the settings.
    ///
    /// # Errors
    /// Every invalid field. Nothing changes then.
    pub fn add(&mut self, fields: &Fields<'_>) -> Result<u32, Vec<ParamError>> {
        self.transact(&mut |new, errors| new.insert(fields, errors))?;
        Ok(self.objects.last().map_or(0, |last| last.id))
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
            if let Some(index) = new.find(id, errors)
                && new.objects.remove(index).values == Values::FirstSource
            {
                new.promote();
            }
        })
    }

    /// Makes the next source the first.
    fn promote(&mut self) {
        let is_source = |object: &&mut Stored| matches!(object.values, Values::Source(_));
        if let Some(next) = self.objects.iter_mut().find(is_source)
            && let Values::Source(values) = std::mem::replace(&mut next.values, Values::FirstSource)
        {
            self.set_settings(with_properties_of(&self.settings, &values));
        }
    }

    /// The pixels of all masks. Solids that are off have a mask, too.
    fn pixels(&self) -> usize {
        let solids = self.objects().filter_map(|object| object.solid());
        solids.map(|solid| solid.mask.pixels()).sum()
    }

    /// Removes all objects. The settings keep the values of the first source for the next one.
    pub fn clear(&mut self) {
        self.objects.clear();
    }

    /// Applies `act` to a copy, and keeps the copy if there is no error.
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
    fn insert(&mut self, fields: &Fields<'_>, errors: &mut Vec<ParamError>) {
        let index = self.objects.len();
        let is_free = |id: f64| self.objects.iter().all(|object| f64::from(object.id) != id);
        let free = (1..).find(|&id| is_free(f64::from(id)));
        let mut name = Input::Text("undefined");
        let mut id = Input::Number(free.unwrap_or_default().into());
        for &(field, input) in fields {
            match field {
                KIND => name = input,
                ID => id = input,
                _ => {}
            }
        }
        let number = match id {
            Input::Number(x) if is_free(x) && (1.0..=MAX_ID).contains(&x) => x as u32,
            _ => 0,
        };
        let kind = KINDS.iter().find(|kind| name == Input::Text(kind.name));
        let of_kind = |object: &Object<'_>| Some(object.kind.name) == kind.map(|kind| kind.name);
        let count = self.objects().filter(of_kind).count();
        let values = match kind {
            Some(kind) if count >= MAX_OBJECTS => {
                let words = match kind.name {
                    "solid" => "at most 64 solids",
                    _ => "at most 64 sources",
                };
                errors.push(ParamError {
                    id: "objects".to_owned(),
                    value: format!("{} {}s", count + 1, kind.name),
                    kind: ParamErrorKind::Other(words),
                });
                return;
            }
            None => Err((KIND, name, kinds::NAMES)),
            Some(_) if number == 0 || id != Input::Number(number.into()) => {
                let words = "a whole number from 1 to 1000000 that no other object has";
                Err((ID, id, words))
            }
            Some(kind) => Ok((kind.new)(&self.settings, count)),
        };
        let values = match values {
            Ok(values) => values,
            Err((field, input, words)) => {
                errors.push(must_be(path(index, field), input, words));
                return;
            }
        };
        self.objects.push(Stored {
            id: number,
            name: Name::default(),
            values,
        });
        self.write(index, fields, errors);
    }

    /// Writes properties of the object at `index`.
    fn write(&mut self, index: usize, fields: &Fields<'_>, errors: &mut Vec<ParamError>) {
        let Some(object) = self.objects.get_mut(index) else {
            return;
        };
        let id = Input::Number(object.id.into());
        let kind = object.values.kind();
        let before = object.values.of_solid().map(|(solid, _)| solid.clone());
        for &(field, input) in fields {
            let known = [(KIND, Input::Text(kind.name)), (ID, id)];
            if known.contains(&(field, input)) {
                continue;
            }
            match kind.property(field) {
                Some(property) => {
                    if let Err(mut error) = object.set(&property, input, &mut self.settings) {
                        error.id = path(index, field);
                        errors.push(error);
                    }
                }
                None => {
                    let choices = kind.names;
                    let kind = ParamErrorKind::NotAChoice { choices };
                    errors.push(refused(path(index, "property"), Input::Text(field), kind));
                }
            }
        }
        object.values.settle(before.as_ref());
        let pixels = self.pixels();
        if pixels > MAX_PIXELS {
            let words = "smaller: all masks of a scene have at most 262144 pixels";
            let pixels = Input::Number(pixels as f64);
            errors.push(must_be(path(index, "mask"), pixels, words));
            self.restore_mask(index, before);
        }
    }

    /// Restores the mask of a solid that was `before`.
    fn restore_mask(&mut self, index: usize, before: Option<Solid>) {
        let object = self.objects.get_mut(index);
        if let (Some(Values::Solid(stored)), Some(before)) =
            (object.map(|object| &mut object.values), before)
        {
            stored.0.mask = before.mask;
            stored.1 = stored.0.surface();
        }
    }

    fn find(&self, id: u32, errors: &mut Vec<ParamError>) -> Option<usize> {
        let index = self.objects.iter().position(|object| object.id == id);
        if index.is_none() {
            let words = "the id of an object";
            errors.push(must_be(ID.to_owned(), Input::Number(id.into()), words));
        }
        index
    }
}

fn must_be(id: String, input: Input<'_>, words: &'static str) -> ParamError {
    refused(id, input, ParamErrorKind::Other(words))
}

fn refused(id: String, input: Input<'_>, kind: ParamErrorKind) -> ParamError {
    let value = format!("{input}");
    ParamError { id, value, kind }
}

/// The JavaScript path of a field of the object at `index`.
fn path(index: usize, field: &str) -> String {
    format!("objects[{index}].{field}")
}
