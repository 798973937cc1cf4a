//! What the engine asks of the place it runs in: the time.
//!
//! It is a global, of a page and of a worker, which has no `window`.

use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

/// The globals that a fire needs.
pub struct Host;

impl Host {
    /// The time of a steady clock, in ms.
    pub fn now(&self) -> f64 {
        now()
    }
}
