//! What a film of a fire does with its embers.

use std::cell::RefCell;
use std::rc::Rc;

use hearth_core::looping::Sparks;
use hearth_core::{Instance, Simulation};

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
    /// The film of a fire, at that time \[s\]. Its copy copies another one of it if there is a `known` film: that one
    /// records embers for a loop, or shows those of the loop, of which `looped` has the number of the first picture,
    /// and of all.
    pub fn new(of: u32, known: Option<&Film>, looped: &[usize], time: f64) -> Film {
        Film {
            of,
            embers: match (known, looped) {
                (Some(_), &[start, count]) => Embers::Replaces([start, count]),
                (Some(_), _) => Embers::Records(time),
                (None, _) => Embers::Shows,
            },
            sparks: known.map_or_else(Rc::default, |film| film.sparks.clone()),
        }
    }

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
