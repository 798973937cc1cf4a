//! Exact input: a click on a value turns it into a text field.
//!
//! Enter and a click elsewhere apply the text, Escape discards it. A red line below the field
//! states why a value is refused; no value is clamped silently. A wheel over the value changes it.

use egui::style::ScrollAnimation;
use egui::text::{CCursor, CCursorRange};
use egui::{
    Align, CursorIcon, Event, Id, Key, Margin, MouseWheelUnit, Rect, Sense, TextEdit, Ui,
    UiBuilder, pos2,
};

use hearth_core::params::Kind;

use crate::browser_text;
use crate::state::{Action, Field, Fire, Pointer, State, Subject};
use crate::theme;
use crate::view::layout;
use crate::view::output::Output;

/// Scroll distance of one notch of most wheels, which is one step [points].
const NOTCH_DISTANCE: f32 = 50.0;

/// Most letters of a text: those of the longest mask.
const MOST_LETTERS: usize = 66_000;

/// Shows a value that can be typed, at the right of `room`.
pub fn show(
    state: &State,
    out: &mut Output,
    ui: &mut Ui,
    subject: Subject,
    room: Rect,
    shown: &str,
) {
    if let Some(field) = state.open.field_of(subject) {
        edit(&state.fire, field.clone(), out, ui, subject, room);
        return;
    }
    let painted = layout::value(ui, room, shown, subject.param.unit, theme::TEXT);
    let hit = Rect::from_min_max(
        pos2((painted.left() - 6.0).max(room.left()), room.top()),
        pos2(room.right(), room.bottom()),
    );
    let response = ui
        .interact(hit, Id::new(("value", subject.id)), Sense::click())
        .on_hover_cursor(CursorIcon::Text);
    let wheel = &mut out.pointer.wheel;
    if response.hovered() {
        // A value that scrolls under a resting pointer does not receive the wheel.
        if ui.input(|input| {
            let mut events = input.events.iter();
            events.any(|event| matches!(event, Event::PointerMoved(_)))
        }) {
            *wheel = Some(subject.id);
        }
        let y = painted.bottom();
        ui.painter()
            .hline(painted.x_range(), y, (1.0, theme::ACCENT));
    }
    if !response.contains_pointer() {
        wheel.take_if(|id| *id == subject.id);
    }
    out.record(ui, format!("value:{}", subject.id), hit);
    if response.clicked() {
        let text = state.fire.value(subject).to_string();
        out.push(Action::OpenField(Field {
            subject,
            before: text.clone(),
            text,
            fresh: true,
        }));
    }
}

/// The steps by which a wheel changes the value under the pointer.
pub fn wheel_steps(pointer: &mut Pointer, ui: &Ui, subject: Subject) -> Option<f32> {
    if pointer.wheel != Some(subject.id) {
        return None;
    }
    let turned: f32 = ui.input_mut(|input| {
        input.smooth_scroll_delta.y = 0.0;
        let turns = input.events.iter().map(|event| match event {
            Event::MouseWheel {
                unit,
                delta,
                modifiers,
                ..
            } if !modifiers.command => match unit {
                MouseWheelUnit::Point => delta.y / NOTCH_DISTANCE,
                MouseWheelUnit::Line | MouseWheelUnit::Page => delta.y,
            },
            _ => 0.0,
        });
        turns.sum()
    });
    pointer.turned += turned;
    let steps = pointer.turned.trunc();
    pointer.turned -= steps;
    (steps != 0.0).then_some(steps)
}

fn edit(
    fire: &Fire,
    mut field: Field,
    out: &mut Output,
    ui: &mut Ui,
    subject: Subject,
    room: Rect,
) {
    let id = Id::new(("typing", subject.id));
    let (width, most) = match subject.param.kind {
        Kind::Text(_) => (room.width(), MOST_LETTERS),
        _ => (130.0, 40),
    };
    let rect = room.with_min_x(room.left().max(room.right() - width));
    let mut lay_out = browser_text::lay_out;
    let text = TextEdit::singleline(&mut field.text)
        .layouter(&mut lay_out)
        .id(id)
        .char_limit(most)
        .desired_width(rect.width())
        .min_size(rect.size())
        .margin(Margin::symmetric(6, 1))
        .horizontal_align(Align::Max)
        .vertical_align(Align::Center);
    let mut output = ui
        .scope_builder(UiBuilder::new().max_rect(rect), |ui| text.show(ui))
        .inner;
    browser_text::paint_typed(ui, &output, &field.text);
    out.record(ui, format!("value:{}", subject.id), rect);
    if std::mem::take(&mut field.fresh) {
        let length = field.text.chars().count();
        ui.memory_mut(|memory| memory.request_focus(id));
        let all = CCursorRange::two(CCursor::new(0), CCursor::new(length));
        output.state.cursor.set_char_range(Some(all));
        output.state.store(ui.ctx(), id);
        // An on-screen keyboard may have made the panel lower.
        ui.scroll_to_rect_animation(rect.expand(24.0), None, ScrollAnimation::none());
        out.push(Action::Type(field));
        return;
    }
    let (enter, escape, awake) = ui.input(|input| {
        (
            input.key_pressed(Key::Enter),
            input.key_pressed(Key::Escape),
            input.focused,
        )
    });
    if escape {
        out.push(Action::Refuse(subject.id, None));
        out.push(Action::CloseField(subject.id));
    } else if enter || output.response.lost_focus() || !awake {
        let taken = field.text == field.before || take(fire, out, subject, &field.text);
        if taken || !enter {
            out.push(Action::CloseField(subject.id));
        } else {
            // Enter keeps the field of a refused value, so that it can be corrected.
            ui.memory_mut(|memory| memory.request_focus(id));
            out.push(Action::Type(field));
        }
    } else if output.response.changed() {
        out.push(Action::Type(field));
    }
}

/// Sets a parameter to the typed text. Returns whether the table accepts it.
fn take(fire: &Fire, out: &mut Output, subject: Subject, text: &str) -> bool {
    let entry = fire.typed(subject, text);
    match fire.check(subject, entry.input()) {
        Ok(()) => {
            out.push(Action::Set(subject, entry));
            true
        }
        Err(refusal) => {
            out.push(Action::Refuse(subject.id, Some(refusal.to_string())));
            false
        }
    }
}
