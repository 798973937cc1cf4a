//! The plot of the frame rate in the last half minute.

use std::collections::VecDeque;

use egui::{Align2, Mesh, Rect, Shape, Stroke, Ui, pos2};

use crate::state::fire::HISTORY_LENGTH;
use crate::theme;

/// Paints the history in `rect`, the newest sample at the right.
pub fn show(ui: &Ui, rect: Rect, history: &VecDeque<f32>) {
    if !ui.is_rect_visible(rect) {
        return;
    }
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, egui::Color32::from_rgb(14, 11, 10));
    let max = history.iter().copied().fold(60.0_f32, f32::max) * 1.15;
    let y = |fps: f32| rect.bottom() - 2.0 - (rect.height() - 4.0) * (fps / max).clamp(0.0, 1.0);
    painter.hline(rect.x_range(), y(60.0), Stroke::new(1.0, theme::line()));
    painter.text(
        pos2(rect.left() + 5.0, y(60.0) + 1.0),
        Align2::LEFT_TOP,
        "60",
        egui::FontId::proportional(11.0),
        theme::weak(),
    );
    let step = rect.width() / (HISTORY_LENGTH - 1) as f32;
    let points: Vec<_> = history
        .iter()
        .rev()
        .enumerate()
        .map(|(age, &fps)| pos2(rect.right() - age as f32 * step, y(fps)))
        .collect();
    if points.len() < 2 {
        return;
    }
    let mut glow = Mesh::default();
    for (at, &point) in points.iter().enumerate() {
        glow.colored_vertex(point, theme::EMBER.gamma_multiply(0.8));
        glow.colored_vertex(
            pos2(point.x, rect.bottom()),
            theme::EMBER.gamma_multiply(0.1),
        );
        if at > 0 {
            let corner = 2 * at as u32;
            glow.add_triangle(corner - 2, corner - 1, corner);
            glow.add_triangle(corner - 1, corner, corner + 1);
        }
    }
    painter.add(Shape::mesh(glow));
    painter.line(points, Stroke::new(1.5, theme::ACCENT));
}
