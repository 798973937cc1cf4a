//! The state of the page's panel controller (`web/panel/controller.js`).

/// The state of the buttons.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ControllerState {
    /// The label of the scene that the fire started from, with "changed" if the fire differs from
    /// it; empty if unknown.
    pub scene: String,
    /// The label of the scene alone.
    pub preset: String,
    /// The letter of the state that the fire shows, of the two that are compared; empty if unknown.
    pub compared: String,
    /// Whether there is a step to undo.
    pub undo: bool,
    /// Whether there is a step to redo.
    pub redo: bool,
    /// The forms in which the page can copy the fire.
    pub copies: Vec<CopyForm>,
    /// Whether the browser allows full screen.
    pub fullscreen: bool,
    /// The button whose command has just succeeded, without its `action:`.
    pub done: String,
    /// The message about that command; an error if `done` is empty.
    pub message: String,
}

/// A form in which the page copies the fire.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CopyForm {
    /// The name for [`super::Command::Copy`].
    pub name: String,
    /// The text of the button.
    pub button: String,
    /// The tooltip.
    pub hint: String,
}

impl CopyForm {
    /// The name of the report for an issue, whose button has a line of its own.
    pub const REPORT: &str = "report";
}

impl ControllerState {
    /// The error message, if there is one.
    pub fn error(&self) -> Option<&str> {
        (self.done.is_empty() && !self.message.is_empty()).then_some(&*self.message)
    }
}
