//! The actions that views return.

use hearth_core::params::Param;

use crate::state::command::Command;
use crate::state::fire::Entry;
use crate::state::open::{Field, OpenColour};

/// An input that a view has recognised.
#[derive(Clone, Debug)]
pub enum Action {
    /// Send a command to the host.
    Send(Command),
    /// Set a parameter and close its field.
    Set(&'static Param, Entry),
    /// Set a parameter by dragging: a value that does not change is not sent.
    Slide(&'static Param, Entry),
    /// Set a choice, whose row then keeps its place.
    Choose(&'static Param, &'static str),
    /// Reset a parameter to the scene's value.
    Restore(&'static Param),
    /// Reset all parameters.
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
