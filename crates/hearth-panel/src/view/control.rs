//! The controls of numbers, seeds and flags.

use egui::{Align2, Id, Ui};
use hearth_core::params::{AnyValue, Scale};

use crate::browser_text;
use crate::cost;
use crate::format::{fraction, step, text_in_short, value_at, value_text};
use crate::state::fire::Entry;
use crate::state::{Action, State, Subject};
use crate::theme;
use crate::view::button::{self, Face};
use crate::view::icons::Icon;
use crate::view::layout::{paragraph, strip};
use crate::view::output::Output;
use crate::view::slider::{self, Moved, Rail};
use crate::view::{field, title};

/// A number: a field for its value, and a slider.
pub fn number(
    state: &State,
    out: &mut Output,
    ui: &mut Ui,
    subject: Subject,
    scale: Scale,
    whole: bool,
) {
    let fire = &state.fire;
    let range = fire.slider_range(subject);
    let value = fire.value(subject);
    let room = title::line(state, out, ui, subject, state.device.measures.line);
    field::show(state, out, ui, subject, room, &value_text(&value));
    let turned = field::wheel_steps(&mut out.pointer, ui, subject);

    let rect = strip(ui, state.device.measures.rail);
    let x = value.as_number().unwrap_or(range.0);
    let default = fire.default_of(subject);
    let mark = default.as_number().filter(|_| default != value);
    let rail = Rail {
        fraction: fraction(x, range, scale) as f32,
        mark: mark.map(|x| fraction(x, range, scale) as f32),
        costly: cost::costly_from(subject)
            .filter(|from| *from < range.1)
            .map(|from| fraction(from, range, scale) as f32),
        colours: None,
    };
    let id = Id::new(("slider", subject.id));
    let gesture = &mut out.pointer.gesture;
    let moved = slider::show(ui, rect, id, &rail, state.device.finger, gesture);
    out.record(ui, subject.id, rect);
    if let Some(note) = cost::note(fire, subject, x) {
        paragraph(ui, &note, theme::weak());
    }
    let next = match moved.or(turned.map(Moved::Steps)) {
        Some(Moved::To(at)) => value_at(f64::from(at), range, scale, whole),
        Some(Moved::Steps(steps)) => stepped(x, f64::from(steps), range, scale, whole),
        None => return,
    };
    out.push(Action::Unmark);
    out.push(Action::Slide(subject, Entry::Number(next)));
}

/// `x` after a number of key presses: each is a step of a linear slider, a hundredth of a
/// logarithmic one, and at least 1 for an integer.
fn stepped(x: f64, steps: f64, range: (f64, f64), scale: Scale, whole: bool) -> f64 {
    let next = match scale {
        Scale::Log => {
            let at = fraction(x, range, scale) + steps * 0.01;
            let next = value_at(at, range, scale, whole);
            if whole && next == x {
                x + steps.signum()
            } else {
                next
            }
        }
        Scale::Linear => {
            let unit = if whole {
                step(range).max(1.0)
            } else {
                step(range)
            };
            value_at(
                (x + steps * unit - range.0) / (range.1 - range.0),
                range,
                scale,
                whole,
            )
        }
    };
    next.clamp(range.0, range.1)
}

/// A seed: a field, and a button for a random one.
pub fn seed(state: &State, out: &mut Output, ui: &mut Ui, subject: Subject) {
    let control = state.device.measures.control;
    let room = title::line(state, out, ui, subject, control);
    let value = state.fire.value(subject);
    let (room, dice) = room.split_left_right_at_x(room.right() - control);
    let number = room.with_max_x(room.right() - 8.0);
    field::show(state, out, ui, subject, number, &value_text(&value));
    let key = format!("dice:{}", subject.id);
    let face = Face::new(Icon::Dice, "");
    let response = button::show(ui, dice, Id::new(&key), face).on_hover_text("Random seed");
    out.record(ui, key, dice);
    // A seed has no slider: its control is the number.
    out.record(ui, subject.id, room);
    if response.clicked()
        && let AnyValue::Seed(old) = value
    {
        let time = ui.input(|input| input.time).to_bits();
        let seed = f64::from(random_seed(old, time));
        out.push(Action::Set(subject, Entry::Number(seed)));
    }
}

/// A random number below a million other than `old`, from the time of the click
/// (splitmix64).
fn random_seed(old: u32, time: u64) -> u32 {
    let mut x = time ^ u64::from(old).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    let seed = ((x ^ (x >> 31)) % 1_000_000) as u32;
    if seed == old { seed + 1 } else { seed }
}

/// A flag: a check box.
pub fn flag(state: &State, out: &mut Output, ui: &mut Ui, subject: Subject) {
    let control = state.device.measures.control;
    let room = title::line(state, out, ui, subject, control);
    let on = state.fire.value(subject) == AnyValue::Flag(true);
    let hit = room.with_min_x(room.right() - control);
    if button::check_box(ui, hit, Id::new(("flag", subject.id)), on) {
        out.push(Action::Set(subject, Entry::Flag(!on)));
    }
    out.record(ui, subject.id, hit);
}

/// A text: a field, which is closed while it shows the text in short.
pub fn text(state: &State, out: &mut Output, ui: &mut Ui, subject: Subject) {
    let room = title::line(state, out, ui, subject, state.device.measures.control);
    let shown = text_in_short(subject.param.id, &state.fire.value(subject).to_string());
    field::show(state, out, ui, subject, room, &shown);
    out.record(ui, subject.id, room);
    // The field shows such letters from left to right.
    let typed = state.open.field_of(subject).map_or("", |field| &field.text);
    if browser_text::is_from_right(typed) {
        let rect = strip(ui, state.device.measures.line);
        browser_text::paint(ui, rect, Align2::RIGHT_CENTER, typed, theme::weak());
    }
}
