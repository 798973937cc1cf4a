//! One parameter's row: its name, its value, its control, its way back to the
//! default, and in words why a value was refused.

use egui::{Align2, Color32, CursorIcon, Id, Rect, Response, Sense, Shape, Ui, pos2, vec2};
use hearth_core::params::{Kind, Param, Selection, selections_in_words};

use crate::button::{self, Face};
use crate::fire::Command;
use crate::format::{bound_text, value_text, with_unit};
use crate::icons::Icon;
use crate::panel::{Panel, in_sight, strip};
use crate::{control, cost, theme};

/// How much is seen of a control whose value counts for nothing at present: it can
/// be set all the same, so its words keep 4.5:1 wherever they stand.
const IDLE: f32 = 0.8;

/// Shows the row of `param`.
pub fn show(panel: &mut Panel, ui: &mut Ui, param: &'static Param) {
    framed(panel, ui, param, true, |panel, ui| match param.kind {
        Kind::Number(scale) => control::number(panel, ui, param, scale, false),
        Kind::Integer(scale) => control::number(panel, ui, param, scale, true),
        Kind::Seed => control::seed(panel, ui, param),
        Kind::Flag => control::flag(panel, ui, param),
        Kind::Choice(names) => crate::choices::show(panel, ui, param, names),
        Kind::Colour => crate::colour::show(panel, ui, param),
    });
    ui.add_space(panel.measures.gap);
}

/// Shows what `content` shows of a parameter, below it what there is to say of
/// it, and behind it a mark where it is pointed at. `scrolls`: whether it can be
/// brought into sight.
pub fn framed(
    panel: &mut Panel,
    ui: &mut Ui,
    param: &'static Param,
    scrolls: bool,
    content: impl FnOnce(&mut Panel, &mut Ui),
) {
    let ground = ui.painter().add(Shape::Noop);
    let top = ui.cursor().top();
    let idle = idle(panel, param);
    ui.scope(|ui| {
        if idle.is_some() {
            ui.multiply_opacity(IDLE);
        }
        content(panel, ui);
    });
    if let Some(words) = idle {
        paragraph(ui, &words, theme::weak());
    }
    if let Some(refusal) = panel.fire.refusals.get(param.id) {
        paragraph(ui, refusal, theme::ERROR);
    }
    if panel.told == Some(param.id) {
        paragraph(ui, &explanation(panel, param), theme::weak());
    }
    let space = ui.max_rect();
    let rect = Rect::from_x_y_ranges(space.x_range(), top..=ui.cursor().top());
    hover(panel, ui, param, rect);
    if panel.shown == Some(param.id) {
        let fill = Shape::rect_filled(rect.expand2(vec2(8.0, 2.0)), 6.0, theme::RAISED);
        ui.painter().set(ground, fill);
        if panel.revealing && scrolls {
            in_sight(ui, rect);
        }
    }
}

/// All of the row tells about the parameter, and its value can be copied.
fn hover(panel: &mut Panel, ui: &Ui, param: &'static Param, rect: Rect) {
    let row = ui.interact(rect, Id::unique(("row", param.id)), Sense::hover());
    if row.contains_pointer() {
        panel.hovered = Some(param.id);
    }
    let quiet = std::mem::take(&mut panel.quiet);
    // Somebody who types or chooses wants to see what is there.
    let busy = panel.typing.is_some() || panel.listed == Some(param.id);
    if !panel.finger && !quiet && !busy {
        row.on_hover_text(explanation(panel, param));
    }
}

/// Why the value of a parameter counts for nothing at present, in words.
fn idle(panel: &Panel, param: &Param) -> Option<String> {
    let label = |id: &str| {
        Param::find(id).map_or_else(String::new, |choice| {
            choice.description().label.to_lowercase()
        })
    };
    let in_words = |all: &[Selection]| selections_in_words(all, label, str::to_owned);
    let now = &panel.fire.parameters;
    let waits: Vec<_> = param.waits_for(now).copied().collect();
    if !waits.is_empty() {
        return Some(format!("Only with {}", in_words(&waits)));
    }
    let ruled_out = param.ruled_out_by(now);
    (!ruled_out.is_empty()).then(|| format!("Not with {}", in_words(ruled_out)))
}

/// The first line of a row: the name, and beside it the way back to the
/// default, where there is anything to go back from. Returns what is left of
/// the line, for the value or the control.
pub fn line(panel: &mut Panel, ui: &mut Ui, param: &'static Param, height: f32) -> Rect {
    let rect = strip(ui, height);
    let name = name(panel, ui, param, rect);
    let slot = if panel.finger { 36.0 } else { 24.0 };
    let back = Rect::from_min_size(name.right_top(), vec2(slot, rect.height()));
    if param.get(&panel.fire.parameters) != panel.fire.default_of(param) {
        let key = format!("action:restore:{}", param.id);
        let response = button::show(ui, back, Id::unique(&key), Face::bare(Icon::Reset));
        panel.place(ui, key, back);
        panel.quiet = response.hovered();
        if response
            .on_hover_text("Back to the scene's value")
            .clicked()
        {
            restore(panel, param);
        }
    }
    Rect::from_min_max(pos2(back.right() + 4.0, rect.top()), rect.max)
}

/// The name of a parameter at the left of `rect`, which tells about it.
pub fn name(panel: &mut Panel, ui: &mut Ui, param: &'static Param, rect: Rect) -> Rect {
    let idle = idle(panel, param).is_some();
    let rest = if idle { theme::weak() } else { theme::TEXT };
    let label =
        ui.painter()
            .layout_no_wrap(param.description().label.to_owned(), theme::body(), rest);
    let name = Rect::from_min_size(rect.min, vec2(label.size().x + 4.0, rect.height()));
    let response = ui
        .interact(name, Id::unique(("name", param.id)), Sense::click())
        .on_hover_cursor(CursorIcon::Help);
    let ink = if response.hovered() {
        theme::ACCENT
    } else {
        rest
    };
    let at = pos2(rect.left(), rect.center().y - label.size().y / 2.0);
    ui.painter().galley_with_override_text_color(at, label, ink);
    panel.place(ui, format!("label:{}", param.id), name);
    name_pressed(panel, param, &response);
    name
}

/// A finger has no hover: it taps the name to read about it.
fn name_pressed(panel: &mut Panel, param: &'static Param, response: &Response) {
    if response.double_clicked() {
        restore(panel, param);
    }
    if response.clicked() && panel.finger {
        panel.told = (panel.told != Some(param.id)).then_some(param.id);
    }
}

fn restore(panel: &mut Panel, param: &'static Param) {
    panel.fire.refusals.remove(param.id);
    panel.typing = None;
    panel.ask(Command::Restore(param.id));
}

/// What a parameter does, what it has in the scene, its range and its name in HTML.
fn explanation(panel: &Panel, param: &Param) -> String {
    let scene = if panel.desk.preset.is_empty() {
        "Default"
    } else {
        &*panel.desk.preset
    };
    let default = with_unit(&value_text(&panel.fire.default_of(param)), param.unit);
    let mut text = format!("{}\n{scene} {default}", param.description().doc);
    if let Kind::Number(_) | Kind::Integer(_) | Kind::Seed = param.kind {
        let (min, max) = panel.fire.range_of(param);
        text += &format!(
            " · from {} to {}",
            bound_text(min, ""),
            bound_text(max, param.unit)
        );
    }
    if cost::dear_from(param).is_some() {
        text += "\nTakes much work towards the end of its slider";
    }
    text + "\nAttribute " + &param.id.replace('_', "-")
}

/// Text over as many lines as it needs.
pub fn paragraph(ui: &mut Ui, text: &str, ink: Color32) {
    let width = ui.available_width();
    let galley = ui
        .painter()
        .layout(text.to_owned(), theme::small(), ink, width);
    let rect = strip(ui, galley.size().y + 4.0);
    ui.painter().galley(rect.min, galley, ink);
}

/// A value with its unit at the right of `room`; returns where it stands.
pub fn value(ui: &Ui, room: Rect, text: &str, unit: &str, ink: Color32) -> Rect {
    let painter = ui.painter();
    let mut place = Rect::from_min_max(room.right_center(), room.right_center());
    if !unit.is_empty() {
        place = painter.text(
            room.right_center(),
            Align2::RIGHT_CENTER,
            unit,
            theme::small(),
            theme::weak(),
        );
    }
    let gap = if unit.is_empty() { 0.0 } else { 4.0 };
    let at = pos2(place.left() - gap, room.center().y);
    place.union(painter.text(at, Align2::RIGHT_CENTER, text, theme::body(), ink))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How bright a colour is, as the contrast of two is defined (WCAG 2).
    fn luminance(colour: Color32) -> f64 {
        let [r, g, b, _] = colour.to_array().map(|byte| {
            let part = f64::from(byte) / 255.0;
            if part <= 0.04045 {
                part / 12.92
            } else {
                ((part + 0.055) / 1.055).powf(2.4)
            }
        });
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    #[test]
    fn words_that_are_dimmed_can_be_read() {
        let on = |ground: Color32, ink: Color32| ground.lerp_to_gamma(ink, IDLE);
        // The panel, a row that is pointed at, and in both a button, also a lit one.
        for behind in [theme::GROUND, theme::RAISED] {
            let words = [
                (behind, theme::TEXT),
                (behind, theme::weak()),
                (behind, theme::ACCENT),
                (on(behind, theme::RAISED), theme::TEXT),
                (on(behind, theme::HOVERED), theme::TEXT),
                (on(behind, theme::EMBER), theme::TEXT),
            ];
            for (ground, ink) in words {
                let [ground, ink] =
                    [ground, on(ground, ink)].map(|colour| luminance(colour) + 0.05);
                let contrast = ink / ground;
                assert!(contrast >= 4.5, "{contrast} in {ink:?} on {ground:?}");
            }
        }
    }
}
