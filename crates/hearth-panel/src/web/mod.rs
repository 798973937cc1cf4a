//! The panel on a page: a canvas, an element, and eframe between them.
//!
//! [`Panel`] is all that JavaScript sees. eframe on the web has habits that
//! disturb a page, and they are undone here: it keeps the wheel and the Tab key
//! to itself, and it makes canvas and text field stops of the Tab key although
//! the page's own controls (see `web/panel/accessible-controls.js`) serve the keyboard. It also
//! takes the focus when it starts, which only the page's script can prevent.

mod app;
mod element;
mod listener;

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use wasm_bindgen::prelude::*;
use web_sys::{HtmlCanvasElement, HtmlElement, KeyboardEvent, PointerEvent};

use self::app::App;
use self::element::{Element, desk, paint_soon, property, read_scene};
use self::listener::Listener;
use crate::theme::{self, Measures};

/// What eframe's event handlers ask about, which run outside of a frame.
#[derive(Debug, Default)]
struct Manners {
    /// Whether somebody types in the panel.
    typing: Cell<bool>,
    /// Whether a wheel would still move it, up and down.
    scrolls: Cell<(bool, bool)>,
}

/// The panel, as a page sees it.
#[wasm_bindgen]
pub struct Panel {
    runner: eframe::WebRunner,
    panel: Rc<RefCell<crate::Panel>>,
    ctx: egui::Context,
    _element: Rc<Element>,
    _listeners: Vec<Listener>,
}

#[wasm_bindgen]
impl Panel {
    /// Starts the panel on `canvas`, which stands in the document, for `fire`,
    /// a `<hearth-fire>` element or anything with its API, and with `desk`, which
    /// does what is wished.
    ///
    /// # Errors
    /// Says in words why it cannot start: no WebGL, mostly.
    pub async fn start(
        canvas: HtmlCanvasElement,
        fire: JsValue,
        desk: JsValue,
    ) -> Result<Panel, JsValue> {
        let measures = if matches("(pointer: coarse)") {
            Measures::COARSE
        } else {
            Measures::FINE
        };
        let mut state = crate::Panel::new(measures);
        state.finger = measures == Measures::COARSE;
        let panel = Rc::new(RefCell::new(state));
        let manners = Rc::new(Manners::default());
        // Before eframe's own, so that these are asked first.
        let mut listeners = vec![press_listener(&canvas, &panel)?];

        let runner = eframe::WebRunner::new();
        let started = Rc::new(RefCell::new(None));
        let create: eframe::AppCreator<'static> = {
            let (panel, manners, started) = (panel.clone(), manners.clone(), started.clone());
            let canvas = canvas.clone();
            Box::new(move |creation| {
                let ctx = creation.egui_ctx.clone();
                theme::prefer_contrast(matches("(prefers-contrast: more)"));
                theme::apply(&ctx);
                let element = Rc::new(Element::new(fire, desk, panel.clone(), ctx.clone())?);
                started.replace(Some((element.clone(), ctx)));
                Ok(Box::new(App::new(panel, element, manners, canvas)))
            })
        };
        runner
            .start(canvas.clone(), options(&manners), create)
            .await?;
        let (element, ctx) = started
            .take()
            .ok_or_else(|| js_sys::Error::new("the panel did not start"))?;
        listeners.extend(tab_listeners(&canvas)?);
        Ok(Panel {
            runner,
            panel,
            ctx,
            _element: element,
            _listeners: listeners,
        })
    }

    /// Where each visible control stands: name → `[x, y, width, height]` in CSS
    /// pixels from the canvas's upper left corner. A parameter's id names what
    /// is dragged or pressed to change it; `action:pause`, `action:reset`,
    /// `action:step`, `action:undo`, `action:copy:<what>`, `action:scenes`,
    /// `action:restore:<id>` and others name buttons; `value:<id>` is what is clicked to
    /// type, `label:<id>` the name, `choice:<id>:<name>` one of the choices.
    pub fn rectangles(&self) -> js_sys::Object {
        let result = js_sys::Object::new();
        if let Ok(panel) = self.panel.try_borrow() {
            for (name, rect) in panel.rectangles() {
                let numbers: js_sys::Array = [rect.left(), rect.top(), rect.width(), rect.height()]
                    .into_iter()
                    .map(|x| JsValue::from_f64((f64::from(x) * 100.0).round() / 100.0))
                    .collect();
                // A plain new object takes any property.
                let _ = js_sys::Reflect::set(&result, &JsValue::from_str(name), &numbers);
            }
        }
        result
    }

    /// Brings a parameter's row into sight and marks it, or what can be shared
    /// (`share`), the tools (`tools`), the quality (`quality`) or the search (`search`),
    /// which gets the focus; an empty id takes the mark away.
    pub fn reveal(&self, id: &str) {
        if let Ok(mut panel) = self.panel.try_borrow_mut() {
            panel.reveal(id);
        }
        paint_soon(&self.ctx);
    }

    /// The page's desk is in this state now: an object with the fields of
    /// [`crate::desk::Desk`].
    pub fn tell(&self, state: JsValue) {
        if let Ok(mut panel) = self.panel.try_borrow_mut() {
            panel.desk = desk(&state);
            read_scene(&mut panel, &property(&state, "values"));
        }
        paint_soon(&self.ctx);
    }

    /// The value of the row under the pointer and its label, to be copied; nothing where
    /// there is none, or somebody types.
    pub fn hovered(&self) -> Option<Vec<String>> {
        let panel = self.panel.try_borrow().ok()?;
        if panel.is_typing(&self.ctx) {
            return None;
        }
        let (value, label) = panel.hovered_value()?;
        Some(vec![value, label.to_owned()])
    }

    /// Paints soon: the canvas's resolution was changed from outside.
    pub fn repaint(&self) {
        paint_soon(&self.ctx);
    }

    /// Stops it and lets go of the canvas and the element.
    pub fn destroy(self) {
        self.runner.destroy();
    }
}

fn options(manners: &Rc<Manners>) -> eframe::WebOptions {
    let (prevent, stop) = (manners.clone(), manners.clone());
    eframe::WebOptions {
        should_prevent_default: Box::new(move |event| match event {
            // The page scrolls on where the panel cannot; with the control key
            // the browser zooms.
            egui::Event::MouseWheel {
                delta, modifiers, ..
            } => {
                let (up, down) = prevent.scrolls.get();
                !modifiers.ctrl && if delta.y > 0.0 { up } else { down }
            }
            egui::Event::Zoom(_) | egui::Event::PointerMoved(_) => false,
            _ => true,
        }),
        // A page has keys of its own; they rest while somebody types here.
        should_stop_propagation: Box::new(move |event| {
            matches!(event, egui::Event::Key { .. } | egui::Event::Text(_)) && stop.typing.get()
        }),
        dithering: false,
        ..eframe::WebOptions::default()
    }
}

fn matches(query: &str) -> bool {
    web_sys::window()
        .and_then(|window| window.match_media(query).ok().flatten())
        .is_some_and(|query| query.matches())
}

/// A finger and a mouse mean different things by a press.
fn press_listener(
    canvas: &HtmlCanvasElement,
    panel: &Rc<RefCell<crate::Panel>>,
) -> Result<Listener, JsValue> {
    let panel = panel.clone();
    Listener::new(canvas, "pointerdown", true, move |event| {
        let finger = event
            .dyn_ref::<PointerEvent>()
            .is_some_and(|event| event.pointer_type() == "touch");
        if let Ok(mut panel) = panel.try_borrow_mut() {
            panel.finger = finger;
        }
    })
}

/// Keeps the Tab key from eframe, so that the browser moves the focus on, and
/// takes canvas and text field out of the Tab order.
fn tab_listeners(canvas: &HtmlCanvasElement) -> Result<Vec<Listener>, JsValue> {
    canvas.set_tab_index(-1);
    let mut listeners = Vec::new();
    if let Some(agent) = text_agent(canvas) {
        agent.set_tab_index(-1);
        agent.set_attribute("aria-hidden", "true")?;
        agent.set_attribute("autocomplete", "off")?;
        listeners.push(leave_tab(&agent)?);
    }
    listeners.push(leave_tab(canvas)?);
    Ok(listeners)
}

/// eframe listens on the element itself, and for those a capturing listener
/// comes first whenever it was added.
fn leave_tab(target: &HtmlElement) -> Result<Listener, JsValue> {
    Listener::new(target, "keydown", true, |event| {
        if event
            .dyn_ref::<KeyboardEvent>()
            .is_some_and(|event| event.key() == "Tab")
        {
            event.stop_immediate_propagation();
        }
    })
}

/// eframe's hidden field, through which text comes; it stands after the canvas.
fn text_agent(canvas: &HtmlCanvasElement) -> Option<HtmlElement> {
    canvas.next_sibling()?.dyn_into().ok()
}
