//! What the views return from a frame.

use std::collections::BTreeMap;

use egui::{Rect, Ui};

use crate::state::{Action, Command, Pointer, Subject};

/// What the views of a frame return.
#[derive(Debug, Default)]
pub struct Output {
    /// The recognised input, in order.
    pub actions: Vec<Action>,
    /// The rectangle of each visible control.
    pub rectangles: BTreeMap<String, Rect>,
    /// What the row under the pointer shows.
    pub hovered: Option<Subject>,
    /// What the row under a resting pointer is about, and the row. The page shows it beside the
    /// panel, where it covers no other row.
    pub tooltip: Option<(String, Rect)>,
    /// The top of each visible row.
    pub tops: Vec<(&'static str, f32)>,
    /// Whether a control of the present row shows its own tooltip.
    pub quiet: bool,
    /// The pointer's unfinished gestures.
    pub pointer: Pointer,
}

impl Output {
    /// Returns an action.
    pub fn push(&mut self, action: Action) {
        self.actions.push(action);
    }

    /// Returns a command for the host.
    pub fn send(&mut self, command: Command) {
        self.push(Action::Send(command));
    }

    /// Records the rectangle of a control that is visible as a whole.
    pub fn record(&mut self, ui: &Ui, name: impl Into<String>, rect: Rect) {
        if ui.clip_rect().expand(1.0).contains_rect(rect) {
            self.rectangles.insert(name.into(), rect);
        }
    }
}
