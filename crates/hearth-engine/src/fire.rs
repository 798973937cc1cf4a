//! A fire: a simulation, its clock and its picture.

mod frame;
mod warming;

use glam::Vec2;
use hearth_core::clock::Clock;
use hearth_core::fps::FpsCounter;
use hearth_core::{Instance, Parameters, Simulation, burning};
use hearth_render::{Camera, Fit};

use crate::average::Averages;
use crate::budget::RealTime;
use crate::commands::Start;
use crate::events::Events;
use crate::fire_frame::FireFrame;
use crate::grain::Grain;
use crate::limits::{Fps, Limits, Pixels};
use crate::pending::Pending;
use crate::pointer::PointerForce;
use crate::quality::{Level, Quality};
use crate::requested::{Requested, adapt};
use crate::warm::Warm;

/// What was done since the last picture: where pictures are shown less often than the
/// engine's frames come, the fire burns on between two.
#[derive(Default)]
struct Since {
    steps_ms: f64,
    burnt: f64,
}

/// A fire and all that belongs to it.
pub struct Fire {
    id: u32,
    /// The simulation has these values, with the number of particles that goes with the
    /// quality.
    requested: Requested,
    pub(crate) simulation: Simulation,
    warm: Warm,
    /// Whether it is to begin before its next step.
    begins: bool,
    /// Whether it ever was drawn.
    begun: bool,
    pub(crate) quality: Quality,
    grain: Grain,
    pub(crate) picture: FireFrame,
    /// Whether there is a context to draw it in.
    drawable: bool,
    instances: Vec<Instance>,
    embers: Vec<Instance>,
    /// Size of its element in device pixels.
    size: (u32, u32),
    limits: Limits,
    /// When the next frame may come where their rate is limited \[ms\].
    next: f64,
    pointer: Option<PointerForce>,
    camera: Camera,
    visible: bool,
    pub(crate) playing: bool,
    /// Whether the picture is not what it should show.
    stale: bool,
    pending: Pending,
    clock: Clock,
    /// Length of the last step in seconds of fire: about what the next will have.
    last_step: f64,
    pub(crate) fps: FpsCounter,
    pub(crate) real_time: RealTime,
    pub(crate) averages: Averages,
    /// When it last reported statistics \[ms\].
    told_at: f64,
    since: Since,
}

impl Fire {
    /// A fire that has not burnt yet. It is not visible and has no size.
    pub fn new(id: u32, requested: Requested, start: &Start<'_>) -> Fire {
        let guess = start.guess.unwrap_or(Level::Medium);
        let quality = Quality::new(start.quality, guess);
        let warm = Warm::new(start.warm, start.state.to_vec());
        let mut fire = Fire {
            id,
            simulation: Simulation::new(Parameters::default()),
            requested,
            begins: warm.is_wanted(),
            begun: false,
            warm,
            quality,
            grain: Grain::of(start.side),
            picture: FireFrame::default(),
            drawable: false,
            instances: Vec::new(),
            embers: Vec::new(),
            size: (0, 0),
            limits: Limits::default(),
            next: 0.0,
            pointer: None,
            visible: false,
            camera: Camera::default(),
            playing: !start.paused,
            stale: true,
            pending: Pending::default(),
            clock: Clock::new(),
            last_step: 0.0,
            fps: FpsCounter::new(),
            real_time: RealTime::default(),
            averages: Averages::default(),
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

    /// The settings that it should burn with.
    pub fn requested(&self) -> &Requested {
        &self.requested
    }

    /// Gives it other settings, which the next step and picture use. `replaced`: they
    /// replace all of those before.
    pub fn request(&mut self, requested: Requested, source: &str, replaced: bool, events: &Events) {
        let old = &self.requested;
        events.changed(self.id, source, replaced, old, &requested);
        if requested.parameters().model != old.parameters().model {
            self.averages.forget_steps();
        }
        if !requested.works_like(old) {
            self.real_time.forgive();
            self.quality.skip();
        }
        let time = self.simulation.time();
        // The fire of a scene carries nothing of the one before.
        let other = burning::digest(&requested.scene) != burning::digest(&old.scene);
        self.requested = requested;
        self.adapt();
        let again = replaced && other || self.simulation.time() < time;
        if self.warm.is_wanted() && (again || other && !self.begun) {
            self.begin(events);
        }
    }

    /// Fixes its quality, or lets it find its own.
    pub fn ask_quality(&mut self, wish: Option<Level>, events: &Events) {
        let before = (self.quality.wish(), self.quality.level());
        self.quality.ask(wish);
        if before != (self.quality.wish(), self.quality.level()) {
            events.quality(self.id, &self.quality);
        }
        self.real_time.forgive();
        self.adapt();
    }

    /// Gives the simulation the requested values, with the number of particles that goes
    /// with the quality. A burning fire is resampled.
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

    /// Tells whether anybody sees it. Unseen time is not made up for.
    pub fn set_visible(&mut self, visible: bool) {
        let was_seen = self.seen();
        self.visible = visible;
        if !visible {
            // Other fires can use its textures meanwhile.
            self.picture.free();
            self.stale = true;
        }
        self.keep_time(was_seen);
    }

    /// Limits its pictures a second.
    pub fn limit_fps(&mut self, fps: Option<Fps>) {
        self.limits.fps = fps.map(|fps| fps.0);
        self.stale = true;
    }

    /// Limits the pixels of its pictures.
    pub fn limit_pixels(&mut self, pixels: Option<Pixels>) {
        self.limits.pixels = pixels.map(|pixels| pixels.0);
        self.stale = true;
    }

    /// Lets a pointer move its gas in the next steps.
    pub fn stir(&mut self, force: PointerForce) {
        self.pointer = Some(force);
    }

    /// Throws sparks from a place \[m\].
    pub fn throw(&mut self, x: f32, y: f32, count: u32) {
        self.simulation.throw_embers(Vec2::new(x, y), count);
        self.stale = true;
    }

    /// Fits the domain into the next pictures.
    pub fn look(&mut self, fit: Fit, align: [f32; 2]) {
        self.camera = Camera { fit, align };
        self.stale = true;
    }

    /// A picture that was on its way is shown.
    pub fn shown(&mut self) {
        self.picture.shown();
    }

    /// Goes on or stands still.
    pub fn set_playing(&mut self, playing: bool, events: &Events) {
        if self.playing != playing {
            self.playing = playing;
            self.stale = true;
            self.restart_clock();
            events.state(self.id, playing);
        }
    }

    /// Starts again from nothing.
    pub fn reset(&mut self, events: &Events) {
        self.simulation.reset();
        if self.warm.is_wanted() {
            self.begin(events);
        }
        self.stale = true;
        self.restart_clock();
    }

    /// Requests steps, which are made as the frames allow: so many of them, or enough for
    /// so many seconds of fire. The answer to `request` follows when they are drawn.
    pub fn ask_steps(&mut self, steps: u32, seconds: f64, request: u32) {
        self.pending.add(steps, seconds, request);
    }

    /// Tells whether there is a context to draw it in. The simulation is not touched.
    pub fn set_drawable(&mut self, drawable: bool) {
        let was_seen = self.seen();
        self.drawable = drawable;
        self.picture.free();
        self.stale = true;
        self.keep_time(was_seen);
    }

    /// Whether it has anything to do in the next frame.
    pub fn wants_frame(&self) -> bool {
        let asked = !self.pending.is_empty() || (self.pending.waits() && !self.seen());
        asked || (self.seen() && (self.playing || self.is_warming() || self.wants_picture()))
    }

    fn wants_picture(&self) -> bool {
        self.stale && self.picture.is_awaited()
    }

    /// Whether a frame at `now` \[ms\] is one of its own, if their rate is limited.
    pub fn is_due(&mut self, now: f64) -> bool {
        !self.pending.is_empty() || self.is_warming() || self.limits.is_due(now, &mut self.next)
    }

    /// What the first and the last colour of its picture stand for, where they measure
    /// something. Until the requested display is drawn, its colours stand for nothing.
    pub(crate) fn measured(&self) -> Option<[f32; 2]> {
        let (mode, ends) = self.picture.scale()?;
        (mode == self.requested.parameters().display_mode).then_some(ends)
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
