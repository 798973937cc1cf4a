//! Samples of a fire as fast as its clock.

use hearth_core::StepRecord;
use hearth_core::sound::{Mix, Synthesis};

/// Samples beyond those of the clock, at most and usually \[s\].
const MAX_AHEAD: f64 = 0.05;
/// How much faster or slower the steps are played at most, so that so many samples are ahead.
const MAX_CORRECTION: f64 = 0.1;
/// Share of the last frame in the mean speed.
const NEWEST: f64 = 0.1;
/// Longest frame \[s\].
const LONGEST_FRAME: f64 = 0.3;

/// The sound of one fire.
pub(crate) struct Sound {
    synthesis: Synthesis,
    /// Sample rate \[Hz\].
    rate: f64,
    /// Mean seconds of fire and of the clock in a frame.
    means: [f64; 2],
    /// Seconds of samples beyond those of the clock.
    ahead: f64,
}

impl Sound {
    /// A sound of a rate \[Hz\].
    pub fn new(rate: f64, seed: u32, mix: Mix) -> Sound {
        Sound {
            synthesis: Synthesis::new(rate, seed, mix),
            rate,
            means: [0.0; 2],
            ahead: 0.0,
        }
    }

    /// Sample rate \[Hz\].
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// Sets how loud its parts are.
    pub fn mix(&mut self, mix: Mix) {
        self.synthesis.mix(mix);
    }

    /// The samples of the steps of a frame, so many seconds after the last one: those of the left channel, then of the
    /// right one. A fire that is slower than the clock is played by the clock.
    pub fn frame(&mut self, steps: &[StepRecord], passed: f64, half_width: f32) -> Vec<f32> {
        let passed = passed.min(LONGEST_FRAME);
        let seconds: f64 = steps.iter().map(|step| f64::from(step.length)).sum();
        for (mean, new) in self.means.iter_mut().zip([seconds, passed]) {
            *mean += (new - *mean) * NEWEST;
        }
        let [fire, clock] = self.means;
        let correction = (self.ahead / MAX_AHEAD).clamp(-1.0, 1.0);
        let speed = fire / clock.max(1e-3) * (1.0 + MAX_CORRECTION * correction);
        self.synthesis.push(steps, speed, half_width);
        self.synthesis.trim(LONGEST_FRAME);
        let samples = self.samples();
        self.ahead += 0.5 * samples.len() as f64 / self.rate - passed;
        self.ahead = self.ahead.clamp(-LONGEST_FRAME, LONGEST_FRAME);
        samples
    }

    /// The samples of steps as [`frame`](Sound::frame) returns them, as long as the steps are at a speed.
    pub fn film(&mut self, steps: &[StepRecord], speed: f64, half_width: f32) -> Vec<f32> {
        self.synthesis.push(steps, speed, half_width);
        self.samples()
    }

    /// The samples that are ahead.
    fn samples(&mut self) -> Vec<f32> {
        let frames = (self.synthesis.ahead() * self.rate) as usize;
        let mut samples = vec![0.0; 2 * frames];
        if let Some((left, right)) = samples.split_at_mut_checked(frames) {
            self.synthesis.render(left, right);
        }
        samples
    }
}
