//! The actions that views return.

use crate::state::command::Command;
use crate::state::fire::Entry;
use crate::state::open::{Field, OpenColour};
use crate::state::subject::Subject;

/// An input that a view has recognised.
#[derive(Clone, Debug)]
pub enum Action {
    /// Send a command to the host.
    Send(Command),
    /// Set a value and close its field.
    Set(Subject, Entry),
    /// Set a value by dragging: a value that does not change is not sent.
    Slide(Subject, Entry),
    /// Set a choice, whose row then keeps its position.
    Choose(Subject, &'static str),
    /// Reset a value to the scene's.
    Restore(Subject),
    /// Reset all parameters and objects.
    RestoreAll,
    /// Set the quality, by name.
    Quality(&'static str),
    /// Show the scenes.
    Scenes,
    /// Open a field for exact input, in place of any other.
    OpenField(Field),
    /// The text of an open field has changed.
    Type(Field),
    /// Close the field of a parameter.
    CloseField(&'static str),
    /// Show why a typed value is refused, or remove the reason.
    Refuse(&'static str, Option<String>),
    /// Open the sliders of a colour, or close them.
    OpenColour(Option<OpenColour>),
    /// Unfold the list of a choice, or fold it.
    OpenChoice(Option<&'static str>),
    /// Show the description of a parameter, or hide it.
    Describe(Option<&'static str>),
    /// Select an object, or none.
    Select(Option<u32>),
    /// Remove the mark from the revealed row.
    Unmark,
    /// Toggle the tools of a low panel.
    ToggleTools,
    /// Toggle copy and paste.
    ToggleSharing,
    /// Toggle the times of a frame.
    ToggleTimes,
    /// Toggle a group of parameters.
    ToggleGroup(&'static str),
    /// Search for a text.
    Search(String),
    /// The search field has taken the focus.
    SearchFocused,
}
