//! A frame of a fire: its due steps and its picture.

use std::cell::Cell;

use glam::Vec2;
use hearth_core::params::DisplayMode;
use hearth_core::{Simulation, Stage};
use hearth_render::ResolutionLimits;

use super::{Fire, FrameTime, SincePicture};
use crate::events::{ErrorKind, Events};
use crate::fire_renderer::FrameInput;
use crate::pacing::averages::{StageTimes, smooth};
use crate::pacing::quality::FrameCost;
use crate::pacing::thread_budget::make_steps;
use crate::pointer::PointerForce;
use crate::shared_canvas::SharedCanvas;
use crate::stats;
use crate::wall_clock::WallClock;

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
        // The warm-up comes before requested steps.
        let warms =
            self.is_warming() && (self.can_draw() || self.step_requests.next_open().is_some());
        if warms && self.starts {
            self.begin_warm_up(events);
        }
        let passed = if self.playing && self.can_draw() && !self.is_warming() {
            Some(self.clock.advance(now / 1000.0, scale))
        } else {
            None
        };

        let made = self.make_steps(passed.is_some(), warms, time.deadline, clock);
        if made.steps > 0 {
            let steps = f64::from(made.steps);
            for (average, stage) in self.averages.step_stages.iter_mut().zip(made.stages) {
                smooth(average, stage / steps);
            }
            smooth(&mut self.averages.step_length, made.seconds / steps);
            let power = self.simulation.power().map_or(0.0, f64::from);
            smooth(&mut self.averages.power, power);
            self.stale = true;
            self.measure(made.stages.iter().sum::<f64>() / steps, events);
        }
        let series = self.simulation.series_numbers();
        if let Some(passed) = passed {
            // Requested steps and those of a warm-up are silent.
            if !series.is_empty() {
                events.series(self.id, passed, &series);
            }
            let dropped = if self.clock.due(self.last_step) {
                self.clock.drop_rest()
            } else {
                0.0
            };
            self.real_time
                .frame(passed, scale, made.played_seconds, dropped);
            smooth(&mut self.averages.steps_per_frame, f64::from(made.played));
        }
        self.step_requests.close();

        // Pictures between requested steps are not shown.
        let (paused, warming) = (!self.playing, self.is_warming());
        let drawn =
            self.needs_picture() && self.step_requests.is_empty() && self.can_draw() && !warming;
        self.drawn |= drawn;
        let scale_before = self.renderer.scale();
        let draw_ms = if drawn {
            self.draw(canvas, clock, events)
        } else {
            0.0
        };
        // A new scale of the colours is posted with its picture.
        let rescaled = self.renderer.scale() != scale_before;
        self.since_picture.steps_ms += made.stages.iter().sum::<f64>();
        self.since_picture.simulated += made.played_seconds;
        if passed.is_some() && made.steps != made.played {
            // The times of requested steps do not predict those of due steps.
            self.quality.skip();
            self.since_picture = SincePicture::default();
        } else if passed.is_some() && drawn {
            self.fps.frame(now / 1000.0);
            let since = std::mem::take(&mut self.since_picture);
            let gpu_ms = self.renderer.passes().map_or(0.0, |passes| passes.gpu_ms());
            let cost = FrameCost {
                now,
                min_interval: self.limits.min_interval(),
                steps_ms: since.steps_ms,
                simulated: since.simulated,
                draw_ms: if gpu_ms > draw_ms { gpu_ms } else { draw_ms },
                pixels: match self.limits.pixels {
                    Some(_) => None,
                    None => Some(f64::from(self.size.0) * f64::from(self.size.1)),
                },
                time_scale: scale,
                slowed: self.real_time.slowed(),
                particles: self.counts_of_levels(),
                fires: time.fires,
                share: time.share,
            };
            if self.quality.frame(&cost) {
                events.quality(self.id, &self.quality);
                // Another level has other costs.
                self.real_time.forget_losses();
                self.adapt();
            }
        }
        if (drawn && paused) || rescaled || now - self.stats_at >= STATS_INTERVAL_MS {
            self.stats_at = now;
            events.stats(self.id, &stats::of(self, canvas));
        }
        // The answer to a step request follows its picture and statistics.
        if !self.can_draw() || (!warming && (!self.stale || !self.step_requests.is_empty())) {
            for request in self.step_requests.answers() {
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
        self.history.follow(&self.simulation);
        let mut made = StepsMade::default();
        let last = Cell::new(clock.now());
        let steps = make_steps(
            || last.get() < deadline,
            || {
                let warms = warms && self.warm_up.is_on();
                let requested = self.step_requests.next_open();
                if !warms && requested.is_none() && !(plays && self.clock.due(self.last_step)) {
                    return false;
                }
                let age = self.simulation.time();
                let mut requested = requested.filter(|_| !warms);
                let end = requested.as_mut().map_or(f64::INFINITY, |it| it.end(age));
                let length = step(&mut self.simulation, self.pointer, end, &mut |stage| {
                    let now = clock.now();
                    made.stages[stage as usize] += now - last.replace(now);
                });
                if self
                    .pointer
                    .as_mut()
                    .is_some_and(|force| !force.lasts(length))
                {
                    self.pointer = None;
                }
                self.history.follow(&self.simulation);
                self.last_step = length;
                made.seconds += length;
                if warms {
                    if self.warm_up.advance(length) {
                        let scene = self.scene();
                        self.simulation.set_scene(scene);
                    }
                    if !self.warm_up.is_on() {
                        self.restart_clock();
                    }
                    return true;
                }
                match requested {
                    Some(request) => request.take(self.simulation.time()),
                    None => {
                        self.clock.spend(length);
                        made.played += 1;
                        made.played_seconds += length;
                    }
                }
                true
            },
        );
        StepsMade { steps, ..made }
    }

    /// Draws the picture. Returns the time of drawing \[ms\].
    fn draw(&mut self, canvas: &SharedCanvas, clock: &WallClock, events: &Events) -> f64 {
        let start = clock.now();
        // A fire that is drawn before its first step has no sample yet.
        self.history.follow(&self.simulation);
        self.simulation.write_instances(&mut self.instances);
        self.simulation.write_charred(&mut self.charred);
        if self.simulation.parameters().display_mode == DisplayMode::Fire {
            self.simulation.write_embers(&mut self.embers);
        } else {
            self.embers.clear();
        }
        let temperatures: Vec<_> = self.simulation.solid_temperatures().collect();
        let drawn = self.renderer.draw(
            canvas,
            &FrameInput {
                fire: self.id,
                size: self.limits.fit(self.size, self.quality.pixels()),
                limits: ResolutionLimits::of(self.quality.level()),
                camera: self.camera,
                time: self.simulation.time(),
                is_paused: !self.playing,
                scene: self.simulation.scene(),
                particles: &self.instances,
                embers: &self.embers,
                temperatures: &temperatures,
                poses: &self.simulation.poses(),
                charred: &self.charred,
                history: &self.history,
            },
            clock,
        );
        match drawn {
            Ok(uploaded) => smooth(&mut self.averages.upload_ms, uploaded - start),
            Err(message) => {
                self.drawable = false;
                events.error(self.id, ErrorKind::Unsupported, &message);
            }
        }
        let took = clock.now() - start;
        smooth(&mut self.averages.draw_ms, took);
        self.stale = false;
        took
    }
}

/// Makes a step towards the age `end`, with the force of a pointer. Returns its length [s of fire].
// Inlined into its loop, the whole solver would be compiled twice.
#[inline(never)]
fn step(
    simulation: &mut Simulation,
    pointer: Option<PointerForce>,
    end: f64,
    on_stage: &mut dyn FnMut(Stage),
) -> f64 {
    let start = simulation.time();
    match pointer {
        Some(force) => {
            let acceleration =
                |at: Vec2, v: Vec2| Vec2::from(force.acceleration(at.into(), v.into()));
            simulation.step_towards(end, Some(&acceleration), on_stage);
        }
        None => simulation.step_towards(end, None, on_stage),
    }
    simulation.time() - start
}
