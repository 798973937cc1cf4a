//! Moving averages over frames, slow enough to read.

/// Weight of the newest frame.
const NEWEST_WEIGHT: f64 = 0.1;

/// The stages of a step, in the order of the core's `Stage`.
const STAGE_NAMES: [&str; 4] = ["sort", "density", "forces", "integrate"];

/// Time of each stage of a step \[ms\].
pub type StageTimes = [f64; STAGE_NAMES.len()];

/// Averages of a fire.
#[derive(Default)]
pub struct Averages {
    /// Time of each stage of a step \[ms\].
    pub step_stages: StageTimes,
    /// Time of uploading the particles to the graphics card \[ms\].
    pub upload_ms: f64,
    /// Time of drawing a picture on the processor \[ms\].
    pub draw_ms: f64,
    /// Steps in a frame.
    pub steps_per_frame: f64,
    /// Length of a step [s of fire].
    pub step_length: f64,
    /// Power of the combustion [kW/m].
    pub power: f64,
}

impl Averages {
    /// Forgets the steps: another model's steps take another time.
    pub fn forget_steps(&mut self) {
        self.step_stages = StageTimes::default();
        self.step_length = 0.0;
        self.power = 0.0;
    }

    /// Time of a step \[ms\].
    pub fn step_ms(&self) -> f64 {
        self.step_stages.iter().sum()
    }

    /// Time per frame of each stage of its steps, and of the upload \[ms\].
    pub fn stages(&self) -> [(&'static str, f64); STAGE_NAMES.len() + 1] {
        let mut stages = [("upload", self.upload_ms); STAGE_NAMES.len() + 1];
        for (at, name) in STAGE_NAMES.into_iter().enumerate() {
            stages[at] = (name, self.step_stages[at] * self.steps_per_frame);
        }
        stages
    }
}

/// Moves `average` towards the newest measurement. The first measurement counts fully.
pub fn smooth(average: &mut f64, newest: f64) {
    *average += if *average == 0.0 {
        newest
    } else {
        NEWEST_WEIGHT * (newest - *average)
    };
}
