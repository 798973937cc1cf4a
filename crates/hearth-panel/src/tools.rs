//! The line of tools: play and pause, back and again, picture, full screen, what can
//! be shared, and the keys.

use egui::{Align2, Id, Rect, Ui};

use crate::button::{self, Face};
use crate::fire::Command;
use crate::header::LABEL;
use crate::icons::{self, Icon};
use crate::panel::{Panel, in_sight, strip};
use crate::theme::Measures;
use crate::{row, theme};

/// What can be copied: its name, its button's face, and what that means.
const COPIES: [(&str, &str, &str); 4] = [
    ("link", "Link", "An address that shows this fire"),
    ("element", "HTML", "HTML that shows this fire on any page"),
    (
        "iframe",
        "Iframe",
        "HTML that shows it in a frame of its own",
    ),
    ("json", "JSON", "Its settings, to be kept and pasted"),
];

/// A button of the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// Let time pass, or hold it.
    Pause,
    /// One step.
    Step,
    /// Start again.
    Restart,
    /// A step back.
    Undo,
    /// And again.
    Redo,
    /// Save a picture.
    Picture,
    /// Take all of the screen.
    Fullscreen,
    /// Unfold what can be shared.
    Share,
    /// Show the keys.
    Help,
    /// Unfold all others, where there is little height.
    More,
}

impl Tool {
    /// All that stand side by side, where there is room.
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

    /// Those that are unfolded, where there is little height.
    const FOLDED: [Tool; 7] = [
        Tool::Step,
        Tool::Restart,
        Tool::Redo,
        Tool::Picture,
        Tool::Fullscreen,
        Tool::Share,
        Tool::Help,
    ];

    fn is_there(self, panel: &Panel) -> bool {
        match self {
            Tool::Fullscreen => panel.desk.fullscreen,
            // Where there is no mouse there is hardly a keyboard.
            Tool::Help => panel.measures != Measures::COARSE,
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
            Tool::Pause => "Let time pass, or hold it (Space)",
            Tool::Step => "One step of the simulation",
            Tool::Restart => "Start the fire again with these values (R)",
            Tool::Undo => "Undo (Ctrl Z)",
            Tool::Redo => "Do again (Ctrl Y)",
            Tool::Picture => "Save a picture (S)",
            Tool::Fullscreen => "Full screen (F)",
            Tool::Share => "Copy and paste",
            Tool::Help => "Keys (?)",
            Tool::More => "More",
        }
    }

    fn face(self, panel: &Panel) -> Face<'static> {
        let icon = |icon| Face::new(icon, "");
        match self {
            Tool::Pause if panel.fire.paused => Face {
                lit: true,
                ..icon(Icon::Play)
            },
            Tool::Pause => icon(Icon::Pause),
            Tool::Step => icon(Icon::Step),
            Tool::Restart => icon(Icon::Restart),
            Tool::Undo => Face {
                enabled: panel.desk.undo,
                ..icon(Icon::Undo)
            },
            Tool::Redo => Face {
                enabled: panel.desk.redo,
                ..icon(Icon::Redo)
            },
            Tool::Picture if panel.desk.done == "picture" => icon(Icon::Tick),
            Tool::Picture => icon(Icon::Camera),
            Tool::Fullscreen => icon(Icon::Corners),
            Tool::Share => Face {
                lit: panel.sharing,
                ..icon(Icon::Share)
            },
            Tool::Help => Face::text("?"),
            Tool::More => Face {
                lit: panel.more,
                ..Face::text("")
            },
        }
    }

    fn press(self, panel: &mut Panel) {
        let paused = panel.fire.paused;
        match self {
            Tool::Pause if paused => panel.ask(Command::Play),
            Tool::Pause => panel.ask(Command::Pause),
            Tool::Step => {
                if !paused {
                    panel.ask(Command::Pause);
                }
                panel.ask(Command::Step);
            }
            Tool::Restart => panel.ask(Command::Reset),
            Tool::Undo => panel.ask(Command::Undo),
            Tool::Redo => panel.ask(Command::Redo),
            Tool::Picture => panel.ask(Command::Picture),
            Tool::Fullscreen => panel.ask(Command::Fullscreen),
            Tool::Help => panel.ask(Command::Help),
            Tool::Share => panel.sharing ^= true,
            Tool::More => {
                panel.more ^= true;
                // It is unfolded above the rows.
                panel.rewinding = panel.more;
            }
        }
    }
}

/// These tools side by side.
pub fn line(panel: &mut Panel, ui: &Ui, rect: Rect, tools: &[Tool]) {
    let tools: Vec<Tool> = tools
        .iter()
        .copied()
        .filter(|tool| tool.is_there(panel))
        .collect();
    for (rect, tool) in button::split(rect, tools.len(), 4.0).zip(tools) {
        let name = tool.name();
        let response =
            button::show(ui, rect, Id::unique(name), tool.face(panel)).on_hover_text(tool.hint());
        if tool == Tool::More {
            let ink = if response.hovered() {
                theme::ACCENT
            } else {
                theme::TEXT
            };
            icons::chevron(ui.painter(), rect.center(), panel.more, ink);
        }
        panel.place(ui, name, rect);
        if response.clicked() {
            tool.press(panel);
        }
    }
}

/// Shows the tools, and below them what can be shared, where somebody asked.
/// `scrolls`: there is little height, and they can be brought into sight.
pub fn show(panel: &mut Panel, ui: &mut Ui, scrolls: bool) {
    let rect = strip(ui, panel.measures.control);
    let tools: &[Tool] = if scrolls { &Tool::FOLDED } else { &Tool::LINE };
    line(panel, ui, rect, tools);
    if panel.sharing {
        ui.add_space(6.0);
        copies(panel, ui);
        ui.add_space(6.0);
        paste(panel, ui);
    }
    if panel.bringing_tools && scrolls {
        in_sight(ui, rect.with_max_y(ui.cursor().top()));
    }
    complaint(panel, ui);
}

/// What went wrong, if anything did.
pub fn complaint(panel: &Panel, ui: &mut Ui) {
    if let Some(complaint) = panel.desk.complaint() {
        ui.add_space(6.0);
        row::paragraph(ui, complaint, theme::ERROR);
    }
}

fn copies(panel: &mut Panel, ui: &mut Ui) {
    let rect = labelled(panel, ui, "Copy");
    let copies: Vec<_> = COPIES
        .into_iter()
        .filter(|&(what, ..)| match what {
            "link" => panel.desk.link,
            "iframe" => panel.desk.iframe,
            _ => true,
        })
        .collect();
    for (rect, (what, text, hint)) in button::split(rect, copies.len(), 6.0).zip(copies) {
        let key = format!("copy:{what}");
        let done = panel.desk.done == key;
        let face = Face {
            lit: done,
            ..Face::text(if done { "Copied" } else { text })
        };
        let name = format!("action:{key}");
        let response = button::show(ui, rect, Id::unique(&name), face).on_hover_text(hint);
        panel.place(ui, name, rect);
        if response.clicked() {
            panel.ask(Command::Copy(what));
        }
    }
}

fn paste(panel: &mut Panel, ui: &mut Ui) {
    let rect = labelled(panel, ui, "Paste");
    let done = panel.desk.done == "paste";
    let text = if done {
        "Taken"
    } else {
        "Settings from JSON…"
    };
    let face = Face {
        lit: done,
        ..Face::text(text)
    };
    let name = "action:paste";
    let response = button::show(ui, rect, Id::unique(name), face);
    panel.place(ui, name, rect);
    if response.clicked() {
        panel.ask(Command::Paste);
    }
}

/// A line with its name at the left; what is left of it.
fn labelled(panel: &Panel, ui: &mut Ui, text: &str) -> egui::Rect {
    let mut rect = strip(ui, panel.measures.control);
    ui.painter().text(
        rect.left_center(),
        Align2::LEFT_CENTER,
        text,
        theme::small(),
        theme::weak(),
    );
    rect.min.x += LABEL;
    rect
}
