//! The line of tools: back and again, picture, full screen, what can be shared,
//! and the keys.

use egui::{Align2, Id, Ui};

use crate::button::{self, Face};
use crate::fire::Command;
use crate::header::LABEL;
use crate::icons::Icon;
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

/// Shows the tools, and below them what can be shared, where somebody asked.
/// `scrolls`: whether they can be brought into sight.
pub fn show(panel: &mut Panel, ui: &mut Ui, scrolls: bool) {
    let desk = panel.desk.clone();
    let rect = strip(ui, panel.measures.control);
    let picture = if desk.done == "picture" {
        Icon::Tick
    } else {
        Icon::Camera
    };
    let tool = |icon, enabled| Face {
        enabled,
        ..Face::new(icon, "")
    };
    let share = Face {
        lit: panel.sharing,
        ..Face::new(Icon::Share, "")
    };
    let tools = [
        (
            "action:undo",
            tool(Icon::Undo, desk.undo),
            "Undo (Ctrl Z)",
            Some(Command::Undo),
        ),
        (
            "action:redo",
            tool(Icon::Redo, desk.redo),
            "Do again (Ctrl Y)",
            Some(Command::Redo),
        ),
        (
            "action:picture",
            tool(picture, true),
            "Save a picture (S)",
            Some(Command::Picture),
        ),
        (
            "action:fullscreen",
            tool(Icon::Corners, true),
            "Full screen (F)",
            Some(Command::Fullscreen),
        ),
        ("action:share", share, "Copy and paste", None),
        (
            "action:help",
            Face::text("?"),
            "Keys (?)",
            Some(Command::Help),
        ),
    ];
    let tools: Vec<_> = tools
        .into_iter()
        .filter(|tool| match tool.3 {
            Some(Command::Fullscreen) => desk.fullscreen,
            // Where there is no mouse there is hardly a keyboard.
            Some(Command::Help) => panel.measures != Measures::COARSE,
            _ => true,
        })
        .collect();
    for (rect, (name, face, hint, command)) in button::split(rect, tools.len(), 6.0).zip(tools) {
        let response = button::show(ui, rect, Id::unique(name), face).on_hover_text(hint);
        panel.place(ui, name, rect);
        if !response.clicked() {
            continue;
        }
        match command {
            Some(command) => panel.ask(command),
            None => panel.sharing ^= true,
        }
    }
    if panel.sharing {
        ui.add_space(6.0);
        copies(panel, ui);
        ui.add_space(6.0);
        paste(panel, ui);
        if panel.bringing_tools && scrolls {
            in_sight(ui, rect.with_max_y(ui.cursor().top()));
        }
    }
    if let Some(complaint) = desk.complaint() {
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
        theme::WEAK,
    );
    rect.min.x += LABEL;
    rect
}
