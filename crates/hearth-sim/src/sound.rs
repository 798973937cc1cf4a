//! The sound behind `web/sound.js`, which checks the values.

use hearth_core::StepRecord;
use hearth_core::sound::{self, Mix};
use wasm_bindgen::prelude::wasm_bindgen;

/// The sound of one fire.
#[wasm_bindgen]
pub struct Synthesis(sound::Synthesis);

#[wasm_bindgen]
impl Synthesis {
    /// Silence, with a sample rate \[Hz\], a seed, a volume, and gains of roar, crackle and hiss.
    #[wasm_bindgen(constructor)]
    pub fn new(rate: f64, seed: u32, volume: f32, roar: f32, crackle: f32, hiss: f32) -> Synthesis {
        let mix = Mix {
            volume,
            roar,
            crackle,
            hiss,
        };
        Synthesis(sound::Synthesis::new(rate, seed, mix))
    }

    /// Fades to another mix.
    pub fn mix(&mut self, volume: f32, roar: f32, crackle: f32, hiss: f32) {
        self.0.mix(Mix {
            volume,
            roar,
            crackle,
            hiss,
        });
    }

    /// Seconds of the clock for which there are samples.
    pub fn ahead(&self) -> f64 {
        self.0.ahead()
    }

    /// Drops the oldest steps beyond so many seconds of the clock.
    pub fn trim(&mut self, seconds: f64) {
        self.0.trim(seconds);
    }

    /// Takes the next steps of the series: all numbers of one, then of the next.
    pub fn push(&mut self, series: &[f32], speed: f64, half_width: f32) {
        for numbers in series.as_chunks().0 {
            self.0.push(&[StepRecord::of(*numbers)], speed, half_width);
        }
    }

    /// So many samples of the left channel, then of the right one.
    pub fn render(&mut self, frames: usize) -> Vec<f32> {
        let mut samples = vec![0.0; 2 * frames];
        if let Some((left, right)) = samples.split_at_mut_checked(frames) {
            self.0.render(left, right);
        }
        samples
    }
}
