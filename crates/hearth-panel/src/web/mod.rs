//! The panel on a page: a canvas, an element, and eframe between them.
//!
//! [`Panel`] is the whole interface to JavaScript. This module also undoes what eframe does
//! to a page: eframe consumes the wheel and the Tab key, and adds canvas and text field to
//! the Tab order, although `web/panel/accessible-controls.js` serves the keyboard. eframe
//! also takes the focus when it starts, unless its canvas is in no document then.

mod app;
mod element;
mod listener;
mod read;
mod text;

use std::cell::RefCell;
use std::rc::Rc;

use wasm_bindgen::prelude::*;
use web_sys::{HtmlCanvasElement, HtmlElement, KeyboardEvent, PointerEvent};

use self::app::{App, InputPolicy};
use self::element::{Element, paint_soon, read_scene};
use self::listener::Listener;
use self::read::controller_state;
use crate::browser_text;
use crate::theme::{self, Measures};

/// The panel, as a page sees it.
#[wasm_bindgen]
pub struct Panel {
    runner: eframe::WebRunner,
    panel: Rc<RefCell<crate::panel::Panel>>,
    ctx: egui::Context,
    _element: Rc<Element>,
    _listeners: Vec<Listener>,
}

#[wasm_bindgen]
impl Panel {
    /// Starts the panel on `canvas`, the child of a fragment that the caller then adds to its page, for `fire`, a
    /// `<hearth-fire>` element or an object with its API. `controller` is the panel
    /// controller, which executes the commands.
    ///
    /// # Errors
    /// Returns the reason why the panel cannot start, usually missing WebGL.
    pub async fn start(
        canvas: HtmlCanvasElement,
        fire: JsValue,
        controller: JsValue,
    ) -> Result<Panel, JsValue> {
        let measures = if matches("(pointer: coarse)") {
            Measures::COARSE
        } else {
            Measures::FINE
        };
        let mut panel = crate::panel::Panel::new(measures);
        panel.state.device.finger = measures == Measures::COARSE;
        let panel = Rc::new(RefCell::new(panel));
        let policy = Rc::new(InputPolicy::default());
        // Added before eframe's listeners, so that these run first.
        let mut listeners = vec![press_listener(&canvas, &panel)?];

        let runner = eframe::WebRunner::new();
        let started = Rc::new(RefCell::new(None));
        let create: eframe::AppCreator<'static> = {
            let (panel, policy, started) = (panel.clone(), policy.clone(), started.clone());
            let canvas = canvas.clone();
            Box::new(move |creation| {
                let ctx = creation.egui_ctx.clone();
                theme::prefer_contrast(matches("(prefers-contrast: more)"));
                theme::apply(&ctx, text::system_font());
                browser_text::draw_with(&ctx, text::draw);
                let element = Rc::new(Element::new(fire, controller, panel.clone(), ctx.clone())?);
                started.replace(Some((element.clone(), ctx)));
                Ok(Box::new(App::new(panel, element, policy, canvas)))
            })
        };
        runner
            .start(canvas.clone(), options(&policy), create)
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

    /// The rectangle of each visible control: name → `[x, y, width, height]` in CSS pixels from
    /// the upper left corner of the canvas. A parameter's id names its control;
    /// `action:pause`, `action:reset`, `action:step`, `action:undo`, `action:copy:<what>`,
    /// `action:scenes`, `action:restore:<id>` and others name buttons; `value:<id>` is the
    /// value that a click turns into a field, `label:<id>` the name, `choice:<id>:<name>`
    /// one of the choices; `object:<id>` is an object of the list, and `<kind>:<name>` the
    /// control of a property.
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

    /// Scrolls to the row of a parameter, or of a property of the selected object
    /// (`solid:width`), and marks it; or scrolls to copy and paste (`share`), the tools
    /// (`tools`), the quality (`quality`), the objects (`Objects`) or the search (`search`), which
    /// takes the focus. An empty id removes the mark.
    pub fn reveal(&self, id: &str) {
        if let Ok(mut panel) = self.panel.try_borrow_mut() {
            panel.state.reveal(id);
        }
        paint_soon(&self.ctx);
    }

    /// Takes the state of the panel controller: an object with the fields of
    /// [`crate::state::ControllerState`].
    pub fn update(&self, state: JsValue) {
        if let Ok(mut panel) = self.panel.try_borrow_mut() {
            panel.state.controller = controller_state(&state);
            read_scene(&mut panel, &state);
        }
        paint_soon(&self.ctx);
    }

    /// The value of the row under the pointer and its label, for the clipboard; undefined
    /// without a row under the pointer or while a text field has the focus.
    pub fn hovered(&self) -> Option<Vec<String>> {
        let panel = self.panel.try_borrow().ok()?;
        if panel.is_typing(&self.ctx) {
            return None;
        }
        let (value, label) = panel.hovered_value()?;
        Some(vec![value, label.to_owned()])
    }

    /// What the row under a resting pointer is about, its top and its height in CSS pixels;
    /// undefined without one.
    pub fn tooltip(&self) -> Option<js_sys::Array> {
        let panel = self.panel.try_borrow().ok()?;
        let (text, row) = panel.tooltip()?;
        let text = JsValue::from_str(text);
        let place = [row.top(), row.height()].map(|x| JsValue::from_f64(x.into()));
        Some(std::iter::once(text).chain(place).collect())
    }

    /// Repaints soon, after the page has changed the canvas's resolution.
    pub fn repaint(&self) {
        paint_soon(&self.ctx);
    }

    /// Stops the panel and releases the canvas and the element.
    pub fn destroy(self) {
        self.runner.destroy();
    }
}

fn options(policy: &Rc<InputPolicy>) -> eframe::WebOptions {
    let (prevent, stop) = (policy.clone(), policy.clone());
    eframe::WebOptions {
        should_prevent_default: Box::new(move |event| match event {
            // The page scrolls if the panel cannot. With the control key the browser zooms.
            egui::Event::MouseWheel {
                delta, modifiers, ..
            } => {
                let (up, down) = prevent.scrolls.get();
                !modifiers.ctrl && if delta.y > 0.0 { up } else { down }
            }
            egui::Event::Zoom(_) | egui::Event::PointerMoved(_) => false,
            _ => true,
        }),
        // The page's shortcuts do not work while a text field has the focus.
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

/// Records whether a press comes from a finger, which drags and scrolls differently.
fn press_listener(
    canvas: &HtmlCanvasElement,
    panel: &Rc<RefCell<crate::panel::Panel>>,
) -> Result<Listener, JsValue> {
    let panel = panel.clone();
    Listener::new(canvas, "pointerdown", true, move |event| {
        let finger = event
            .dyn_ref::<PointerEvent>()
            .is_some_and(|event| event.pointer_type() == "touch");
        if let Ok(mut panel) = panel.try_borrow_mut() {
            panel.state.device.finger = finger;
        }
    })
}

/// Hides the Tab key from eframe, so that the browser moves the focus, and removes canvas
/// and text field from the Tab order.
fn tab_listeners(canvas: &HtmlCanvasElement) -> Result<Vec<Listener>, JsValue> {
    canvas.set_tab_index(-1);
    let mut listeners = Vec::new();
    if let Some(agent) = text_agent(canvas) {
        agent.set_tab_index(-1);
        agent.remove_attribute("autofocus")?;
        // eframe places it by coordinates of the window.
        agent.style().set_property("position", "fixed")?;
        agent.set_attribute("aria-hidden", "true")?;
        agent.set_attribute("autocomplete", "off")?;
        listeners.push(leave_tab(&agent)?);
    }
    listeners.push(leave_tab(canvas)?);
    Ok(listeners)
}

/// eframe listens on the element itself, where capturing listeners run first.
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

/// eframe's hidden text field, the sibling of the canvas.
fn text_agent(canvas: &HtmlCanvasElement) -> Option<HtmlElement> {
    canvas.next_sibling()?.dyn_into().ok()
}
