//! The control of a colour: a swatch that opens sliders, and a check box for
//! *transparent*.
//!
//! The sliders open in the row, because the sheet on a phone is too low for a window above
//! it.

use egui::ecolor::Hsva;
use egui::{Align2, Color32, CursorIcon, Id, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};
use hearth_core::params::{AnyValue, Colour};

use crate::state::fire::Entry;
use crate::state::{Action, OpenColour, State, Subject};
use crate::theme;
use crate::view::layout::{label, strip};
use crate::view::output::Output;
use crate::view::slider::{self, Moved, Rail};
use crate::view::{button, field, title};

/// Shows the row of a colour.
pub fn show(state: &State, out: &mut Output, ui: &mut Ui, subject: Subject) {
    let AnyValue::Colour(colour) = state.fire.value(subject) else {
        return;
    };
    let open = state.open.colour.filter(|open| open.id == subject.id);
    let room = title::line(state, out, ui, subject, state.device.measures.control);
    let (slider, swatch) = room.split_left_right_at_x(room.right() - 44.0);
    transparency(out, ui, subject, slider, colour, open);
    let swatch = swatch.shrink2(vec2(0.0, 2.0));
    let mut next = open;
    if swatch_button(out, ui, subject.id, swatch, colour) {
        next = match open {
            Some(_) => None,
            None => Some(OpenColour {
                id: subject.id,
                hsva: Hsva::from_srgba_unmultiplied(colour.rgba),
            }),
        };
    }
    if let Some(open) = &mut next {
        open.hsva = sliders(state, out, ui, subject, colour, open.hsva);
    }
    if next != open {
        out.push(Action::OpenColour(next));
    }
}

/// The check box for *transparent*. Its removal brings back the colour of open sliders.
fn transparency(
    out: &mut Output,
    ui: &Ui,
    subject: Subject,
    room: Rect,
    colour: Colour,
    open: Option<OpenColour>,
) {
    let transparent = colour == Colour::TRANSPARENT;
    let text = ui.painter().text(
        pos2(room.right() - 10.0, room.center().y),
        Align2::RIGHT_CENTER,
        "transparent",
        theme::small(),
        theme::weak(),
    );
    let centre = pos2(text.left() - 16.0, room.center().y);
    let rect = Rect::from_center_size(centre, vec2(24.0, room.height()));
    if button::check_box(ui, rect, Id::new(("transparent", subject.id)), transparent) {
        let next = match (transparent, open) {
            (false, _) => Colour::TRANSPARENT,
            (true, Some(open)) => as_colour(open.hsva.to_opaque()),
            (true, None) => Colour::rgb(0, 0, 0),
        };
        set(out, subject, next);
    }
    out.record(ui, format!("transparent:{}", subject.id), rect);
}

/// The swatch. Returns whether it was clicked.
fn swatch_button(out: &mut Output, ui: &Ui, id: &'static str, rect: Rect, colour: Colour) -> bool {
    let response = ui
        .interact(rect, Id::new(("swatch", id)), Sense::click())
        .on_hover_cursor(CursorIcon::PointingHand);
    out.record(ui, id, rect);
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
    response.clicked()
}

/// The background of a transparent colour: squares of two greys.
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

/// Shows the sliders of a colour, and a field for its hexadecimal form. Returns the
/// position of the sliders.
fn sliders(
    state: &State,
    out: &mut Output,
    ui: &mut Ui,
    subject: Subject,
    colour: Colour,
    mut hsva: Hsva,
) -> Hsva {
    if as_colour(hsva) != colour {
        hsva = Hsva::from_srgba_unmultiplied(colour.rgba);
    }
    let device = state.device;
    let exact = strip(ui, device.measures.control);
    field::show(state, out, ui, subject, exact, &colour.to_string());
    label(ui, exact, "Hexadecimal");
    let names = ["Hue", "Saturation", "Brightness", "Opacity"];
    let parts = [hsva.h, hsva.s, hsva.v, hsva.a];
    let mut moved = None;
    for (at, name) in names.into_iter().enumerate() {
        let mut rect = strip(ui, device.measures.rail + 4.0);
        label(ui, rect, name);
        rect.min.x += 80.0;
        let along = |fraction: f32| rail_colour(hsva, at, fraction);
        let rail = Rail {
            fraction: parts[at],
            mark: None,
            costly: None,
            colours: Some(&along),
        };
        let id = Id::new(("colour", subject.id, at));
        let gesture = &mut out.pointer.gesture;
        let change = slider::show(ui, rect, id, &rail, device.finger, gesture);
        let key = format!("{}:{}", name.to_lowercase(), subject.id);
        out.record(ui, key, rect);
        match change {
            Some(Moved::To(to)) => moved = Some((at, to)),
            Some(Moved::Steps(steps)) => {
                moved = Some((at, (parts[at] + steps * 0.01).clamp(0.0, 1.0)));
            }
            None => {}
        }
    }
    if let Some((at, to)) = moved {
        hsva = moved_to(parts, at, to, colour == Colour::TRANSPARENT);
        set(out, subject, as_colour(hsva));
    }
    hsva
}

/// The colour after a slider moved. Parts that hide the effect of that slider are raised.
fn moved_to(mut parts: [f32; 4], at: usize, to: f32, transparent: bool) -> Hsva {
    parts[at] = to;
    if at < 3 && transparent {
        parts[3] = 1.0;
    }
    if at == 0 && parts[1] < 0.05 {
        parts[1] = 0.8;
    }
    if at < 2 && parts[2] < 0.05 {
        parts[2] = 0.6;
    }
    from_parts(parts)
}

fn set(out: &mut Output, subject: Subject, colour: Colour) {
    out.push(Action::Slide(subject, Entry::Text(colour.to_string())));
}

/// The colour at a point of a slider's rail: the knob's choice there, light enough to be
/// distinguished.
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

/// The nearest colour with 8 bits per channel; an invisible one is *transparent*.
fn as_colour(hsva: Hsva) -> Colour {
    let rgba = hsva.to_srgba_unmultiplied();
    if rgba[3] == 0 {
        Colour::TRANSPARENT
    } else {
        Colour { rgba }
    }
}
