//! THE table of objects: each kind and its properties.
//!
//! A property is a parameter of the settings that each source has for itself; the
//! parameter gives its label, unit, range, default and doc.

use crate::params::{Model, Param};

/// A kind of object.
#[derive(Debug)]
pub struct Kind {
    /// Its name in the field `kind`.
    pub name: &'static str,
    /// What it is, in a sentence.
    pub doc: &'static str,
    /// The names of its properties, in words.
    pub(super) allowed: &'static str,
    /// What can be set of it.
    pub properties: &'static [Property],
}

/// What can be set of an object.
#[derive(Debug)]
pub struct Property {
    /// Its name.
    pub name: &'static str,
    /// The parameter that it is of the first source.
    pub id: &'static str,
}

/// Every kind of object.
pub static KINDS: &[Kind] = &[Kind {
    name: "source",
    doc: "Where fuel comes into the air, or where the classic model's particles are born.",
    allowed: "one of x, y, width, power, rate, speed, spread, noise, temperature, oxygen, \
              birth_temperature, life_min, life_max, taper",
    properties: &[
        property("x", "source_x"),
        property("y", "source_height"),
        property("width", "source_width"),
        property("power", "fuel_power"),
        property("rate", "emission_rate"),
        property("speed", "emission_speed"),
        property("spread", "emission_spread"),
        property("noise", "emission_noise"),
        property("temperature", "source_temperature"),
        property("oxygen", "source_oxygen"),
        property("birth_temperature", "maximum_temperature"),
        property("life_min", "lifetime_min"),
        property("life_max", "lifetime_max"),
        property("taper", "taper"),
    ],
}];

const fn property(name: &'static str, id: &'static str) -> Property {
    Property { name, id }
}

impl Kind {
    /// The property of that name.
    pub fn property(&self, name: &str) -> Option<&'static Property> {
        let all: &'static [Property] = self.properties;
        all.iter().find(|property| property.name == name)
    }
}

impl Property {
    /// The parameter, where `model` uses it.
    pub fn param(&self, model: Model) -> Option<&'static Param> {
        Param::find(self.id).filter(|param| param.domain(model).is_some())
    }
}
