//! A fire: its simulation, clock and picture.

mod particles;
mod tick;

use glam::Vec2;
use hearth_bindings::memory;
use hearth_core::clock::Clock;
use hearth_core::fps::FpsCounter;
use hearth_core::{Charred, Instance, Parameters, Simulation, burning};
use hearth_render::{Camera, Fit, History, Viewport};

use crate::commands::Start;
use crate::events::Events;
use crate::fire_renderer::FireRenderer;
use crate::pacing::averages::Averages;
use crate::pacing::machine_limit::MachineLimit;
use crate::pacing::picture_limits::{Fps, PictureLimits, Pixels};
use crate::pacing::quality::Quality;
use crate::pacing::real_time::RealTime;
use crate::pacing::step_requests::StepRequests;
use crate::pointer::PointerForce;
use hearth_core::resolution::Level;
use hearth_core::resolution::SizeLimit;
use hearth_core::warm_up::WarmUp;
use hearth_settings::{Settings, adapt};

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

/// Memory of the largest map of open air, in particles.
const MAP_MEMORY_IN_PARTICLES: usize = 4096;

/// Work since the last picture. The simulation also runs in frames without a picture.
#[derive(Default)]
struct SincePicture {
    steps_ms: f64,
    simulated: f64,
}

/// A fire of an engine.
pub struct Fire {
    id: u32,
    /// The settings of the simulation, except for the number of particles that the quality
    /// decides.
    settings: Settings,
    pub(crate) simulation: Simulation,
    warm_up: WarmUp,
    /// Whether a new fire starts before the next step.
    starts: bool,
    /// Whether the fire was ever drawn.
    drawn: bool,
    pub(crate) quality: Quality,
    size_limit: SizeLimit,
    machine_limit: MachineLimit,
    pub(crate) renderer: FireRenderer,
    history: History,
    /// Whether there is a context to draw in.
    drawable: bool,
    instances: Vec<Instance>,
    embers: Vec<Instance>,
    charred: Charred,
    /// Size of the element [device pixels].
    size: (u32, u32),
    limits: PictureLimits,
    /// Earliest time of the next picture if their rate is limited \[ms\].
    next: f64,
    pointer: Option<PointerForce>,
    camera: Camera,
    visible: bool,
    pub(crate) playing: bool,
    /// Whether the picture is out of date.
    stale: bool,
    step_requests: StepRequests,
    clock: Clock,
    /// Length of the last step [s of fire], an estimate of the next.
    last_step: f64,
    pub(crate) fps: FpsCounter,
    pub(crate) real_time: RealTime,
    pub(crate) averages: Averages,
    /// Time of the last statistics \[ms\].
    stats_at: f64,
    since_picture: SincePicture,
}

impl Fire {
    /// A fire before its first step. It is not visible and has no size. `on_page`: its thread is
    /// the page's own.
    pub fn new(id: u32, settings: Settings, start: &Start<'_>, on_page: bool) -> Fire {
        let guess = start.guess.unwrap_or(Level::Medium);
        let quality = Quality::new(start.quality, guess);
        let warm_up = WarmUp::new(start.warm, start.state.to_vec());
        let mut fire = Fire {
            id,
            simulation: Simulation::new(Parameters::default()),
            settings,
            starts: warm_up.is_enabled(),
            drawn: false,
            warm_up,
            quality,
            size_limit: SizeLimit::of(start.side),
            machine_limit: MachineLimit::new(on_page),
            renderer: FireRenderer::default(),
            history: History::default(),
            drawable: false,
            instances: Vec::new(),
            embers: Vec::new(),
            charred: Charred::default(),
            size: (0, 0),
            limits: PictureLimits::default(),
            next: 0.0,
            pointer: None,
            visible: false,
            camera: Camera::default(),
            playing: !start.paused,
            stale: true,
            step_requests: StepRequests::default(),
            clock: Clock::new(),
            last_step: 0.0,
            fps: FpsCounter::new(),
            real_time: RealTime::default(),
            averages: Averages::default(),
            stats_at: f64::NEG_INFINITY,
            since_picture: SincePicture::default(),
        };
        fire.simulation = Simulation::new(fire.scene());
        fire
    }

    /// Number of the fire in calls and events.
    pub fn id(&self) -> u32 {
        self.id
    }

    /// The settings, except for the number of particles that the quality decides.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Applies other settings from the next step and picture on. `replaced`: they replace all
    /// earlier settings, not single values.
    pub fn change(&mut self, settings: Settings, source: &str, replaced: bool, events: &Events) {
        let old = &self.settings;
        events.changed(self.id, source, old, &settings);
        if settings.parameters().model != old.parameters().model {
            self.averages.forget_steps();
        }
        if !settings.costs_like(old) {
            self.real_time.forget_losses();
            self.quality.skip();
            self.machine_limit.restart();
        }
        let time = self.simulation.time();
        // The fire of another scene starts without gas of the previous one.
        let differs = burning::digest(settings.scene()) != burning::digest(old.scene());
        self.settings = settings;
        self.adapt();
        let restarted = replaced && differs || self.simulation.time() < time;
        if self.warm_up.is_enabled() && (restarted || differs && !self.drawn) {
            self.start(events);
        }
    }

    /// Fixes the level of quality, or makes it adaptive.
    pub fn request_quality(&mut self, level: Option<Level>, events: &Events) {
        let before = (self.quality.requested(), self.quality.level());
        self.quality.request(level);
        if before != (self.quality.requested(), self.quality.level()) {
            events.quality(self.id, &self.quality);
        }
        self.real_time.forget_losses();
        self.adapt();
    }

    /// Applies the settings and the number of particles to the simulation, which
    /// resamples a burning fire.
    fn adapt(&mut self) {
        let scene = self.scene();
        adapt(&mut self.simulation, scene);
        self.set_visible_area();
        self.stale = true;
    }

    /// Resizes the picture. A size of zero draws nothing.
    pub fn resize(&mut self, size: (u32, u32), side: f64) {
        let could_draw = self.can_draw();
        self.stale |= self.size != size;
        self.size = size;
        if self.size_limit.resize(side) {
            self.quality.skip();
            self.adapt();
        }
        self.set_visible_area();
        self.on_drawable_change(could_draw);
    }

    /// Sets whether the element is visible. Time without a picture is not made up for.
    pub fn set_visible(&mut self, visible: bool) {
        let could_draw = self.can_draw();
        self.visible = visible;
        if !visible {
            // Other fires can use the memory of its targets.
            self.renderer.free();
            self.stale = true;
        }
        self.on_drawable_change(could_draw);
    }

    /// Limits pictures per second.
    pub fn limit_fps(&mut self, fps: Option<Fps>) {
        self.limits.fps = fps.map(|fps| fps.0);
        self.stale = true;
    }

    /// Limits the pixels of a picture.
    pub fn limit_pixels(&mut self, pixels: Option<Pixels>) {
        self.limits.pixels = pixels.map(|pixels| pixels.0);
        self.stale = true;
    }

    /// Applies the force of a pointer in the next steps.
    pub fn apply_force(&mut self, force: PointerForce) {
        self.pointer = Some(force);
    }

    /// Acts on the burning fire, whose picture is out of date then.
    pub fn act<T>(&mut self, act: impl FnOnce(&mut Simulation) -> T) -> T {
        self.stale = true;
        act(&mut self.simulation)
    }

    /// Sets how the domain fits the picture.
    pub fn set_fit(&mut self, fit: Fit, align: [f32; 2]) {
        self.camera = Camera {
            fit,
            align,
            ..self.camera
        };
        self.stale = true;
        self.set_visible_area();
    }

    /// Enlarges a part of the picture.
    pub fn set_zoom(&mut self, zoom: f32, pan: [f32; 2]) {
        self.camera = Camera {
            zoom,
            pan,
            ..self.camera
        };
        self.stale = true;
    }

    /// Tells the simulation the part of the world that the picture shows before it is enlarged.
    fn set_visible_area(&mut self) {
        let (width, height) = self.size;
        let values = self.settings.parameters();
        // The map of what is seen needs less memory than so many particles.
        let has_room = !values.has_open_edges() || memory::has_room(MAP_MEMORY_IN_PARTICLES);
        if width == 0 || height == 0 || !has_room {
            return;
        }
        let domain = [values.domain_width, values.domain_height];
        let viewport = Viewport::new([width, height], domain, self.camera.zoomed_out());
        self.simulation
            .set_visible_area(Some(viewport.corners().map(Vec2::from)));
    }

    /// Limits the memory of the fire's past \[bytes\].
    pub fn limit_history(&mut self, bytes: usize) {
        self.history.set_limit(bytes);
    }

    /// Counts a picture in flight as shown.
    pub fn shown(&mut self) {
        self.renderer.shown();
    }

    /// Plays or pauses.
    pub fn set_playing(&mut self, playing: bool, events: &Events) {
        if self.playing != playing {
            self.playing = playing;
            self.stale = true;
            self.restart_clock();
            events.state(self.id, playing);
        }
    }

    /// Restarts the simulation.
    pub fn reset(&mut self, events: &Events) {
        self.simulation.reset();
        self.history.clear();
        if self.warm_up.is_enabled() {
            self.start(events);
        }
        self.stale = true;
        self.restart_clock();
    }

    /// Requests a number of steps, or steps for a duration, which frames make as their budget
    /// allows. The answer to `request` follows when they are drawn.
    pub fn request_steps(&mut self, steps: u32, seconds: f64, request: u32) {
        self.step_requests.add(steps, seconds, request);
    }

    /// Sets whether there is a context to draw in. The simulation is not affected.
    pub fn set_drawable(&mut self, drawable: bool) {
        let could_draw = self.can_draw();
        self.drawable = drawable;
        self.renderer.free();
        self.stale = true;
        self.on_drawable_change(could_draw);
    }

    /// Whether the next frame has work for this fire.
    pub fn needs_frame(&self) -> bool {
        let can_draw = self.can_draw();
        let pending =
            !self.step_requests.is_empty() || (self.step_requests.awaits_drawing() && !can_draw);
        pending || (can_draw && (self.playing || self.is_warming() || self.needs_picture()))
    }

    fn needs_picture(&self) -> bool {
        self.stale && self.renderer.is_ready()
    }

    /// Whether the limit of the frame rate allows a frame at `now` \[ms\].
    pub fn is_due(&mut self, now: f64) -> bool {
        !self.step_requests.is_empty()
            || self.is_warming()
            || self.limits.is_due(now, &mut self.next)
    }

    /// Quantities of the first and last colour of the picture; `None` if the display mode
    /// measures nothing, or is not drawn yet.
    pub(crate) fn measured(&self) -> Option<[f32; 2]> {
        let (mode, ends) = self.renderer.scale()?;
        (mode == self.settings.parameters().display_mode).then_some(ends)
    }

    /// Whether the fire can be drawn: it is visible, with a size and a context.
    fn can_draw(&self) -> bool {
        self.visible && self.size.0 > 0 && self.size.1 > 0 && self.drawable
    }

    fn on_drawable_change(&mut self, could_draw: bool) {
        if self.can_draw() != could_draw {
            self.restart_clock();
        }
    }

    fn restart_clock(&mut self) {
        self.clock.restart();
        self.fps.skip();
        self.quality.skip();
        self.since_picture = SincePicture::default();
    }
}
