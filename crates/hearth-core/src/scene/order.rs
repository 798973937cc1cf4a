//! The order of the objects, and objects of another scene.

use super::kinds::Values;
use super::source_properties::with_properties_of;
use super::stored::Stored;
use super::{Fields, MAX_OBJECTS, MAX_PIXELS, Scene};
use crate::params::ParamError;

impl Scene {
    /// Makes the first source in the order of the objects the source of the settings.
    fn settle_sources(&mut self) {
        let mut sources = self.objects.iter_mut();
        let first = sources.find(|object| object.values.kind().is_of_parameters());
        if first.is_none_or(|object| object.values == Values::FirstSource) {
            return self.set_settings(self.settings.clone());
        }
        if let Some(before) = sources.find(|object| object.values == Values::FirstSource) {
            before.values = Values::Source(Box::new(self.settings.clone()));
        }
        self.promote();
    }

    /// Puts the objects with these ids into this order, in the positions that they have together.
    pub fn arrange(&mut self, ids: &[u32]) {
        let find = |all: &[Stored], id: u32| all.iter().position(|object| object.id == id);
        let indices = ids.iter().filter_map(|id| find(&self.objects, *id));
        if indices.is_sorted() {
            return;
        }
        let mut from = 0;
        for id in ids {
            let Some(found) = find(&self.objects, *id) else {
                continue;
            };
            let is_listed = |object: &Stored| ids.contains(&object.id);
            let Some(next) = self.objects.iter().skip(from).position(is_listed) else {
                break;
            };
            self.objects.swap(from + next, found);
            from += next + 1;
        }
        self.settle_sources();
    }

    /// Without a source, the settings keep the values of the next one from another scene.
    pub fn keep_source_of(&mut self, other: &Scene) {
        if self.objects().all(|object| object.source().is_none()) {
            self.settings = with_properties_of(&self.settings, &other.settings);
        }
    }

    /// Adds an object of another scene, and returns its id: the same, if it is free. `None` if there is no such object,
    /// or no room.
    pub fn copy(&mut self, other: &Scene, id: u32) -> Option<u32> {
        let object = other.objects.iter().find(|object| object.id == id)?;
        let kind = object.values.kind().name;
        let of_kind = self.objects().filter(|known| known.kind.name == kind);
        if of_kind.count() >= MAX_OBJECTS {
            return None;
        }
        let is_free = |id: &u32| self.objects.iter().all(|object| object.id != *id);
        let id = std::iter::once(id).chain(1..).find(is_free)?;
        let values = match &object.values {
            Values::FirstSource => Values::Source(Box::new(other.settings.clone())),
            values => values.clone(),
        };
        let name = object.name.clone();
        self.objects.push(Stored { id, name, values });
        self.settle_sources();
        if self.pixels() > MAX_PIXELS {
            self.objects.pop();
            return None;
        }
        Some(id)
    }

    /// Changes an object or, without an id, adds one, without the fields that are refused. Appends an error for each,
    /// and returns the id of the object, if there is one.
    pub fn lay(
        &mut self,
        id: Option<u32>,
        fields: &Fields<'_>,
        errors: &mut Vec<ParamError>,
    ) -> Option<u32> {
        let count = self.objects.len();
        let Some(id) = id else {
            self.insert(fields, errors);
            return self.objects.get(count).map(|object| object.id);
        };
        let index = self.find(id, errors)?;
        self.write(index, fields, errors);
        Some(id)
    }
}
