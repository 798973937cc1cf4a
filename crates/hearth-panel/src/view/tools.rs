//! The line of tools, and below it copy and paste.

use egui::{Id, Rect, Ui};

use crate::state::{Action, Command, ControllerState, CopyForm, State};
use crate::theme::{self, Measures};
use crate::view::button::{self, Face};
use crate::view::icons::{self, Icon};
use crate::view::layout::{labelled, paragraph, scroll_into_view, strip};
use crate::view::output::Output;

/// A button of the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// Pause or resume.
    Pause,
    /// One step.
    Step,
    /// Restart the fire.
    Restart,
    /// Undo.
    Undo,
    /// Redo.
    Redo,
    /// Save an image or a film.
    Picture,
    /// Toggle full screen.
    Fullscreen,
    /// Unfold copy and paste.
    Share,
    /// Show the keyboard shortcuts.
    Help,
    /// Unfold all others, where the panel is low.
    More,
}

impl Tool {
    /// The line of a high panel.
    const LINE: [Tool; 9] = [
        Tool::Pause,
        Tool::Step,
        Tool::Restart,
        Tool::Undo,
        Tool::Redo,
        Tool::Picture,
        Tool::Fullscreen,
        Tool::Share,
        Tool::Help,
    ];

    /// The unfolded line of a low panel.
    const FOLDED: [Tool; 7] = [
        Tool::Step,
        Tool::Restart,
        Tool::Redo,
        Tool::Picture,
        Tool::Fullscreen,
        Tool::Share,
        Tool::Help,
    ];

    fn is_available(self, state: &State) -> bool {
        match self {
            Tool::Fullscreen => state.controller.fullscreen,
            // A device without a mouse rarely has a keyboard.
            Tool::Help => state.device.measures != Measures::COARSE,
            _ => true,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Tool::Pause => "action:pause",
            Tool::Step => "action:step",
            Tool::Restart => "action:reset",
            Tool::Undo => "action:undo",
            Tool::Redo => "action:redo",
            Tool::Picture => "action:picture",
            Tool::Fullscreen => "action:fullscreen",
            Tool::Share => "action:share",
            Tool::Help => "action:help",
            Tool::More => "action:more",
        }
    }

    fn hint(self) -> &'static str {
        match self {
            Tool::Pause => "Pause or play (Space)",
            Tool::Step => "Advance by one step",
            Tool::Restart => "Restart with these values (R)",
            Tool::Undo => "Undo (Ctrl Z)",
            Tool::Redo => "Redo (Ctrl Y)",
            Tool::Picture => "Save an image or a film (S)",
            Tool::Fullscreen => "Full screen (F)",
            Tool::Share => "Copy and paste",
            Tool::Help => "Keyboard shortcuts (?)",
            Tool::More => "More tools",
        }
    }

    fn face(self, state: &State) -> Face<'static> {
        let icon = |icon| Face::new(icon, "");
        match self {
            Tool::Pause if state.fire.paused => Face {
                lit: true,
                ..icon(Icon::Play)
            },
            Tool::Pause => icon(Icon::Pause),
            Tool::Step => icon(Icon::Step),
            Tool::Restart => icon(Icon::Restart),
            Tool::Undo => Face {
                enabled: state.controller.undo,
                ..icon(Icon::Undo)
            },
            Tool::Redo => Face {
                enabled: state.controller.redo,
                ..icon(Icon::Redo)
            },
            Tool::Picture if state.controller.done == "picture" => icon(Icon::Tick),
            Tool::Picture => icon(Icon::Camera),
            Tool::Fullscreen => icon(Icon::Corners),
            Tool::Share => Face {
                lit: state.open.sharing,
                ..icon(Icon::Share)
            },
            Tool::Help => Face::text("?"),
            Tool::More => Face {
                lit: state.open.tools,
                ..Face::text("")
            },
        }
    }

    fn press(self, paused: bool, out: &mut Output) {
        match self {
            Tool::Pause if paused => out.send(Command::Play),
            Tool::Pause => out.send(Command::Pause),
            Tool::Step => {
                if !paused {
                    out.send(Command::Pause);
                }
                out.send(Command::Step);
            }
            Tool::Restart => out.send(Command::Reset),
            Tool::Undo => out.send(Command::Undo),
            Tool::Redo => out.send(Command::Redo),
            Tool::Picture => out.send(Command::Picture),
            Tool::Fullscreen => out.send(Command::Fullscreen),
            Tool::Help => out.send(Command::Help),
            Tool::Share => out.push(Action::ToggleSharing),
            Tool::More => out.push(Action::ToggleTools),
        }
    }
}

/// Shows tools side by side.
pub fn line(state: &State, out: &mut Output, ui: &Ui, rect: Rect, tools: &[Tool]) {
    let tools: Vec<Tool> = tools
        .iter()
        .copied()
        .filter(|tool| tool.is_available(state))
        .collect();
    for (rect, tool) in button::split(rect, tools.len(), 4.0).zip(tools) {
        let name = tool.name();
        let response =
            button::show(ui, rect, Id::new(name), tool.face(state)).on_hover_text(tool.hint());
        if tool == Tool::More {
            let ink = if response.hovered() {
                theme::ACCENT
            } else {
                theme::TEXT
            };
            icons::chevron(ui.painter(), rect.center(), state.open.tools, ink);
        }
        out.record(ui, name, rect);
        if response.clicked() {
            tool.press(state.fire.paused, out);
        }
    }
}

/// Shows the tools and, unfolded below them, copy and paste. `scrolls`: the panel is low,
/// and the tools scroll with the rows.
pub fn show(state: &State, out: &mut Output, ui: &mut Ui, scrolls: bool) {
    let control = state.device.measures.control;
    let rect = strip(ui, control);
    let tools: &[Tool] = if scrolls { &Tool::FOLDED } else { &Tool::LINE };
    line(state, out, ui, rect, tools);
    if state.open.sharing {
        ui.add_space(6.0);
        copies(&state.controller, out, ui, control);
        ui.add_space(6.0);
        paste(&state.controller, out, ui, control);
        ui.add_space(6.0);
        report(&state.controller, out, ui, control);
    }
    if state.reveal.tools && scrolls {
        scroll_into_view(ui, rect.with_max_y(ui.cursor().top()));
    }
    error(&state.controller, ui);
}

/// Shows the error of the panel controller, if there is one.
pub fn error(controller: &ControllerState, ui: &mut Ui) {
    if let Some(error) = controller.error() {
        ui.add_space(6.0);
        paragraph(ui, error, theme::ERROR);
    }
}

fn copies(controller: &ControllerState, out: &mut Output, ui: &mut Ui, control: f32) {
    let rect = labelled(ui, control, "Copy");
    let forms: Vec<_> = controller
        .copies
        .iter()
        .filter(|form| form.name != CopyForm::REPORT)
        .collect();
    for (rect, form) in button::split(rect, forms.len(), 6.0).zip(forms) {
        let key = format!("copy:{}", form.name);
        let done = controller.done == key;
        let face = Face {
            lit: done,
            ..Face::text(if done { "Copied" } else { &form.button })
        };
        let name = format!("action:{key}");
        let response = button::show(ui, rect, Id::new(&name), face).on_hover_text(&form.hint);
        out.record(ui, name, rect);
        if response.clicked() {
            out.send(Command::Copy(form.name.clone()));
        }
    }
}

/// A line with one button, which confirms its action.
struct Line<'a> {
    label: &'static str,
    /// What the controller reports as done.
    key: &'static str,
    text: &'a str,
    done: &'static str,
    hint: &'a str,
    command: Command,
}

fn paste(controller: &ControllerState, out: &mut Output, ui: &mut Ui, control: f32) {
    let line = Line {
        label: "Paste",
        key: "paste",
        text: "Settings from JSON…",
        done: "Applied",
        hint: "Apply settings that were copied as JSON",
        command: Command::Paste,
    };
    line.show(controller, out, ui, control);
}

fn report(controller: &ControllerState, out: &mut Output, ui: &mut Ui, control: f32) {
    let mut copies = controller.copies.iter();
    let Some(form) = copies.find(|form| form.name == CopyForm::REPORT) else {
        return;
    };
    let line = Line {
        label: "Report",
        key: "copy:report",
        text: &form.button,
        done: "Copied",
        hint: &form.hint,
        command: Command::Copy(form.name.clone()),
    };
    line.show(controller, out, ui, control);
}

impl Line<'_> {
    fn show(self, controller: &ControllerState, out: &mut Output, ui: &mut Ui, control: f32) {
        let rect = labelled(ui, control, self.label);
        let done = controller.done == self.key;
        let face = Face {
            lit: done,
            ..Face::text(if done { self.done } else { self.text })
        };
        let name = format!("action:{}", self.key);
        let response = button::show(ui, rect, Id::new(&name), face).on_hover_text(self.hint);
        out.record(ui, name, rect);
        if response.clicked() {
            out.send(self.command);
        }
    }
}
