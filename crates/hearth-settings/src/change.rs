//! What changes settings.

use crate::untrusted::Values;

/// A change of settings. Its values are not checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change<'a> {
    /// Values of parameters, and the list of `objects`, all or none. `undefined` states nothing, `null` restores.
    Set(Values<'a>),
    /// Such values. With another model, what attributes of the page state, the second values, applies again.
    SetModel(Values<'a>, Values<'a>),
    /// The page states such values in attributes. One that the model has no use for has no effect. The objects of
    /// children stay.
    State(Values<'a>),
    /// An object is added.
    AddObject(Values<'a>),
    /// Properties of the object with this id change.
    ChangeObject(u32, Values<'a>),
    /// The object with this id is removed.
    RemoveObject(u32),
    /// A preset replaces all settings. Children stay.
    Preset(&'a str),
}
