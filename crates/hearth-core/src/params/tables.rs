//! All tables of entries; those of the kinds of objects lie in the folder.

pub(super) mod name;
pub(super) mod solid;

use super::entry::Description;
use super::table::{DESCRIPTIONS, PARAMETERS, Param};
use name::{COMMON, COMMON_DESCRIPTIONS};
use solid::{SOLID, SOLID_DESCRIPTIONS};

/// A table of entries: a reference to the static itself, of which there is one.
pub(crate) type Table = &'static &'static [Param];

/// Every table of entries, with their descriptions.
pub(super) static TABLES: &[(Table, &&[Description])] = &[
    (&PARAMETERS, &DESCRIPTIONS),
    (&COMMON, &COMMON_DESCRIPTIONS),
    (&SOLID, &SOLID_DESCRIPTIONS),
];
