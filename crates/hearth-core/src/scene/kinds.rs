//! THE table of objects: each kind and its properties.
//!
//! [`COMMON`](crate::params::COMMON) is the table of what every kind has. Any other property of a
//! source is a parameter of the settings with a value per source, whose label, unit, range,
//! default and doc the parameter gives. [`SOLID`] gives those of a solid's properties.

use crate::params::{PARAMETERS, Param, Property, SOLID, SOLID_NAMES};

/// A kind of object.
#[derive(Debug)]
pub struct Kind {
    /// Its name in the field `kind`.
    pub name: &'static str,
    /// The names of its properties.
    pub names: &'static [&'static str],
    /// The ids of their entries, in the same order.
    ids: &'static [&'static str],
    /// The table of these entries.
    table: &'static [Param],
}

/// A kind with parameters as properties.
macro_rules! kind {
    ($kind:literal, $($name:literal = $id:literal),+) => {
        Kind {
            name: $kind,
            names: &["name", $($name),+],
            ids: &["name", $($id),+],
            table: PARAMETERS,
        }
    };
}

/// Every kind of object.
pub static KINDS: &[Kind] = &[SOURCE, BODY];

const SOURCE: Kind = kind!(
    "source",
    "enabled" = "source_enabled",
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

const BODY: Kind = Kind {
    name: "solid",
    names: SOLID_NAMES,
    ids: SOLID_NAMES,
    table: SOLID,
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
