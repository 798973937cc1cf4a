//! The state of the page's panel controller (`web/panel/controller.js`).

/// What the page offers at present. The buttons take their state from here.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ControllerState {
    /// The label of the scene that the fire started from, with "changed" where it is;
    /// empty if unknown.
    pub scene: String,
    /// The label of the scene alone.
    pub preset: String,
    /// Whether there is a step to undo.
    pub undo: bool,
    /// Whether there is a step to redo.
    pub redo: bool,
    /// Whether the page has a URL that shows this fire.
    pub link: bool,
    /// Whether the page has a URL to embed in a frame.
    pub iframe: bool,
    /// Whether the browser allows full screen.
    pub fullscreen: bool,
    /// The button whose work has just finished, without its `action:`.
    pub done: String,
    /// The message of that button, or, where `done` is empty, an error.
    pub said: String,
}

impl ControllerState {
    /// The error message, if there is one.
    pub fn error(&self) -> Option<&str> {
        (self.done.is_empty() && !self.said.is_empty()).then_some(&*self.said)
    }
}
