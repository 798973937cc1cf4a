//! The panel as an eframe app: it paints, then sends the commands.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use web_sys::{Event, HtmlCanvasElement};

use crate::panel::Panel;
use crate::theme;
use crate::web::element::Element;

/// The event on the canvas after each frame: rectangles may have moved.
const PAINTED_EVENT: &str = "panel-painted";

/// What eframe's event handlers need, which run outside of a frame.
#[derive(Debug, Default)]
pub struct InputPolicy {
    /// Whether a text field has the focus.
    pub typing: Cell<bool>,
    /// Whether the panel takes a wheel, up and down.
    pub scrolls: Cell<(bool, bool)>,
}

/// The eframe app.
pub struct App {
    panel: Rc<RefCell<Panel>>,
    element: Rc<Element>,
    policy: Rc<InputPolicy>,
    canvas: HtmlCanvasElement,
}

impl App {
    /// An app that shows `panel` and sends its commands to `element`.
    pub fn new(
        panel: Rc<RefCell<Panel>>,
        element: Rc<Element>,
        policy: Rc<InputPolicy>,
        canvas: HtmlCanvasElement,
    ) -> App {
        App {
            panel,
            element,
            policy,
            canvas,
        }
    }
}

impl eframe::App for App {
    fn update(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        let commands = {
            let Ok(mut panel) = self.panel.try_borrow_mut() else {
                return;
            };
            panel.show(ctx);
            self.policy.typing.set(panel.is_typing(ctx));
            self.policy.scrolls.set(panel.scrolls);
            panel.take_commands()
        };
        // The element may answer with events at once, which borrow the panel.
        for command in commands {
            self.element.send(command);
        }
        if let Ok(event) = Event::new(PAINTED_EVENT) {
            let _ = self.canvas.dispatch_event(&event);
        }
    }

    /// Undoes the scale of the canvas on its page, which eframe ignores.
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
