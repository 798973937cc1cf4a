//! One line of measurements and, unfolded below it, the durations within a frame.

use egui::{Align2, Color32, CursorIcon, Id, Sense, Ui, pos2};

use crate::format::significant;
use crate::state::{Action, Fire};
use crate::view::layout::{paragraph, strip};
use crate::view::output::Output;
use crate::view::{history, icons};
use crate::{cost, theme};

/// Shows the line and, if `times`, the durations. `control` is the height of a control.
pub fn show(fire: &Fire, times: bool, out: &mut Output, ui: &mut Ui, control: f32) {
    line(fire, times, out, ui, control);
    if times {
        let plot = strip(ui, 34.0);
        history::show(ui, plot, &fire.history);
        ui.add_space(4.0);
        durations(fire, ui);
    }
}

fn line(fire: &Fire, times: bool, out: &mut Output, ui: &mut Ui, control: f32) {
    let rect = strip(ui, (control - 6.0).max(22.0));
    let name = "action:times";
    let response = ui
        .interact(rect, Id::new(name), Sense::click())
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text("Times of a frame");
    out.record(ui, name, rect);
    if response.clicked() {
        out.push(Action::ToggleTimes);
    }
    let painter = ui.painter();
    let words = |left: f32, text: String, ink: Color32| {
        let at = pos2(left, rect.center().y);
        painter.text(at, Align2::LEFT_CENTER, text, theme::small(), ink)
    };
    let fps = format!("{:.0} FPS", fire.stats.fps);
    let mut left = words(rect.left(), fps, theme::ACCENT).right() + 14.0;
    if let Some(speed) = cost::speed(fire) {
        left = words(left, speed, theme::ERROR).right() + 14.0;
    }
    let ink = if response.hovered() {
        theme::ACCENT
    } else {
        theme::weak()
    };
    let chevron = pos2(rect.right() - 6.0, rect.center().y);
    icons::chevron(painter, chevron, times, ink);
    let right = rect.right() - 18.0;
    let whole = cost::particles(fire);
    let short = whole.split(" (").next().unwrap_or_default().to_owned();
    // What does not fit is left out: the unfolded part has all of it.
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

/// The durations of stages and passes, and the reason for the quality.
fn durations(fire: &Fire, ui: &mut Ui) {
    let stats = &fire.stats;
    let of = |times: &[(String, f64)]| {
        let each: Vec<String> = times
            .iter()
            .map(|(name, ms)| format!("{name} {ms:.1}"))
            .collect();
        each.join(" · ")
    };
    let ms = |x: f64| format!("{} ms", significant(x, 2));
    let mut write = |text: String| paragraph(ui, &text, theme::weak());
    write(cost::particles(fire));
    write(format!(
        "{} per frame, {} per step",
        ms(stats.frame_ms()),
        ms(stats.step_ms)
    ));
    let passes = if stats.on_card {
        "Drawing, ms on the GPU"
    } else {
        "Drawing, ms on the CPU to submit it"
    };
    for (what, times) in [("Simulation, ms", &stats.stages), (passes, &stats.passes)] {
        if !times.is_empty() {
            write(format!("{what}: {}", of(times)));
        }
    }
    if !stats.reason.is_empty() {
        write(format!("Quality {}: {}", stats.quality, stats.reason));
    }
}
