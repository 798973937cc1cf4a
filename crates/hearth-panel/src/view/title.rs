//! The first line of a row: the parameter's name, and the button that resets it.

use egui::{CursorIcon, Id, Rect, Sense, Ui, pos2, vec2};
use hearth_core::params::{Condition, conditions_text};

use crate::state::{Action, Fire, State, Subject};
use crate::theme;
use crate::view::button::{self, Face};
use crate::view::icons::Icon;
use crate::view::layout::strip;
use crate::view::output::Output;

/// Shows the line, with a reset button if the value differs from the scene. Returns the
/// rest of the line, for the value or the control.
pub fn line(state: &State, out: &mut Output, ui: &mut Ui, subject: Subject, height: f32) -> Rect {
    let rect = strip(ui, height);
    let name = name(state, out, ui, subject, rect);
    let slot = if state.device.finger { 36.0 } else { 24.0 };
    let back = Rect::from_min_size(name.right_top(), vec2(slot, rect.height()));
    if state.fire.differs(subject) {
        let key = format!("action:restore:{}", subject.id);
        let response = button::show(ui, back, Id::new(&key), Face::bare(Icon::Reset));
        out.record(ui, key, back);
        out.quiet = response.hovered();
        let hint = if state.fire.is_of_scene(subject) {
            "Reset to the scene's value"
        } else {
            "Reset to the default"
        };
        if response.on_hover_text(hint).clicked() {
            out.push(Action::Restore(subject));
        }
    }
    Rect::from_min_max(pos2(back.right() + 4.0, rect.top()), rect.max)
}

/// Shows the name at the left of `rect`. A double click resets the parameter; a tap shows
/// its description, because a finger cannot hover.
pub fn name(state: &State, out: &mut Output, ui: &Ui, subject: Subject, rect: Rect) -> Rect {
    let idle = idle(&state.fire, subject).is_some();
    let plain = if idle { theme::weak() } else { theme::TEXT };
    let label = ui.painter().layout_no_wrap(
        subject.param.description().label.to_owned(),
        theme::body(),
        plain,
    );
    let name = Rect::from_min_size(rect.min, vec2(label.size().x + 4.0, rect.height()));
    let response = ui
        .interact(name, Id::new(("name", subject.id)), Sense::click())
        .on_hover_cursor(CursorIcon::Help);
    let ink = if response.hovered() {
        theme::ACCENT
    } else {
        plain
    };
    let at = pos2(rect.left(), rect.center().y - label.size().y / 2.0);
    ui.painter().galley_with_override_text_color(at, label, ink);
    out.record(ui, format!("label:{}", subject.id), name);
    if response.double_clicked() {
        out.push(Action::Restore(subject));
    }
    if response.clicked() && state.device.finger {
        let open = state.open.description == Some(subject.id);
        out.push(Action::Describe((!open).then_some(subject.id)));
    }
    name
}

/// The reason why a parameter has no effect at present, if it has none.
pub fn idle(fire: &Fire, subject: Subject) -> Option<String> {
    let label = |id: &str| {
        let choice = fire.choice_of(subject, id);
        choice.map_or_else(String::new, |choice| {
            choice.description().label.to_lowercase()
        })
    };
    let text_of = |all: &[Condition]| conditions_text(all, label, str::to_owned);
    let missing: Vec<_> = fire
        .unmet_conditions(subject)
        .into_iter()
        .copied()
        .collect();
    if !missing.is_empty() {
        return Some(format!("Only with {}", text_of(&missing)));
    }
    let ruled_out = fire.met_exclusions(subject);
    (!ruled_out.is_empty()).then(|| format!("Not with {}", text_of(ruled_out)))
}
