//! The pointer's unfinished gestures, which outlive a frame.

use egui::{Event, Id, Pos2, Ui};

/// Gestures of the pointer.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pointer {
    /// The press on a slider.
    pub gesture: Option<(Id, Gesture)>,
    /// The parameter whose value a wheel turns.
    pub wheel: Option<&'static str>,
    /// The part of a step that the wheel has turned.
    pub turned: f32,
    /// Whether it has pressed or turned since it last moved freely. Rows have no tooltips then.
    pub acts: bool,
}

impl Pointer {
    /// Notes whether it acts in this frame.
    pub fn follow(&mut self, ui: &Ui) {
        self.acts = ui.input(|input| {
            let has = |is: fn(&Event) -> bool| input.events.iter().any(is);
            let turns = has(|event| matches!(event, Event::MouseWheel { .. }));
            let moves = has(|event| matches!(event, Event::PointerMoved(_)));
            input.pointer.any_down() || turns || self.acts && !moves
        });
    }
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
