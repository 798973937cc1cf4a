//! The series of steps that sound follows from.

use super::Simulation;
use crate::combustion::Combustion;
use crate::params::Backdrop;
use crate::series::{Recorder, StepRecord};

/// Width of a source up to which it is a nozzle \[m\].
const MAX_NOZZLE_WIDTH: f32 = 0.12;

impl Simulation {
    /// Starts to record each part of a step, or ends that. A fire that is not recorded takes no time or memory for it. The
    /// record of a fire changes none of its bits.
    pub fn record_series(&mut self, on: bool) {
        if on != self.recorder.is_some() {
            self.recorder = on.then(|| Box::new(Recorder::new(self.solver.totals())));
        }
    }

    /// The parts of steps since the last call, if they are [recorded](Simulation::record_series). Where more than 2048 wait,
    /// the older ones are dropped.
    ///
    /// ```
    /// # use hearth_core::{Parameters, Simulation};
    /// let mut fire = Simulation::new(Parameters::default());
    /// fire.record_series(true);
    /// for _ in 0..100 {
    ///     fire.step();
    /// }
    /// let seconds: f32 = fire.read_series().iter().map(|step| step.length).sum();
    /// assert!((f64::from(seconds) - fire.time()).abs() < 1e-4);
    /// ```
    pub fn read_series(&mut self) -> Vec<StepRecord> {
        let recorder = self.recorder.as_mut();
        recorder.map_or_else(Vec::new, |recorder| {
            let steps = recorder.steps();
            recorder.clear();
            steps
        })
    }

    /// All numbers of one such step, then of the next, for bindings.
    pub fn series_numbers(&mut self) -> Vec<f32> {
        let recorder = self.recorder.as_mut();
        recorder.map_or_else(Vec::new, |recorder| {
            let numbers = recorder.numbers().to_vec();
            recorder.clear();
            numbers
        })
    }

    /// Records the parts of a step of a length \[s\]; the first has its events.
    // An entry of the part `sound` of the wasm.
    #[inline(never)]
    pub(super) fn record(&mut self, length: f64) {
        if let Some(recorder) = self.recorder.as_mut() {
            let powers = self
                .solver
                .combustion()
                .map_or(&[0.0][..], Combustion::powers);
            let burns = powers.iter().any(|&power| power > 0.0);
            let (mut jet, mut flutter) = (0.0_f32, 0.0_f32);
            let burning = self.scene.sources().filter(|_| burns);
            for source in burning.filter(|source| source.power > 0.0) {
                if source.width <= MAX_NOZZLE_WIDTH {
                    jet = jet.max(source.speed);
                } else {
                    let speed = source.speed.max(source.world.wind.abs());
                    flutter = flutter.max(speed / source.width);
                }
            }
            let wall = f32::from(u8::from(self.scene.world().backdrop != Backdrop::None));
            let part = length as f32 / powers.len() as f32;
            for &power in powers {
                recorder.add([part, power, jet, flutter, wall], self.solver.totals());
            }
        }
    }
}
