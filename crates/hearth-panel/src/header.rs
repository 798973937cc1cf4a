//! The header: how the fire does, the tools, scenes, model, search.

use egui::{Align2, Id, Key, Rect, TextEdit, Ui, UiBuilder, pos2, vec2};
use hearth_core::params::{Kind, Param};

use crate::button::{self, Face};
use crate::fire::{Command, MODEL, QUALITIES};
use crate::icons::Icon;
use crate::panel::{Panel, QUALITY, in_sight, strip};
use crate::tools::{self, Tool};
use crate::{choices, row, telemetry, theme};

/// Width of the words before the models and the scenes.
pub const LABEL: f32 = 56.0;

/// Width of the button that resets all.
const RESET: f32 = 100.0;

/// The part that never scrolls: one line where there is little height, or where only
/// some parameters are shown.
pub fn fixed(panel: &mut Panel, ui: &mut Ui, low: bool) {
    let gap = 6.0;
    if panel.only.is_some() {
        let line = strip(ui, panel.measures.control);
        let (tools, reset) = line.split_left_right_at_x(line.right() - RESET);
        let tools = tools.with_max_x(tools.right() - gap);
        tools::line(
            panel,
            ui,
            tools,
            &[Tool::Pause, Tool::Restart, Tool::Undo, Tool::Redo],
        );
        reset_all(panel, ui, reset);
    } else if low {
        let line = strip(ui, panel.measures.control);
        let side = panel.measures.control;
        let at = |x: f32| Rect::from_min_size(pos2(x, line.top()), vec2(side, side));
        tools::line(panel, ui, at(line.left()), &[Tool::Pause]);
        let right = line.right() - 2.0 * side - gap;
        let scene = Rect::from_x_y_ranges(line.left() + side + gap..=right - gap, line.y_range());
        scene_button(panel, ui, scene);
        tools::line(panel, ui, at(right), &[Tool::Undo]);
        tools::line(panel, ui, at(line.right() - side), &[Tool::More]);
    } else {
        telemetry::show(panel, ui);
        ui.add_space(gap);
        tools::show(panel, ui, false);
        ui.add_space(gap);
        scenes(panel, ui);
        ui.add_space(gap);
        model(panel, ui, false);
        ui.add_space(gap);
        search(panel, ui);
    }
    if let Some(notice) = panel.fire.notice.clone() {
        ui.add_space(gap);
        row::paragraph(ui, &notice, theme::ERROR);
    }
}

/// What there is besides where there is little height: it is unfolded, and scrolls with
/// the rows.
pub fn movable(panel: &mut Panel, ui: &mut Ui) {
    if panel.only.is_some() {
        return;
    }
    if panel.more {
        ui.add_space(4.0);
        tools::show(panel, ui, true);
        ui.add_space(8.0);
        model(panel, ui, true);
        ui.add_space(8.0);
        search(panel, ui);
        ui.add_space(6.0);
        telemetry::show(panel, ui);
    } else {
        tools::complaint(panel, ui);
    }
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

/// How much work the fire may make itself: a row of the simplest controls.
pub fn quality(panel: &mut Panel, ui: &mut Ui) {
    let top = ui.cursor().top();
    let mut rect = strip(ui, panel.measures.control);
    ui.painter().text(
        rect.left_center(),
        Align2::LEFT_CENTER,
        "Quality",
        theme::small(),
        theme::weak(),
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
    ui.add_space(panel.measures.gap);
    if panel.revealing && panel.wanted == QUALITY {
        let rows = ui.max_rect().x_range();
        in_sight(ui, Rect::from_x_y_ranges(rows, top..=ui.cursor().top()));
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
        theme::weak(),
    );
    rect.min.x += LABEL;
    scene_button(panel, ui, rect);
}

fn scene_button(panel: &mut Panel, ui: &Ui, rect: Rect) {
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
    let (field, reset) = rect.split_left_right_at_x(rect.right() - RESET);
    let field = field.with_max_x(field.right() - 6.0);

    let id = Id::unique("search");
    let mut edit = TextEdit::singleline(&mut panel.search)
        .id(id)
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
    let response = ui
        .scope_builder(UiBuilder::new().max_rect(field), |ui| ui.add(edit))
        .inner;
    if std::mem::take(&mut panel.seeking) {
        response.request_focus();
    }
    let escape = ui.input(|input| input.key_pressed(Key::Escape));
    if response.lost_focus() && escape && !panel.search.is_empty() {
        panel.search.clear();
        response.request_focus();
    }
    let glass = pos2(field.left() + 15.0, field.center().y);
    Icon::Search.paint(ui.painter(), glass, 14.0, theme::weak());
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

    reset_all(panel, ui, reset);
}

fn reset_all(panel: &mut Panel, ui: &Ui, rect: Rect) {
    let face = Face {
        enabled: match &panel.only {
            Some(few) => few.iter().any(|param| panel.fire.differs(param)),
            None => panel.fire.is_changed(),
        },
        ..Face::new(Icon::Reset, "Reset all")
    };
    let name = "action:reset-all";
    let response = button::show(ui, rect, Id::unique(name), face)
        .on_hover_text("Every parameter of this model as the scene has it");
    panel.place(ui, name, rect);
    if response.clicked() {
        panel.fire.refusals.clear();
        panel.typing = None;
        panel.ask(Command::RestoreAll);
    }
}
