//! The header: measurements, tools, scene, variants and search.

use egui::{Id, Rect, Ui, pos2, vec2};

use crate::state::{Action, ControllerState, State};
use crate::theme;
use crate::view::button::{self, Face};
use crate::view::icons::Icon;
use crate::view::layout::{labelled, paragraph, strip};
use crate::view::output::Output;
use crate::view::tools::{self, Tool};
use crate::view::{search_field, telemetry, variants};

/// Width of the button that resets all.
const RESET_WIDTH: f32 = 100.0;

/// The part that never scrolls: one line where the panel is low, or where the page
/// selects the parameters.
pub fn fixed(state: &State, out: &mut Output, ui: &mut Ui, low: bool) {
    let gap = 6.0;
    let control = state.device.measures.control;
    if state.only.is_some() {
        let line = strip(ui, control);
        let (tools, reset) = line.split_left_right_at_x(line.right() - RESET_WIDTH);
        let tools = tools.with_max_x(tools.right() - gap);
        let few = [Tool::Pause, Tool::Restart, Tool::Undo, Tool::Redo];
        tools::line(state, out, ui, tools, &few);
        reset_all(state, out, ui, reset);
    } else if low {
        let line = strip(ui, control);
        let at = |x: f32| Rect::from_min_size(pos2(x, line.top()), vec2(control, control));
        tools::line(state, out, ui, at(line.left()), &[Tool::Pause]);
        let right = line.right() - 2.0 * control - gap;
        let scene =
            Rect::from_x_y_ranges(line.left() + control + gap..=right - gap, line.y_range());
        scene_button(&state.controller, out, ui, scene);
        tools::line(state, out, ui, at(right), &[Tool::Undo]);
        tools::line(state, out, ui, at(line.right() - control), &[Tool::More]);
    } else {
        measurements(state, out, ui);
        ui.add_space(gap);
        tools::show(state, out, ui, false);
        ui.add_space(gap);
        let scene = labelled(ui, control, "Scene");
        scene_button(&state.controller, out, ui, scene);
        ui.add_space(gap);
        let variants = labelled(ui, control, "Variants");
        variants::line(&state.controller, out, ui, variants);
        ui.add_space(gap);
        search(state, out, ui);
    }
    if let Some(notice) = &state.fire.notice {
        ui.add_space(gap);
        paragraph(ui, notice, theme::ERROR);
    }
}

/// The lines below the first one where the panel is low: they unfold, and scroll with the rows.
pub fn movable(state: &State, out: &mut Output, ui: &mut Ui) {
    if state.only.is_some() {
        return;
    }
    if state.open.tools {
        ui.add_space(4.0);
        tools::show(state, out, ui, true);
        ui.add_space(8.0);
        let rect = labelled(ui, state.device.measures.control, "Variants");
        variants::line(&state.controller, out, ui, rect);
        ui.add_space(8.0);
        search(state, out, ui);
        ui.add_space(6.0);
        measurements(state, out, ui);
    } else {
        tools::error(&state.controller, ui);
    }
}

fn measurements(state: &State, out: &mut Output, ui: &mut Ui) {
    let control = state.device.measures.control;
    telemetry::show(&state.fire, state.memory.times, out, ui, control);
}

/// The button of the scene that the fire started from, which shows all scenes.
fn scene_button(controller: &ControllerState, out: &mut Output, ui: &Ui, rect: Rect) {
    let name = "action:scenes";
    let scene = match &*controller.scene {
        "" => "All scenes",
        scene => scene,
    };
    let response = button::unfolder(ui, rect, Id::new(name), scene, false);
    out.record(ui, name, rect);
    if response.on_hover_text("Choose another scene").clicked() {
        out.push(Action::Scenes);
    }
}

fn search(state: &State, out: &mut Output, ui: &mut Ui) {
    let rect = strip(ui, state.device.measures.control);
    let (field, reset) = rect.split_left_right_at_x(rect.right() - RESET_WIDTH);
    let field = field.with_max_x(field.right() - 6.0);
    search_field::show(&state.search, out, ui, field);
    reset_all(state, out, ui, reset);
}

fn reset_all(state: &State, out: &mut Output, ui: &Ui, rect: Rect) {
    let face = Face {
        enabled: match &state.only {
            Some(few) => few.iter().any(|&param| state.fire.differs(param)),
            None => state.fire.is_changed(),
        },
        ..Face::new(Icon::Reset, "Reset all")
    };
    let name = "action:reset-all";
    let response =
        button::show(ui, rect, Id::new(name), face).on_hover_text("Reset all to the scene");
    out.record(ui, name, rect);
    if response.clicked() {
        out.push(Action::RestoreAll);
    }
}
