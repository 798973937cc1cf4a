//! One fire: a simulation, its clock and its picture.

mod tell;
mod warming;

use std::cell::Cell;

use glam::Vec2;
use hearth_core::clock::Clock;
use hearth_core::fps::FpsCounter;
use hearth_core::params::DisplayMode;
use hearth_core::{Instance, Parameters, Simulation, Stage, burning};
use hearth_render::{Camera, ResolutionLimits};

use crate::asked::Asked;
use crate::average::smooth;
use crate::budget::{Pace, make_steps};
use crate::fire_frame::FireFrame;
use crate::grain::Grain;
use crate::host::Host;
use crate::limits::{Limit, Limits, Sparks, Stir};
use crate::message::Start;
use crate::outbox::{Outbox, Trouble};
use crate::quality::{Frame, Level, Quality};
use crate::shared_canvas::SharedCanvas;
use crate::wanted::{Wanted, adapt};
use crate::warm::Warm;

/// Time between two messages about how a fire is doing, in ms.
const STATS_EVERY_MS: f64 = 250.0;

/// The stages of a step, in the order of the core's `Stage`.
const STAGES: [&str; 4] = ["sort", "density", "forces", "integrate"];

/// The steps of a frame.
#[derive(Default)]
struct Made {
    /// How many there were.
    steps: u32,
    /// Seconds of fire that they made.
    seconds: f64,
    /// What each stage of them took \[ms\].
    stages: [f64; STAGES.len()],
    /// How many of them time brought.
    played: u32,
    /// Seconds of fire that those made.
    burnt: f64,
}

/// What was done since the last picture: where they are shown more slowly than the
/// engine's frames come, the fire burns on between two.
#[derive(Default)]
struct Since {
    steps_ms: f64,
    burnt: f64,
}

/// A fire and all that belongs to it.
pub struct Fire {
    id: u32,
    /// Its values as somebody asked for them; the simulation's own have the number
    /// of particles that goes with the quality.
    wanted: Wanted,
    simulation: Simulation,
    warm: Warm,
    /// Whether it is to begin before its next step, and whether it ever was drawn.
    begins: bool,
    begun: bool,
    quality: Quality,
    grain: Grain,
    picture: FireFrame,
    /// Whether there is a context to draw it in.
    drawable: bool,
    instances: Vec<Instance>,
    embers: Vec<Instance>,
    /// Size of its element in device pixels.
    size: (u32, u32),
    limits: Limits,
    /// When the next frame may come where their rate is limited \[ms\].
    next: f64,
    stir: Option<Stir>,
    camera: Camera,
    visible: bool,
    playing: bool,
    /// Whether the picture is not what it should show.
    stale: bool,
    asked: Asked,
    clock: Clock,
    /// Length of the last step in seconds of fire: about what the next will have.
    last_step: f64,
    fps: FpsCounter,
    pace: Pace,
    /// What each stage of a step takes \[ms\].
    stages: [f64; STAGES.len()],
    upload_ms: f64,
    draw_ms: f64,
    steps_per_frame: f64,
    step_length: f64,
    power: f64,
    told_at: f64,
    since: Since,
}

impl Fire {
    /// A fire that has not burnt yet.
    pub fn new(id: u32, wanted: Wanted, start: Start) -> Fire {
        let guess = start.guess.unwrap_or(Level::Medium);
        let quality = Quality::new(start.quality, guess);
        let warm = Warm::new(start.warm, start.state);
        let mut fire = Fire {
            id,
            simulation: Simulation::new(Parameters::default()),
            wanted,
            begins: warm.is_wanted(),
            begun: false,
            warm,
            quality,
            grain: Grain::of(start.side),
            picture: FireFrame::default(),
            drawable: false,
            instances: Vec::new(),
            embers: Vec::new(),
            size: start.size,
            limits: Limits::default(),
            next: 0.0,
            stir: None,
            visible: start.visible,
            camera: start.camera,
            playing: !start.paused,
            stale: true,
            asked: Asked::default(),
            clock: Clock::new(),
            last_step: 0.0,
            fps: FpsCounter::new(),
            pace: Pace::default(),
            stages: [0.0; STAGES.len()],
            upload_ms: 0.0,
            draw_ms: 0.0,
            steps_per_frame: 0.0,
            step_length: 0.0,
            power: 0.0,
            told_at: f64::NEG_INFINITY,
            since: Since::default(),
        };
        fire.simulation = Simulation::new(fire.scene());
        fire
    }

    /// Its number.
    pub fn id(&self) -> u32 {
        self.id
    }

    /// What it should burn with.
    pub fn wanted(&self) -> &Wanted {
        &self.wanted
    }

    /// Gives it other values, which the next step and picture use; `anew`: they
    /// owe nothing to those before.
    pub fn want(&mut self, wanted: Wanted, source: &str, anew: bool, out: &mut Outbox) {
        let old = &self.wanted;
        out.changed(self.id, source, anew, old, &wanted);
        if wanted.parameters().model != old.parameters().model {
            // Averages over two models say nothing about either.
            self.stages = [0.0; STAGES.len()];
            self.step_length = 0.0;
            self.power = 0.0;
        }
        if !wanted.works_like(old) {
            self.pace.forgive();
            self.quality.skip();
        }
        let time = self.simulation.time();
        // A scene's fire carries nothing of the one before.
        let other = burning::digest(&wanted.scene) != burning::digest(&old.scene);
        self.wanted = wanted;
        self.adapt();
        let again = anew && other || self.simulation.time() < time;
        if self.warm.is_wanted() && (again || other && !self.begun) {
            self.begin(out);
        }
    }

    /// Lets it have that quality, or find its own.
    pub fn ask_quality(&mut self, wish: Option<Level>, out: &mut Outbox) {
        let before = (self.quality.wish(), self.quality.level());
        self.quality.ask(wish);
        if before != (self.quality.wish(), self.quality.level()) {
            out.quality(self.id, &self.quality);
        }
        self.pace.forgive();
        self.adapt();
    }

    /// Gives the simulation the values, and the number of particles that goes with
    /// the quality: other particles take over the fire that burns.
    fn adapt(&mut self) {
        let scene = self.warm.coarse(&self.scene());
        adapt(&mut self.simulation, scene);
        self.stale = true;
    }

    /// Another size of its picture; nothing is drawn while it is zero.
    pub fn resize(&mut self, size: (u32, u32), side: f64) {
        let was_seen = self.seen();
        self.stale |= self.size != size;
        self.size = size;
        if self.grain.resize(side) {
            self.quality.skip();
            self.adapt();
        }
        self.keep_time(was_seen);
    }

    /// Whether anybody sees it. Time that nobody saw is not made up for.
    pub fn set_visible(&mut self, visible: bool) {
        let was_seen = self.seen();
        self.visible = visible;
        if !visible {
            // Its textures are of use to others meanwhile.
            self.picture.free();
            self.stale = true;
        }
        self.keep_time(was_seen);
    }

    /// Draws no more than that from now on.
    pub fn limit(&mut self, limit: Limit) {
        self.limits = self.limits.with(limit);
        self.stale = true;
    }

    /// Has its gas moved in the next steps.
    pub fn stir(&mut self, stir: Stir) {
        self.stir = Some(stir);
    }

    /// Throws sparks from a place.
    pub fn throw(&mut self, sparks: Sparks) {
        let place = Vec2::from(sparks.place);
        self.simulation.throw_embers(place, sparks.count);
        self.stale = true;
    }

    /// Is seen so from the next picture on.
    pub fn look(&mut self, camera: Camera) {
        self.camera = camera;
        self.stale = true;
    }

    /// A picture that was on its way is shown.
    pub fn shown(&mut self) {
        self.picture.shown();
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
    pub fn reset(&mut self, out: &mut Outbox) {
        self.simulation.reset();
        if self.warm.is_wanted() {
            self.begin(out);
        }
        self.stale = true;
        self.restart_clock();
    }

    /// Takes on steps to be made as the frames allow: so many of them, or enough
    /// for so many seconds of fire. The answer to `request` follows when they are
    /// made and drawn.
    pub fn ask_steps(&mut self, steps: u32, seconds: f64, request: Option<f64>) {
        self.asked.add(steps, seconds, request);
    }

    /// Whether there is a context to draw it in: it may be lost, and back. The fire
    /// does not notice.
    pub fn set_drawable(&mut self, drawable: bool) {
        let was_seen = self.seen();
        self.drawable = drawable;
        self.picture.free();
        self.stale = true;
        self.keep_time(was_seen);
    }

    /// Whether it has anything to do in the next frame.
    pub fn wants_frame(&self) -> bool {
        let asked = !self.asked.is_empty() || (self.asked.waits() && !self.seen());
        asked || (self.seen() && (self.playing || self.is_warming() || self.wants_picture()))
    }

    fn wants_picture(&self) -> bool {
        self.stale && self.picture.is_awaited()
    }

    /// Whether a frame at `now` \[ms\] is one of its own, if their rate is limited.
    pub fn is_due(&mut self, now: f64) -> bool {
        !self.asked.is_empty() || self.is_warming() || self.limits.is_due(now, &mut self.next)
    }

    /// One frame: the steps that are due, as far as `deadline` allows, and the
    /// picture of them. `now` is the time of the frame, in ms. Returns how long drawing
    /// took \[ms\].
    pub fn frame(
        &mut self,
        now: f64,
        deadline: f64,
        fires: usize,
        canvas: &SharedCanvas,
        host: &Host,
        out: &mut Outbox,
    ) -> f64 {
        let scale = f64::from(self.wanted.parameters().time_scale);
        // Whoever asked for steps asked for those of a warm fire.
        let warms = self.is_warming() && (self.seen() || self.asked.next_open().is_some());
        if warms && self.begins {
            self.begins = false;
            let scene = self.scene();
            if let Some(words) = self.warm.begin(&mut self.simulation, &scene) {
                out.complaint(self.id, words);
            }
            // What it may have taken up is drawn before it burns on.
            self.stale = true;
        }
        let passed = if self.playing && self.seen() && !self.is_warming() {
            Some(self.clock.advance(now / 1000.0, scale))
        } else {
            None
        };

        let made = self.make_steps(passed.is_some(), warms, deadline, host);
        if made.steps > 0 {
            let steps = f64::from(made.steps);
            for (average, stage) in self.stages.iter_mut().zip(made.stages) {
                smooth(average, stage / steps);
            }
            smooth(&mut self.step_length, made.seconds / steps);
            let power = f64::from(self.simulation.power());
            smooth(&mut self.power, power);
            self.stale = true;
        }
        if let Some(passed) = passed {
            let dropped = if self.clock.due(self.last_step) {
                self.clock.drop_rest()
            } else {
                0.0
            };
            self.pace.frame(passed, scale, made.burnt, dropped);
            smooth(&mut self.steps_per_frame, f64::from(made.played));
        }
        self.asked.take_made();

        // Asked-for steps are a jump: what lies between is not shown.
        let (stands, warming) = (!self.playing, self.is_warming());
        let drawn = self.wants_picture() && self.asked.is_empty() && self.seen() && !warming;
        self.begun |= drawn;
        let shown = self.picture.scale();
        let draw_ms = if drawn {
            self.draw(stands, canvas, host, out)
        } else {
            0.0
        };
        // Whoever shows what the colours stand for shows it with the picture.
        let rescaled = self.picture.scale() != shown;
        self.since.steps_ms += made.stages.iter().sum::<f64>();
        self.since.burnt += made.burnt;
        if passed.is_some() && made.steps != made.played {
            // Steps that somebody asked for say nothing about what time brings.
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
                slowed: self.pace.slowed(),
                particles: self
                    .wanted
                    .follows_level()
                    .then(|| Level::ALL.map(|level| self.particles(level))),
                fires,
            };
            if self.quality.frame(&frame) {
                out.quality(self.id, &self.quality);
                // What was too much before says nothing about what comes.
                self.pace.forgive();
                self.adapt();
            }
        }
        if (drawn && stands) || rescaled || now - self.told_at >= STATS_EVERY_MS {
            self.told_at = now;
            self.tell(canvas, out);
        }
        // Whoever waits for steps finds them in picture and statistics.
        if !self.seen() || (!warming && (!self.stale || !self.asked.is_empty())) {
            for request in self.asked.answers() {
                out.done(self.id, request);
            }
        }
        draw_ms
    }

    /// Makes the steps that were asked for and, if it `burns`, those that are due,
    /// as far as there is time.
    fn make_steps(&mut self, burns: bool, warms: bool, deadline: f64, host: &Host) -> Made {
        let mut made = Made::default();
        let scene = warms.then(|| self.scene());
        let last = Cell::new(host.now());
        let steps = make_steps(
            || last.get() < deadline,
            || {
                let warms = scene.as_ref().filter(|_| self.warm.is_on());
                let asked = self.asked.next_open();
                if warms.is_none() && asked.is_none() && !(burns && self.clock.due(self.last_step))
                {
                    return false;
                }
                let length = step(&mut self.simulation, self.stir, &mut |stage| {
                    let now = host.now();
                    made.stages[stage as usize] += now - last.replace(now);
                });
                if self.stir.as_mut().is_some_and(|stir| !stir.lasts(length)) {
                    self.stir = None;
                }
                self.last_step = length;
                made.seconds += length;
                if let Some(scene) = warms {
                    if self.warm.burnt(length, &mut self.simulation, scene) {
                        self.restart_clock();
                    }
                    return true;
                }
                match asked {
                    Some(asked) => asked.take(length),
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
    fn draw(&mut self, stands: bool, canvas: &SharedCanvas, host: &Host, out: &mut Outbox) -> f64 {
        let start = host.now();
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
            host,
        );
        match drawn {
            Ok(sent) => smooth(&mut self.upload_ms, sent - start),
            Err(words) => {
                self.drawable = false;
                out.error(self.id, Trouble::Unsupported, &words);
            }
        }
        let took = host.now() - start;
        smooth(&mut self.draw_ms, took);
        self.stale = false;
        took
    }

    /// Whether its picture can be drawn and somebody sees it.
    fn seen(&self) -> bool {
        self.visible && self.size.0 > 0 && self.size.1 > 0 && self.drawable
    }

    fn keep_time(&mut self, was_seen: bool) {
        if self.seen() != was_seen {
            self.restart_clock();
        }
    }

    fn restart_clock(&mut self) {
        self.clock.restart();
        self.fps.skip();
        self.quality.skip();
        self.since = Since::default();
    }
}

/// Makes a step, of gas that somebody may stir; returns its length in seconds of fire.
// The whole solver would be there twice if the loop around it took it in.
#[inline(never)]
fn step(simulation: &mut Simulation, stir: Option<Stir>, watch: &mut dyn FnMut(Stage)) -> f64 {
    let start = simulation.time();
    match stir {
        Some(stir) => {
            let force =
                |place: Vec2, velocity: Vec2| Vec2::from(stir.push(place.into(), velocity.into()));
            simulation.step_in_stages(Some(&force), watch);
        }
        None => simulation.step_in_stages(None, watch),
    }
    simulation.time() - start
}
