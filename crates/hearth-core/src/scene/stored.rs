//! The values of an object as a scene stores them.

use super::distance::Surface;
use super::kinds::Values;
use crate::params::{Input, Name, ParamError, Parameters, Property, Solid};

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

    /// Writes a property, of the first source to `settings`.
    pub fn set(
        &mut self,
        property: &Property,
        input: Input<'_>,
        settings: &mut Parameters,
    ) -> Result<(), ParamError> {
        if !property.is_common()
            && let Some(parameters) = self.values.parameters_mut(settings)
        {
            return parameters.set(property.id, input);
        }
        let Some(entry) = property.entry() else {
            return Ok(());
        };
        let value = entry.check(settings.model(), input)?;
        if property.is_common() {
            self.name.put(entry, value)
        } else {
            self.values.put(entry, value)
        }
    }
}
