//! A scene: the settings of a fire and the objects in it.
//!
//! The objects are sources and solids, and each has values of its own. [`KINDS`] lists the properties of each kind.
//! A property of a source has the id of a parameter (`source_x`, `fuel_power`, …), by which a scene
//! [sets](Scene::set) and [gets](Scene::get) that of its first source.

mod contour;
mod distance;
mod drive;
mod field;
mod kinds;
mod object;
mod order;
mod poses;
mod source;
mod sources;
mod stored;
#[cfg(test)]
mod tests;
mod values;

use crate::params::{
    Fuel, Input, Model, Motion, Name, ParamError, ParamErrorKind, Parameters, Plane, Solid, Source,
    quoted,
};
use std::sync::Arc;

pub use crate::params::Property;
pub use distance::{RoundedBox, Surface};
pub use drive::Pose;
pub(crate) use drive::{Drive, MAX_SPEED};
pub use field::Field;
use kinds::Values;
pub use kinds::{KINDS, Kind};
pub use object::Object;
pub use source::SceneSource;
use stored::Stored;

/// Most objects of a kind in a scene.
pub const MAX_OBJECTS: usize = 64;

/// Most pixels of all masks of a scene.
const MAX_PIXELS: usize = 262_144;

/// Largest id of an object.
pub const MAX_ID: u32 = 1_000_000;

/// The fields of an object that are not properties.
pub(crate) const KIND: &str = "kind";
const ID: &str = "id";

/// A world and the objects in it: the input of a fire. Every value is in range.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    world: Parameters,
    objects: Vec<Stored>,
}

/// The unchecked fields of an object: its `kind`, optionally its `id`, and its properties.
pub type Fields<'a> = [(&'a str, Input<'a>)];

impl From<Parameters> for Scene {
    fn from(world: Parameters) -> Scene {
        Scene::new(world)
    }
}

impl Default for Scene {
    fn default() -> Scene {
        Scene::of_model(Model::default())
    }
}

impl Scene {
    /// The defaults of a model: its world with one source.
    pub fn of_model(model: Model) -> Scene {
        Scene::new(Parameters::new(model))
    }

    /// This world with one source.
    pub fn new(world: Parameters) -> Scene {
        let source = Source::new(world.model());
        Scene {
            world,
            objects: vec![Stored {
                id: 1,
                name: Name::default(),
                values: Values::Source(source),
            }],
        }
    }

    /// The values of the world.
    pub fn world(&self) -> &Parameters {
        &self.world
    }

    /// The model, which decides the parameters of the world and the properties of sources.
    pub fn model(&self) -> Model {
        self.world.model()
    }

    /// Replaces the values of the world. In another model, sources keep what both models have.
    pub fn set_world(&mut self, world: Parameters) {
        let before = self.model();
        self.world = world;
        self.set_model_of_sources(before);
    }

    /// The solids that are on, in the order of the objects.
    pub fn solids(&self) -> impl Iterator<Item = &Solid> {
        self.surfaces().map(|(_, solid, _)| solid)
    }

    /// The solids that are on with their ids and surfaces, in the order of the objects.
    pub fn surfaces(&self) -> impl Iterator<Item = (u32, &Solid, &Surface)> {
        self.objects.iter().filter_map(Stored::surface)
    }

    /// The same of the solids that gas flows around.
    pub fn obstacles(&self) -> impl Iterator<Item = (u32, &Solid, &Surface)> {
        self.surfaces().filter(|(id, solid, _)| {
            solid.plane == Plane::Within
                || solid.fuel != Fuel::None
                || solid.motion == Motion::Free
                || self
                    .all_sources()
                    .any(|source| source.solid_id() == Some(*id))
        })
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

    /// The objects, in order.
    pub fn objects(&self) -> impl ExactSizeIterator<Item = Object<'_>> {
        let all = self.objects.iter();
        all.map(|object| Object::new(object, self.model()))
    }

    /// The ids of the objects, in order.
    pub fn ids(&self) -> impl Iterator<Item = u32> {
        self.objects.iter().map(|object| object.id)
    }

    /// The object with this id.
    pub fn object(&self, id: u32) -> Option<Object<'_>> {
        self.objects().find(|object| object.id == id)
    }

    /// Adds an object and returns its id. Missing properties have their defaults.
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

    /// Removes an object.
    ///
    /// # Errors
    /// There is no object with this id.
    pub fn remove(&mut self, id: u32) -> Result<(), Vec<ParamError>> {
        let mut errors = Vec::new();
        match self.find(id, &mut errors) {
            Some(index) => {
                self.objects.remove(index);
                Ok(())
            }
            None => Err(errors),
        }
    }

    /// The pixels of all masks. Solids that are off have a mask, too.
    fn pixels(&self) -> usize {
        let solids = self.objects().filter_map(|object| object.solid());
        solids.map(|solid| solid.mask.pixels()).sum()
    }

    /// Removes all objects.
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
            Input::Number(x) if is_free(x) && (1.0..=f64::from(MAX_ID)).contains(&x) => x as u32,
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
            Some(kind) => Ok((kind.new)(self.model())),
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
        let model = self.model();
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
                    if let Err(mut error) = object.set(&property, input, model) {
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
            let (solid, surface) = Arc::make_mut(stored);
            solid.mask = before.mask;
            *surface = solid.surface();
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
    format!("objects[{index}].{}", quoted(field))
}
