//! The sound of a fire: the samples of its frames.

use hearth_core::StepRecord;
use hearth_core::sound::{Mix, Synthesis};

use super::Fire;
use crate::events::Events;

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

impl Fire {
    /// Makes samples of a rate \[Hz\], or none, with gains of roar, crackle and hiss.
    // An entry of the part `sound` of the wasm.
    #[inline(never)]
    pub fn set_sound(&mut self, rate: Option<f64>, gains: [f64; 3]) {
        self.simulation.record_series(rate.is_some());
        let [roar, crackle, hiss] = gains.map(|gain| gain as f32);
        let mix = Mix {
            roar,
            crackle,
            hiss,
            ..Mix::default()
        };
        match (rate, self.sound.as_mut()) {
            (Some(rate), Some(sound)) if sound.rate == rate => sound.synthesis.mix(mix),
            (Some(rate), _) => {
                let seed = self.settings.parameters().seed;
                self.sound = Some(Box::new(Sound {
                    synthesis: Synthesis::new(rate, seed, mix),
                    rate,
                    means: [0.0; 2],
                    ahead: 0.0,
                }));
            }
            (None, _) => self.sound = None,
        }
    }

    /// Posts the samples of a frame of a fire that plays, so many seconds after the last one. Requested steps and those
    /// of a warm-up are silent.
    // An entry of the part `sound` of the wasm.
    #[inline(never)]
    pub(super) fn make_samples(&mut self, passed: Option<f64>, events: &Events) {
        let steps = self.simulation.read_series();
        let half_width = 0.5 * self.settings.parameters().domain_width;
        if let (Some(sound), Some(passed)) = (self.sound.as_mut(), passed) {
            let samples = sound.frame(&steps, passed, half_width);
            if !samples.is_empty() {
                events.samples(self.id, &samples);
            }
        }
    }
}

impl Sound {
    /// The samples of the steps of a frame, so many seconds after the last one: those of the left channel, then of the
    /// right one. A fire that is slower than the clock is played by the clock.
    fn frame(&mut self, steps: &[StepRecord], passed: f64, half_width: f32) -> Vec<f32> {
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
        let frames = (self.synthesis.ahead() * self.rate) as usize;
        let mut samples = vec![0.0; 2 * frames];
        if let Some((left, right)) = samples.split_at_mut_checked(frames) {
            self.synthesis.render(left, right);
        }
        self.ahead += frames as f64 / self.rate - passed;
        self.ahead = self.ahead.clamp(-LONGEST_FRAME, LONGEST_FRAME);
        samples
    }
}
