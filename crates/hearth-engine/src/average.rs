//! Averages over frames, slow enough for a person to read.

use hearth_bindings::Record;

use crate::stats::numbers;

/// Weight of the newest frame.
const SMOOTHING: f64 = 0.1;

/// The stages of a step, in the order of the core's `Stage`.
const STAGES: [&str; 4] = ["sort", "density", "forces", "integrate"];

/// Times of the stages of steps \[ms\].
pub type StageTimes = [f64; STAGES.len()];

/// What the frames of a fire took and made.
#[derive(Default)]
pub struct Averages {
    /// Time of each stage of a step \[ms\].
    pub step_stages: StageTimes,
    /// Time of sending the particles to the graphics card \[ms\].
    pub upload_ms: f64,
    /// Time of drawing a picture, as the processor sees it \[ms\].
    pub draw_ms: f64,
    /// Steps in a frame.
    pub steps_per_frame: f64,
    /// Length of a step [s of fire].
    pub step_length: f64,
    /// Power of the burning [kW/m].
    pub power: f64,
}

impl Averages {
    /// Forgets what steps took: those of another model say nothing about the next ones.
    pub fn forget_steps(&mut self) {
        self.step_stages = StageTimes::default();
        self.step_length = 0.0;
        self.power = 0.0;
    }

    /// Time of a step \[ms\].
    pub fn step_ms(&self) -> f64 {
        self.step_stages.iter().sum()
    }

    /// Time in a frame of each stage of its steps and of the upload \[ms\].
    pub fn stages(&self) -> Record {
        let mut stages = [("upload", self.upload_ms); STAGES.len() + 1];
        for (at, name) in STAGES.into_iter().enumerate() {
            stages[at] = (name, self.step_stages[at] * self.steps_per_frame);
        }
        numbers(&stages)
    }
}

/// Lets `average` follow what is measured; the first measurement counts fully.
pub fn smooth(average: &mut f64, newest: f64) {
    *average += if *average == 0.0 {
        newest
    } else {
        SMOOTHING * (newest - *average)
    };
}
