//! What the page around the panel can do at present: the buttons that are no
//! sliders take their state from here.

/// What there is to press besides the fire's own values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Desk {
    /// The scene that the fire started from, in words; empty where nobody knows.
    pub scene: String,
    /// What that scene is called, changed or not.
    pub preset: String,
    /// Whether there is a step to undo.
    pub undo: bool,
    /// Whether there is a step to do again.
    pub redo: bool,
    /// Whether the page has an address that shows this fire.
    pub link: bool,
    /// Whether there is a page to put into a frame.
    pub iframe: bool,
    /// Whether the browser allows the full screen.
    pub fullscreen: bool,
    /// The button whose work is just done, without its `action:`; for a while.
    pub done: String,
    /// What is just done, or, where no button is, what went wrong.
    pub said: String,
}

impl Desk {
    /// What went wrong, if anything did.
    pub fn complaint(&self) -> Option<&str> {
        (self.done.is_empty() && !self.said.is_empty()).then_some(&*self.said)
    }
}
