//! How the fire does: one line, and under it, where somebody unfolds it, what takes
//! how long.

use egui::{Align2, Color32, CursorIcon, Id, Sense, Ui, pos2};

use crate::fire::Command;
use crate::format::significant;
use crate::panel::{Panel, strip};
use crate::{cost, history, icons, row, theme};

/// Shows the line, and what is unfolded.
pub fn show(panel: &mut Panel, ui: &mut Ui) {
    line(panel, ui);
    if panel.memory.times {
        let plot = strip(ui, 34.0);
        history::show(ui, plot, &panel.fire.history);
        ui.add_space(4.0);
        times(panel, ui);
    }
}

fn line(panel: &mut Panel, ui: &mut Ui) {
    let rect = strip(ui, (panel.measures.control - 6.0).max(22.0));
    let name = "action:times";
    let response = ui
        .interact(rect, Id::unique(name), Sense::click())
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text("What takes how long");
    panel.place(ui, name, rect);
    if response.clicked() {
        panel.memory.times ^= true;
        panel.ask(Command::Remember(panel.memory.clone()));
    }
    let painter = ui.painter();
    let words = |left: f32, text: String, ink: Color32| {
        let at = pos2(left, rect.center().y);
        painter.text(at, Align2::LEFT_CENTER, text, theme::small(), ink)
    };
    let fps = format!("{:.0} FPS", panel.fire.stats.fps);
    let mut left = words(rect.left(), fps, theme::ACCENT).right() + 14.0;
    if let Some(speed) = cost::speed(&panel.fire) {
        left = words(left, speed, theme::ERROR).right() + 14.0;
    }
    let ink = if response.hovered() {
        theme::ACCENT
    } else {
        theme::weak()
    };
    let chevron = pos2(rect.right() - 6.0, rect.center().y);
    icons::chevron(painter, chevron, panel.memory.times, ink);
    let right = rect.right() - 18.0;
    let whole = cost::particles(&panel.fire);
    let short = whole.split(" (").next().unwrap_or_default().to_owned();
    // What does not fit is left out; all of it is told below.
    for text in [whole, short] {
        let galley = painter.layout_no_wrap(text, theme::small(), theme::TEXT);
        if right - galley.size().x >= left {
            let at = pos2(
                right - galley.size().x,
                rect.center().y - galley.size().y / 2.0,
            );
            painter.galley(at, galley, theme::TEXT);
            break;
        }
    }
}

/// What each part of a frame takes, and why it is of this quality.
fn times(panel: &Panel, ui: &mut Ui) {
    let stats = &panel.fire.stats;
    let of = |times: &[(String, f64)]| {
        let each: Vec<String> = times
            .iter()
            .map(|(name, ms)| format!("{name} {ms:.1}"))
            .collect();
        each.join(" · ")
    };
    let ms = |x: f64| format!("{} ms", significant(x, 2));
    let mut tell = |text: String| row::paragraph(ui, &text, theme::weak());
    tell(cost::particles(&panel.fire));
    tell(format!(
        "A frame takes {}, a step {}",
        ms(stats.frame_ms()),
        ms(stats.step_ms)
    ));
    let passes = if stats.on_card {
        "Picture, ms on the graphics card"
    } else {
        "Picture, ms to hand it over"
    };
    for (what, times) in [("Frame, ms", &stats.stages), (passes, &stats.passes)] {
        if !times.is_empty() {
            tell(format!("{what}: {}", of(times)));
        }
    }
    if !stats.reason.is_empty() {
        tell(format!("Quality {}: {}", stats.quality, stats.reason));
    }
}
