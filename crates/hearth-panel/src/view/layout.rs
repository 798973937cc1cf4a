//! Parts of a layout: strips, labels, paragraphs, and scrolling into view.

use egui::style::ScrollAnimation;
use egui::{Align, Align2, Color32, Rect, Ui, pos2, vec2};

use crate::browser_text::{self, Letters};
use crate::theme;

/// Empty space below the last row: a row can scroll above the focused accessible control, which
/// covers the lower edge of the panel.
pub const SPACE_BELOW: i8 = 84;

/// Width of the label before a line of buttons.
const LABEL_WIDTH: f32 = 56.0;

/// Allocates a strip of the whole width.
pub fn strip(ui: &mut Ui, height: f32) -> Rect {
    let size = vec2(ui.available_width(), height);
    let (_, rect) = ui.allocate_space(size);
    rect
}

/// Scrolls `rect` into view, above what covers the lower edge.
pub fn scroll_into_view(ui: &Ui, mut rect: Rect) {
    rect.max.y += f32::from(SPACE_BELOW);
    // The middle, unless that pushes the row out at the top.
    let align = if rect.height() > ui.clip_rect().height() {
        Align::Min
    } else {
        Align::Center
    };
    ui.scroll_to_rect_animation(rect, Some(align), ScrollAnimation::none());
}

/// The part of a line beside its label.
pub fn beside_label(rect: Rect) -> Rect {
    rect.with_min_x(rect.left() + LABEL_WIDTH)
}

/// Allocates a strip, paints a label at its left, and returns the room beside the label.
pub fn labelled(ui: &mut Ui, height: f32, text: &str) -> Rect {
    let rect = strip(ui, height);
    label(ui, rect, text);
    beside_label(rect)
}

/// Paints a label at the left of `rect`.
pub fn label(ui: &Ui, rect: Rect, text: &str) {
    ui.painter().text(
        rect.left_center(),
        Align2::LEFT_CENTER,
        text,
        theme::small(),
        theme::weak(),
    );
}

/// A text over as many lines as it needs.
pub fn paragraph(ui: &mut Ui, text: &str, ink: Color32) {
    let width = ui.available_width();
    let letters = Letters::of(ui.ctx(), text, &theme::small(), ink, width);
    let rect = strip(ui, letters.galley.size().y + 4.0);
    ui.painter().galley(rect.min, letters.galley.clone(), ink);
    letters.paint(ui, rect, rect.min, ink);
}

/// Paints a value with its unit at the right of `room`. Returns their rectangle.
pub fn value(ui: &Ui, room: Rect, text: &str, unit: &str, ink: Color32) -> Rect {
    let painter = ui.painter();
    let mut painted = Rect::from_min_max(room.right_center(), room.right_center());
    if !unit.is_empty() {
        painted = painter.text(
            room.right_center(),
            Align2::RIGHT_CENTER,
            unit,
            theme::small(),
            theme::weak(),
        );
    }
    if let Some(rect) = browser_text::paint(ui, room, Align2::RIGHT_CENTER, text, ink) {
        return rect;
    }
    let gap = if unit.is_empty() { 0.0 } else { 4.0 };
    let at = pos2(painted.left() - gap, room.center().y);
    painted.union(painter.text(at, Align2::RIGHT_CENTER, text, theme::body(), ink))
}
