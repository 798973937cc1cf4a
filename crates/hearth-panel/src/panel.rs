//! The whole panel: a header that stays, and the rows of the parameter table
//! that scroll under it.
//!
//! Nothing is listed by hand: groups, rows and controls come from the table.
//! Where there is little height (the sheet on a phone) only the most important
//! line stays and the rest scrolls with the rows. The panel remembers where
//! each control stands, so that a mirror of it in the page's own controls, and
//! tests with a real mouse, can find it.

use std::collections::BTreeMap;

use egui::style::ScrollAnimation;
use egui::{Align, Frame, Id, Margin, Rect, ScrollArea, Sense, Ui, UiBuilder, pos2, vec2};
use hearth_core::params::{Model, Param, Value};

use crate::colour::OpenColour;
use crate::desk::Desk;
use crate::field::Typing;
use crate::fire::{Command, Fire, MODEL};
use crate::memory::Memory;
use crate::slider::Gesture;
use crate::theme::{self, Measures};
use crate::{header, icons, row, search};

/// Below this height the header keeps one line.
const LOW: f32 = 540.0;

/// The name of what can be copied and pasted, for [`Panel::reveal`].
pub const SHARE: &str = "share";

/// That of the tools.
pub const TOOLS: &str = "tools";

/// That of the search, which gets the focus.
pub const SEARCH: &str = "search";

/// That of the quality.
pub const QUALITY: &str = "quality";

/// The group of the simplest controls; the quality is one of them.
const BASICS: &str = "Basics";

/// Empty space after the last row, so that it can be brought above whatever
/// the page lays over the panel's lower edge (the mirror's control that has the
/// focus).
const END: i8 = 84;

/// The panel's state.
#[derive(Debug)]
pub struct Panel {
    /// What it knows about the fire.
    pub fire: Fire,
    /// What the page around it can do.
    pub desk: Desk,
    /// Whether the last press came from a finger.
    pub finger: bool,
    /// Sizes for the finger or the mouse.
    pub measures: Measures,
    /// Whether a wheel over the panel would still move it, up and down.
    pub scrolls: (bool, bool),
    /// What it keeps from one visit to the next.
    pub memory: Memory,
    /// The parameters that it shows, in this order and without groups; nothing: all.
    pub only: Option<Vec<&'static Param>>,
    pub(crate) search: String,
    pub(crate) typing: Option<Typing>,
    pub(crate) colour: Option<OpenColour>,
    /// The choice whose list is unfolded.
    pub(crate) listed: Option<&'static str>,
    /// The parameter whose doc is shown in its row.
    pub(crate) told: Option<&'static str>,
    /// The parameter that the page's own controls point at.
    pub(crate) shown: Option<&'static str>,
    pub(crate) revealing: bool,
    pub(crate) gesture: Option<(Id, Gesture)>,
    /// What is to be brought into sight.
    pub(crate) wanted: String,
    /// Whether the tools are unfolded, where there is little height.
    pub(crate) more: bool,
    /// Whether the rows are to go to their beginning.
    pub(crate) rewinding: bool,
    /// Whether the search is to get the focus.
    pub(crate) seeking: bool,
    /// The value that a wheel turns, and how much of a step it has turned.
    pub(crate) turning: Option<&'static str>,
    pub(crate) turned: f32,
    /// The choice of which a name was just chosen.
    pub(crate) chosen: Option<&'static str>,
    /// The row under the pointer.
    pub(crate) hovered: Option<&'static str>,
    /// Whether something in the row tells about itself.
    pub(crate) quiet: bool,
    /// Whether it is shown what can be copied and pasted.
    pub(crate) sharing: bool,
    /// Whether that is to be brought into sight.
    pub(crate) bringing_tools: bool,
    /// The model whose rows were shown last.
    model: Model,
    /// Where each row in sight began, the uppermost first.
    tops: Vec<(&'static str, f32)>,
    rectangles: BTreeMap<String, Rect>,
    commands: Vec<Command>,
}

impl Panel {
    /// A panel that knows the defaults only.
    pub fn new(measures: Measures) -> Panel {
        Panel {
            fire: Fire::default(),
            desk: Desk::default(),
            finger: false,
            measures,
            scrolls: (false, false),
            memory: Memory::default(),
            only: None,
            search: String::new(),
            typing: None,
            colour: None,
            listed: None,
            told: None,
            shown: None,
            revealing: false,
            gesture: None,
            wanted: String::new(),
            more: false,
            rewinding: false,
            seeking: false,
            turning: None,
            turned: 0.0,
            chosen: None,
            hovered: None,
            quiet: false,
            sharing: false,
            bringing_tools: false,
            model: Model::default(),
            tops: Vec::new(),
            rectangles: BTreeMap::new(),
            commands: Vec::new(),
        }
    }

    /// Shows the panel in all of `ui` and takes its input.
    pub fn ui(&mut self, ui: &mut Ui) {
        self.rectangles.clear();
        self.hovered = None;
        let area = ui.max_rect();
        ui.painter().rect_filled(area, 0.0, theme::GROUND);
        if area.width() < 120.0 || area.height() < 80.0 {
            return;
        }
        let low = area.height() < LOW;
        let inner = area.shrink2(vec2(14.0, if low { 6.0 } else { 12.0 }));
        let bottom = ui
            .scope_builder(UiBuilder::new().max_rect(inner), |ui| {
                header::fixed(self, ui, low);
                ui.min_rect().bottom()
            })
            .inner;
        let body = Rect::from_min_max(pos2(area.left(), bottom + 6.0), area.max);
        ui.painter()
            .hline(area.x_range(), body.top(), (1.0, theme::line()));
        ui.scope_builder(UiBuilder::new().max_rect(body), |ui| self.body(ui, low));
        if !ui.input(|input| input.pointer.any_down()) {
            self.gesture = None;
        }
        self.revealing = false;
        self.bringing_tools = false;
    }

    fn body(&mut self, ui: &mut Ui, low: bool) {
        let output = ScrollArea::vertical()
            .id_salt("parameters")
            .auto_shrink(false)
            .show(ui, |ui| {
                Frame::new()
                    .inner_margin(Margin {
                        left: 14,
                        right: 14,
                        top: 4,
                        bottom: END,
                    })
                    .show(ui, |ui| {
                        if self.rewinding {
                            let start = ui.max_rect().with_max_y(ui.max_rect().top() + 1.0);
                            ui.scroll_to_rect_animation(
                                start,
                                Some(Align::Min),
                                ScrollAnimation::none(),
                            );
                        }
                        if low {
                            header::movable(self, ui);
                        }
                        if self.only.is_some() {
                            self.few(ui);
                        } else if self.search.trim().is_empty() {
                            self.groups(ui);
                        } else {
                            self.results(ui);
                        }
                    });
            });
        let hidden = output.content_size.y - output.inner_rect.height();
        let offset = output.state.clamped_offset().y;
        let inside = ui.rect_contains_pointer(output.inner_rect);
        self.scrolls = (inside && offset > 0.5, inside && offset < hidden - 0.5);
        if self.turning.is_some() {
            self.scrolls = (true, true);
        }
        self.rewinding = false;
    }

    /// All parameters, by their groups.
    fn groups(&mut self, ui: &mut Ui) {
        let anchor = self.anchor();
        let used: Vec<&'static Param> = self.fire.used().collect();
        for group in used.chunk_by(|a, b| a.group == b.group) {
            let name = group[0].group;
            if !self.heading(ui, name) {
                continue;
            }
            for param in group {
                let top = ui.cursor().top();
                match anchor {
                    Some((id, wanted)) if id == param.id => {
                        let delta = vec2(0.0, wanted - top);
                        ui.scroll_with_delta_animation(delta, ScrollAnimation::none());
                    }
                    _ => {}
                }
                if top >= ui.clip_rect().top() {
                    self.tops.push((param.id, top));
                }
                row::show(self, ui, param);
            }
            if name == BASICS {
                header::quality(self, ui);
            }
            ui.add_space(4.0);
        }
    }

    /// Those that answer the search, the best first.
    fn results(&mut self, ui: &mut Ui) {
        self.anchor();
        let rank = |param| Some((search::rank(&self.search, param)?, param));
        let mut found: Vec<(u32, &'static Param)> = self.fire.used().filter_map(rank).collect();
        found.sort_by_key(|(rank, _)| *rank);
        let quality = QUALITY.starts_with(self.search.trim().to_lowercase().as_str());
        ui.add_space(6.0);
        if quality {
            header::quality(self, ui);
        } else if found.is_empty() {
            row::paragraph(ui, "No parameter matches this.", theme::weak());
        }
        for (_, param) in found {
            row::show(self, ui, param);
        }
    }

    /// Those that the page wants to be shown, as far as the model uses them.
    fn few(&mut self, ui: &mut Ui) {
        self.anchor();
        let model = self.fire.parameters.model();
        ui.add_space(6.0);
        for param in self.only.clone().unwrap_or_default() {
            if param.domain(model).is_some() {
                row::show(self, ui, param);
            }
        }
    }

    /// Another model has other rows. The uppermost row in sight that both have
    /// stays where it is: this one, at that height. A choice may have given others a
    /// line that says why they count for nothing; its own row stays then.
    fn anchor(&mut self) -> Option<(&'static str, f32)> {
        let tops = std::mem::take(&mut self.tops);
        let chosen = self.chosen.take();
        let model = self.fire.parameters.model();
        if model == self.model {
            return tops.into_iter().find(|&(id, _)| Some(id) == chosen);
        }
        self.model = model;
        let used = |id: &str| self.fire.used().any(|param| param.id == id);
        if self.typing.as_ref().is_some_and(|typing| !used(typing.id)) {
            self.typing = None;
        }
        tops.into_iter().find(|&(id, _)| used(id))
    }

    /// The heading of a group; whether that is unfolded.
    fn heading(&mut self, ui: &mut Ui, name: &'static str) -> bool {
        let rect = strip(ui, self.measures.control + 4.0);
        let response = ui
            .interact(rect, Id::unique(("group", name)), Sense::click())
            .on_hover_cursor(egui::CursorIcon::PointingHand);
        if response.clicked() {
            if !self.memory.folded.remove(name) {
                self.memory.folded.insert(name);
            }
            self.ask(Command::Remember(self.memory.clone()));
        }
        let open = !self.memory.folded.contains(name);
        self.place(ui, format!("group:{name}"), rect);
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
        open
    }

    /// Brings the row of a parameter into sight and marks it; or what can be shared
    /// ([`SHARE`]), the tools ([`TOOLS`]), the quality ([`QUALITY`]) or the search
    /// ([`SEARCH`]), which gets the focus. An id that is none takes the mark away.
    pub fn reveal(&mut self, id: &str) {
        self.wanted = id.to_owned();
        let model = self.fire.parameters.model();
        let param = Param::find(id).filter(|param| param.domain(model).is_some());
        self.shown = param.map(|param| param.id);
        match id {
            SHARE | TOOLS | SEARCH | MODEL => {
                self.sharing |= id == SHARE;
                self.seeking |= id == SEARCH;
                self.more = true;
                self.bringing_tools = id != MODEL;
                self.revealing = true;
            }
            QUALITY => {
                self.revealing = true;
                self.memory.folded.remove(BASICS);
                self.search.clear();
            }
            _ => {}
        }
        if let Some(param) = param.filter(|param| param.id != MODEL) {
            self.revealing = true;
            self.memory.folded.remove(param.group);
            if !search::matches(&self.search, param) {
                self.search.clear();
            }
        }
    }

    /// The value of the row under the pointer, to be copied, and what it is called.
    pub fn hovered_value(&self) -> Option<(String, &'static str)> {
        let param = Param::find(self.hovered?)?;
        let value = param.get(&self.fire.parameters).to_string();
        Some((value, param.description().label))
    }

    /// Whether somebody types in the panel.
    pub fn is_typing(&self, ctx: &egui::Context) -> bool {
        ctx.text_edit_focused()
    }

    /// Where each visible control stands, in points.
    pub fn rectangles(&self) -> &BTreeMap<String, Rect> {
        &self.rectangles
    }

    /// Remembers where a control stands, if it can be seen and touched there.
    pub(crate) fn place(&mut self, ui: &Ui, name: impl Into<String>, rect: Rect) {
        if ui.clip_rect().expand(1.0).contains_rect(rect) {
            self.rectangles.insert(name.into(), rect);
        }
    }

    pub(crate) fn ask(&mut self, command: Command) {
        // What went wrong before has been read by whoever goes on.
        self.fire.notice = None;
        self.commands.push(command);
    }

    /// Asks for a value that has been checked.
    pub(crate) fn ask_for(&mut self, param: &'static Param, value: Value) {
        self.ask(Command::Set(param.id, value));
    }

    /// What it asks of the fire since the last call.
    pub fn take_commands(&mut self) -> Vec<Command> {
        std::mem::take(&mut self.commands)
    }
}

/// Takes a strip of the whole width.
pub(crate) fn strip(ui: &mut Ui, height: f32) -> Rect {
    let size = vec2(ui.available_width(), height);
    let (_, rect) = ui.allocate_space(size);
    rect
}

/// Brings `rect` into sight, above what may lie over the lower edge.
pub(crate) fn in_sight(ui: &Ui, mut rect: Rect) {
    rect.max.y += f32::from(END);
    // The middle, unless that would push the row out at the top.
    let align = if rect.height() > ui.clip_rect().height() {
        Align::Min
    } else {
        Align::Center
    };
    let at_once = egui::style::ScrollAnimation::none();
    ui.scroll_to_rect_animation(rect, Some(align), at_once);
}
