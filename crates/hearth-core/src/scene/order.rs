//! The order of the objects, and objects of another scene.

use super::kinds::Values;
use super::stored::Stored;
use super::{Fields, Scene};
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
