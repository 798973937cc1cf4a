//! What is seen of a fire: its picture, and whether and how it is drawn.

use glam::Vec2;
use hearth_core::params::DisplayMode;
use hearth_core::{Charred, Instance, Simulation};
use hearth_render::{Camera, History, ResolutionLimits, Viewport};

use super::film::Film;
use crate::fire_renderer::{FireRenderer, FrameInput};
use crate::pacing::picture_limits::{Fps, PictureLimits, Pixels};
use crate::pacing::quality::Quality;
use crate::shared_canvas::SharedCanvas;
use crate::wall_clock::WallClock;

/// The picture of a fire. At first it is not visible and has no size.
#[derive(Default)]
pub struct Presentation {
    pub(crate) renderer: FireRenderer,
    pub(crate) history: History,
    pub(super) camera: Camera,
    /// Size of the element [device pixels].
    pub(super) size: (u32, u32),
    pub(super) limits: PictureLimits,
    /// Earliest time of the next picture if their rate is limited \[ms\].
    next: f64,
    visible: bool,
    /// Whether there is a context to draw in.
    drawable: bool,
    /// Whether the picture is up to date.
    pub(super) current: bool,
    /// Whether the fire was ever drawn.
    pub(super) drawn: bool,
    /// Whether a picture is followed by its lights, and whether it is an atlas.
    pub(super) lights: bool,
    pub(super) sheets: bool,
    instances: Vec<Instance>,
    embers: Vec<Instance>,
    charred: Charred,
    /// What is filmed, if this is a copy for a film.
    pub(super) film: Option<Box<Film>>,
}

impl Presentation {
    /// Shows what another one does. It is not visible and has no size.
    pub fn copy(&mut self, other: &Presentation) {
        self.history = other.history.clone();
        self.camera = other.camera;
        self.drawable = other.drawable;
    }

    /// Whether the fire can be drawn: it is visible, with a size and a context.
    pub fn can_draw(&self) -> bool {
        self.visible && self.size.0 > 0 && self.size.1 > 0 && self.drawable
    }

    /// Whether the picture is out of date, and another may be drawn.
    pub fn needs_picture(&self) -> bool {
        !self.current && self.renderer.is_ready()
    }

    /// Whether the limit of the frame rate allows a picture at `now` \[ms\].
    pub fn is_due(&mut self, now: f64) -> bool {
        self.limits.is_due(now, &mut self.next)
    }

    /// Resizes the picture. A size of zero draws nothing.
    pub fn resize(&mut self, size: (u32, u32)) {
        self.current &= self.size == size;
        self.size = size;
    }

    /// Sets whether the element is visible.
    pub fn set_visible(&mut self, visible: bool) {
        self.visible = visible;
        if !visible {
            // Other fires can use the memory of its targets.
            self.renderer.free();
            self.current = false;
        }
    }

    /// Sets whether there is a context to draw in.
    pub fn set_drawable(&mut self, drawable: bool) {
        self.drawable = drawable;
        self.renderer.free();
        self.current = false;
    }

    /// Limits pictures per second.
    pub fn limit_fps(&mut self, fps: Option<Fps>) {
        self.limits.fps = fps.map(|fps| fps.0);
        self.current = false;
    }

    /// Limits the pixels of a picture.
    pub fn limit_pixels(&mut self, pixels: Option<Pixels>) {
        self.limits.pixels = pixels.map(|pixels| pixels.0);
        self.current = false;
    }

    /// Enlarges a part of the picture.
    pub fn set_zoom(&mut self, zoom: f32, pan: [f32; 2]) {
        self.camera = Camera {
            zoom,
            pan,
            ..self.camera
        };
        self.current = false;
    }

    /// The part of the world that the picture shows of a domain of that size before it is enlarged \[m\]; `None` without
    /// a size.
    pub fn visible_area(&self, domain: [f32; 2]) -> Option<[Vec2; 2]> {
        let (width, height) = self.size;
        (width > 0 && height > 0).then(|| {
            let camera = self.camera.zoomed_out();
            let viewport = Viewport::new([width, height], domain, camera);
            viewport.corners().map(Vec2::from)
        })
    }

    /// The numbers of the event `lights` of the last picture.
    pub fn light_numbers(&self, simulation: &Simulation) -> Vec<f32> {
        let values = simulation.parameters();
        let area = self.visible_area([values.domain_width, values.domain_height]);
        let mut numbers = Vec::new();
        numbers.extend(area.into_iter().flatten().flat_map(|at| at.to_array()));
        numbers.extend(hearth_render::light(&self.instances, values));
        numbers.extend(hearth_render::pale(values));
        numbers.extend(self.embers.iter().flatten());
        numbers
    }

    /// Draws the picture of the fire with this number. Returns the time at which the upload of the particles ended \[ms\].
    ///
    /// # Errors
    /// The driver rejects a resource, and nothing more is drawn.
    pub fn draw(
        &mut self,
        fire: u32,
        simulation: &Simulation,
        quality: &Quality,
        is_paused: bool,
        canvas: &SharedCanvas,
        clock: &WallClock,
    ) -> Result<f64, String> {
        // A fire that is drawn before its first step has no sample yet.
        self.history.follow(simulation);
        simulation.write_instances(&mut self.instances);
        simulation.write_charred(&mut self.charred);
        if simulation.parameters().display_mode == DisplayMode::Fire {
            simulation.write_embers(&mut self.embers);
        } else {
            self.embers.clear();
        }
        if let Some(film) = &mut self.film {
            film.follow(simulation, &mut self.embers);
        }
        let temperatures: Vec<_> = simulation.solid_temperatures().collect();
        let drawn = self.renderer.draw(
            canvas,
            &FrameInput {
                fire,
                size: self.limits.fit(self.size, quality.pixels()),
                limits: ResolutionLimits::of(quality.level()),
                camera: self.camera,
                time: simulation.time(),
                is_paused,
                scene: simulation.scene(),
                particles: &self.instances,
                embers: &self.embers,
                temperatures: &temperatures,
                poses: &simulation.poses(),
                charred: &self.charred,
                sheets: self.sheets,
                history: &self.history,
            },
            clock,
        );
        self.drawn = true;
        self.current = true;
        self.drawable &= drawn.is_ok();
        drawn
    }
}
