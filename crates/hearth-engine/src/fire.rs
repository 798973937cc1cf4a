//! A fire: its simulation, and when, how and how much of it is drawn.

mod copy;
pub mod film;
mod playback;
mod presentation;
mod sound;
pub mod tick;

use hearth_bindings::memory;
use hearth_core::resolution::{Level, ParticleCount};
use hearth_core::{Parameters, Scene, Simulation, burning};
use hearth_render::{Camera, Fit};
use hearth_settings::Settings;

use crate::commands::Start;
use crate::events::Events;
use crate::pacing::Pacing;
use crate::sound::Sound;
use playback::Playback;
use presentation::Presentation;

/// Memory of the largest map of open air, in particles.
const MAP_MEMORY_IN_PARTICLES: usize = 4096;

/// A fire of an engine.
pub struct Fire {
    id: u32,
    /// The settings of the simulation, except for the number of particles that the quality
    /// decides.
    settings: Settings,
    pub(crate) simulation: Simulation,
    pub(crate) playback: Playback,
    pub(crate) presentation: Presentation,
    pub(crate) pacing: Pacing,
    /// The sound, while a page plays it.
    sound: Option<Box<Sound>>,
    /// Time of the last statistics \[ms\].
    stats_at: f64,
    /// Whether it waits while a copy of it is filmed.
    waits: bool,
}

impl Fire {
    /// A fire before its first step. It is not visible and has no size. `on_page`: its thread is
    /// the page's own.
    pub fn new(id: u32, settings: Settings, start: &Start<'_>, on_page: bool) -> Fire {
        let mut fire = Fire {
            id,
            settings,
            simulation: Simulation::new(Parameters::default()),
            playback: Playback::new(start),
            presentation: Presentation::default(),
            pacing: Pacing::new(start, on_page),
            sound: None,
            stats_at: f64::NEG_INFINITY,
            waits: false,
        };
        fire.presentation.lights = start.lights;
        fire.presentation.sheets = start.sheets;
        fire.simulation = Simulation::new(fire.scene());
        fire
    }

    /// Number of the fire in calls and events.
    pub fn id(&self) -> u32 {
        self.id
    }

    /// The number of the fire that this one copies for a film: it burns by requested steps alone, with as many particles.
    pub fn films(&self) -> Option<u32> {
        self.presentation.film.as_ref().map(|film| film.of)
    }

    /// Goes on after a film. The time of the film is not made up for.
    pub fn go_on(&mut self) {
        self.waits = false;
        self.restart_clock();
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
            self.pacing.averages.forget_steps();
        }
        if !settings.costs_like(old) {
            self.pacing.restart();
        }
        let time = self.simulation.time();
        let warms = self.playback.warm_up.is_enabled();
        // The fire of another scene starts without gas of the previous one.
        let starts = warms
            && (replaced || !self.presentation.drawn && self.playback.starts_over())
            && burning::digest(settings.scene()) != burning::digest(old.scene());
        self.settings = settings;
        self.adapt();
        if starts || warms && self.simulation.time() < time {
            self.start(events);
        }
    }

    /// Fixes the level of quality, or makes it adaptive.
    pub fn request_quality(&mut self, level: Option<Level>, events: &Events) {
        let quality = &mut self.pacing.quality;
        let before = (quality.requested(), quality.level());
        quality.request(level);
        if before != (quality.requested(), quality.level()) {
            events.quality(self.id, quality);
        }
        self.pacing.real_time.forget_losses();
        self.adapt();
    }

    /// Changes whether the fire can be drawn. Time without a picture is not made up for.
    pub fn present(&mut self, change: &dyn Fn(&mut Presentation)) {
        let could_draw = self.presentation.can_draw();
        change(&mut self.presentation);
        if self.presentation.can_draw() != could_draw {
            self.restart_clock();
        }
    }

    /// Resizes the picture. A size of zero draws nothing.
    pub fn resize(&mut self, size: (u32, u32), side: f64) {
        self.present(&|presentation| presentation.resize(size));
        if self.pacing.resize(side) {
            self.adapt();
        }
        self.set_visible_area();
    }

    /// Sets how the domain fits the picture.
    pub fn set_fit(&mut self, fit: Fit, align: [f32; 2]) {
        let camera = &mut self.presentation.camera;
        *camera = Camera {
            fit,
            align,
            ..*camera
        };
        self.presentation.current = false;
        self.set_visible_area();
    }

    /// Acts on the burning fire, whose picture is out of date then.
    pub fn act<T>(&mut self, act: impl FnOnce(&mut Simulation) -> T) -> T {
        self.presentation.current = false;
        act(&mut self.simulation)
    }

    /// Plays or pauses.
    pub fn set_playing(&mut self, playing: bool, events: &Events) {
        if self.playback.playing != playing {
            self.playback.playing = playing;
            self.presentation.current = false;
            self.restart_clock();
            events.state(self.id, playing);
        }
    }

    /// Restarts the simulation.
    pub fn reset(&mut self, events: &Events) {
        self.simulation.reset();
        self.presentation.history.clear();
        self.presentation.current = false;
        self.restart_clock();
        if self.playback.warm_up.is_enabled() {
            self.start(events);
        }
    }

    /// Whether the next frame has work for this fire.
    pub fn needs_frame(&self) -> bool {
        let can_draw = self.presentation.can_draw();
        let requests = &self.playback.requests;
        let pending = !requests.is_empty() || (requests.awaits_drawing() && !can_draw);
        let burns = self.playback.playing || self.playback.is_warming();
        !self.waits && (pending || (can_draw && (burns || self.presentation.needs_picture())))
    }

    /// Whether a frame at `now` \[ms\] does work: the limit of the frame rate allows a picture, or steps do not wait for it.
    pub fn is_due(&mut self, now: f64) -> bool {
        !self.playback.requests.is_empty()
            || self.playback.is_warming()
            || self.presentation.is_due(now)
    }

    /// Quantities of the first and last colour of the picture; `None` if the display mode
    /// measures nothing, or is not drawn yet.
    pub(crate) fn measured(&self) -> Option<[f32; 2]> {
        let (mode, ends) = self.presentation.renderer.scale()?;
        (mode == self.settings.parameters().display_mode).then_some(ends)
    }

    /// The present number of particles, and what limits it.
    pub(crate) fn particle_count(&self) -> ParticleCount {
        let is_coarse = self.playback.warm_up.is_coarse();
        self.pacing
            .particle_count(self.settings.resolution(), is_coarse)
    }

    /// The scene with the present number of particles.
    fn scene(&self) -> Scene {
        self.settings.at(self.particle_count().number)
    }

    /// Applies the settings and the number of particles to the simulation.
    fn adapt(&mut self) {
        let scene = self.scene();
        self.simulation.adapt(scene);
        self.set_visible_area();
        self.presentation.current = false;
    }

    /// Tells the simulation the part of the world that the picture shows before it is enlarged.
    fn set_visible_area(&mut self) {
        let values = self.settings.parameters();
        let domain = [values.domain_width, values.domain_height];
        // The map of what is seen needs less memory than so many particles.
        let has_room = !values.has_open_edges() || memory::has_room(MAP_MEMORY_IN_PARTICLES);
        if let Some(area) = self.presentation.visible_area(domain)
            && has_room
        {
            self.simulation.set_visible_area(Some(area));
        }
    }

    /// Starts a new fire with a warm-up before the next step.
    fn start(&mut self, events: &Events) {
        self.playback.start();
        self.presentation.current = false;
        self.restart_clock();
        if self.presentation.drawn {
            events.warming(self.id);
        }
    }

    /// Starts the warm-up of a new fire, or resumes the saved one.
    fn begin_warm_up(&mut self, events: &Events) {
        let resolution = self.settings.resolution();
        let scene = self
            .settings
            .at(self.pacing.particle_count(resolution, false).number);
        self.presentation.history.clear();
        self.playback.starts = false;
        if let Some(error) = self.playback.warm_up.begin(&mut self.simulation, scene) {
            events.warn(self.id, &error.to_string());
        }
        if self.playback.warm_up.is_on() {
            self.adapt();
        }
        self.set_visible_area();
        self.presentation.current = false;
    }

    fn restart_clock(&mut self) {
        self.playback.clock.restart();
        self.pacing.skip();
    }
}
