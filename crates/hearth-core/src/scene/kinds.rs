//! THE table of objects: each kind and its properties.
//!
//! A property of a source is a parameter of the settings with a value per source. The parameter
//! gives its label, unit, range, default and doc. [`SOLID`](crate::params::SOLID) gives those of
//! a solid's properties.

use crate::params::{Model, PARAMETERS, Param, SOLID_NAMES, SOLID_PROPERTIES};

/// A kind of object.
#[derive(Debug)]
pub struct Kind {
    /// Its name in the field `kind`.
    pub name: &'static str,
    /// Its description, in a sentence.
    pub doc: &'static str,
    /// The names of its properties, as text for an error.
    pub(super) allowed: &'static str,
    /// Its properties.
    pub properties: &'static [Property],
}

/// A property of an object.
#[derive(Debug)]
pub struct Property {
    /// Its name.
    pub name: &'static str,
    /// The id of its entry: of a source's property, the parameter whose value it is in the
    /// first source.
    pub id: &'static str,
    /// The table of its entry.
    pub(crate) table: &'static [Param],
}

/// A kind with parameters as properties, whose error of an unknown property lists all of its properties.
macro_rules! kind {
    ($kind:literal, $doc:literal, $first:literal = $first_id:literal
        $(, $name:literal = $id:literal)*) => {
        Kind {
            name: $kind,
            doc: $doc,
            allowed: concat!("one of ", $first $(, ", ", $name)*),
            properties: &[
                Property { name: $first, id: $first_id, table: PARAMETERS },
                $(Property { name: $name, id: $id, table: PARAMETERS },)*
            ],
        }
    };
}

/// Every kind of object.
pub static KINDS: &[Kind] = &[SOURCE, SOLID];

const SOURCE: Kind = kind!(
    "source",
    "Where fuel comes into the air, or where the classic model's particles are born.",
    "x" = "source_x",
    "y" = "source_height",
    "width" = "source_width",
    "power" = "fuel_power",
    "rate" = "emission_rate",
    "speed" = "emission_speed",
    "spread" = "emission_spread",
    "noise" = "emission_noise",
    "temperature" = "source_temperature",
    "oxygen" = "source_oxygen",
    "birth_temperature" = "maximum_temperature",
    "life_min" = "lifetime_min",
    "life_max" = "lifetime_max",
    "taper" = "taper"
);

const SOLID: Kind = Kind {
    name: "solid",
    doc: "A body that gas flows around and does not enter.",
    allowed: SOLID_NAMES,
    properties: SOLID_PROPERTIES,
};

impl Kind {
    /// The property with this name.
    pub fn property(&self, name: &str) -> Option<&'static Property> {
        let all: &'static [Property] = self.properties;
        all.iter().find(|property| property.name == name)
    }
}

impl Property {
    /// Its entry.
    pub fn entry(&self) -> Option<&'static Param> {
        self.table.iter().find(|param| param.id == self.id)
    }

    /// Its entry, if `model` uses it.
    pub fn param(&self, model: Model) -> Option<&'static Param> {
        self.entry().filter(|param| param.domain(model).is_some())
    }
}
