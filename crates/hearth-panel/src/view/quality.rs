//! The row of the quality, which limits the work of a frame.

use egui::{Id, Rect, Ui};

use crate::state::fire::QUALITIES;
use crate::state::{Action, State};
use crate::theme;
use crate::view::button::{self, Face};
use crate::view::layout::{labelled, scroll_into_view};
use crate::view::output::Output;

/// Shows the row.
pub fn show(state: &State, out: &mut Output, ui: &mut Ui) {
    let fire = &state.fire;
    let top = ui.cursor().top();
    let rect = labelled(ui, state.device.measures.control, "Quality");
    out.record(ui, "quality", rect);
    let labels = ["Auto", "Low", "Medium", "High"];
    let parts = button::split_by_words(ui, rect, &labels, 6.0);
    for (rect, (name, label)) in parts.into_iter().zip(QUALITIES.into_iter().zip(labels)) {
        let face = Face {
            lit: fire.quality == name,
            ..Face::text(label)
        };
        let key = format!("quality:{name}");
        let mut response = button::show(ui, rect, Id::new(&key), face);
        if fire.stats.quality == name {
            // The present quality, whether it was set or chosen automatically.
            let line = rect.bottom() - 4.0;
            let middle = rect.center().x;
            ui.painter()
                .hline(middle - 8.0..=middle + 8.0, line, (1.5, theme::ACCENT));
            response = response.on_hover_text(&fire.stats.reason);
        }
        out.record(ui, key, rect);
        if response.clicked() {
            out.push(Action::Quality(name));
        }
    }
    ui.add_space(state.device.measures.gap);
    if state.reveal.quality {
        let rows = ui.max_rect().x_range();
        scroll_into_view(ui, Rect::from_x_y_ranges(rows, top..=ui.cursor().top()));
    }
}
