//! The variants of the scene: two states to compare, and random values of three strengths.

use egui::{Id, Rect, Ui};

use crate::state::{Command, ControllerState};
use crate::view::button::{self, Face};
use crate::view::output::Output;

/// The gap between two buttons.
const BUTTON_GAP: f32 = 4.0;

/// The strengths of random values: the name, the text of its button, and its hint.
const STRENGTHS: [(&str, &str, &str); 3] = [
    ("mild", "Mild", "Random values near those of the scene"),
    ("bold", "Bold", "Random values far from those of the scene"),
    ("wild", "Wild", "Another scene, with random values"),
];

/// Shows the buttons of the two states, and of random values beside them.
pub fn line(controller: &ControllerState, out: &mut Output, ui: &Ui, rect: Rect) {
    let state = |letter| Face {
        lit: controller.compared == letter,
        ..Face::text(letter)
    };
    let states = [
        ("A", "Show state A. B keeps its settings."),
        ("B", "Show state B, at first a copy of A."),
    ]
    .map(|(letter, hint)| {
        let name = format!("action:compare:{letter}");
        (name, hint, state(letter), Command::Compare(letter))
    });
    let random = STRENGTHS.map(|(strength, text, hint)| {
        let name = format!("action:randomise:{strength}");
        (name, hint, Face::text(text), Command::Randomise(strength))
    });
    let (letters, words) = rect.split_left_right_at_x(rect.left() + 2.0 * rect.height());
    let parts = button::split(letters, states.len(), BUTTON_GAP).chain(button::split(
        words.with_min_x(words.left() + BUTTON_GAP),
        random.len(),
        BUTTON_GAP,
    ));
    for (rect, (name, hint, face, command)) in parts.zip(states.into_iter().chain(random)) {
        let response = button::show(ui, rect, Id::new(&name), face).on_hover_text(hint);
        out.record(ui, name, rect);
        if response.clicked() {
            out.send(command);
        }
    }
}
