//! Surgery on the list of objects by their ids.

use super::stored::Stored;
use super::{Fields, Scene};
use crate::params::ParamError;

impl Scene {
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
    }

    /// Gives an object another id, if no other object has it. Returns whether the object has it then.
    pub fn rename(&mut self, id: u32, new: u32) -> bool {
        let is_free = self.objects.iter().all(|object| object.id != new);
        let mut objects = self.objects.iter_mut();
        match objects.find(|object| object.id == id) {
            Some(object) if is_free => {
                object.id = new;
                true
            }
            _ => false,
        }
    }

    /// Adds an object of another scene or replaces the one that has its id. Without such an object it does nothing.
    pub fn take(&mut self, other: &Scene, id: u32) {
        let Some(object) = other.objects.iter().find(|object| object.id == id) else {
            return;
        };
        match self.objects.iter_mut().find(|own| own.id == id) {
            Some(own) => own.clone_from(object),
            None => self.objects.push(object.clone()),
        }
    }

    /// Changes an object or, without an id, adds one, without the fields that are refused. Appends an error for each,
    /// and returns the id of the object, if there is one.
    pub fn apply_fields(
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
