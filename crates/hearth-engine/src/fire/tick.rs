//! A frame of a fire: its due steps and its picture.

use std::cell::Cell;

use super::Fire;
use super::playback::Due;
use super::presentation::Presentation;
use crate::events::{ErrorKind, Events};
use crate::pacing::averages::{StageTimes, smooth};
use crate::pacing::quality::FrameCost;
use crate::pacing::thread_budget::make_steps;
use crate::shared_canvas::SharedCanvas;
use crate::stats;
use crate::wall_clock::WallClock;
use hearth_core::resolution::Resolution;

/// The time of a frame.
#[derive(Clone, Copy, Debug)]
pub struct FrameTime {
    /// Time of the frame \[ms\].
    pub now: f64,
    /// Time after which no step begins \[ms\].
    pub deadline: f64,
    /// Number of fires that share it.
    pub fires: usize,
    /// Share of the thread that the engine takes.
    pub share: f64,
}

/// Interval between two posts of statistics \[ms\].
const STATS_INTERVAL_MS: f64 = 250.0;

/// The steps of a frame.
#[derive(Default)]
struct StepsMade {
    /// Number of steps.
    steps: u32,
    /// Total length [s of fire].
    seconds: f64,
    /// Time of each stage \[ms\].
    stages: StageTimes,
    /// Number of steps that were due by the clock.
    played: u32,
    /// Length of those [s of fire].
    played_seconds: f64,
}

impl Fire {
    /// Makes the due steps of a frame and draws the picture. Returns the time of drawing \[ms\].
    pub fn frame(
        &mut self,
        time: FrameTime,
        canvas: &SharedCanvas,
        clock: &WallClock,
        events: &Events,
    ) -> f64 {
        let now = time.now;
        let scale = f64::from(self.settings.parameters().time_scale);
        let can_draw = self.presentation.can_draw();
        // The warm-up comes before requested steps.
        let warms = self.playback.is_warming()
            && (can_draw || self.playback.requests.next_open().is_some());
        if warms && self.playback.starts {
            self.begin_warm_up(events);
        }
        let playback = &mut self.playback;
        let plays = playback.playing && can_draw && !playback.is_warming();
        let passed = plays.then(|| playback.clock.advance(now / 1000.0, scale));

        let made = self.make_steps(plays, warms, time.deadline, clock);
        if made.steps > 0 {
            self.count_steps(&made, events);
        }
        if self.sound.is_some() {
            self.make_samples(passed, events);
        }
        if let Some(passed) = passed {
            let dropped = self.playback.drop_rest();
            let pacing = &mut self.pacing;
            pacing
                .real_time
                .frame(passed, scale, made.played_seconds, dropped);
            smooth(&mut pacing.averages.steps_per_frame, f64::from(made.played));
        }
        self.playback.requests.close();

        // Pictures between requested steps are not shown.
        let warming = self.playback.is_warming();
        let drawn = self.presentation.needs_picture()
            && self.playback.requests.is_empty()
            && self.presentation.can_draw()
            && !warming;
        let scale_before = self.presentation.renderer.scale();
        let draw_ms = if drawn {
            self.draw(canvas, clock, events)
        } else {
            0.0
        };
        // A new scale of the colours is posted with its picture.
        let rescaled = self.presentation.renderer.scale() != scale_before;
        let since = &mut self.pacing.since_picture;
        since.steps_ms += made.stages.iter().sum::<f64>();
        since.simulated += made.played_seconds;
        if plays && made.steps != made.played {
            // The times of requested steps do not predict those of due steps.
            self.pacing.skip_work();
        } else if plays && drawn {
            self.pace(time, draw_ms, events);
        }
        let paused = !self.playback.playing;
        let reports = (drawn && paused) || rescaled || now - self.stats_at >= STATS_INTERVAL_MS;
        if reports && self.films().is_none() {
            self.stats_at = now;
            events.stats(self.id, &stats::of(self, canvas));
        }
        // The answer to a step request follows its picture and statistics.
        let requests = &mut self.playback.requests;
        let shown = !warming && (self.presentation.current || !requests.is_empty());
        if !self.presentation.can_draw() || shown {
            for request in requests.answers() {
                events.done(self.id, request);
            }
        }
        draw_ms
    }

    /// Makes the steps of the warm-up, the requested steps and, if it `plays`, the steps due by
    /// the clock, until `deadline`.
    fn make_steps(
        &mut self,
        plays: bool,
        warms: bool,
        deadline: f64,
        clock: &WallClock,
    ) -> StepsMade {
        // The first moment of a fire is a sample, drawn or not.
        self.presentation.history.follow(&self.simulation);
        let mut made = StepsMade::default();
        let last = Cell::new(clock.now());
        let steps = make_steps(
            || last.get() < deadline,
            || {
                let simulation = &mut self.simulation;
                let Some(due) = self.playback.due(warms, plays, simulation.time()) else {
                    return false;
                };
                let length = self.playback.step(due, simulation, &mut |stage| {
                    let now = clock.now();
                    made.stages[stage as usize] += now - last.replace(now);
                });
                self.presentation.history.follow(simulation);
                made.seconds += length;
                match due {
                    Due::WarmUp => {
                        if self.playback.warm_up.advance(length) {
                            let scene = self.scene();
                            self.simulation.set_scene(scene);
                        }
                        if !self.playback.warm_up.is_on() {
                            self.restart_clock();
                        }
                    }
                    Due::Request(_) => {
                        if let Some(request) = self.playback.requests.next_open() {
                            request.take(simulation.time());
                        }
                    }
                    Due::Clock => {
                        self.playback.clock.spend(length);
                        made.played += 1;
                        made.played_seconds += length;
                    }
                }
                true
            },
        );
        StepsMade { steps, ..made }
    }

    /// Adds steps to the averages, and adapts the number of particles to their time.
    fn count_steps(&mut self, made: &StepsMade, events: &Events) {
        let steps = f64::from(made.steps);
        let averages = &mut self.pacing.averages;
        for (average, stage) in averages.step_stages.iter_mut().zip(made.stages) {
            smooth(average, stage / steps);
        }
        smooth(&mut averages.step_length, made.seconds / steps);
        let power = self.simulation.power().map_or(0.0, f64::from);
        smooth(&mut averages.power, power);
        self.presentation.current = false;
        let resolution = self.settings.resolution();
        // The time of a step decides nothing of a film.
        if resolution == Resolution::Level || self.films().is_some() {
            return;
        }
        // Open air has fewer particles than would fill its domain, and the limit is one of those.
        let values = self.simulation.parameters();
        let count = match values.has_open_edges() {
            true => values.domain_particles() as usize,
            false => self.simulation.count(),
        };
        let step = made.stages.iter().sum::<f64>() / steps;
        if self
            .pacing
            .limit_particles(step, count, resolution.number())
        {
            events.quality(self.id, &self.pacing.quality);
            self.adapt();
        }
    }

    /// Draws the picture. Returns the time of drawing \[ms\].
    fn draw(&mut self, canvas: &SharedCanvas, clock: &WallClock, events: &Events) -> f64 {
        let start = clock.now();
        let drawn = self.presentation.draw(
            self.id,
            &self.simulation,
            &self.pacing.quality,
            !self.playback.playing,
            canvas,
            clock,
        );
        let averages = &mut self.pacing.averages;
        match drawn {
            Ok(uploaded) => {
                smooth(&mut averages.upload_ms, uploaded - start);
                if self.presentation.lights {
                    events.lights(self.id, &self.presentation.light_numbers(&self.simulation));
                }
            }
            Err(message) => events.error(self.id, ErrorKind::Unsupported, &message),
        }
        let took = clock.now() - start;
        smooth(&mut averages.draw_ms, took);
        took
    }

    /// Adapts the quality to what a picture that was drawn in `draw_ms` and its steps cost.
    fn pace(&mut self, time: FrameTime, draw_ms: f64, events: &Events) {
        let Presentation {
            renderer,
            limits,
            size,
            ..
        } = &self.presentation;
        let pacing = &mut self.pacing;
        pacing.fps.frame(time.now / 1000.0);
        let since = std::mem::take(&mut pacing.since_picture);
        let gpu_ms = renderer.passes().map_or(0.0, |passes| passes.gpu_ms());
        let cost = FrameCost {
            now: time.now,
            min_interval: limits.min_interval(),
            steps_ms: since.steps_ms,
            simulated: since.simulated,
            draw_ms: if gpu_ms > draw_ms { gpu_ms } else { draw_ms },
            pixels: match limits.pixels {
                Some(_) => None,
                None => Some(f64::from(size.0) * f64::from(size.1)),
            },
            time_scale: f64::from(self.settings.parameters().time_scale),
            slowed: pacing.real_time.slowed(),
            particles: pacing.counts_of_levels(self.settings.resolution()),
            fires: time.fires,
            share: time.share,
        };
        if pacing.quality.frame(&cost) {
            events.quality(self.id, &pacing.quality);
            // Another level has other costs.
            pacing.real_time.forget_losses();
            self.adapt();
        }
    }
}
