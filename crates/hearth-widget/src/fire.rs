//! One fire: a simulation, its clock and its picture.

use std::collections::VecDeque;

use hearth_core::clock::Clock;
use hearth_core::fps::FpsCounter;
use hearth_core::simulation::Instance;
use hearth_core::{Parameters, Simulation};

use crate::budget::{Pace, make_steps};
use crate::host::Host;
use crate::message::Start;
use crate::outbox::{Outbox, Stats, Trouble};
use crate::picture::{ContextEvent, Picture};

/// Time between two messages about how a fire is doing, in ms.
const STATS_EVERY_MS: f64 = 250.0;

/// Weight of the newest frame in the smoothed times of a step and of drawing.
const SMOOTHING: f64 = 0.1;

/// Steps that somebody asked for, apart from those that time brings.
struct AskedSteps {
    request: Option<f64>,
    left: u32,
}

/// A fire and all that belongs to it.
pub struct Fire {
    id: u32,
    simulation: Simulation,
    picture: Picture,
    instances: Vec<Instance>,
    size: (u32, u32),
    visible: bool,
    playing: bool,
    /// Whether the picture is not what it should show.
    stale: bool,
    asked: VecDeque<AskedSteps>,
    clock: Clock,
    fps: FpsCounter,
    pace: Pace,
    step_ms: f64,
    draw_ms: f64,
    steps_per_frame: f64,
    told_at: f64,
}

impl Fire {
    /// A fire that has not burnt yet.
    pub fn new(id: u32, picture: Picture, parameters: Parameters, start: &Start) -> Fire {
        Fire {
            id,
            simulation: Simulation::new(parameters),
            picture,
            instances: Vec::new(),
            size: start.size,
            visible: start.visible,
            playing: !start.paused,
            stale: true,
            asked: VecDeque::new(),
            clock: Clock::new(),
            fps: FpsCounter::new(),
            pace: Pace::default(),
            step_ms: 0.0,
            draw_ms: 0.0,
            steps_per_frame: 0.0,
            told_at: f64::NEG_INFINITY,
        }
    }

    /// Its values.
    pub fn parameters(&self) -> &Parameters {
        self.simulation.parameters()
    }

    /// Gives it other values, which the next step and picture use.
    pub fn set_parameters(&mut self, parameters: Parameters, source: &str, out: &mut Outbox) {
        out.changed(self.id, source, self.simulation.parameters(), &parameters);
        self.simulation.set_parameters(parameters);
        self.stale = true;
    }

    /// Another size of its picture; nothing is drawn while it is zero.
    pub fn resize(&mut self, width: u32, height: u32) {
        let was_seen = self.seen();
        self.stale |= self.size != (width, height);
        self.size = (width, height);
        self.keep_time(was_seen);
    }

    /// Whether anybody sees it. Time that nobody saw is not made up for.
    pub fn set_visible(&mut self, visible: bool) {
        let was_seen = self.seen();
        self.visible = visible;
        self.keep_time(was_seen);
    }

    /// Goes on or stands still.
    pub fn set_playing(&mut self, playing: bool, out: &mut Outbox) {
        if self.playing != playing {
            self.playing = playing;
            self.stale = true;
            self.restart_clock();
            out.state(self.id, playing);
        }
    }

    /// Starts again from nothing.
    pub fn reset(&mut self) {
        self.simulation.reset();
        self.stale = true;
        self.restart_clock();
    }

    /// Takes on steps to be made as the frames allow; the answer to `request`
    /// follows when they are made and drawn.
    pub fn ask_steps(&mut self, steps: u32, request: Option<f64>) {
        self.asked.push_back(AskedSteps {
            request,
            left: steps,
        });
    }

    /// Its context was lost or is back. The fire does not notice.
    pub fn context(&mut self, event: ContextEvent, out: &mut Outbox) {
        let was_seen = self.seen();
        match event {
            ContextEvent::Lost => {
                self.picture.lose();
                let words = "the graphics context was lost; the fire goes on when it is back";
                out.error(self.id, Trouble::ContextLost, words);
            }
            ContextEvent::Restored => match self.picture.restore() {
                Ok(()) => {
                    self.stale = true;
                    out.restored(self.id);
                }
                Err(words) => out.error(self.id, Trouble::Unsupported, &words),
            },
        }
        self.keep_time(was_seen);
    }

    /// Whether it has anything to do in the next frame.
    pub fn wants_frame(&self) -> bool {
        !self.asked.is_empty() || (self.seen() && (self.playing || self.stale))
    }

    /// One frame: the steps that are due, as far as `deadline` allows, and the
    /// picture of them. `now` is the time of the frame, in ms.
    pub fn frame(&mut self, now: f64, deadline: f64, host: &Host, out: &mut Outbox) {
        let due = if self.playing && self.seen() {
            self.fps.frame(now / 1000.0);
            let (step, scale) = (self.parameters().time_step, self.parameters().time_scale);
            let due = self.clock.advance(now / 1000.0, step.into(), scale.into());
            Some(due)
        } else {
            None
        };
        let left = self.asked.iter().map(|asked| asked.left);
        let asked = left.fold(0, u32::saturating_add);
        let owed = due.unwrap_or(0).saturating_add(asked);

        let start = host.now();
        let simulation = &mut self.simulation;
        let made = make_steps(owed, || host.now() < deadline, || simulation.step());
        if made > 0 {
            let took = (host.now() - start) / f64::from(made);
            smooth(&mut self.step_ms, took);
            self.stale = true;
        }
        let finished = self.take_asked(made);
        if let Some(due) = due {
            let played = made.saturating_sub(asked);
            self.pace.frame(due, played);
            smooth(&mut self.steps_per_frame, f64::from(played));
        }

        // Asked-for steps are a jump: what lies between is not shown.
        let stands = due.is_none();
        let drawn = self.stale && self.asked.is_empty() && self.seen();
        if drawn {
            self.draw(host, out);
        }
        for request in finished {
            out.done(self.id, request);
        }
        if (drawn && stands) || now - self.told_at >= STATS_EVERY_MS {
            self.told_at = now;
            self.tell(out);
        }
    }

    /// Counts steps against those that were asked for; returns the requests
    /// that are carried out.
    fn take_asked(&mut self, mut made: u32) -> Vec<Option<f64>> {
        let mut finished = Vec::new();
        while let Some(first) = self.asked.front_mut() {
            let taken = first.left.min(made);
            first.left -= taken;
            made -= taken;
            if first.left > 0 {
                break;
            }
            finished.push(first.request);
            self.asked.pop_front();
        }
        finished
    }

    fn draw(&mut self, host: &Host, out: &mut Outbox) {
        let start = host.now();
        self.simulation.write_instances(&mut self.instances);
        let drawn = self.picture.draw(
            self.size,
            self.simulation.time(),
            &self.instances,
            self.simulation.parameters(),
        );
        if let Err(words) = drawn {
            out.error(self.id, Trouble::Unsupported, &words);
        }
        smooth(&mut self.draw_ms, host.now() - start);
        self.stale = false;
    }

    fn tell(&mut self, out: &mut Outbox) {
        let report = self.simulation.report();
        let stats = Stats {
            fps: self.fps.fps(),
            particles: self.simulation.count(),
            step_ms: self.step_ms,
            draw_ms: self.draw_ms,
            steps_per_frame: self.steps_per_frame,
            substeps: report.substeps,
            neighbours: report.mean_neighbours,
            at_speed_limit: report.at_speed_limit,
            time: self.simulation.time(),
            paused: !self.playing,
            slowed: self.pace.take_slowed(),
            target_format: self.picture.target_format(),
        };
        out.stats(self.id, &stats);
    }

    /// Whether its picture can be drawn and somebody sees it.
    fn seen(&self) -> bool {
        self.visible && self.size.0 > 0 && self.size.1 > 0 && self.picture.drawable()
    }

    fn keep_time(&mut self, was_seen: bool) {
        if self.seen() != was_seen {
            self.restart_clock();
        }
    }

    fn restart_clock(&mut self) {
        self.clock.restart();
        self.fps.skip();
    }
}

fn smooth(average: &mut f64, newest: f64) {
    *average += if *average == 0.0 {
        newest
    } else {
        SMOOTHING * (newest - *average)
    };
}
