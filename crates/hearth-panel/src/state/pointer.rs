//! The pointer's unfinished gestures, which outlive a frame.

use egui::{Id, Pos2};

/// Gestures of the pointer.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pointer {
    /// The press on a slider.
    pub gesture: Option<(Id, Gesture)>,
    /// The parameter whose value a wheel turns.
    pub wheel: Option<&'static str>,
    /// The part of a step that the wheel has turned.
    pub turned: f32,
}

/// The meaning of a press on a slider, until its release.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gesture {
    /// Not known yet: it began here.
    Undecided(Pos2),
    /// It moves the knob.
    Slide,
    /// It moves the knob a tenth as far, from this x of the pointer and of the knob.
    Fine(f32, f32),
    /// It scrolls the panel.
    Scroll,
}
