//! The copy of a fire that is filmed.

use super::Fire;
use super::film::Film;
use crate::commands::Start;

impl Fire {
    /// A copy with that number for a film, invisible and without a size. This fire waits until it [goes on](Fire::go_on).
    // An entry of the part `films` of the wasm.
    #[inline(never)]
    pub fn film(&mut self, id: u32, start: &Start<'_>, on_page: bool) -> Fire {
        self.waits = true;
        let mut copy = Fire {
            simulation: self.simulation.clone(),
            ..Fire::new(id, self.settings.clone(), start, on_page)
        };
        let known = self.presentation.film.as_deref();
        let values = start.values.iter();
        let looped: Vec<_> = values.map(|(_, value)| value.number() as usize).collect();
        let film = Film::new(self.id, known, &looped, self.simulation.time());
        copy.presentation.film = Some(Box::new(film));
        // Without sound, its part of the wasm may be missing.
        if self.sound.is_some() {
            copy.simulation.record_series(false);
        }
        copy.playback.copy(&self.playback);
        copy.presentation.copy(&self.presentation);
        copy.pacing.copy(&self.pacing);
        copy
    }
}
