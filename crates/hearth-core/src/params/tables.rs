//! The list of all tables of entries.

use super::entry::Description;
use super::name::{COMMON, COMMON_DESCRIPTIONS};
use super::solid::{SOLID, SOLID_DESCRIPTIONS};
use super::table::{DESCRIPTIONS, PARAMETERS, Param};

/// A table of entries: a reference to the static itself, of which there is one.
pub(crate) type Table = &'static &'static [Param];

/// Every table of entries, with their descriptions.
pub(super) static TABLES: &[(Table, &&[Description])] = &[
    (&PARAMETERS, &DESCRIPTIONS),
    (&COMMON, &COMMON_DESCRIPTIONS),
    (&SOLID, &SOLID_DESCRIPTIONS),
];
