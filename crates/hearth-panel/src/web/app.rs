//! The panel as an eframe app: paints, then sends what was asked for.

use std::cell::RefCell;
use std::rc::Rc;

use web_sys::{Event, HtmlCanvasElement};

use super::Manners;
use super::element::Element;
use crate::Panel;
use crate::theme;

/// The event on the canvas after each frame: rectangles may have moved.
const PAINTED: &str = "panel-painted";

/// What eframe runs.
pub struct App {
    panel: Rc<RefCell<Panel>>,
    element: Rc<Element>,
    manners: Rc<Manners>,
    canvas: HtmlCanvasElement,
}

impl App {
    /// An app that shows `panel` and sends to `element`.
    pub fn new(
        panel: Rc<RefCell<Panel>>,
        element: Rc<Element>,
        manners: Rc<Manners>,
        canvas: HtmlCanvasElement,
    ) -> App {
        App {
            panel,
            element,
            manners,
            canvas,
        }
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        let commands = {
            let Ok(mut panel) = self.panel.try_borrow_mut() else {
                return;
            };
            panel.ui(ui);
            self.manners.typing.set(panel.is_typing(ui.ctx()));
            self.manners.scrolls.set(panel.scrolls);
            panel.take_commands()
        };
        // The element may answer with events at once; the panel is free to
        // hear them by now.
        for command in commands {
            self.element.send(command);
        }
        if let Ok(event) = Event::new(PAINTED) {
            let _ = self.canvas.dispatch_event(&event);
        }
    }

    /// eframe takes distances in the window for distances on the canvas, which they are
    /// not where the page scales it.
    fn raw_input_hook(&mut self, _ctx: &egui::Context, input: &mut egui::RawInput) {
        let shown = self.canvas.get_bounding_client_rect().width();
        let scale = f64::from(self.canvas.offset_width()) / shown;
        if !scale.is_finite() || (scale - 1.0).abs() < 0.001 {
            return;
        }
        for event in &mut input.events {
            match event {
                egui::Event::PointerMoved(pos)
                | egui::Event::PointerButton { pos, .. }
                | egui::Event::Touch { pos, .. } => {
                    *pos = (pos.to_vec2() * scale as f32).to_pos2();
                }
                _ => {}
            }
        }
    }

    fn clear_color(&self, _visuals: &egui::Visuals) -> [f32; 4] {
        theme::GROUND.to_normalized_gamma_f32()
    }
}
