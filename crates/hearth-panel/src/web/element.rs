//! The `<hearth-fire>` element, read through its public API, and the panel controller
//! (`web/panel/controller.js`): both execute commands.
//!
//! The controller's methods return promises; the element's events report changes. A page
//! may pass another object with the same API, so no class is checked, and a missing
//! property or one of the wrong type counts as empty.

use std::cell::RefCell;
use std::rc::{Rc, Weak};
use std::time::Duration;

use hearth_core::params::{PARAMETERS, Param};
use js_sys::{Array, Function, Promise, Reflect};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{CustomEvent, Event, EventTarget};

use crate::panel::Panel;
use crate::state::{Command, MODEL, Owner, Subject};
use crate::web::listener::Listener;
use crate::web::read::{objects, property, stats, text, to_js, value_of};

/// Time between two repaints for new measurements alone. Without a graphics card, painting blocks the page.
const STATS_INTERVAL: Duration = Duration::from_secs(1);

/// The fire and the panel controller, as objects of JavaScript.
pub struct Element {
    fire: JsValue,
    controller: JsValue,
    panel: Rc<RefCell<Panel>>,
    ctx: egui::Context,
    _listeners: Vec<Listener>,
}

impl Element {
    /// Reads all properties and listens to the events.
    pub fn new(
        fire: JsValue,
        controller: JsValue,
        panel: Rc<RefCell<Panel>>,
        ctx: egui::Context,
    ) -> Result<Element, String> {
        let unlistenable = |_| "the fire dispatches no events".to_owned();
        let target: &EventTarget = fire.unchecked_ref();
        let mut listeners = Vec::new();
        let names = [
            "params-change",
            "objects-change",
            "quality-change",
            "stats",
            "play",
            "pause",
            "ready",
            "restored",
            "error",
        ];
        for name in names {
            let (fire, panel, ctx) = (fire.clone(), Rc::downgrade(&panel), ctx.clone());
            let on_event = move |event: Event| {
                if let Some(panel) = panel.upgrade()
                    && let Ok(mut panel) = panel.try_borrow_mut()
                {
                    receive(&mut panel, &fire, name, &event);
                    if name == "stats" {
                        ctx.request_repaint_after(STATS_INTERVAL);
                    } else {
                        paint_soon(&ctx);
                    }
                }
            };
            listeners.push(Listener::new(target, name, false, on_event).map_err(unlistenable)?);
        }
        let element = Element {
            fire,
            controller,
            panel,
            ctx,
            _listeners: listeners,
        };
        if let Ok(mut panel) = element.panel.try_borrow_mut() {
            read_controller(&mut panel, &element.controller);
            read_all(&mut panel, &element.fire);
        }
        Ok(element)
    }

    /// Sends a command. Events report its effect; a refusal is shown in the parameter's row.
    pub fn send(&self, command: Command) {
        let row = match &command {
            Command::Set(subject, _) => Some(*subject),
            _ => None,
        };
        if let (Some(subject), Ok(mut panel)) = (row, self.panel.try_borrow_mut()) {
            panel.state.fire.sent(subject);
        }
        let answer = self.call(command);
        let (fire, panel) = (self.fire.clone(), Rc::downgrade(&self.panel));
        let ctx = self.ctx.clone();
        spawn_local(async move {
            let refusal = match answer {
                Ok(answer) => JsFuture::from(Promise::resolve(&answer)).await.err(),
                Err(error) => Some(error),
            };
            settle(&panel, &fire, row, refusal);
            paint_soon(&ctx);
        });
    }

    fn call(&self, command: Command) -> Result<JsValue, JsValue> {
        let (method, arguments): (&str, Vec<JsValue>) = match command {
            Command::Set(subject, entry) => match subject.object {
                None => ("set", vec![subject.id.into(), to_js(entry)]),
                Some(Owner { id, property, .. }) => {
                    ("change", vec![id.into(), property.into(), to_js(entry)])
                }
            },
            Command::Restore(subject) => match subject.object {
                None => ("restore", vec![subject.id.into()]),
                Some(Owner { id, property, .. }) => {
                    ("restoreProperty", vec![id.into(), property.into()])
                }
            },
            Command::Add(kind) => ("add", vec![kind.into()]),
            Command::Duplicate(id) => ("duplicate", vec![id.into()]),
            Command::Remove(id) => ("remove", vec![id.into()]),
            Command::Order(id, front) => ("order", vec![id.into(), front.into()]),
            Command::Act(name, id) => ("act", vec![name.into(), id.into()]),
            Command::Select(id) => ("select", vec![id.into()]),
            Command::Remember(memory) => {
                let folded: Array = memory.folded.into_iter().map(JsValue::from_str).collect();
                ("rememberFolds", vec![folded.into(), memory.times.into()])
            }
            Command::RestoreAll => ("restoreAll", vec![]),
            Command::Quality(name) => ("quality", vec![name.into()]),
            Command::Copy(what) => ("copy", vec![what.into()]),
            Command::Compare(letter) => ("compare", vec![letter.into()]),
            Command::Randomise(strength) => ("randomise", vec![strength.into()]),
            Command::Scenes => ("scenes", vec![]),
            Command::Play => ("play", vec![]),
            Command::Pause => ("pause", vec![]),
            Command::Reset => ("reset", vec![]),
            Command::Step => ("step", vec![]),
            Command::Undo => ("undo", vec![]),
            Command::Redo => ("redo", vec![]),
            Command::Paste => ("paste", vec![]),
            Command::Picture => ("picture", vec![]),
            Command::Fullscreen => ("fullscreen", vec![]),
            Command::Help => ("help", vec![]),
        };
        let receiver = match method {
            "play" | "pause" | "reset" | "step" => self.fire.clone(),
            _ => self.controller.clone(),
        };
        let function: Function = Reflect::get(&receiver, &method.into())?.dyn_into()?;
        function.apply(&receiver, &arguments.into_iter().collect())
    }
}

/// Handles the answer to a command: shows its error and reads the present values. A command that
/// sets a value has a row.
fn settle(
    panel: &Weak<RefCell<Panel>>,
    fire: &JsValue,
    row: Option<Subject>,
    refusal: Option<JsValue>,
) {
    let Some(panel) = panel.upgrade() else { return };
    let Ok(mut panel) = panel.try_borrow_mut() else {
        return;
    };
    let refusal = refusal.map(|error| text(&error, "message").unwrap_or_default());
    match row {
        Some(subject) => {
            match panel.state.fire.answered(subject) {
                true if subject.object.is_some() => read_objects(&mut panel, fire),
                true => {
                    let value = property(&property(fire, "params"), subject.id);
                    receive_value(&mut panel, fire, subject.id, &value);
                }
                false => {}
            }
            if let Some(refusal) = refusal {
                panel.state.fire.refusals.insert(subject.id, refusal);
            }
        }
        None => {
            read_all(&mut panel, fire);
            if let Some(refusal) = refusal {
                panel.state.fire.notice = Some(refusal);
            }
        }
    }
}

fn receive(panel: &mut Panel, fire: &JsValue, name: &str, event: &Event) {
    let detail = event
        .dyn_ref::<CustomEvent>()
        .map_or(JsValue::UNDEFINED, CustomEvent::detail);
    match name {
        "stats" => {
            let stats = stats(&property(fire, "stats"));
            panel.state.fire.measure(stats);
            panel.state.fire.quality = text(fire, "quality").unwrap_or_default();
            panel.state.fire.paused = property(fire, "paused").is_truthy();
        }
        "params-change" => {
            if let Some(id) = text(&detail, "id") {
                receive_value(panel, fire, &id, &property(&detail, "value"));
            }
        }
        "objects-change" => read_objects(panel, fire),
        "quality-change" => {
            panel.state.fire.quality = text(fire, "quality").unwrap_or_default();
            panel.state.fire.stats.quality = text(&detail, "quality").unwrap_or_default();
            panel.state.fire.stats.reason = text(&detail, "reason").unwrap_or_default();
        }
        "play" => panel.state.fire.paused = false,
        "pause" => panel.state.fire.paused = true,
        "error" => {
            let message = text(&detail, "message").unwrap_or_default();
            let id = text(&detail, "id");
            let known = PARAMETERS
                .iter()
                .find(|param| Some(param.id) == id.as_deref());
            match known {
                Some(param) => {
                    panel.state.fire.refusals.insert(param.id, message);
                }
                None => panel.state.fire.notice = Some(message),
            }
        }
        _ => {
            panel.state.fire.notice = None;
            read_all(panel, fire);
        }
    }
}

/// Takes a value of the fire. A change of the model changes other values too, without
/// events for them.
fn receive_value(panel: &mut Panel, fire: &JsValue, id: &str, value: &JsValue) {
    if id == MODEL {
        read_values(panel, fire);
    } else {
        receive_entry(panel, id, value);
    }
}

/// Reads the selected parameters and what persists from the last visit.
fn read_controller(panel: &mut Panel, controller: &JsValue) {
    let only = property(controller, "only");
    if let Some(ids) = only.dyn_ref::<Array>() {
        let ids = ids.iter().filter_map(|id| id.as_string());
        panel.state.only = Some(ids.filter_map(|id| Param::find(&id)).collect());
    }
    let memory = property(controller, "folds");
    if let Some(folded) = property(&memory, "folded").dyn_ref::<Array>() {
        let names: Vec<String> = folded.iter().filter_map(|name| name.as_string()).collect();
        panel.state.memory.fold(names.iter().map(String::as_str));
    }
    panel.state.memory.times = property(&memory, "times").is_truthy();
}

/// Takes the values and the objects of the scene that the fire started from, and the selection,
/// from the state of the panel controller.
pub(super) fn read_scene(panel: &mut Panel, state: &JsValue) {
    let values = &property(state, "values");
    let selected = property(state, "selected").as_f64();
    panel.state.selected = selected.map(|id| id as u32);
    let of = |param: &'static Param| Some((param.id, value_of(&property(values, param.id))?));
    let values: Vec<_> = PARAMETERS.iter().filter_map(of).collect();
    panel.state.fire.start_from(
        values.iter().map(|(id, value)| (*id, value.input())),
        objects(&property(state, "objects")).as_deref(),
    );
}

fn read_values(panel: &mut Panel, fire: &JsValue) {
    let values = property(fire, "params");
    for param in PARAMETERS {
        receive_entry(panel, param.id, &property(&values, param.id));
    }
    // The model decides which properties objects have.
    read_objects(panel, fire);
}

fn read_objects(panel: &mut Panel, fire: &JsValue) {
    if let Some(objects) = objects(&property(fire, "objects")) {
        panel.state.fire.receive_objects(&objects);
    }
}

fn read_all(panel: &mut Panel, fire: &JsValue) {
    read_values(panel, fire);
    panel.state.fire.paused = property(fire, "paused").is_truthy();
    panel.state.fire.quality = text(fire, "quality").unwrap_or_default();
    panel.state.fire.stats = stats(&property(fire, "stats"));
}

fn receive_entry(panel: &mut Panel, id: &str, value: &JsValue) {
    if let Some(entry) = value_of(value) {
        panel.state.fire.receive(id, entry.input());
    }
}

/// Repaints once: `request_repaint` paints two frames.
pub(super) fn paint_soon(ctx: &egui::Context) {
    ctx.request_repaint_after(Duration::from_millis(1));
}
