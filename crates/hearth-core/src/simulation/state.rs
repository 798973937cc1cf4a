//! The exact state of a fire.

use super::Simulation;
use super::model::AnySolver;
use crate::params::Model;
use crate::state::{Bytes, State};

impl Simulation {
    /// Appends the exact state of this fire; its scene is not in it.
    pub fn save_state(&self, out: &mut Vec<u8>) {
        match &self.solver {
            AnySolver::Classic(solver) => solver.save(out),
            AnySolver::Combustion(solver) => solver.save(out),
        }
        self.random.save(out);
        self.time.save(out);
        self.seen.save(out);
        self.recorder.save(out);
    }

    /// Continues with the bits of the fire of the same scene whose state this is. `None` changes nothing: the bytes end
    /// early, or are of another model.
    pub fn load_state(&mut self, bytes: &mut Bytes<'_>) -> Option<()> {
        *self = Simulation {
            solver: match self.scene.world().model() {
                Model::Classic => AnySolver::Classic(State::load(bytes)?),
                Model::Combustion => AnySolver::Combustion(State::load(bytes)?),
            },
            random: State::load(bytes)?,
            time: State::load(bytes)?,
            seen: State::load(bytes)?,
            recorder: State::load(bytes)?,
            scene: self.scene.clone(),
        };
        Some(())
    }
}

#[cfg(test)]
mod tests;
