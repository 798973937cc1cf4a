//! An event listener that is removed on drop.

use wasm_bindgen::prelude::*;
use web_sys::{Event, EventTarget};

/// A listener, removed on drop.
#[derive(Debug)]
pub struct Listener {
    target: EventTarget,
    name: &'static str,
    capture: bool,
    closure: Closure<dyn FnMut(Event)>,
}

impl Listener {
    /// Listens for `name` on `target`.
    pub fn new(
        target: &EventTarget,
        name: &'static str,
        capture: bool,
        on_event: impl FnMut(Event) + 'static,
    ) -> Result<Listener, JsValue> {
        let closure = Closure::<dyn FnMut(Event)>::new(on_event);
        target.add_event_listener_with_callback_and_bool(
            name,
            closure.as_ref().unchecked_ref(),
            capture,
        )?;
        Ok(Listener {
            target: target.clone(),
            name,
            capture,
            closure,
        })
    }
}

impl Drop for Listener {
    fn drop(&mut self) {
        // An error means that the target has no such listener any more.
        let _ = self.target.remove_event_listener_with_callback_and_bool(
            self.name,
            self.closure.as_ref().unchecked_ref(),
            self.capture,
        );
    }
}
