//! A fire that burns for a picture, as the element's fire does at a stated level of quality.

use hearth_core::params::DisplayMode;
use hearth_core::resolution::{CountInputs, Level, ParticleCount, SizeLimit};
use hearth_core::state::{Bytes, State};
use hearth_core::warm_up::WarmUp;
use hearth_core::{Charred, Instance, Scene, Simulation, Vec2};
use hearth_render::{Camera, History, Viewport};
use hearth_settings::Settings;

use crate::film::sound::Sound;

/// A fire and what it shows.
#[derive(Clone)]
pub struct Fire {
    settings: Settings,
    level: Level,
    warm_up: WarmUp,
    pub(crate) simulation: Simulation,
    pub(crate) history: History,
    pub(crate) instances: Vec<Instance>,
    pub(crate) embers: Vec<Instance>,
    pub(crate) charred: Charred,
    /// Its sound, if it is recorded.
    pub(crate) sound: Option<Sound>,
}

impl Fire {
    /// A fire at that level of quality before its first step. It warms up for `warm` \[s\]: most of that time
    /// with few particles.
    pub fn new(settings: Settings, level: Level, warm: f64) -> Fire {
        let mut fire = Fire {
            simulation: Simulation::new(Scene::default()),
            history: History::default(),
            warm_up: WarmUp::new(warm, Vec::new()),
            settings,
            level,
            instances: Vec::new(),
            embers: Vec::new(),
            charred: Charred::default(),
            sound: None,
        };
        let scene = fire.scene();
        fire.warm_up.begin(&mut fire.simulation, scene);
        if fire.warm_up.is_on() {
            fire.simulation = Simulation::new(fire.scene());
        }
        fire
    }

    /// The scene with the present number of particles.
    fn scene(&self) -> Scene {
        let count = ParticleCount::of(&CountInputs {
            settings: self.settings.resolution(),
            level: self.level,
            is_level_requested: true,
            size: SizeLimit::default(),
            machine: u32::MAX,
            is_coarse: self.warm_up.is_coarse(),
        });
        self.settings.at(count.number)
    }

    /// What is set of the fire.
    pub(crate) fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The simulation.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Sends the simulation the part of the world that pictures of that size show: gas that is seen
    /// stays in open air.
    pub fn set_visible_area(&mut self, size: [u32; 2], camera: Camera) {
        let values = self.settings.parameters();
        let domain = [values.domain_width, values.domain_height];
        let viewport = Viewport::new(size, domain, camera.zoomed_out());
        self.simulation
            .set_visible_area(Some(viewport.corners().map(Vec2::from)));
    }

    /// Burns until an age \[s\], or until the first step that exceeds it. Calls `on_step` with the age after each step.
    pub fn burn(&mut self, until: f64, on_step: &mut dyn FnMut(f64)) {
        self.burn_by(Simulation::step, until, on_step);
    }

    /// Burns until exactly an age \[s\], because the last two steps are shorter where that is needed.
    pub fn advance(&mut self, until: f64, on_step: &mut dyn FnMut(f64)) {
        let step = |fire: &mut Simulation| fire.step_towards(until, None, &mut |_| ());
        self.burn_by(step, until, on_step);
    }

    fn burn_by(
        &mut self,
        step: impl Fn(&mut Simulation),
        until: f64,
        on_step: &mut dyn FnMut(f64),
    ) {
        // The first moment is a sample too.
        self.history.follow(&self.simulation);
        while self.simulation.time() < until {
            let before = self.simulation.time();
            step(&mut self.simulation);
            self.history.follow(&self.simulation);
            if let Some(sound) = &mut self.sound {
                sound.listen(&mut self.simulation);
            }
            let now = self.simulation.time();
            if self.warm_up.is_on() && self.warm_up.advance(now - before) {
                let scene = self.scene();
                self.simulation.set_scene(scene);
            }
            on_step(now);
        }
    }

    /// Records the sound from now on, unless it is recorded already.
    pub(crate) fn record_sound(&mut self) -> &mut Sound {
        let fire = &mut self.simulation;
        self.sound.get_or_insert_with(|| Sound::of(fire))
    }

    /// Records no sound.
    pub(crate) fn forget_sound(&mut self) {
        self.sound = None;
        self.simulation.record_series(false);
    }

    /// Appends all that a picture or a sample reads; the settings are not in it.
    pub(crate) fn save(&self, out: &mut Vec<u8>) {
        self.warm_up.save(out);
        self.simulation.save_state(out);
        self.history.save(out);
        self.sound.save(out);
    }

    /// Continues from the state of a fire with the same settings; `None` if the bytes end.
    pub(crate) fn load(&mut self, bytes: &mut Bytes<'_>) -> Option<()> {
        self.warm_up = State::load(bytes)?;
        self.simulation = Simulation::new(self.scene());
        self.simulation.load_state(bytes)?;
        self.history = State::load(bytes)?;
        self.sound = State::load(bytes)?;
        Some(())
    }

    /// Writes what the renderer gets.
    pub(crate) fn write(&mut self) {
        let fire = &self.simulation;
        // A fire that is drawn before its first step has no sample yet.
        self.history.follow(fire);
        fire.write_instances(&mut self.instances);
        fire.write_charred(&mut self.charred);
        if fire.parameters().display_mode == DisplayMode::Fire {
            fire.write_embers(&mut self.embers);
        } else {
            self.embers.clear();
        }
    }
}
