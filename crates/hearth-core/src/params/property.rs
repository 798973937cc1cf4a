//! A property of an object, by its name and its entry.

use super::choices::Model;
use super::table::Param;
use super::tables::name::COMMON;

/// A property of an object.
#[derive(Clone, Copy, Debug)]
pub struct Property {
    /// Its name.
    pub name: &'static str,
    /// The table of its entry, unless objects of every kind have it.
    pub(crate) table: &'static [Param],
}

impl Property {
    /// Its entry.
    pub fn entry(&self) -> Option<&'static Param> {
        let mut all = self.table.iter().chain(COMMON);
        all.find(|param| param.property == self.name)
    }

    /// The id of its entry: of a source's property, that of the parameter.
    pub fn id(&self) -> &'static str {
        self.entry().map_or(self.name, |param| param.id)
    }

    /// Whether objects of every kind have it.
    pub fn is_common(&self) -> bool {
        self.name == COMMON[0].property
    }

    /// Its entry, if `model` uses it.
    pub fn param(&self, model: Model) -> Option<&'static Param> {
        self.entry().filter(|param| param.domain(model).is_some())
    }
}
