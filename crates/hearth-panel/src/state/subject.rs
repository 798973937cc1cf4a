//! What a row shows: a parameter, or a property of an object.

use std::sync::OnceLock;

use hearth_core::params::{Param, Property};
use hearth_core::scene::{KINDS, Kind};

/// A parameter, or a property of an object that is not the first source: the properties of the
/// first source are parameters.
#[derive(Clone, Copy, Debug)]
pub struct Subject {
    /// Its name in the panel, unique among the rows of a frame: the parameter's id, or the kind
    /// and the name of the property (`solid:width`).
    pub id: &'static str,
    /// Its entry in a table.
    pub param: &'static Param,
    /// The object that has it.
    pub object: Option<Owner>,
}

/// The object of a property, and its name there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Owner {
    /// The id of the object.
    pub id: u32,
    /// The kind of the object.
    pub kind: &'static str,
    /// The name of the property.
    pub property: &'static str,
}

impl PartialEq for Subject {
    fn eq(&self, other: &Subject) -> bool {
        (self.id, self.object) == (other.id, other.object)
    }
}

impl From<&'static Param> for Subject {
    fn from(param: &'static Param) -> Subject {
        Subject {
            id: param.id,
            param,
            object: None,
        }
    }
}

impl Subject {
    /// Whether a row of this name is a parameter's.
    pub fn is_parameter(id: &str) -> bool {
        !id.contains(':')
    }

    /// A property of the object `id`.
    pub fn of(id: u32, kind: &'static Kind, property: Property) -> Option<Subject> {
        Some(Subject {
            id: name(kind, property)?,
            param: property.entry()?,
            object: Some(Owner {
                id,
                kind: kind.name,
                property: property.name,
            }),
        })
    }
}

/// The name of a property, made once.
fn name(kind: &Kind, property: Property) -> Option<&'static str> {
    static NAMES: OnceLock<Vec<String>> = OnceLock::new();
    let all = NAMES.get_or_init(|| {
        let of = |kind: &'static Kind| {
            let names = kind.names.iter();
            names.map(|name| format!("{}:{name}", kind.name))
        };
        KINDS.iter().copied().flat_map(of).collect()
    });
    let is_it = |text: &&String| text.split_once(':') == Some((kind.name, property.name));
    all.iter().find(is_it).map(String::as_str)
}
