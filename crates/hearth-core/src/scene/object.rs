//! An object as callers read it.

use super::kinds::Kind;
use super::stored::Stored;
use crate::params::{AnyValue, Model, Param, Solid, Source};

/// An object of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Object<'a> {
    /// Its id.
    pub id: u32,
    /// Its kind.
    pub kind: &'static Kind,
    stored: &'a Stored,
    model: Model,
}

impl PartialEq for Object<'_> {
    fn eq(&self, other: &Object<'_>) -> bool {
        self.stored == other.stored
    }
}

impl<'a> Object<'a> {
    pub(super) fn new(stored: &'a Stored, model: Model) -> Object<'a> {
        Object {
            id: stored.id,
            kind: stored.values.kind(),
            stored,
            model,
        }
    }

    /// The model, which decides the properties in use.
    pub fn model(&self) -> Model {
        self.model
    }

    /// This source; `None` for another kind.
    pub fn source(&self) -> Option<&'a Source> {
        self.stored.values.source()
    }

    /// Its name; empty without one.
    pub fn name(&self) -> &'a str {
        self.stored.name.text()
    }

    /// This solid; `None` for another kind.
    pub fn solid(&self) -> Option<&'a Solid> {
        self.stored.values.of_solid().map(|(solid, _)| solid)
    }

    /// The properties that the model uses: name, entry and value.
    pub fn properties(self) -> impl Iterator<Item = (&'static str, &'static Param, AnyValue<'a>)> {
        let all = self.kind.properties();
        all.filter_map(move |property| {
            let param = property.param(self.model())?;
            let value = if property.is_common() {
                AnyValue::Text(self.stored.name.text())
            } else {
                self.stored.values.get(param)?
            };
            Some((property.name, param, value))
        })
    }
}
