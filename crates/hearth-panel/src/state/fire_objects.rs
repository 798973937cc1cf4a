//! What the panel shows of the fire's objects.

use hearth_core::scene::{Kind, MAX_OBJECTS, Object};

use crate::state::fire::Fire;
use crate::state::objects::has_row;
use crate::state::subject::Subject;

impl Fire {
    /// The object with this id.
    pub fn object(&self, id: u32) -> Option<Object<'_>> {
        self.objects.object(id)
    }

    /// Whether there are as many objects of a kind as a scene can have.
    pub fn is_full(&self, kind: &Kind) -> bool {
        let all = self.objects.objects();
        all.filter(|object| object.kind.name == kind.name).count() >= MAX_OBJECTS
    }

    /// The properties of an object that have rows: of the first source its name alone, because its
    /// other properties are parameters.
    pub fn properties(&self, object: Object<'_>) -> impl Iterator<Item = Subject> + use<> {
        let (id, kind, model) = (object.id, object.kind, self.parameters().model());
        let first = self.is_first_source(&object);
        let all = kind.properties();
        all.filter(move |property| has_row(*property, model) && (!first || property.is_common()))
            .filter_map(move |property| Subject::of(id, kind, property))
    }
}
