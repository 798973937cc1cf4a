//! What the engine asks of the place it runs in: frames and the time.
//!
//! Both are globals, of a page and of a worker, which has no `window`.

use js_sys::Reflect;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_name = requestAnimationFrame)]
    fn request(callback: &JsValue) -> u32;

    #[wasm_bindgen(js_name = cancelAnimationFrame)]
    fn cancel(handle: u32);

    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

/// The globals that the frame loop needs.
pub struct Host(());

impl Host {
    /// Looks for them.
    ///
    /// # Errors
    /// The name of what is not there.
    pub fn new() -> Result<Host, String> {
        let global = js_sys::global();
        for name in ["requestAnimationFrame", "performance"] {
            if !Reflect::has(&global, &name.into()).unwrap_or(false) {
                return Err(format!("this browser has no {name}"));
            }
        }
        Ok(Host(()))
    }

    /// The time of a steady clock, in ms.
    pub fn now(&self) -> f64 {
        now()
    }

    /// Asks for a frame; the handle withdraws it.
    pub fn request_frame(&self, callback: &JsValue) -> u32 {
        request(callback)
    }

    /// Withdraws a frame that was asked for.
    pub fn cancel_frame(&self, handle: u32) {
        cancel(handle);
    }
}
