//! The beds of all sources.

use super::bed::Bed;
use super::state::Water;
use crate::combustion::fuels::IgnitionTarget;
use crate::random::Random;
use crate::scene::Scene;
use crate::solids::Solids;

impl Water {
    /// Gives each source of a scene its bed.
    pub(super) fn set_beds(&mut self, scene: &Scene, solids: &Solids) {
        let mut count = 0;
        for source in scene.sources() {
            if count == self.beds.len() {
                self.beds.push(Bed::default());
            }
            self.account.run_off += f64::from(self.beds[count].follow(&source, scene, solids));
            count += 1;
        }
        for gone in self.beds.drain(count..) {
            self.account.run_off += f64::from(gone.water);
        }
    }

    /// Boils the water in the beds there, as the flame does that lights a source again. Returns whether
    /// there is a source.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn light(
        &mut self,
        at: IgnitionTarget,
        scene: &Scene,
        solids: &Solids,
        random: &mut Random,
    ) -> bool {
        self.set_beds(scene, solids);
        let mut found = false;
        for bed in &mut self.beds {
            if !bed.is_there(at, solids) {
                continue;
            }
            found = true;
            let steam = std::mem::take(&mut bed.water);
            if steam > 0.0 {
                self.account.boiled += f64::from(steam);
                self.steam
                    .rise(bed.somewhere(random), bed.relative(steam), random);
            }
        }
        found
    }

    /// Whether a source feeds in this step: a bed that is wet in part feeds in so many of all steps.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn feeds(&mut self, index: usize) -> bool {
        self.beds.get_mut(index).is_none_or(Bed::feeds)
    }
}
