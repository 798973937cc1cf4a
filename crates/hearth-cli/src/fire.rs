//! A fire that burns for a picture, as the element's fire does at a stated level of quality.

use hearth_core::params::DisplayMode;
use hearth_core::resolution::{CountInputs, Level, ParticleCount, SizeLimit};
use hearth_core::warm_up::WarmUp;
use hearth_core::{Charred, Instance, Scene, Simulation, Vec2};
use hearth_render::{Camera, Viewport};
use hearth_settings::Requested;

use crate::Painter;
use crate::error::Error;

/// Moments per second of fire at which the state between pictures advances: the pictures of the
/// element on a usual display.
const FRAMES_PER_SECOND: f64 = 60.0;

/// A fire and what it shows.
pub struct Fire {
    requested: Requested,
    level: Level,
    warm_up: WarmUp,
    pub(crate) simulation: Simulation,
    pub(crate) instances: Vec<Instance>,
    pub(crate) embers: Vec<Instance>,
    pub(crate) charred: Charred,
}

impl Fire {
    /// A fire at that level of quality before its first step. It warms up for `warm` \[s\]: most of that time
    /// with few particles.
    pub fn new(requested: Requested, level: Level, warm: f64) -> Fire {
        let mut fire = Fire {
            simulation: Simulation::new(Scene::default()),
            warm_up: WarmUp::new(warm, Vec::new()),
            requested,
            level,
            instances: Vec::new(),
            embers: Vec::new(),
            charred: Charred::default(),
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
            settings: self.requested.resolution(),
            level: self.level,
            is_level_requested: true,
            size: SizeLimit::default(),
            machine: u32::MAX,
            is_coarse: self.warm_up.is_coarse(),
        });
        self.requested.at(count.number)
    }

    /// The simulation.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Sends the simulation the part of the world that pictures of that size show: gas that is seen
    /// stays in open air.
    pub fn see(&mut self, size: [u32; 2], camera: Camera) {
        let values = self.requested.parameters();
        let domain = [values.domain_width, values.domain_height];
        let viewport = Viewport::new(size, domain, camera.zoomed_out());
        self.simulation
            .see(Some(viewport.corners().map(Vec2::from)));
    }

    /// Burns until an age \[s\]. The painter follows, so that its next picture continues the motion of
    /// the fine structure. Calls `on_step` with the age after each step.
    ///
    /// # Errors
    /// The driver has no memory.
    pub fn burn(
        &mut self,
        until: f64,
        painter: &mut Painter<'_>,
        on_step: &mut dyn FnMut(f64),
    ) -> Result<(), Error> {
        let frame = |time: f64| (time * FRAMES_PER_SECOND).floor();
        // The element's first picture has a fire before its first step, or a warm one.
        if self.simulation.time() == 0.0 && until > 0.0 && !self.warm_up.is_on() {
            painter.follow(self)?;
        }
        while self.simulation.time() < until {
            let before = self.simulation.time();
            self.simulation.step();
            let now = self.simulation.time();
            if self.warm_up.is_on() && self.warm_up.advance(now - before) {
                let scene = self.scene();
                self.simulation.set_scene(scene);
            }
            on_step(now);
            // The element draws no picture before its fire is warm.
            if frame(now) > frame(before) && now < until && !self.warm_up.is_on() {
                painter.follow(self)?;
            }
        }
        Ok(())
    }

    /// Writes what the renderer gets.
    pub(crate) fn write(&mut self) {
        let fire = &self.simulation;
        fire.write_instances(&mut self.instances);
        fire.write_charred(&mut self.charred);
        if fire.parameters().display_mode == DisplayMode::Fire {
            fire.write_embers(&mut self.embers);
        } else {
            self.embers.clear();
        }
    }
}
