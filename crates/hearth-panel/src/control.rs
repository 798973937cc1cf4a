//! The controls of numbers, seeds and flags.

use egui::{CursorIcon, Id, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};
use hearth_core::params::{Input, Param, Scale, Value};

use crate::button::{self, Face};
use crate::format::{fraction, step, value_at, value_text};
use crate::icons::Icon;
use crate::panel::{Panel, strip};
use crate::slider::{self, Moved, Rail};
use crate::{cost, field, row, theme};

/// A number: its value can be typed, its slider dragged.
pub fn number(panel: &mut Panel, ui: &mut Ui, param: &'static Param, scale: Scale, whole: bool) {
    let range = panel.fire.range_of(param);
    let value = param.get(&panel.fire.parameters);
    let room = row::line(panel, ui, param, panel.measures.line);
    field::show(panel, ui, param, room, &value_text(&value));
    let turned = field::turned(panel, ui, param);

    let rect = strip(ui, panel.measures.rail);
    let x = value.as_number().unwrap_or(range.0);
    let default = panel.fire.default_of(param);
    let mark = default.as_number().filter(|_| default != value);
    let rail = Rail {
        fraction: fraction(x, range, scale) as f32,
        mark: mark.map(|x| fraction(x, range, scale) as f32),
        dear: cost::dear_from(param)
            .filter(|from| *from < range.1)
            .map(|from| fraction(from, range, scale) as f32),
        colours: None,
    };
    let id = Id::unique(("slider", param.id));
    let (_, moved) = slider::show(ui, rect, id, &rail, panel.finger, &mut panel.gesture);
    panel.place(ui, param.id, rect);
    if let Some(words) = cost::note(&panel.fire, param, x) {
        row::paragraph(ui, &words, theme::weak());
    }
    let moved = moved.or(turned.map(Moved::Steps));
    let wish = match moved {
        Some(Moved::To(at)) => value_at(f64::from(at), range, scale, whole),
        Some(Moved::Steps(steps)) => stepped(x, f64::from(steps), range, scale, whole),
        None => return,
    };
    panel.shown = None;
    if let Ok(now) = panel.fire.wish(param, Input::Number(wish))
        && now != value
    {
        panel.typing = None;
        panel.ask_for(param, now);
    }
}

/// `x`, so many key presses further: a step of the slider, or a hundredth of a
/// logarithmic one, and at least one whole number.
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

/// A seed: typed, or thrown.
pub fn seed(panel: &mut Panel, ui: &mut Ui, param: &'static Param) {
    let room = row::line(panel, ui, param, panel.measures.control);
    let value = param.get(&panel.fire.parameters);
    let (room, dice) = room.split_left_right_at_x(room.right() - panel.measures.control);
    field::show(
        panel,
        ui,
        param,
        room.with_max_x(room.right() - 8.0),
        &value_text(&value),
    );
    let key = format!("dice:{}", param.id);
    let face = Face {
        icon: Some(Icon::Dice),
        ..Face::text("")
    };
    let response = button::show(ui, dice, Id::unique(&key), face).on_hover_text("Another seed");
    panel.place(ui, key, dice);
    // A seed is set by typing; its own place in the list is the number.
    panel.place(ui, param.id, room);
    if response.clicked() {
        let Value::Seed(old) = value else { return };
        let time = ui.input(|input| input.time).to_bits();
        let thrown = thrown(old, time);
        if let Ok(now) = panel.fire.wish(param, Input::Number(f64::from(thrown))) {
            panel.typing = None;
            panel.ask_for(param, now);
        }
    }
}

/// Some number below a million that is not `old`, mixed from the time of the
/// throw (splitmix64).
fn thrown(old: u32, time: u64) -> u32 {
    let mut x = time ^ u64::from(old).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    let seed = ((x ^ (x >> 31)) % 1_000_000) as u32;
    if seed == old { seed + 1 } else { seed }
}

/// A flag: a box to tick.
pub fn flag(panel: &mut Panel, ui: &mut Ui, param: &'static Param) {
    let room = row::line(panel, ui, param, panel.measures.control);
    let on = param.get(&panel.fire.parameters) == Value::Flag(true);
    let hit = room.with_min_x(room.right() - panel.measures.control);
    if tick(ui, hit, Id::unique(("flag", param.id)), on)
        && let Ok(now) = panel.fire.wish(param, Input::Flag(!on))
    {
        panel.ask_for(param, now);
    }
    panel.place(ui, param.id, hit);
}

/// A box with a tick in it or not; true when it was clicked.
pub fn tick(ui: &Ui, hit: Rect, id: Id, on: bool) -> bool {
    let response = ui
        .interact(hit, id, Sense::click())
        .on_hover_cursor(CursorIcon::PointingHand);
    let painter = ui.painter();
    let rect = Rect::from_center_size(hit.center(), vec2(18.0, 18.0));
    let fill = match (on, response.hovered()) {
        (true, _) => theme::ACCENT,
        (false, true) => theme::HOVERED,
        (false, false) => theme::RAISED,
    };
    painter.rect_filled(rect, 4.0, fill);
    if on {
        let at = |x: f32, y: f32| pos2(rect.left() + x * 18.0, rect.top() + y * 18.0);
        let stroke = Stroke::new(2.2, theme::GROUND);
        painter.line(vec![at(0.22, 0.52), at(0.42, 0.72), at(0.78, 0.3)], stroke);
    } else {
        let stroke = Stroke::new(1.0, theme::weak());
        painter.rect_stroke(rect, 4.0, stroke, StrokeKind::Inside);
    }
    response.clicked()
}
