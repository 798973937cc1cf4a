//! The copy of a fire that is filmed.

use std::cell::RefCell;
use std::rc::Rc;

use hearth_core::looping::Sparks;
use hearth_core::{Instance, Simulation};

use super::Fire;
use crate::commands::Start;

/// What is filmed by a copy of a fire.
pub struct Film {
    /// The number of the fire that it copies.
    pub of: u32,
    /// What is done with embers.
    embers: Embers,
    /// The sparks of a loop, which the copies of this copy share with it.
    sparks: Rc<RefCell<Sparks>>,
}

/// What a copy does with its embers.
enum Embers {
    /// It shows them.
    Shows,
    /// It records them, from that time on \[s\].
    Records(f64),
    /// It shows those of a loop instead: number of its first picture, and of its pictures.
    Replaces([usize; 2]),
}

impl Film {
    /// Records the embers of a picture for a loop, or replaces them by those of the loop.
    // An entry of the part `films` of the wasm.
    #[inline(never)]
    pub fn follow(&mut self, fire: &Simulation, embers: &mut Vec<Instance>) {
        let time = fire.time();
        match &mut self.embers {
            Embers::Records(recorded) if time > *recorded => {
                *recorded = time;
                self.sparks.borrow_mut().record(fire, embers);
            }
            Embers::Replaces([start, count]) => {
                self.sparks.borrow().show(time, *start, *count, embers);
            }
            _ => {}
        }
    }
}

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
        let known = self.presentation.film.as_ref();
        let looped: Vec<_> = start
            .values
            .iter()
            .map(|(_, value)| value.number() as usize)
            .collect();
        copy.presentation.film = Some(Box::new(Film {
            of: self.id,
            embers: match (known, &looped[..]) {
                (Some(_), &[start, count]) => Embers::Replaces([start, count]),
                (Some(_), _) => Embers::Records(self.simulation.time()),
                (None, _) => Embers::Shows,
            },
            sparks: known.map_or_else(Rc::default, |film| film.sparks.clone()),
        }));
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
