//! The control of a colour: a swatch that opens sliders, and a tick for
//! *transparent*.
//!
//! The sliders open in the row instead of a window above it: the sheet on a
//! phone is too low for one. Hue and saturation are kept while the sliders are
//! open, because black and grey have none to remember.

use egui::ecolor::Hsva;
use egui::{Align2, Color32, CursorIcon, Id, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};
use hearth_core::params::{Colour, Input, Param, Value};

use crate::panel::{Panel, strip};
use crate::slider::{self, Moved, Rail};
use crate::{control, field, row, theme};

/// The colour whose sliders are open.
#[derive(Clone, Copy, Debug)]
pub struct OpenColour {
    id: &'static str,
    hsva: Hsva,
}

/// Shows the row of a colour.
pub fn show(panel: &mut Panel, ui: &mut Ui, param: &'static Param) {
    let Value::Colour(colour) = param.get(&panel.fire.parameters) else {
        return;
    };
    let room = row::line(panel, ui, param, panel.measures.control);
    let (rest, swatch) = room.split_left_right_at_x(room.right() - 44.0);
    let transparent = colour == Colour::TRANSPARENT;
    tick_transparent(panel, ui, param, rest, transparent);
    swatch_button(panel, ui, param, swatch.shrink2(vec2(0.0, 2.0)), colour);
    if panel.colour.is_some_and(|open| open.id == param.id) {
        sliders(panel, ui, param, colour);
    }
}

fn tick_transparent(
    panel: &mut Panel,
    ui: &Ui,
    param: &'static Param,
    room: Rect,
    transparent: bool,
) {
    let text = ui.painter().text(
        pos2(room.right() - 10.0, room.center().y),
        Align2::RIGHT_CENTER,
        "transparent",
        theme::small(),
        theme::weak(),
    );
    let centre = pos2(text.left() - 16.0, room.center().y);
    let tick = Rect::from_center_size(centre, vec2(24.0, room.height()));
    if control::tick(ui, tick, Id::unique(("transparent", param.id)), transparent) {
        let next = match (transparent, panel.colour) {
            (false, _) => Colour::TRANSPARENT,
            (true, Some(open)) if open.id == param.id => as_colour(open.hsva.to_opaque()),
            (true, _) => Colour::rgb(0, 0, 0),
        };
        ask(panel, param, next);
    }
    panel.place(ui, format!("transparent:{}", param.id), tick);
}

fn swatch_button(panel: &mut Panel, ui: &Ui, param: &'static Param, rect: Rect, colour: Colour) {
    let response = ui
        .interact(rect, Id::unique(("swatch", param.id)), Sense::click())
        .on_hover_cursor(CursorIcon::PointingHand);
    panel.place(ui, param.id, rect);
    if response.clicked() {
        let open = panel.colour.is_some_and(|open| open.id == param.id);
        panel.colour = (!open).then(|| OpenColour {
            id: param.id,
            hsva: Hsva::from_srgba_unmultiplied(colour.rgba),
        });
    }
    let painter = ui.painter();
    checkers(ui, rect.shrink(1.0));
    let [r, g, b, a] = colour.rgba;
    painter.rect_filled(rect, 4.0, Color32::from_rgba_unmultiplied(r, g, b, a));
    let line = if response.hovered() {
        theme::ACCENT
    } else {
        theme::weak()
    };
    painter.rect_stroke(rect, 4.0, Stroke::new(1.0, line), StrokeKind::Inside);
}

/// What shows through: squares of two greys.
fn checkers(ui: &Ui, rect: Rect) {
    let side = 6.0;
    let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    painter.rect_filled(rect, 0.0, Color32::from_gray(90));
    let (columns, rows) = ((rect.width() / side) as i32, (rect.height() / side) as i32);
    for row in 0..=rows {
        for column in (row % 2..=columns).step_by(2) {
            let corner = rect.min + vec2(column as f32 * side, row as f32 * side);
            let square = Rect::from_min_size(corner, vec2(side, side));
            painter.rect_filled(square, 0.0, Color32::from_gray(60));
        }
    }
}

fn sliders(panel: &mut Panel, ui: &mut Ui, param: &'static Param, colour: Colour) {
    let Some(OpenColour { mut hsva, .. }) = panel.colour else {
        return;
    };
    if as_colour(hsva) != colour {
        hsva = Hsva::from_srgba_unmultiplied(colour.rgba);
    }
    let exact = strip(ui, panel.measures.control);
    let words = colour.to_string();
    field::show(panel, ui, param, exact, &words);
    ui.painter().text(
        exact.left_center(),
        Align2::LEFT_CENTER,
        "Hexadecimal",
        theme::small(),
        theme::weak(),
    );
    let names = ["Hue", "Saturation", "Brightness", "Opacity"];
    let mut parts = [hsva.h, hsva.s, hsva.v, hsva.a];
    let mut moved = None;
    for (at, name) in names.into_iter().enumerate() {
        let mut rect = strip(ui, panel.measures.rail + 4.0);
        ui.painter().text(
            rect.left_center(),
            Align2::LEFT_CENTER,
            name,
            theme::small(),
            theme::weak(),
        );
        rect.min.x += 80.0;
        let along = |fraction: f32| rail_colour(hsva, at, fraction);
        let rail = Rail {
            fraction: parts[at],
            mark: None,
            dear: None,
            colours: Some(&along),
        };
        let id = Id::unique(("colour", param.id, at));
        let (_, change) = slider::show(ui, rect, id, &rail, panel.finger, &mut panel.gesture);
        let key = format!("{}:{}", name.to_lowercase(), param.id);
        panel.place(ui, key, rect);
        match change {
            Some(Moved::To(to)) => moved = Some((at, to)),
            Some(Moved::Steps(steps)) => {
                moved = Some((at, (parts[at] + steps * 0.01).clamp(0.0, 1.0)));
            }
            None => {}
        }
    }
    if let Some((at, to)) = moved {
        parts[at] = to;
        // Somebody who picks a colour wants to see it.
        if at < 3 && colour == Colour::TRANSPARENT {
            parts[3] = 1.0;
        }
        if at == 0 && parts[1] < 0.05 {
            parts[1] = 0.8;
        }
        if at < 2 && parts[2] < 0.05 {
            parts[2] = 0.6;
        }
        hsva = from_parts(parts);
        ask(panel, param, as_colour(hsva));
    }
    panel.colour = Some(OpenColour { id: param.id, hsva });
}

/// The colour along a slider's rail: what the knob would choose there, made
/// light enough to be told apart.
fn rail_colour(hsva: Hsva, part: usize, fraction: f32) -> Color32 {
    let Hsva { h, s, v, .. } = hsva;
    let opaque = |h, s, v| Color32::from(Hsva::new(h, s, v, 1.0));
    match part {
        0 => opaque(fraction, 1.0, 1.0),
        1 => opaque(h, fraction, v.max(0.6)),
        2 => opaque(h, s, fraction),
        _ => theme::GROUND.lerp_to_gamma(opaque(h, s, v.max(0.3)), fraction),
    }
}

fn from_parts([h, s, v, a]: [f32; 4]) -> Hsva {
    Hsva::new(h, s, v, a)
}

/// The nearest colour of 8 bits a channel; one that cannot be seen is
/// *transparent*.
fn as_colour(hsva: Hsva) -> Colour {
    let rgba = hsva.to_srgba_unmultiplied();
    if rgba[3] == 0 {
        Colour::TRANSPARENT
    } else {
        Colour { rgba }
    }
}

fn ask(panel: &mut Panel, param: &'static Param, colour: Colour) {
    let before = param.get(&panel.fire.parameters);
    if let Ok(now) = panel.fire.wish(param, Input::Text(&colour.to_string()))
        && now != before
    {
        panel.ask_for(param, now);
    }
}
