//! THE table of objects: each kind and its properties.
//!
//! A property of a source is a parameter of the settings with a value per source. The parameter
//! gives its label, unit, range, default and doc. [`SOLID`](crate::params::SOLID) gives those of
//! a solid's properties.

use crate::params::{PARAMETERS, Property, SOLID_NAMES, SOLID_PROPERTIES};

/// A kind of object.
#[derive(Debug)]
pub struct Kind {
    /// Its name in the field `kind`.
    pub name: &'static str,
    /// The names of its properties, as text for an error.
    pub(super) allowed: &'static str,
    /// Its properties.
    pub properties: &'static [Property],
}

/// A kind with parameters as properties, whose error of an unknown property lists all of its properties.
macro_rules! kind {
    ($kind:literal, $first:literal = $first_id:literal
        $(, $name:literal = $id:literal)*) => {
        Kind {
            name: $kind,
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
    "shape" = "source_shape",
    "solid" = "source_solid",
    "x" = "source_x",
    "y" = "source_height",
    "angle" = "source_angle",
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
    allowed: SOLID_NAMES,
    properties: SOLID_PROPERTIES,
};

impl Kind {
    /// Its description, in a sentence. A build without text does not include it.
    pub fn doc(&self) -> &'static str {
        if self.name == SOURCE.name {
            "Where fuel comes into the air, or where the classic model's particles are born."
        } else {
            "A body that gas flows around and does not enter."
        }
    }

    /// The property with this name.
    pub fn property(&self, name: &str) -> Option<&'static Property> {
        let all: &'static [Property] = self.properties;
        all.iter().find(|property| property.name == name)
    }
}
