//! The name of an object, the one property that objects of every kind have.

use crate::params::entry::{Description, Domain, Kind, Role};
use crate::params::outline::FromText;
use crate::params::slot::Slot;
use crate::params::table::Param;
use crate::params::value::{AnyValue, ParamError, Value};

/// Most characters of a name.
const LONGEST: usize = 64;

/// The required form.
const FORM: &str = "a line of at most 64 characters";

/// THE table of the properties that objects of every kind have.
pub static COMMON: &[Param] = &[Param {
    id: "name",
    property: "name",
    unit: "",
    kind: Kind::Text(FORM),
    domains: &[Domain {
        model: None,
        default: Value::Text(""),
        range: (0.0, 0.0),
    }],
    role: Role::View,
    field: None,
}];

/// The label and documentation of each of them, in the same order.
pub(in crate::params) static COMMON_DESCRIPTIONS: &[Description] = &[Description {
    group: "",
    label: "Name",
    doc: "An object that lists show under a name. Several objects may have the same. \
          It is a line of at most 64 characters.",
    when: &[],
    unless: &[],
}];

/// The name of an object.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Name(String);

impl Name {
    /// The text; empty for an object without a name.
    pub fn text(&self) -> &str {
        &self.0
    }

    /// Writes a value that the entry has checked.
    ///
    /// # Errors
    /// A text in another form.
    pub(crate) fn put(&mut self, entry: &Param, value: AnyValue<'_>) -> Result<(), ParamError> {
        entry.store(Some(Slot::Text(self)), value)
    }
}

impl FromText for Name {
    fn read(&mut self, text: &str) -> bool {
        let mut length = 0;
        for byte in text.bytes() {
            if byte < b' ' {
                return false;
            }
            // Further bytes of a character begin with the bits 10.
            length += usize::from(byte & 0xC0 != 0x80);
        }
        if length <= LONGEST {
            self.0 = text.to_owned();
        }
        length <= LONGEST
    }
}
