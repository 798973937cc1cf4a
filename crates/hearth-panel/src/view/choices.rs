//! The control of a choice: a few names side by side, or a longer list that opens from a button
//! with the current name.
//!
//! The list opens in the row, because the sheet on a phone is too low for a window above it. It
//! stays open, so that a visitor can try the names one after another.

use egui::style::ScrollAnimation;
use egui::{EventFilter, Id, Key, PointerButton, Rect, Ui};
use hearth_core::params::{AnyValue, Value};

use crate::format::choice_text;
use crate::state::{Action, Fire, State, Subject};
use crate::view::button::{self, Face};
use crate::view::layout::strip;
use crate::view::output::Output;
use crate::view::title;

/// The longest list that is never folded.
const MAX_UNFOLDED: usize = 4;

/// Names per line of an unfolded list.
const PER_LINE: usize = 3;

/// Maximum height of a line of the list: the longest list fits into a sheet.
const MAX_LINE_HEIGHT: f32 = 30.0;

/// Space between the label and the names below it.
const LABEL_GAP: f32 = 3.0;

/// Width of the button that unfolds a list.
const BUTTON_WIDTH: f32 = 150.0;

/// The names of a choice.
type Names = &'static [&'static str];

/// Shows the row of a choice.
pub fn show(state: &State, out: &mut Output, ui: &mut Ui, subject: Subject, names: Names) {
    let measures = state.device.measures;
    if names.len() <= MAX_UNFOLDED {
        title::line(state, out, ui, subject, measures.line);
        ui.add_space(LABEL_GAP);
        let rect = strip(ui, measures.control);
        buttons(&state.fire, out, ui, subject, names, rect, names.len());
        out.record(ui, subject.id, rect);
        ui.add_space(4.0);
        return;
    }
    let room = title::line(state, out, ui, subject, measures.control);
    let rect = room.with_min_x(room.left().max(room.right() - BUTTON_WIDTH));
    let before = state.open.choice == Some(subject.id);
    let open = before ^ unfolder(&state.fire, out, ui, subject, names, (rect, before));
    out.record(ui, subject.id, rect);
    if open != before {
        out.push(Action::OpenChoice(open.then_some(subject.id)));
    }
    if !open {
        return;
    }
    for names in names.chunks(PER_LINE) {
        ui.add_space(4.0);
        let rect = strip(ui, measures.control.min(MAX_LINE_HEIGHT));
        buttons(&state.fire, out, ui, subject, names, rect, PER_LINE);
    }
    if !before {
        let whole = rect.with_max_y(ui.cursor().top() + 6.0);
        ui.scroll_to_rect_animation(whole, None, ScrollAnimation::none());
    }
}

/// A choice in words. A wall has a floor of its own where no ground is chosen.
fn text_of(fire: &Fire, subject: Subject, name: &str) -> String {
    let has_wall = || fire.objects.get("backdrop") != Some(Value::Choice("none"));
    if subject.id == "ground" && name == "none" && has_wall() {
        "Of the wall".to_owned()
    } else {
        choice_text(name)
    }
}

/// The button that unfolds the list and shows the present name. Returns whether it was
/// clicked. The arrow keys go through the names while it has the focus.
fn unfolder(
    fire: &Fire,
    out: &mut Output,
    ui: &Ui,
    subject: Subject,
    names: Names,
    (rect, open): (Rect, bool),
) -> bool {
    let AnyValue::Choice(now) = fire.value(subject) else {
        return false;
    };
    let response = button::unfolder(
        ui,
        rect,
        Id::new(("list", subject.id)),
        &text_of(fire, subject, now),
        open,
    );
    // egui counts Space as a click, but Space pauses the fire.
    let clicked = response.clicked_by(PointerButton::Primary);
    if clicked {
        response.request_focus();
    }
    if !response.has_focus() {
        return clicked;
    }
    let filter = EventFilter {
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let (down, up) = ui.input(|input| {
        let presses = |key| input.num_presses(key);
        (presses(Key::ArrowDown), presses(Key::ArrowUp))
    });
    let at = names.iter().position(|&name| name == now).unwrap_or(0);
    let next = (at + down).saturating_sub(up).min(names.len() - 1);
    if next != at {
        out.push(Action::Choose(subject, names[next]));
    }
    clicked
}

/// Shows the names side by side in `rect`, each as wide as one of `parts`.
pub fn buttons(
    fire: &Fire,
    out: &mut Output,
    ui: &Ui,
    subject: Subject,
    names: Names,
    rect: Rect,
    parts: usize,
) {
    let now = fire.value(subject);
    for (rect, &name) in button::split(rect, parts, 4.0).zip(names) {
        let text = text_of(fire, subject, name);
        let face = Face {
            lit: now == AnyValue::Choice(name),
            ..Face::text(&text)
        };
        let key = format!("choice:{}:{name}", subject.id);
        let clicked = button::show(ui, rect, Id::new(&key), face).clicked();
        out.record(ui, key, rect);
        if clicked {
            out.push(Action::Choose(subject, name));
        }
    }
}
