//! THE table of objects: each kind and its properties.
//!
//! [`COMMON`](crate::params::COMMON) is the table of what every kind has. Any other property of a
//! source is a parameter of the settings with a value per source, whose label, unit, range,
//! default and doc the parameter gives. [`SOLID`] gives those of a solid's properties.

use super::distance::Surface;
use super::source_properties::{OF_PARAMETERS, values_of_source};
use crate::params::{
    AnyValue, PARAMETERS, Param, ParamError, Parameters, Property, SOLID, SOLID_NAMES, Solid, Table,
};

/// A kind of object.
#[derive(Debug)]
pub struct Kind {
    /// Its name in the field `kind`.
    pub name: &'static str,
    /// Its description, in a sentence.
    pub doc: &'static str,
    /// Whether its objects are bodies: they have a surface, which may burn, is drawn in front of or
    /// behind others, and is what a source can be on.
    pub is_body: bool,
    /// The values of a new object of a scene with these settings, which has that many of its kind.
    pub(super) new: fn(&Parameters, usize) -> Values,
    /// The names of its properties.
    pub names: &'static [&'static str],
    /// The ids of their entries, in the same order.
    ids: &'static [&'static str],
    /// The table of these entries.
    table: Table,
}

static SOURCE: Kind = Kind {
    name: "source",
    doc: "Where fuel comes into the air, or where the classic model's particles are born.",
    is_body: false,
    new: Values::new_source,
    names: OF_PARAMETERS.0,
    ids: OF_PARAMETERS.1,
    table: &PARAMETERS,
};

static BODY: Kind = Kind {
    name: "solid",
    doc: "A body that gas flows around and does not enter.",
    is_body: true,
    new: Values::new_solid,
    names: SOLID_NAMES,
    ids: SOLID_NAMES,
    table: &SOLID,
};

/// The names of all kinds, for an error.
pub(super) const NAMES: &str = "source or solid";

/// Every kind of object.
pub static KINDS: &[&Kind] = &[Kind::SOURCE, Kind::SOLID];

impl Kind {
    /// The kind whose properties are parameters of the settings with a value for each object.
    pub const SOURCE: &'static Kind = &SOURCE;

    /// The kind of bodies that gas flows around.
    pub const SOLID: &'static Kind = &BODY;

    /// Whether its properties are parameters of the settings, which have the values of its first object.
    pub fn is_of_parameters(&self) -> bool {
        std::ptr::eq(self.table, &PARAMETERS)
    }

    /// Its properties, in the order of a panel.
    pub fn properties(&self) -> impl ExactSizeIterator<Item = Property> + use<> {
        let table = self.table;
        let all = self.names.iter().zip(self.ids);
        all.map(move |(name, id)| Property { name, id, table })
    }

    /// The property with this name.
    pub fn property(&self, name: &str) -> Option<Property> {
        self.properties().find(|property| property.name == name)
    }
}

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

    /// The parameters that are the properties of a source.
    pub fn parameters_mut<'a>(
        &'a mut self,
        settings: &'a mut Parameters,
    ) -> Option<&'a mut Parameters> {
        match self {
            Values::FirstSource => Some(settings),
            Values::Source(values) => Some(values),
            Values::Solid(_) => None,
        }
    }

    /// Writes a checked property of a kind whose properties are no parameters.
    pub fn put(&mut self, entry: &Param, value: AnyValue<'_>) -> Result<(), ParamError> {
        match self {
            Values::Solid(solid) => solid.0.put(entry, value),
            Values::FirstSource | Values::Source(_) => Ok(()),
        }
    }

    /// A property; of the first source, from `settings`.
    pub fn get<'a>(&'a self, entry: &Param, settings: &'a Parameters) -> Option<AnyValue<'a>> {
        match self {
            Values::Solid(solid) => solid.0.get(entry),
            _ => Some(entry.get(self.of_source(settings)?)),
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
