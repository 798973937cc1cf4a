//! The whole panel: a header that stays, and the rows of the parameter table that scroll
//! below it.
//!
//! The views read the state and return actions; the panel applies them after the frame and
//! passes the commands among them to its host. Groups, rows and controls come from the
//! parameter table. In a low panel (the sheet on a phone) one line of the header stays and the
//! others scroll with the rows.

use std::collections::BTreeMap;

use egui::style::ScrollAnimation;
use egui::text_edit::TextEditState;
use egui::{Align, CentralPanel, Frame, Margin, Rect, ScrollArea, Ui, UiBuilder, pos2, vec2};

use crate::state::{Command, State};
use crate::theme::{self, Measures};
use crate::view::layout::SPACE_BELOW;
use crate::view::output::Output;
use crate::view::{header, rows};

/// Below this height the header keeps one line.
const LOW_PANEL_HEIGHT: f32 = 540.0;

/// The panel: its state, and what its last frame returned.
#[derive(Debug)]
pub struct Panel {
    /// The state.
    pub state: State,
    /// Whether the panel can scroll up and down at the pointer.
    pub scrolls: (bool, bool),
    output: Output,
    pub(crate) commands: Vec<Command>,
}

impl Panel {
    /// A panel with the default values.
    pub fn new(measures: Measures) -> Panel {
        Panel {
            state: State::new(measures),
            scrolls: (false, false),
            output: Output::default(),
            commands: Vec::new(),
        }
    }

    /// Shows the panel in all of the context's area, and applies its input.
    pub fn show(&mut self, ctx: &egui::Context) {
        let all = CentralPanel::default().frame(Frame::NONE);
        all.show(ctx, |ui| self.ui(ui));
    }

    fn ui(&mut self, ui: &mut Ui) {
        self.output.rectangles.clear();
        self.output.hovered = None;
        self.output.tooltip = None;
        let area = ui.max_rect();
        ui.painter().rect_filled(area, 0.0, theme::GROUND);
        if area.width() < 120.0 || area.height() < 80.0 {
            return;
        }
        self.state.close_stale_field();
        self.output.pointer.follow(ui);
        self.views(ui, area);
        if !ui.input(|input| input.pointer.any_down()) {
            self.output.pointer.gesture = None;
        }
        self.end_frame();
    }

    fn views(&mut self, ui: &mut Ui, area: Rect) {
        let low = area.height() < LOW_PANEL_HEIGHT;
        let inner = area.shrink2(vec2(14.0, if low { 6.0 } else { 12.0 }));
        let bottom = ui
            .scope_builder(UiBuilder::new().max_rect(inner), |ui| {
                header::fixed(&self.state, &mut self.output, ui, low);
                ui.min_rect().bottom()
            })
            .inner;
        let body = Rect::from_min_max(pos2(area.left(), bottom + 6.0), area.max);
        ui.painter()
            .hline(area.x_range(), body.top(), (1.0, theme::line()));
        ui.scope_builder(UiBuilder::new().max_rect(body), |ui| self.body(ui, low));
    }

    fn body(&mut self, ui: &mut Ui, low: bool) {
        let (state, output) = (&self.state, &mut self.output);
        let margin = Margin {
            left: 14,
            right: 14,
            top: 4,
            bottom: SPACE_BELOW,
        };
        let scrolled = ScrollArea::vertical()
            .id_salt("parameters")
            .auto_shrink(false)
            .show(ui, |ui| {
                Frame::new().inner_margin(margin).show(ui, |ui| {
                    if state.reveal.start {
                        let start = ui.max_rect().with_max_y(ui.max_rect().top() + 1.0);
                        ui.scroll_to_rect_animation(
                            start,
                            Some(Align::Min),
                            ScrollAnimation::none(),
                        );
                    }
                    if low {
                        header::movable(state, output, ui);
                    }
                    rows::show(state, output, ui);
                });
            });
        let hidden = scrolled.content_size.y - scrolled.inner_rect.height();
        let offset = scrolled.state.offset.y;
        let inside = ui.rect_contains_pointer(scrolled.inner_rect);
        self.scrolls = if output.pointer.wheel.is_some() {
            (true, true)
        } else {
            (inside && offset > 0.5, inside && offset < hidden - 0.5)
        };
    }

    /// Applies what the views returned.
    fn end_frame(&mut self) {
        let marked = self.state.reveal.marked;
        self.state.reveal = Default::default();
        self.state.reveal.marked = marked;
        self.state.anchor.model = self.state.fire.parameters().model();
        self.state.anchor.tops = std::mem::take(&mut self.output.tops);
        self.state.anchor.chosen = None;
        for action in std::mem::take(&mut self.output.actions) {
            self.apply(action);
        }
    }

    /// The text of the value under the pointer, and its label.
    pub fn hovered_value(&self) -> Option<(String, &'static str)> {
        let subject = self.output.hovered?;
        let value = self.state.fire.value(subject).to_string();
        Some((value, subject.param.description().label))
    }

    /// What the row under a resting pointer is about, and the row.
    pub fn tooltip(&self) -> Option<(&str, Rect)> {
        let (text, row) = self.output.tooltip.as_ref()?;
        Some((text, *row))
    }

    /// The position of each visible control in points. The page's accessible controls and
    /// tests with a real pointer use it.
    pub fn rectangles(&self) -> &BTreeMap<String, Rect> {
        &self.output.rectangles
    }

    /// Whether a text field of the panel has the focus.
    pub fn is_typing(&self, ctx: &egui::Context) -> bool {
        let focused = ctx.memory(|memory| memory.focused());
        focused.is_some_and(|id| TextEditState::load(ctx, id).is_some())
    }

    /// The commands since the last call.
    pub fn take_commands(&mut self) -> Vec<Command> {
        std::mem::take(&mut self.commands)
    }
}
