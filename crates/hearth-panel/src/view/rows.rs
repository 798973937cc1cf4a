//! The rows of the parameters and the objects: by group, by search, or the parameters that the
//! page selects.

use egui::style::ScrollAnimation;
use egui::{CursorIcon, Id, Sense, Ui, pos2, vec2};
use hearth_core::params::Param;

use crate::search;
use crate::state::{Action, BASICS, MODEL, OBJECTS, PHYSICS, QUALITY, State};
use crate::theme;
use crate::view::layout::{paragraph, strip};
use crate::view::output::Output;
use crate::view::{icons, objects, quality, row};

/// Shows the rows.
pub fn show(state: &State, out: &mut Output, ui: &mut Ui) {
    if let Some(only) = &state.only {
        selected(state, out, ui, only);
    } else if state.search.text.trim().is_empty() {
        groups(state, out, ui);
    } else {
        results(state, out, ui);
    }
}

/// All parameters of the model, by group. The objects follow the simplest ones.
fn groups(state: &State, out: &mut Output, ui: &mut Ui) {
    let anchor = state.anchor();
    let used: Vec<&'static Param> = state.fire.used().collect();
    let mut objects_shown = false;
    for group in used.chunk_by(|a, b| a.group() == b.group()) {
        let name = group[0].group();
        if !objects_shown && name != BASICS {
            object_group(state, out, ui);
            objects_shown = true;
        }
        let open = !state.memory.folded.contains(name);
        if heading(out, ui, name, open, state.device.measures.control) {
            out.push(Action::ToggleGroup(name));
        }
        if !open {
            continue;
        }
        if name == PHYSICS {
            model(state, out, ui);
        }
        for param in group {
            let top = ui.cursor().top();
            match anchor {
                Some((id, before)) if id == param.id => {
                    let delta = vec2(0.0, before - top);
                    ui.scroll_with_delta_animation(delta, ScrollAnimation::none());
                }
                _ => {}
            }
            if top >= ui.clip_rect().top() {
                out.tops.push((param.id, top));
            }
            row::show(state, out, ui, *param);
        }
        if name == BASICS {
            quality::show(state, out, ui);
        }
        ui.add_space(4.0);
    }
}

/// The row of the model.
fn model(state: &State, out: &mut Output, ui: &mut Ui) {
    if let Some(param) = Param::find(MODEL) {
        row::show(state, out, ui, param);
    }
}

/// The group of the objects.
fn object_group(state: &State, out: &mut Output, ui: &mut Ui) {
    let open = !state.memory.folded.contains(OBJECTS);
    if heading(out, ui, OBJECTS, open, state.device.measures.control) {
        out.push(Action::ToggleGroup(OBJECTS));
    }
    if open {
        objects::show(state, out, ui);
        ui.add_space(4.0);
    }
}

/// The parameters that match the search, the best match first, and the objects that match.
fn results(state: &State, out: &mut Output, ui: &mut Ui) {
    let query = &*state.search.text;
    let rank = |param| Some((search::rank(query, param)?, param));
    let all = state.fire.used().chain(Param::find(MODEL));
    let mut found: Vec<(u32, &'static Param)> = all.filter_map(rank).collect();
    found.sort_by_key(|(rank, _)| *rank);
    ui.add_space(6.0);
    let starts = |name: &str| {
        let query = query.trim().to_lowercase();
        name.to_lowercase().starts_with(&query)
    };
    let mut nothing = found.is_empty();
    if starts(QUALITY) {
        quality::show(state, out, ui);
        nothing = false;
    }
    for (_, param) in found {
        row::show(state, out, ui, param);
    }
    if starts(OBJECTS) {
        objects::show(state, out, ui);
    } else if !objects::results(state, out, ui) && nothing {
        paragraph(
            ui,
            "No parameter matches. Try another word, or clear the search.",
            theme::weak(),
        );
    }
}

/// The parameters that the page selects, as far as the model has them.
fn selected(state: &State, out: &mut Output, ui: &mut Ui, only: &[&'static Param]) {
    let model = state.fire.parameters().model();
    ui.add_space(6.0);
    for param in only {
        if param.domain(model).is_some() {
            row::show(state, out, ui, *param);
        }
    }
}

/// The heading of a group. Returns whether it was clicked.
fn heading(out: &mut Output, ui: &mut Ui, name: &'static str, open: bool, control: f32) -> bool {
    let rect = strip(ui, control + 4.0);
    let response = ui
        .interact(rect, Id::new(("group", name)), Sense::click())
        .on_hover_cursor(CursorIcon::PointingHand);
    out.record(ui, format!("group:{name}"), rect);
    let ink = if response.hovered() {
        theme::TEXT
    } else {
        theme::ACCENT
    };
    let painter = ui.painter();
    icons::chevron(painter, pos2(rect.left() + 5.0, rect.center().y), open, ink);
    let galley = painter.layout_no_wrap(name.to_owned(), theme::body(), ink);
    let x = rect.left() + 18.0;
    let line = (x + galley.size().x + 10.0)..=rect.right();
    painter.galley(
        pos2(x, rect.center().y - galley.size().y / 2.0),
        galley,
        ink,
    );
    painter.hline(line, rect.center().y, (1.0, theme::line()));
    response.clicked()
}
