//! An object as callers read it.

use super::kinds::{Kind, Values};
use super::stored::Stored;
use crate::params::{AnyValue, Model, Param, Parameters, Solid};

/// An object of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Object<'a> {
    /// Its id.
    pub id: u32,
    /// Its kind.
    pub kind: &'static Kind,
    stored: &'a Stored,
    settings: &'a Parameters,
}

impl<'a> Object<'a> {
    pub(super) fn new(stored: &'a Stored, settings: &'a Parameters) -> Object<'a> {
        Object {
            id: stored.id,
            kind: stored.values.kind(),
            stored,
            settings,
        }
    }

    /// Whether it is the source whose properties are parameters of the settings.
    pub fn is_first_source(&self) -> bool {
        matches!(self.stored.values, Values::FirstSource)
    }

    /// The present model, which decides the properties in use.
    pub fn model(&self) -> Model {
        self.settings.model()
    }

    /// The settings with the properties of this source; `None` for another kind.
    pub fn source(&self) -> Option<&'a Parameters> {
        self.stored.values.of_source(self.settings)
    }

    /// Its name; empty without one.
    pub fn name(&self) -> &'a str {
        self.stored.name.text()
    }

    /// This solid; `None` for another kind.
    pub fn solid(&self) -> Option<&'a Solid> {
        self.stored.values.of_solid().map(|(solid, _)| solid)
    }

    /// The properties that the present model uses: name, entry and value.
    pub fn properties(self) -> impl Iterator<Item = (&'static str, &'static Param, AnyValue<'a>)> {
        let all = self.kind.properties();
        all.filter_map(move |property| {
            let param = property.param(self.model())?;
            let value = if property.is_common() {
                AnyValue::Text(self.stored.name.text())
            } else {
                self.stored.values.get(param, self.settings)?
            };
            Some((property.name, param, value))
        })
    }
}
