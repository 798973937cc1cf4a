//! The clock of the page or worker that the engine runs in.

use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

/// A steady clock.
pub struct WallClock;

impl WallClock {
    /// The time \[ms\].
    pub fn now(&self) -> f64 {
        now()
    }
}
