//! The values of an object as a scene stores them.

use super::distance::Surface;
use super::kinds::Values;
use crate::params::{Input, Model, Name, ParamError, ParamErrorKind, Property, Solid};

/// An object as a scene stores it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stored {
    pub id: u32,
    pub name: Name,
    pub values: Values,
}

impl Stored {
    /// The solid with its id and its surface, if it is on.
    pub fn surface(&self) -> Option<(u32, &Solid, &Surface)> {
        let (solid, surface) = self.values.of_solid()?;
        solid.enabled.then_some((self.id, solid, surface))
    }

    /// Whether it is a solid that is off.
    pub fn is_off(&self) -> bool {
        let solid = self.values.of_solid();
        solid.is_some_and(|(solid, _)| !solid.enabled)
    }

    /// Writes a property.
    pub fn set(
        &mut self,
        property: &Property,
        input: Input<'_>,
        model: Model,
    ) -> Result<(), ParamError> {
        let Some(entry) = property.entry() else {
            return Ok(());
        };
        if let Some(other) = entry.only_in(model) {
            return Err(entry.error(input, ParamErrorKind::OfModel(other)));
        }
        if property.is_common() {
            self.name.put(entry, entry.check(model, input)?)
        } else {
            self.values.put(entry, model, input)
        }
    }
}
