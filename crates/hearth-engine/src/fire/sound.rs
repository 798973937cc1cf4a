//! The sound of a fire: the samples of its frames.

use hearth_core::sound::Mix;

use super::Fire;
use crate::events::Events;
use crate::sound::Sound;

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
            (Some(rate), Some(sound)) if sound.rate() == rate => sound.mix(mix),
            (Some(rate), _) => {
                let seed = self.settings.parameters().seed;
                self.sound = Some(Box::new(Sound::new(rate, seed, mix)));
            }
            (None, _) => self.sound = None,
        }
    }

    /// Posts the samples of a frame of a fire that plays, so many seconds after the last one, or of the requested steps of
    /// a film. Other requested steps and those of a warm-up are silent.
    // An entry of the part `sound` of the wasm.
    #[inline(never)]
    pub(super) fn make_samples(&mut self, passed: Option<f64>, events: &Events) {
        let steps = self.simulation.read_series();
        let values = self.settings.parameters();
        let half_width = 0.5 * values.domain_width;
        let samples = match (self.sound.as_mut(), passed) {
            (Some(sound), _) if self.presentation.film.is_some() => {
                sound.film(&steps, values.time_scale.into(), half_width)
            }
            (Some(sound), Some(passed)) => sound.frame(&steps, passed, half_width),
            _ => return,
        };
        if !samples.is_empty() {
            events.samples(self.id, &samples);
        }
    }
}
