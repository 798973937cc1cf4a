//! The variants of the scene: two states to compare, and random values.

use egui::{Id, Rect, Ui};

use crate::state::{Command, ControllerState};
use crate::view::button::{self, Face};
use crate::view::icons::Icon;
use crate::view::output::Output;

/// The gap between two buttons.
const BUTTON_GAP: f32 = 4.0;

/// The width of the line of buttons that are `height` wide.
pub fn width(height: f32) -> f32 {
    3.0 * height + 2.0 * BUTTON_GAP
}

/// Shows the buttons of the two states, and of random values beside them.
pub fn line(controller: &ControllerState, out: &mut Output, ui: &Ui, rect: Rect) {
    let state = |letter| Face {
        lit: controller.compared == letter,
        ..Face::text(letter)
    };
    let buttons = [
        (
            "action:compare:A",
            "Show state A. B keeps its settings.",
            state("A"),
            Command::Compare("A"),
        ),
        (
            "action:compare:B",
            "Show state B, at first a copy of A.",
            state("B"),
            Command::Compare("B"),
        ),
        (
            "action:randomise",
            "Random values near those of the scene",
            Face::new(Icon::Dice, ""),
            Command::Randomise,
        ),
    ];
    let parts = button::split(rect, buttons.len(), BUTTON_GAP);
    for (rect, (name, hint, face, command)) in parts.zip(buttons) {
        let response = button::show(ui, rect, Id::new(name), face).on_hover_text(hint);
        out.record(ui, name, rect);
        if response.clicked() {
            out.send(command);
        }
    }
}
