//! The clock of the page or worker that runs the engine.

use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

/// A monotonic clock.
pub struct WallClock;

impl WallClock {
    /// The current time \[ms\].
    pub fn now(&self) -> f64 {
        now()
    }
}
