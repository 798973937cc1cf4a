//! The commands that the panel sends to its host.

use crate::state::entry::Entry;
use crate::state::memory::Memory;
use crate::state::subject::Subject;

/// A command for the fire or the panel controller of the page.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Set a parameter or a property of an object.
    Set(Subject, Entry),
    /// Reset a parameter or a property to the scene's value.
    Restore(Subject),
    /// Add an object of a kind.
    Add(&'static str),
    /// Add another object with the same properties.
    Duplicate(u32),
    /// Remove an object.
    Remove(u32),
    /// Move an object to the end of the list, before all others, or to its beginning.
    Order(u32, bool),
    /// Act on the fire at an object, by the name of the act: light it, blow at it.
    Act(&'static str, u32),
    /// Select an object, or none.
    Select(Option<u32>),
    /// Reset all parameters, the model included.
    RestoreAll,
    /// Keep this for the next visit.
    Remember(Memory),
    /// Toggle the list of scenes.
    Scenes,
    /// Show one of the two states that are compared, by letter.
    Compare(&'static str),
    /// Set random values, by the name of a strength.
    Randomise(&'static str),
    /// Set the quality, by name.
    Quality(&'static str),
    /// Resume the simulation.
    Play,
    /// Pause the simulation.
    Pause,
    /// Restart the fire with the same values.
    Reset,
    /// Advance a paused simulation by one step.
    Step,
    /// Undo the last change.
    Undo,
    /// Redo the last undone change.
    Redo,
    /// Copy to the clipboard, by name.
    Copy(String),
    /// Paste settings.
    Paste,
    /// Save an image or a film.
    Picture,
    /// Toggle full screen.
    Fullscreen,
    /// Show the keyboard shortcuts.
    Help,
}
