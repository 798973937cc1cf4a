//! THE table of objects: each kind and its properties.
//!
//! [`COMMON`](crate::params::COMMON) is the table of what every kind has. The other properties of a source are
//! entries of [`PARAMETERS`], those of a solid are entries of [`SOLID`].

use super::distance::Surface;
use crate::params::{
    AnyValue, Input, Model, PARAMETERS, Param, ParamError, Property, SOLID, SOLID_NAMES, Solid,
    Source, Table,
};
use std::sync::Arc;

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
    /// The values of a new object in a model.
    pub(super) new: fn(Model) -> Values,
    /// The names of its properties, in the order of a panel.
    pub names: &'static [&'static str],
    /// The table of these entries.
    table: Table,
}

static SOURCE: Kind = Kind {
    name: "source",
    doc: "Where fuel comes into the air, or where the classic model's particles are born.",
    is_body: false,
    new: Values::new_source,
    names: &[
        "name",
        "enabled",
        "shape",
        "solid",
        "x",
        "y",
        "angle",
        "width",
        "power",
        "rate",
        "speed",
        "spread",
        "noise",
        "temperature",
        "oxygen",
        "birth_temperature",
        "life_min",
        "life_max",
        "taper",
    ],
    table: &PARAMETERS,
};

static BODY: Kind = Kind {
    name: "solid",
    doc: "A body that gas flows around and does not enter.",
    is_body: true,
    new: Values::new_solid,
    names: SOLID_NAMES,
    table: &SOLID,
};

/// The names of all kinds, for an error.
pub(super) const NAMES: &str = "source or solid";

/// Every kind of object.
pub static KINDS: &[&Kind] = &[Kind::SOURCE, Kind::SOLID];

impl Kind {
    /// The kind of sources, whose properties have ids of parameters.
    pub const SOURCE: &'static Kind = &SOURCE;

    /// The kind of bodies that gas flows around.
    pub const SOLID: &'static Kind = &BODY;

    /// Whether the ids of its properties are ids of parameters.
    pub fn is_of_parameters(&self) -> bool {
        std::ptr::eq(self.table, &PARAMETERS)
    }

    /// Its properties, in the order of a panel.
    pub fn properties(&self) -> impl ExactSizeIterator<Item = Property> + use<> {
        let table = self.table;
        self.names.iter().map(move |name| Property { name, table })
    }

    /// The property with this name.
    pub fn property(&self, name: &str) -> Option<Property> {
        self.properties().find(|property| property.name == name)
    }
}

/// The values of an object.
#[derive(Clone, Debug)]
pub(super) enum Values {
    /// A source.
    Source(Source),
    /// A solid and its surface, which scenes share.
    Solid(Arc<(Solid, Surface)>),
}

impl PartialEq for Values {
    fn eq(&self, other: &Values) -> bool {
        match (self, other) {
            (Values::Source(own), Values::Source(other)) => own == other,
            (Values::Solid(own), Values::Solid(other)) => {
                Arc::ptr_eq(own, other) || own.0 == other.0
            }
            _ => false,
        }
    }
}

impl Values {
    /// Its kind.
    pub fn kind(&self) -> &'static Kind {
        match self {
            Values::Source(_) => Kind::SOURCE,
            Values::Solid(_) => Kind::SOLID,
        }
    }

    /// The source.
    pub fn source(&self) -> Option<&Source> {
        match self {
            Values::Source(source) => Some(source),
            Values::Solid(_) => None,
        }
    }

    /// Writes a property.
    pub fn put(&mut self, entry: &Param, model: Model, input: Input<'_>) -> Result<(), ParamError> {
        match self {
            Values::Source(source) => source.set(entry, model, input),
            Values::Solid(solid) => {
                let value = entry.check(model, input)?;
                if solid.0.get(entry) == Some(value) {
                    return Ok(());
                }
                Arc::make_mut(solid).0.put(entry, value)
            }
        }
    }

    /// A property.
    pub fn get(&self, entry: &Param) -> Option<AnyValue<'_>> {
        match self {
            Values::Source(source) => source.get(entry),
            Values::Solid(solid) => solid.0.get(entry),
        }
    }

    /// A source with the defaults.
    pub fn new_source(model: Model) -> Values {
        Values::Source(Source::new(model))
    }

    /// A solid with the defaults.
    pub fn new_solid(_: Model) -> Values {
        let solid = Solid::default();
        let surface = solid.surface();
        Values::Solid(Arc::new((solid, surface)))
    }

    /// Computes the surface of a solid that was `before`.
    pub fn settle(&mut self, before: Option<&Solid>) {
        if let Values::Solid(stored) = self
            && before.is_none_or(|before| stored.0 != *before)
        {
            let (solid, surface) = Arc::make_mut(stored);
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
