//! The variants of the scene: two states to compare, and random values.

use egui::{Id, Ui, vec2};

use crate::state::{Command, ControllerState};
use crate::view::button::{self, Face};
use crate::view::layout::labelled;
use crate::view::output::Output;

/// The states that are compared: letter, name of the button, tooltip.
const STATES: [(&str, &str, &str); 2] = [
    (
        "A",
        "action:compare:A",
        "State A: it keeps its values while B is shown",
    ),
    (
        "B",
        "action:compare:B",
        "State B: it begins as a copy of A, and keeps its own values",
    ),
];

/// The gap between two buttons.
const GAP: f32 = 6.0;

/// Shows the buttons of the two states, and of random values beside them.
pub fn show(controller: &ControllerState, out: &mut Output, ui: &mut Ui, control: f32) {
    let line = labelled(ui, control, "Compare");
    let (states, random) = line.split_left_right_at_fraction(0.5);
    for (rect, (letter, name, hint)) in button::split(states, STATES.len(), GAP).zip(STATES) {
        let face = Face {
            lit: controller.compared == letter,
            ..Face::text(letter)
        };
        let response = button::show(ui, rect, Id::unique(name), face).on_hover_text(hint);
        out.place(ui, name, rect);
        if response.clicked() {
            out.send(Command::Compare(letter));
        }
    }
    let name = "action:randomise";
    let rect = random.translate(vec2(GAP, 0.0)).with_max_x(line.right());
    let response = button::show(ui, rect, Id::unique(name), Face::text("Randomise"))
        .on_hover_text("Random values near those of the scene");
    out.place(ui, name, rect);
    if response.clicked() {
        out.send(Command::Randomise);
    }
}
