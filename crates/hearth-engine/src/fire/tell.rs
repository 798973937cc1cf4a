//! What a fire says about itself.

use super::{Fire, STAGES};
use crate::outbox::{Outbox, Stats};
use crate::shared_canvas::SharedCanvas;

impl Fire {
    pub(super) fn tell(&mut self, canvas: &SharedCanvas, out: &mut Outbox) {
        let report = self.simulation.report();
        let passes = self.picture.passes();
        let mut stages = [("upload", self.upload_ms); STAGES.len() + 1];
        for (at, name) in STAGES.into_iter().enumerate() {
            stages[at] = (name, self.stages[at] * self.steps_per_frame);
        }
        let stats = Stats {
            fps: self.fps.fps(),
            particles: self.simulation.count(),
            step_ms: self.stages.iter().sum(),
            draw_ms: self.draw_ms,
            steps_per_frame: self.steps_per_frame,
            substeps: report.substeps,
            neighbours: report.mean_neighbours,
            at_speed_limit: report.speed_limited,
            time: self.simulation.time(),
            paused: !self.playing,
            slowed: self.pace.slowed(),
            time_scale: self.pace.time_scale(),
            step_length: self.step_length,
            power: self.power,
            embers: self.simulation.embers().len(),
            target_format: canvas.target_format(),
            stages,
            passes: passes.map_or(&[], |passes| &passes.times),
            pass_timer: passes.map_or("", |passes| passes.timer()),
            quality: &self.quality,
            limit: self.follows(),
            // Until the display that is wanted is drawn, its colours stand for nothing.
            scale: match self.picture.scale() {
                Some((mode, ends)) if mode == self.wanted.parameters().display_mode => Some(ends),
                _ => None,
            },
        };
        out.stats(self.id, &stats);
    }
}
