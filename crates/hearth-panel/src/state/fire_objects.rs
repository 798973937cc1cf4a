//! The panel's copy of the fire's objects.
//!
//! As the copy of the values, it has checked objects only and ignores reports while a request
//! is pending.

use hearth_core::scene::{Kind, MAX_OBJECTS, Object};

use crate::state::fire::Fire;
use crate::state::objects::{Fields, has_row, update};
use crate::state::subject::Subject;

impl Fire {
    /// Takes the objects that the fire reports.
    pub fn receive_objects(&mut self, objects: &[Fields]) {
        if self.changes == 0 {
            update(&mut self.objects, &self.parameters, objects);
        }
    }

    /// Counts a request to change an object as pending.
    pub fn sent_change(&mut self) {
        self.changes += 1;
    }

    /// Counts such a request as answered. Returns whether none is pending any more, so that the
    /// caller reads the fire's objects again.
    pub fn answered_change(&mut self) -> bool {
        self.changes = self.changes.saturating_sub(1);
        self.changes == 0
    }

    /// The object with this id.
    pub fn object(&self, id: u32) -> Option<Object<'_>> {
        self.objects.objects().find(|object| object.id == id)
    }

    /// Whether there are as many objects of a kind as a scene can have.
    pub fn is_full(&self, kind: &Kind) -> bool {
        let all = self.objects.objects();
        all.filter(|object| object.kind.name == kind.name).count() >= MAX_OBJECTS
    }

    /// The properties of an object that have rows: of the first source its name alone, because its
    /// other properties are parameters.
    pub fn properties(&self, object: Object<'_>) -> impl Iterator<Item = Subject> + use<> {
        let (id, kind, model) = (object.id, object.kind, self.parameters.model());
        let first = object.is_first_source();
        let all = kind.properties();
        all.filter(move |property| has_row(*property, model) && (!first || property.is_common()))
            .filter_map(move |property| Subject::of(id, kind, property))
    }
}
