//! The values of an object, stored and as callers read them.

use super::distance::Surface;
use super::kinds::Kind;
use crate::params::{AnyValue, Input, Model, Name, Param, ParamError, Parameters, Property, Solid};

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
    /// Its kind.
    pub fn kind(&self) -> &'static Kind {
        match self {
            Values::FirstSource | Values::Source(_) => Kind::SOURCE,
            Values::Solid(_) => Kind::SOLID,
        }
    }

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
            let value = match &self.stored.values {
                _ if property.is_common() => AnyValue::Text(self.stored.name.text()),
                Values::Solid(stored) => stored.0.get(param)?,
                _ => param.get(self.source()?),
            };
            Some((property.name, param, value))
        })
    }
}

/// `settings` with the source properties of `source`, which is not the first, and a seed that
/// depends on its `index`, so that sources flicker independently.
pub(super) fn values_of_source(
    settings: &Parameters,
    source: &Parameters,
    index: usize,
) -> Parameters {
    let mut merged = with_properties_of(settings, source);
    let seed = settings.seed ^ (index as u32).wrapping_mul(0x9E37_79B9);
    let set = merged.set("seed", Input::Number(seed.into()));
    debug_assert_eq!(set, Ok(()));
    merged
}

/// `settings` with the source properties of `source`.
#[inline(never)]
pub(super) fn with_properties_of(settings: &Parameters, source: &Parameters) -> Parameters {
    let mut merged = settings.clone();
    for property in Kind::SOURCE.properties() {
        merged.copy_both_models(property.id, source);
    }
    merged
}
