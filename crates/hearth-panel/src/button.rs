//! Buttons: an icon, a text, or both, in a rectangle that is given.

use egui::{Align2, CursorIcon, Id, Rect, Response, Sense, Stroke, StrokeKind, Ui, pos2, vec2};

use crate::icons::{self, Icon};
use crate::theme;

/// What stands on a button.
#[derive(Clone, Copy, Debug)]
pub struct Face<'a> {
    /// A picture.
    pub icon: Option<Icon>,
    /// A word.
    pub text: &'a str,
    /// Lit: what it says is so at present.
    pub lit: bool,
    /// Whether it has a ground of its own.
    pub framed: bool,
    /// Whether it does anything at present.
    pub enabled: bool,
}

impl<'a> Face<'a> {
    /// A picture and a word.
    pub fn new(icon: Icon, text: &'a str) -> Face<'a> {
        Face {
            icon: Some(icon),
            ..Face::text(text)
        }
    }

    /// A word alone.
    pub fn text(text: &'a str) -> Face<'a> {
        Face {
            icon: None,
            text,
            lit: false,
            framed: true,
            enabled: true,
        }
    }

    /// A bare picture, without a ground.
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

/// Shows a button that opens a list, with what is chosen of it at present.
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
    // A text that is too long ends at the mark.
    let room = rect
        .shrink2(vec2(10.0, 0.0))
        .with_max_x(rect.right() - 24.0);
    let painter = ui.painter();
    painter.with_clip_rect(room.intersect(ui.clip_rect())).text(
        room.left_center(),
        Align2::LEFT_CENTER,
        text,
        theme::body(),
        theme::TEXT,
    );
    icons::chevron(
        painter,
        pos2(rect.right() - 14.0, rect.center().y),
        true,
        ink,
    );
    response
}

/// Splits `rect` into parts of equal width.
pub fn split(rect: Rect, parts: usize, gap: f32) -> impl Iterator<Item = Rect> {
    let width = (rect.width() - gap * (parts.max(1) - 1) as f32) / parts.max(1) as f32;
    (0..parts).map(move |part| {
        let left = rect.left() + part as f32 * (width + gap);
        Rect::from_min_size(pos2(left, rect.top()), vec2(width, rect.height()))
    })
}

/// Splits `rect` among buttons with these words: each has the room of its word, and
/// what is left is shared.
pub fn split_by_words(ui: &Ui, rect: Rect, words: &[&str], gap: f32) -> Vec<Rect> {
    let widths: Vec<f32> = words
        .iter()
        .map(|&word| {
            let galley = ui
                .painter()
                .layout_no_wrap(word.to_owned(), theme::body(), theme::TEXT);
            galley.size().x
        })
        .collect();
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
