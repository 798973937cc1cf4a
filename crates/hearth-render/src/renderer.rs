//! The renderer of one fire: it takes particles and draws pictures.

mod draw;
mod fit;

use std::rc::Rc;

use hearth_core::params::DisplayMode;
use hearth_core::{Instance, Parameters};

use crate::advection;
use crate::bounds::ParticleBounds;
use crate::camera::Camera;
use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::frame::Frame;
use crate::gl::Graphics;
use crate::image::{CARRIED, SCENERY};
use crate::motion::{CarriedNoise, Motion};
use crate::palette::Tint;
use crate::particles::Particles;
use crate::resolution::{Layout, ResolutionLimits};
use crate::scale::extremes;
use crate::shared::SharedResources;
use crate::targets::Targets;
use crate::viewport::Viewport;

/// What of the world is seen, and when.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct View {
    /// Width of the picture in device pixels.
    pub width: u32,
    /// Height of the picture in device pixels.
    pub height: u32,
    /// Seconds of fire, for structure that moves.
    pub time: f64,
    /// Which part of the world it shows.
    pub camera: Camera,
}

/// Draws a fire into the default framebuffer, with premultiplied alpha.
pub struct Renderer<G: Graphics = glow::Context> {
    shared: Rc<SharedResources<G>>,
    limits: ResolutionLimits,
    particles: Particles<G>,
    embers: Particles<G>,
    targets: Targets<G>,
    /// Colours of a palette other than the black body's, which all fires share.
    tinted: Option<(Tint, G::Texture)>,
    bounds: ParticleBounds,
    motion: Motion,
    carried: Option<CarriedNoise>,
    /// Camera of the last picture.
    camera: Option<Camera>,
    /// Which of the two targets of the carried noise is the newest.
    newest: usize,
    /// How the backdrop stands that is drawn: its foot, the picture's floor and size.
    scenery: Option<(f32, [[f32; 2]; 2])>,
    /// Smallest and largest value of what is measured of the particles.
    measured: Option<[f32; 2]>,
}

impl<G: Graphics> Renderer<G> {
    /// A renderer with GPU resources of its own, for a context with one fire.
    ///
    /// # Errors
    /// The driver refuses a shader, a texture, a buffer or every format.
    pub fn new(gl: &G) -> Result<Renderer<G>, RenderError> {
        Renderer::within(gl, Rc::new(SharedResources::new(gl)?))
    }

    /// As [`new`](Renderer::new), with a given target format.
    ///
    /// # Errors
    /// The driver refuses a shader, a texture, a buffer or this format.
    pub fn with_format(gl: &G, format: TargetFormat) -> Result<Renderer<G>, RenderError> {
        Renderer::within(gl, Rc::new(SharedResources::with_format(gl, format)?))
    }

    /// A renderer that shares GPU resources with others of the same context.
    ///
    /// # Errors
    /// The driver refuses a texture.
    pub fn within(gl: &G, shared: Rc<SharedResources<G>>) -> Result<Renderer<G>, RenderError> {
        let max_rows = shared.max_side;
        Ok(Renderer {
            shared,
            limits: ResolutionLimits::MEDIUM,
            particles: Particles::new(gl, max_rows)?,
            embers: Particles::new(gl, max_rows)?,
            targets: Targets::new(),
            tinted: None,
            bounds: ParticleBounds::of(&[], &[]),
            motion: Motion::default(),
            carried: None,
            camera: None,
            newest: 0,
            scenery: None,
            measured: None,
        })
    }

    /// The pixels of the off-screen targets.
    pub fn target_format(&self) -> TargetFormat {
        self.shared.format
    }

    /// How far the fine structure has come.
    pub fn motion(&self) -> Motion {
        self.motion
    }

    /// How far the gas has carried the noise, for a fire that stands still: reading it makes the
    /// processor wait for the graphics card.
    pub fn carried(&self, gl: &G) -> Option<CarriedNoise> {
        let (layout, target) = self.targets.get(CARRIED + self.newest)?;
        (self.shared.format == TargetFormat::Rgba16F).then(|| CarriedNoise {
            layout: *layout,
            texels: target.read(gl),
        })
    }

    /// Goes on where another renderer of the same fire was.
    pub fn resume(&mut self, motion: Motion, carried: Option<CarriedNoise>) {
        self.motion = motion;
        self.carried = carried;
    }

    /// The display mode of the last picture, and the quantities of the first and the last
    /// colour, in the unit of [`DisplayMode::quantity`]; none if the mode measures nothing.
    pub fn scale(&self) -> Option<(DisplayMode, [f32; 2])> {
        self.motion.scale.ends()
    }

    /// Sets the resolution from the next picture on.
    pub fn set_limits(&mut self, limits: ResolutionLimits) {
        self.limits = limits;
    }

    /// Uploads the particles, as they are for that display mode, and the embers to the graphics
    /// card.
    pub fn upload(
        &mut self,
        gl: &G,
        mode: DisplayMode,
        instances: &[Instance],
        embers: &[Instance],
    ) {
        self.bounds = ParticleBounds::of(instances, embers);
        self.measured = mode.quantity().and_then(|_| extremes(instances));
        self.particles.upload(gl, instances);
        self.embers.upload(gl, embers);
    }

    /// Draws the uploaded particles. A picture without pixels is ignored.
    ///
    /// # Errors
    /// The driver has no memory for targets of this size.
    pub fn paint(
        &mut self,
        gl: &G,
        view: &View,
        parameters: &Parameters,
    ) -> Result<(), RenderError> {
        self.paint_watched(gl, view, parameters, &mut |_| {})
    }

    /// As [`paint`](Renderer::paint); calls `watch` with the key of each pass after the pass was
    /// submitted. The renderer itself reads no clock.
    ///
    /// # Errors
    /// The driver has no memory for targets of this size.
    pub fn paint_watched(
        &mut self,
        gl: &G,
        view: &View,
        parameters: &Parameters,
        watch: &mut dyn FnMut(&'static str),
    ) -> Result<(), RenderError> {
        let size = [view.width, view.height];
        let Some(layout) = Layout::new(size, self.limits, self.shared.max_side) else {
            return Ok(());
        };
        let domain = [parameters.domain_width, parameters.domain_height];
        let viewport = Viewport::new(layout.picture, domain, view.camera);
        // Noise that was carried in another part of the world is of no use in this one.
        if self
            .camera
            .replace(view.camera)
            .is_some_and(|before| before != view.camera)
        {
            self.motion.advection.forget();
        }
        for capability in [
            glow::DEPTH_TEST,
            glow::STENCIL_TEST,
            glow::CULL_FACE,
            glow::BLEND,
            glow::SCISSOR_TEST,
        ] {
            gl.disable(capability);
        }
        gl.bind_vertex_array(Some(&self.shared.no_attributes));
        let (mode, model) = (parameters.display_mode, parameters.model());
        self.fit_colours(gl, Tint::of(parameters))?;
        self.motion.scale.see(mode, model, self.measured);
        let mut frame = Frame::new(
            parameters,
            (layout, self.shared.format),
            (viewport, view.time),
            ([self.particles.count(), self.embers.count()], &self.bounds),
            self.motion,
        );
        self.fit_targets(gl, &frame)?;
        if mode == DisplayMode::Fire {
            self.motion.rise.advance(&self.bounds, view.time, model);
            let period = advection::period(frame.source.width);
            self.motion.advection.advance(view.time, period);
            self.newest = 1 - self.newest;
        }
        frame.motion = self.motion;
        if frame.has_backdrop() {
            let stands = (frame.wall_foot(), [viewport.floor, viewport.heights()]);
            frame.scenery_is_stale = self.scenery.replace(stands) != Some(stands);
        }
        self.draw(gl, &frame, watch);
        gl.bind_vertex_array(None);
        Ok(())
    }

    /// Frees everything, and the shared resources if this was their last user.
    pub fn destroy(mut self, gl: &G) {
        self.particles.destroy(gl);
        self.embers.destroy(gl);
        self.targets.destroy(gl);
        if let Some((_, colours)) = &self.tinted {
            gl.delete_texture(colours);
        }
        if let Some(shared) = Rc::into_inner(self.shared) {
            shared.destroy(gl);
        }
    }
}
