//! The values of an object as a scene stores them.

use super::distance::Surface;
use super::source_properties::values_of_source;
use crate::params::{Input, Name, ParamError, Parameters, Property, Solid};

/// The values of an object.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Values {
    /// The first source, whose properties are in the scene's settings.
    FirstSource,
    /// Another source: the settings with its properties.
    Source(Box<Parameters>),
    /// A solid and its surface.
    Solid(Box<(Solid, Surface)>),
}

impl Values {
    /// The settings of a source.
    pub fn of_source<'a>(&'a self, settings: &'a Parameters) -> Option<&'a Parameters> {
        match self {
            Values::FirstSource => Some(settings),
            Values::Source(values) => Some(values),
            Values::Solid(_) => None,
        }
    }

    /// A source like the first one, after so many others.
    pub fn new_source(settings: &Parameters, count: usize) -> Values {
        if count == 0 {
            return Values::FirstSource;
        }
        let defaults = Parameters::new(settings.model());
        Values::Source(Box::new(values_of_source(settings, &defaults, count)))
    }

    /// A solid with the defaults.
    pub fn new_solid(_: &Parameters, _: usize) -> Values {
        let solid = Solid::default();
        let surface = solid.surface();
        Values::Solid(Box::new((solid, surface)))
    }

    /// Computes the surface of a solid that was `before`.
    pub fn settle(&mut self, before: Option<&Solid>) {
        if let Values::Solid(stored) = self {
            let (solid, surface) = &mut **stored;
            *surface = match before {
                Some(before) if solid.has_field_of(before) => {
                    solid.surface_with(surface.field.take())
                }
                _ => solid.surface(),
            };
        }
    }

    /// The solid and its surface.
    pub fn of_solid(&self) -> Option<&(Solid, Surface)> {
        match self {
            Values::Solid(solid) => Some(solid),
            _ => None,
        }
    }
}

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
        let own = match &mut self.values {
            _ if property.is_common() => None,
            Values::FirstSource => return settings.set(property.id, input),
            Values::Source(values) => return values.set(property.id, input),
            Values::Solid(solid) => Some(solid),
        };
        let Some(entry) = property.entry() else {
            return Ok(());
        };
        let value = entry.check(settings.model(), input)?;
        match own {
            Some(solid) => solid.0.put(entry, value),
            None => self.name.put(entry, value),
        }
    }
}
