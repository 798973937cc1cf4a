//! The control of a choice: a button for each name, side by side where they are
//! few, and otherwise behind a button with the present name.
//!
//! The list unfolds in the row instead of in a window above it, as a colour's
//! sliders do: the sheet on a phone is too low for one. It stays unfolded, so that
//! one name after the other can be tried.

use egui::style::ScrollAnimation;
use egui::{EventFilter, Id, Key, PointerButton, Rect, Ui};
use hearth_core::params::{Input, Param, Value};

use crate::button::{self, Face};
use crate::panel::{Panel, strip};
use crate::row;

/// Most names that stand side by side with nothing folded.
const FEW: usize = 4;

/// How many stand side by side in a list.
const IN_A_LINE: usize = 3;

/// Largest height of a line of the list: the longest one has to fit into a sheet.
const LINE: f32 = 36.0;

/// Width of the button that unfolds a list.
const BUTTON: f32 = 150.0;

/// Shows the row of a choice.
pub fn show(panel: &mut Panel, ui: &mut Ui, param: &'static Param, names: &'static [&'static str]) {
    if names.len() <= FEW {
        row::line(panel, ui, param, panel.measures.line);
        let rect = strip(ui, panel.measures.control);
        buttons(panel, ui, param, names, rect, names.len());
        panel.place(ui, param.id, rect);
        ui.add_space(4.0);
        return;
    }
    let room = row::line(panel, ui, param, panel.measures.control);
    let rect = room.with_min_x(room.left().max(room.right() - BUTTON));
    let before = panel.listed;
    unfolder(panel, ui, param, names, rect);
    panel.place(ui, param.id, rect);
    if panel.listed != Some(param.id) {
        return;
    }
    for names in names.chunks(IN_A_LINE) {
        ui.add_space(4.0);
        let rect = strip(ui, panel.measures.control.min(LINE));
        buttons(panel, ui, param, names, rect, IN_A_LINE);
    }
    if before != panel.listed {
        let whole = rect.with_max_y(ui.cursor().top() + 6.0);
        ui.scroll_to_rect_animation(whole, None, ScrollAnimation::none());
    }
}

/// The button that folds the list and shows the present name; the arrow keys go
/// through the names while it has the focus.
fn unfolder(
    panel: &mut Panel,
    ui: &Ui,
    param: &'static Param,
    names: &'static [&'static str],
    rect: Rect,
) {
    let Value::Choice(now) = param.get(&panel.fire.parameters) else {
        return;
    };
    let open = panel.listed == Some(param.id);
    let response = button::unfolder(ui, rect, Id::unique(("list", param.id)), now, open);
    // Not by a key, which egui takes for a click too: Space pauses the fire.
    if response.clicked_by(PointerButton::Primary) {
        response.request_focus();
        panel.listed = (!open).then_some(param.id);
    }
    if !response.has_focus() {
        return;
    }
    let filter = EventFilter {
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let (down, up) = ui.input(|input| {
        let presses = |key| input.num_presses(key);
        (presses(Key::ArrowDown), presses(Key::ArrowUp))
    });
    let at = names.iter().position(|&name| name == now).unwrap_or(0);
    let next = (at + down).saturating_sub(up).min(names.len() - 1);
    if next != at {
        choose(panel, param, names[next]);
    }
}

/// These names side by side in `rect`, each as wide as if there were `parts`.
pub fn buttons(
    panel: &mut Panel,
    ui: &Ui,
    param: &'static Param,
    names: &'static [&'static str],
    rect: Rect,
    parts: usize,
) {
    let now = param.get(&panel.fire.parameters);
    for (rect, &name) in button::split(rect, parts, 4.0).zip(names) {
        let face = Face {
            lit: now == Value::Choice(name),
            ..Face::text(name)
        };
        let key = format!("choice:{}:{name}", param.id);
        let clicked = button::show(ui, rect, Id::unique(&key), face).clicked();
        panel.place(ui, key, rect);
        if clicked {
            choose(panel, param, name);
        }
    }
}

fn choose(panel: &mut Panel, param: &'static Param, name: &'static str) {
    if let Ok(now) = panel.fire.wish(param, Input::Text(name)) {
        panel.chosen = Some(param.id);
        panel.ask_for(param, now);
    }
}
