//! A property of an object, by its name and its entry.

use super::choices::Model;
use super::table::Param;
use super::tables::name::COMMON;

/// A property of an object.
#[derive(Clone, Copy, Debug)]
pub struct Property {
    /// Its name.
    pub name: &'static str,
    /// The id of its entry: of a source's property, the parameter whose value it is in the
    /// first source.
    pub id: &'static str,
    /// The table of its entry, unless objects of every kind have it.
    pub(crate) table: &'static [Param],
}

impl Property {
    /// Its entry.
    pub fn entry(&self) -> Option<&'static Param> {
        let mut all = self.table.iter().chain(COMMON);
        all.find(|param| param.id == self.id)
    }

    /// Whether objects of every kind have it.
    pub fn is_common(&self) -> bool {
        self.id == COMMON[0].id
    }

    /// Its entry, if `model` uses it.
    pub fn param(&self, model: Model) -> Option<&'static Param> {
        self.entry().filter(|param| param.domain(model).is_some())
    }
}
