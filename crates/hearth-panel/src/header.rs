//! The header: how the fire does, play and pause, model, scenes, search.

use egui::{Align2, Color32, CursorIcon, Id, Rect, Sense, TextEdit, Ui, UiBuilder, pos2, vec2};
use hearth_core::params::{Kind, Param};

use crate::button::{self, Face};
use crate::fire::{Command, MODEL, QUALITIES};
use crate::format::{count_text, significant};
use crate::history;
use crate::icons::{self, Icon};
use crate::panel::{Panel, strip};
use crate::{choices, row, theme, tools};

/// Width of the words before the models and the scenes.
pub const LABEL: f32 = 56.0;

/// The part that never scrolls: one line where there is little height.
pub fn fixed(panel: &mut Panel, ui: &mut Ui, low: bool) {
    if low {
        let line = strip(ui, panel.measures.control);
        let width = 3.0 * panel.measures.control + 12.0;
        let buttons = Rect::from_min_max(pos2(line.right() - width, line.top()), line.max);
        brief(panel, ui, line.with_max_x(buttons.left()));
        transport(panel, ui, buttons, true);
    } else {
        numbers(panel, ui);
        ui.add_space(4.0);
        if panel.unfolded {
            times_of_all(panel, ui);
        }
        let plot = strip(ui, 34.0);
        history::show(ui, plot, &panel.fire.history);
        ui.add_space(8.0);
        let buttons = strip(ui, panel.measures.control);
        transport(panel, ui, buttons, false);
        ui.add_space(6.0);
        tools::show(panel, ui, false);
        ui.add_space(8.0);
        movable_rows(panel, ui, false);
    }
    if let Some(notice) = panel.fire.notice.clone() {
        ui.add_space(6.0);
        row::paragraph(ui, &notice, theme::ERROR);
    }
}

/// The part that scrolls with the rows where there is little height.
pub fn movable(panel: &mut Panel, ui: &mut Ui) {
    ui.add_space(4.0);
    tools::show(panel, ui, true);
    ui.add_space(8.0);
    movable_rows(panel, ui, true);
    ui.add_space(6.0);
    let plot = strip(ui, 30.0);
    history::show(ui, plot, &panel.fire.history);
    times_of_all(panel, ui);
}

fn movable_rows(panel: &mut Panel, ui: &mut Ui, scrolls: bool) {
    model(panel, ui, scrolls);
    ui.add_space(8.0);
    scenes(panel, ui);
    ui.add_space(8.0);
    quality(panel, ui);
    ui.add_space(8.0);
    search(panel, ui);
}

/// The model, before all else: it decides which parameters there are.
fn model(panel: &mut Panel, ui: &mut Ui, scrolls: bool) {
    let Some(param) = Param::find(MODEL) else {
        return;
    };
    let Kind::Choice(names) = param.kind else {
        return;
    };
    row::framed(panel, ui, param, scrolls, |panel, ui| {
        let mut rect = strip(ui, panel.measures.control);
        row::name(panel, ui, param, rect);
        rect.min.x += LABEL;
        choices::buttons(panel, ui, param, names, rect, names.len());
        panel.place(ui, param.id, rect);
    });
}

/// Frame rate in large figures, particles and milliseconds beside it.
fn numbers(panel: &mut Panel, ui: &mut Ui) {
    let rect = strip(ui, 36.0);
    let name = "action:times";
    let response = ui
        .interact(rect, Id::unique(name), Sense::click())
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text("What takes how long");
    panel.place(ui, name, rect);
    panel.unfolded ^= response.clicked();
    let stats = &panel.fire.stats;
    let painter = ui.painter();
    let fps = painter.text(
        rect.left_center(),
        Align2::LEFT_CENTER,
        format!("{:.0}", stats.fps),
        theme::large(),
        theme::ACCENT,
    );
    painter.text(
        pos2(fps.right() + 6.0, fps.bottom() - 6.0),
        Align2::LEFT_BOTTOM,
        "FPS",
        theme::small(),
        theme::WEAK,
    );
    let ink = if response.hovered() {
        theme::ACCENT
    } else {
        theme::WEAK
    };
    let chevron = pos2(fps.right() + 42.0, fps.bottom() - 14.0);
    icons::chevron(painter, chevron, panel.unfolded, ink);
    let right = |y: f32, text: String, ink| {
        let at = pos2(rect.right(), y);
        painter.text(at, Align2::RIGHT_CENTER, text, theme::small(), ink);
    };
    right(
        rect.top() + 9.0,
        format!("{} particles", count_text(stats.particles)),
        theme::TEXT,
    );
    let (times, ink) = times(panel, false);
    right(rect.top() + 27.0, times, ink);
}

/// The same in one short line.
fn brief(panel: &Panel, ui: &Ui, line: Rect) {
    let stats = &panel.fire.stats;
    let painter = ui.painter();
    let fps = painter.text(
        line.left_center(),
        Align2::LEFT_CENTER,
        format!("{:.0}", stats.fps),
        theme::large(),
        theme::ACCENT,
    );
    let left = fps.right() + 5.0;
    let unit = painter.text(
        pos2(left, fps.bottom() - 6.0),
        Align2::LEFT_BOTTOM,
        "FPS",
        theme::small(),
        theme::WEAK,
    );
    let (times, ink) = times(panel, true);
    let lines = [
        (
            format!("{} particles", count_text(stats.particles)),
            theme::TEXT,
        ),
        (times, ink),
    ];
    let x = unit.right() + 14.0;
    for ((text, ink), y) in lines.into_iter().zip([-8.0, 8.0]) {
        let galley = painter.layout_no_wrap(text, theme::small(), ink);
        // What does not fit would run under the buttons.
        if x + galley.size().x <= line.right() {
            let at = pos2(x, line.center().y + y - galley.size().y / 2.0);
            painter.galley(at, galley, ink);
        }
    }
}

/// What a frame and a step cost, or that they cost too much.
fn times(panel: &Panel, low: bool) -> (String, Color32) {
    let stats = &panel.fire.stats;
    if stats.slowed {
        return ("slower than real time".to_owned(), theme::ERROR);
    }
    let ms = |x: f64| format!("{} ms", significant(x, 2));
    let frame = format!("frame {}", ms(stats.frame_ms()));
    if low {
        (frame, theme::WEAK)
    } else {
        (format!("{frame} · step {}", ms(stats.step_ms)), theme::WEAK)
    }
}

/// What each part of a frame takes, and why it is of this quality.
fn times_of_all(panel: &Panel, ui: &mut Ui) {
    let stats = &panel.fire.stats;
    let of = |times: &[(String, f64)]| {
        let each: Vec<String> = times
            .iter()
            .map(|(name, ms)| format!("{name} {ms:.1}"))
            .collect();
        each.join(" · ")
    };
    let passes = if stats.on_card {
        "Picture, ms on the graphics card"
    } else {
        "Picture, ms to hand it over"
    };
    for (what, times) in [("Frame, ms", &stats.stages), (passes, &stats.passes)] {
        if !times.is_empty() {
            row::paragraph(ui, &format!("{what}: {}", of(times)), theme::WEAK);
        }
    }
    if !stats.reason.is_empty() {
        let words = format!("Quality {}: {}", stats.quality, stats.reason);
        row::paragraph(ui, &words, theme::WEAK);
    }
    ui.add_space(4.0);
}

/// How much work the fire may make itself.
fn quality(panel: &mut Panel, ui: &mut Ui) {
    let mut rect = strip(ui, panel.measures.control);
    ui.painter().text(
        rect.left_center(),
        Align2::LEFT_CENTER,
        "Quality",
        theme::small(),
        theme::WEAK,
    );
    rect.min.x += LABEL;
    panel.place(ui, "quality", rect);
    let labels = ["Auto", "Low", "Medium", "High"];
    let parts = button::split_by_words(ui, rect, &labels, 6.0);
    for (rect, (name, label)) in parts.into_iter().zip(QUALITIES.into_iter().zip(labels)) {
        let face = Face {
            lit: panel.fire.quality == name,
            ..Face::text(label)
        };
        let place = format!("quality:{name}");
        let mut response = button::show(ui, rect, Id::unique(&place), face);
        if panel.fire.stats.quality == name {
            // What the fire has at present, whoever chose it.
            let line = rect.bottom() - 4.0;
            let middle = rect.center().x;
            ui.painter()
                .hline(middle - 8.0..=middle + 8.0, line, (1.5, theme::ACCENT));
            response = response.on_hover_text(&panel.fire.stats.reason);
        }
        panel.place(ui, place, rect);
        if response.clicked() {
            panel.fire.quality = name.to_owned();
            panel.ask(Command::Quality(name));
        }
    }
}

fn transport(panel: &mut Panel, ui: &Ui, rect: Rect, bare: bool) {
    let paused = panel.fire.paused;
    let word = |text: &'static str| if bare { "" } else { text };
    let pause = if paused {
        Face {
            lit: true,
            ..Face::new(Icon::Play, word("Play"))
        }
    } else {
        Face::new(Icon::Pause, word("Pause"))
    };
    let faces = [
        ("action:pause", pause, "Let time pass, or hold it"),
        (
            "action:step",
            Face::new(Icon::Step, word("Step")),
            "One step of the simulation",
        ),
        (
            "action:reset",
            Face::new(Icon::Restart, word("Restart")),
            "Start the fire again with these values",
        ),
    ];
    for (rect, (name, face, hint)) in button::split(rect, faces.len(), 6.0).zip(faces) {
        let response = button::show(ui, rect, Id::unique(name), face).on_hover_text(hint);
        panel.place(ui, name, rect);
        if !response.clicked() {
            continue;
        }
        match name {
            "action:pause" if paused => panel.ask(Command::Play),
            "action:pause" => panel.ask(Command::Pause),
            "action:step" => {
                if !paused {
                    panel.ask(Command::Pause);
                }
                panel.ask(Command::Step);
            }
            _ => panel.ask(Command::Reset),
        }
    }
}

/// What the fire started from, and the way to all other scenes.
fn scenes(panel: &mut Panel, ui: &mut Ui) {
    let mut rect = strip(ui, panel.measures.control);
    ui.painter().text(
        rect.left_center(),
        Align2::LEFT_CENTER,
        "Scene",
        theme::small(),
        theme::WEAK,
    );
    rect.min.x += LABEL;
    let name = "action:scenes";
    let scene = match &*panel.desk.scene {
        "" => "All scenes",
        scene => scene,
    };
    let response = button::unfolder(ui, rect, Id::unique(name), scene, false);
    panel.place(ui, name, rect);
    if response
        .on_hover_text("Other fires to start from")
        .clicked()
    {
        panel.fire.refusals.clear();
        panel.ask(Command::Scenes);
    }
}

fn search(panel: &mut Panel, ui: &mut Ui) {
    let rect = strip(ui, panel.measures.control);
    let (field, reset) = rect.split_left_right_at_x(rect.right() - 100.0);
    let field = field.with_max_x(field.right() - 6.0);

    let mut edit = TextEdit::singleline(&mut panel.search)
        .id(Id::unique("search"))
        .hint_text("Search")
        .desired_width(field.width())
        .min_size(field.size())
        .align(Align2::LEFT_CENTER)
        .char_limit(60);
    edit = edit.margin(egui::Margin {
        left: 28,
        right: 26,
        top: 2,
        bottom: 2,
    });
    ui.scope_builder(UiBuilder::new().max_rect(field), |ui| ui.add(edit));
    let glass = pos2(field.left() + 15.0, field.center().y);
    Icon::Search.paint(ui.painter(), glass, 14.0, theme::WEAK);
    panel.place(ui, "search", field);
    if !panel.search.is_empty() {
        let cross = Rect::from_center_size(
            pos2(field.right() - 14.0, field.center().y),
            vec2(26.0, field.height()),
        );
        if button::show(
            ui,
            cross,
            Id::unique("search-clear"),
            Face::bare(Icon::Cross),
        )
        .clicked()
        {
            panel.search.clear();
        }
    }

    let face = Face {
        enabled: panel.fire.is_changed(),
        ..Face::new(Icon::Reset, "Reset all")
    };
    let name = "action:reset-all";
    let response = button::show(ui, reset, Id::unique(name), face)
        .on_hover_text("Every parameter of this model back to its default");
    panel.place(ui, name, reset);
    if response.clicked() {
        panel.fire.refusals.clear();
        let ids = panel.fire.used().map(|param| param.id).collect();
        panel.ask(Command::Restore(ids));
    }
}
