//! A frame of a fire: the steps that are due, and the picture of them.

use std::cell::Cell;

use glam::Vec2;
use hearth_core::params::DisplayMode;
use hearth_core::{Simulation, Stage};
use hearth_render::ResolutionLimits;

use super::{Fire, Since};
use crate::average::{StageTimes, smooth};
use crate::budget::make_steps;
use crate::events::{ErrorKind, Events};
use crate::pointer::PointerForce;
use crate::quality::{Frame, Level};
use crate::shared_canvas::SharedCanvas;
use crate::stats;
use crate::wall_clock::WallClock;

/// Time between two reports of statistics \[ms\].
const STATS_EVERY_MS: f64 = 250.0;

/// The steps of a frame.
#[derive(Default)]
struct Made {
    /// Their number.
    steps: u32,
    /// Their length in seconds of fire.
    seconds: f64,
    /// Time of each stage \[ms\].
    stages: StageTimes,
    /// The number of those that were due by the clock.
    played: u32,
    /// The length of those in seconds of fire.
    burnt: f64,
}

impl Fire {
    /// One frame: the steps that are due, as far as `deadline` allows, and the
    /// picture of them. `now` is the time of the frame, in ms. Returns how long drawing
    /// took \[ms\].
    pub fn frame(
        &mut self,
        now: f64,
        deadline: f64,
        fires: usize,
        canvas: &SharedCanvas,
        clock: &WallClock,
        events: &Events,
    ) -> f64 {
        let scale = f64::from(self.requested.parameters().time_scale);
        // Requested steps are those of a warm fire.
        let warms = self.is_warming() && (self.seen() || self.pending.next_open().is_some());
        if warms && self.begins {
            self.begins = false;
            let scene = self.scene();
            if let Some(words) = self.warm.begin(&mut self.simulation, &scene) {
                events.warn(self.id, words);
            }
            // A saved fire is drawn before it burns on.
            self.stale = true;
        }
        let passed = if self.playing && self.seen() && !self.is_warming() {
            Some(self.clock.advance(now / 1000.0, scale))
        } else {
            None
        };

        let made = self.make_steps(passed.is_some(), warms, deadline, clock);
        if made.steps > 0 {
            let steps = f64::from(made.steps);
            for (average, stage) in self.averages.step_stages.iter_mut().zip(made.stages) {
                smooth(average, stage / steps);
            }
            smooth(&mut self.averages.step_length, made.seconds / steps);
            let power = f64::from(self.simulation.power());
            smooth(&mut self.averages.power, power);
            self.stale = true;
        }
        if let Some(passed) = passed {
            let dropped = if self.clock.due(self.last_step) {
                self.clock.drop_rest()
            } else {
                0.0
            };
            self.real_time.frame(passed, scale, made.burnt, dropped);
            smooth(&mut self.averages.steps_per_frame, f64::from(made.played));
        }
        self.pending.close();

        // Requested steps are a jump: what lies between is not shown.
        let (stands, warming) = (!self.playing, self.is_warming());
        let drawn = self.wants_picture() && self.pending.is_empty() && self.seen() && !warming;
        self.begun |= drawn;
        let shown = self.picture.scale();
        let draw_ms = if drawn {
            self.draw(stands, canvas, clock, events)
        } else {
            0.0
        };
        // What the colours stand for is reported with the picture.
        let rescaled = self.picture.scale() != shown;
        self.since.steps_ms += made.stages.iter().sum::<f64>();
        self.since.burnt += made.burnt;
        if passed.is_some() && made.steps != made.played {
            // Requested steps say nothing about those that are due by the clock.
            self.quality.skip();
            self.since = Since::default();
        } else if passed.is_some() && drawn {
            self.fps.frame(now / 1000.0);
            let since = std::mem::take(&mut self.since);
            let on_card = self.picture.passes().map_or(0.0, |passes| passes.on_card());
            let frame = Frame {
                now,
                apart: self.limits.apart(),
                steps_ms: since.steps_ms,
                made: since.burnt,
                draw_ms: if on_card > draw_ms { on_card } else { draw_ms },
                time_scale: scale,
                slowed: self.real_time.slowed(),
                particles: self
                    .requested
                    .follows_level()
                    .then(|| Level::ALL.map(|level| self.particles(level))),
                fires,
            };
            if self.quality.frame(&frame) {
                events.quality(self.id, &self.quality);
                // Another level is other work.
                self.real_time.forgive();
                self.adapt();
            }
        }
        if (drawn && stands) || rescaled || now - self.told_at >= STATS_EVERY_MS {
            self.told_at = now;
            events.stats(self.id, &stats::of(self, canvas));
        }
        // An answer to a step request follows its picture and statistics.
        if !self.seen() || (!warming && (!self.stale || !self.pending.is_empty())) {
            for request in self.pending.answers() {
                events.done(self.id, request);
            }
        }
        draw_ms
    }

    /// Makes the requested steps and, if it `burns`, those that are due by the clock, as
    /// far as there is time.
    fn make_steps(&mut self, burns: bool, warms: bool, deadline: f64, clock: &WallClock) -> Made {
        let mut made = Made::default();
        let scene = warms.then(|| self.scene());
        let last = Cell::new(clock.now());
        let steps = make_steps(
            || last.get() < deadline,
            || {
                let warms = scene.as_ref().filter(|_| self.warm.is_on());
                let requested = self.pending.next_open();
                if warms.is_none()
                    && requested.is_none()
                    && !(burns && self.clock.due(self.last_step))
                {
                    return false;
                }
                let length = step(&mut self.simulation, self.pointer, &mut |stage| {
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
                self.last_step = length;
                made.seconds += length;
                if let Some(scene) = warms {
                    if self.warm.burnt(length, &mut self.simulation, scene) {
                        self.restart_clock();
                    }
                    return true;
                }
                match requested {
                    Some(request) => request.take(length),
                    None => {
                        self.clock.spend(length);
                        made.played += 1;
                        made.burnt += length;
                    }
                }
                true
            },
        );
        Made { steps, ..made }
    }

    /// Draws it; returns how long that took \[ms\].
    fn draw(
        &mut self,
        stands: bool,
        canvas: &SharedCanvas,
        clock: &WallClock,
        events: &Events,
    ) -> f64 {
        let start = clock.now();
        self.simulation.write_instances(&mut self.instances);
        if self.simulation.parameters().display_mode == DisplayMode::Fire {
            self.simulation.write_embers(&mut self.embers);
        } else {
            self.embers.clear();
        }
        let level = self.quality.level();
        let limits = [
            ResolutionLimits::LOW,
            ResolutionLimits::MEDIUM,
            ResolutionLimits::HIGH,
        ];
        let drawn = self.picture.draw(
            self.id,
            canvas,
            self.limits.fit(self.size, level.pixels()),
            limits[level as usize],
            (&self.instances, &self.embers),
            (self.simulation.time(), self.simulation.parameters()),
            self.camera,
            stands,
            clock,
        );
        match drawn {
            Ok(sent) => smooth(&mut self.averages.upload_ms, sent - start),
            Err(words) => {
                self.drawable = false;
                events.error(self.id, ErrorKind::Unsupported, &words);
            }
        }
        let took = clock.now() - start;
        smooth(&mut self.averages.draw_ms, took);
        self.stale = false;
        took
    }
}

/// Makes a step, with the force of a pointer; returns its length in seconds of fire.
// Inlined into its loop, the whole solver would be compiled twice.
#[inline(never)]
fn step(
    simulation: &mut Simulation,
    pointer: Option<PointerForce>,
    on_stage: &mut dyn FnMut(Stage),
) -> f64 {
    let start = simulation.time();
    match pointer {
        Some(force) => {
            let push = |at: Vec2, v: Vec2| Vec2::from(force.acceleration(at.into(), v.into()));
            simulation.step_in_stages(Some(&push), on_stage);
        }
        None => simulation.step_in_stages(None, on_stage),
    }
    simulation.time() - start
}
