//! Exact typing: a click on a value turns it into a field.
//!
//! Enter takes what was typed, Escape leaves it, and so does a click elsewhere
//! take it. What the validator refuses is said in a red line under the field;
//! nothing is ever pulled into the range in silence. A wheel over the value turns it.

use egui::text::{CCursor, CCursorRange};
use egui::{
    Align2, CursorIcon, Event, Id, Key, MouseWheelUnit, Rect, Sense, TextEdit, Ui, UiBuilder, pos2,
};
use hearth_core::params::{Input, Kind, Param};

use crate::format::typed_text;
use crate::panel::Panel;
use crate::{row, theme};

/// How far most wheels scroll with one notch [points]: one step.
const NOTCH: f32 = 50.0;

/// A value that is being typed.
#[derive(Clone, Debug)]
pub struct Typing {
    /// Of which parameter.
    pub id: &'static str,
    text: String,
    before: String,
    fresh: bool,
}

/// Shows a value that can be typed, at the right of `room`.
pub fn show(panel: &mut Panel, ui: &mut Ui, param: &'static Param, room: Rect, shown: &str) {
    if panel.typing.as_ref().is_some_and(|t| t.id == param.id) {
        edit(panel, ui, param, room);
        return;
    }
    let place = row::value(ui, room, shown, param.unit, theme::TEXT);
    let hit = Rect::from_min_max(
        pos2((place.left() - 6.0).max(room.left()), room.top()),
        pos2(room.right(), room.bottom()),
    );
    let response = ui
        .interact(hit, Id::unique(("value", param.id)), Sense::click())
        .on_hover_cursor(CursorIcon::Text);
    if response.hovered() {
        // What comes under a resting pointer because the panel scrolls is not meant.
        if ui.input(|input| {
            input
                .events
                .iter()
                .any(|one| matches!(one, Event::PointerMoved(_)))
        }) {
            panel.turning = Some(param.id);
        }
        let y = place.bottom();
        ui.painter().hline(place.x_range(), y, (1.0, theme::ACCENT));
    }
    panel.place(ui, format!("value:{}", param.id), hit);
    if !response.contains_pointer() && panel.turning == Some(param.id) {
        panel.turning = None;
    }
    if response.clicked() {
        let text = param.get(&panel.fire.parameters).to_string();
        panel.typing = Some(Typing {
            id: param.id,
            before: text.clone(),
            text,
            fresh: true,
        });
    }
}

/// By how many steps the wheel turns the value that is pointed at.
pub fn turned(panel: &mut Panel, ui: &Ui, param: &'static Param) -> Option<f32> {
    if panel.turning != Some(param.id) {
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
                MouseWheelUnit::Point => delta.y / NOTCH,
                MouseWheelUnit::Line | MouseWheelUnit::Page => delta.y,
            },
            _ => 0.0,
        });
        turns.sum()
    });
    panel.turned += turned;
    let steps = panel.turned.trunc();
    panel.turned -= steps;
    (steps != 0.0).then_some(steps)
}

fn edit(panel: &mut Panel, ui: &mut Ui, param: &'static Param, room: Rect) {
    let Some(mut typing) = panel.typing.take() else {
        return;
    };
    let id = Id::unique(("typing", param.id));
    let rect = room.with_min_x(room.left().max(room.right() - 130.0));
    let field = TextEdit::singleline(&mut typing.text)
        .id(id)
        .char_limit(40)
        .desired_width(rect.width())
        .min_size(rect.size())
        .margin(egui::Margin::symmetric(6, 1))
        .align(Align2::RIGHT_CENTER);
    let mut output = ui
        .scope_builder(UiBuilder::new().max_rect(rect), |ui| field.show(ui))
        .inner;
    panel.place(ui, format!("value:{}", param.id), rect);
    let length = typing.text.chars().count();
    if std::mem::take(&mut typing.fresh) {
        ui.memory_mut(|memory| memory.request_focus(id));
        let all = CCursorRange::two(CCursor::new(0), CCursor::new(length));
        output.state.cursor.set_char_range(Some(all));
        output.state.store(ui.ctx(), id);
        row_in_sight(ui, rect);
        panel.typing = Some(typing);
        return;
    }
    let (enter, escape, awake) = ui.input(|input| {
        (
            input.key_pressed(Key::Enter),
            input.key_pressed(Key::Escape),
            input.focused,
        )
    });
    let left = output.response.lost_focus() || !awake;
    if escape {
        panel.fire.refusals.remove(param.id);
    } else if enter || left {
        let taken = typing.text == typing.before || take(panel, param, &typing.text);
        // Enter on a refused value keeps the field, so that it can be mended.
        if !taken && enter {
            ui.memory_mut(|memory| memory.request_focus(id));
            panel.typing = Some(typing);
        }
    } else {
        panel.typing = Some(typing);
    }
}

/// Asks for what was typed; false, and a red line, if it is refused.
fn take(panel: &mut Panel, param: &'static Param, text: &str) -> bool {
    let typed = typed_text(text, param);
    // As a number where it is one, so that a refusal does not quote it.
    let input = match (param.kind, typed.parse::<f64>()) {
        (Kind::Number(_) | Kind::Integer(_) | Kind::Seed, Ok(x)) if x.is_finite() => {
            Input::Number(x)
        }
        _ => Input::Text(&typed),
    };
    match panel.fire.wish(param, input) {
        Ok(value) => {
            panel.ask_for(param, value);
            true
        }
        Err(refusal) => {
            panel.fire.refusals.insert(param.id, refusal.to_string());
            false
        }
    }
}

/// A keyboard on the screen may have made the panel lower: what is edited must
/// not be under its edge.
fn row_in_sight(ui: &Ui, rect: Rect) {
    ui.scroll_to_rect_animation(
        rect.expand(24.0),
        None,
        egui::style::ScrollAnimation::none(),
    );
}
