//! What the engine asks of the place it runs in: frames and the time.
//!
//! Both are looked up on `globalThis`, because a worker has no `window`.

use js_sys::{Function, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::Performance;

/// The functions of `globalThis` that the frame loop needs.
pub struct Host {
    request: Function,
    cancel: Function,
    performance: Performance,
}

impl Host {
    /// Looks them up.
    ///
    /// # Errors
    /// The name of what is not there.
    pub fn new() -> Result<Host, String> {
        let global = js_sys::global();
        let look_up = |name: &str| {
            Reflect::get(&global, &name.into())
                .ok()
                .filter(|found| !found.is_undefined())
                .ok_or_else(|| format!("this browser has no {name}"))
        };
        Ok(Host {
            request: look_up("requestAnimationFrame")?.unchecked_into(),
            cancel: look_up("cancelAnimationFrame")?.unchecked_into(),
            performance: look_up("performance")?.unchecked_into(),
        })
    }

    /// The time of a steady clock, in ms.
    pub fn now(&self) -> f64 {
        self.performance.now()
    }

    /// Asks for a frame; the handle withdraws it.
    pub fn request_frame(&self, callback: &JsValue) -> Option<JsValue> {
        self.request.call1(&js_sys::global(), callback).ok()
    }

    /// Withdraws a frame that was asked for.
    pub fn cancel_frame(&self, handle: &JsValue) {
        let _ = self.cancel.call1(&js_sys::global(), handle);
    }
}
