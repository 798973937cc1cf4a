//! Buttons with an icon, a text or both, and check boxes, in a given rectangle.

use egui::text::{LayoutJob, TextFormat, TextWrapping};
use egui::{Align2, CursorIcon, Id, Rect, Response, Sense, Stroke, StrokeKind, Ui, pos2, vec2};

use crate::browser_text;
use crate::theme;
use crate::view::icons::{self, Icon};

/// The face of a button.
#[derive(Clone, Copy, Debug)]
pub struct Face<'a> {
    /// The icon.
    pub icon: Option<Icon>,
    /// The text.
    pub text: &'a str,
    /// Whether its option is on.
    pub lit: bool,
    /// Whether it has a background.
    pub framed: bool,
    /// Whether it can be pressed.
    pub enabled: bool,
}

impl<'a> Face<'a> {
    /// An icon and a text.
    pub fn new(icon: Icon, text: &'a str) -> Face<'a> {
        Face {
            icon: Some(icon),
            ..Face::text(text)
        }
    }

    /// A text alone.
    pub fn text(text: &'a str) -> Face<'a> {
        Face {
            icon: None,
            text,
            lit: false,
            framed: true,
            enabled: true,
        }
    }

    /// An icon without a background.
    pub fn bare(icon: Icon) -> Face<'a> {
        Face {
            framed: false,
            ..Face::new(icon, "")
        }
    }
}

/// Shows a button in `rect`.
pub fn show(ui: &Ui, rect: Rect, id: Id, face: Face<'_>) -> Response {
    let sense = if face.enabled {
        Sense::click()
    } else {
        Sense::hover()
    };
    let mut response = ui.interact(rect, id, sense);
    if face.enabled {
        response = response.on_hover_cursor(CursorIcon::PointingHand);
    }
    if !ui.is_rect_visible(rect) {
        return response;
    }
    let painter = ui.painter();
    let pressed = response.is_pointer_button_down_on();
    let ground = match (face.lit || pressed, response.hovered() && face.enabled) {
        (true, _) => theme::EMBER,
        (false, true) => theme::HOVERED,
        (false, false) => theme::RAISED,
    };
    if face.framed {
        painter.rect_filled(rect, 6.0, ground);
        if face.lit {
            let stroke = Stroke::new(1.0, theme::ACCENT);
            painter.rect_stroke(rect, 6.0, stroke, StrokeKind::Inside);
        }
    }
    let ink = match (face.enabled, face.framed, response.hovered()) {
        (false, ..) => theme::weak().gamma_multiply(0.5),
        (true, false, false) => theme::weak(),
        (true, false, true) => theme::ACCENT,
        (true, true, _) => theme::TEXT,
    };
    let galley = painter.layout_no_wrap(face.text.to_owned(), theme::body(), ink);
    let size = 13.0;
    let icon_room = match (face.icon, face.text.is_empty()) {
        (None, _) => 0.0,
        (Some(_), true) => size,
        (Some(_), false) => size + 7.0,
    };
    let left = rect.center().x - (icon_room + galley.size().x) / 2.0;
    if let Some(icon) = face.icon {
        icon.paint(painter, pos2(left + size / 2.0, rect.center().y), size, ink);
    }
    let text =
        Align2::LEFT_CENTER.anchor_size(pos2(left + icon_room, rect.center().y), galley.size());
    painter.galley(text.min, galley, ink);
    response
}

/// Paints a text at the left of `room`. One that is too long ends in "…".
pub fn left_text(ui: &Ui, room: Rect, text: &str) {
    if browser_text::paint(ui, room, Align2::LEFT_CENTER, text, theme::TEXT).is_some() {
        return;
    }
    let format = TextFormat::simple(theme::body(), theme::TEXT);
    let mut job = LayoutJob::single_section(text.to_owned(), format);
    job.wrap = TextWrapping::truncate_at_width(room.width());
    let galley = ui.painter().layout_job(job);
    let rect = Align2::LEFT_CENTER.anchor_size(room.left_center(), galley.size());
    ui.painter().galley(rect.min, galley, theme::TEXT);
}

/// The width of a text of a button.
fn width_of(ui: &Ui, text: &str) -> f32 {
    let galley = ui
        .painter()
        .layout_no_wrap(text.to_owned(), theme::body(), theme::TEXT);
    galley.size().x
}

/// The room of the text in a button that opens a list, left of its mark.
fn text_room(rect: Rect) -> Rect {
    rect.shrink2(vec2(10.0, 0.0))
        .with_max_x(rect.right() - 24.0)
}

/// Shows a button that opens a list, with its present choice.
pub fn unfolder(ui: &Ui, rect: Rect, id: Id, text: &str, open: bool) -> Response {
    let face = Face {
        lit: open,
        ..Face::text("")
    };
    let response = show(ui, rect, id, face);
    let ink = if response.hovered() {
        theme::ACCENT
    } else {
        theme::weak()
    };
    left_text(ui, text_room(rect), text);
    icons::chevron(
        ui.painter(),
        pos2(rect.right() - 14.0, rect.center().y),
        true,
        ink,
    );
    response
}

/// Shows a check box. Returns whether it was clicked.
pub fn check_box(ui: &Ui, hit: Rect, id: Id, on: bool) -> bool {
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

/// Splits `rect` into parts of equal width.
pub fn split(rect: Rect, parts: usize, gap: f32) -> impl Iterator<Item = Rect> {
    let width = (rect.width() - gap * (parts.max(1) - 1) as f32) / parts.max(1) as f32;
    (0..parts).map(move |part| {
        let left = rect.left() + part as f32 * (width + gap);
        Rect::from_min_size(pos2(left, rect.top()), vec2(width, rect.height()))
    })
}

/// Splits `rect` among buttons with these labels: each has the width of its label and an
/// equal share of the rest.
pub fn split_by_words(ui: &Ui, rect: Rect, words: &[&str], gap: f32) -> Vec<Rect> {
    let widths: Vec<f32> = words.iter().map(|word| width_of(ui, word)).collect();
    let gaps = gap * words.len().saturating_sub(1) as f32;
    let left = rect.width() - gaps - widths.iter().sum::<f32>();
    let share = left / words.len().max(1) as f32;
    let mut from = rect.left();
    widths
        .into_iter()
        .map(|width| {
            let size = vec2((width + share).max(0.0), rect.height());
            let part = Rect::from_min_size(pos2(from, rect.top()), size);
            from = part.right() + gap;
            part
        })
        .collect()
}
