//! The renderer of one fire: particles in, pictures out.

mod draw;
mod fit;

use std::rc::Rc;

use hearth_core::params::DisplayMode;
use hearth_core::scene::Pose;
use hearth_core::{Charred, Instance, Parameters, Scene, Source};

use crate::advection;
use crate::bounds::ParticleBounds;
use crate::camera::Camera;
use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::frame_uniforms::FrameUniforms;
use crate::gl::Graphics;
use crate::image::{Image, NOISE_OFFSETS, SCENERY};
use crate::kernel::Kernel;
use crate::motion::{CarriedNoise, Motion};
use crate::palette::Tint;
use crate::particles::Particles;
use crate::resolution::{Layout, ResolutionLimits};
use crate::scale::extremes;
use crate::shared::SharedResources;
use crate::solids::Solids;
use crate::targets::Targets;
use crate::viewport::Viewport;

/// Size, time and camera of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct View {
    /// Width of the picture [device pixels].
    pub width: u32,
    /// Height of the picture [device pixels].
    pub height: u32,
    /// Age of the fire \[s\], which moves the fine structure.
    pub time: f64,
    /// Part of the world in the picture.
    pub camera: Camera,
}

/// Draws a fire into a framebuffer, with premultiplied alpha.
pub struct Renderer<G: Graphics = glow::Context> {
    shared: Rc<SharedResources<G>>,
    /// The framebuffer of the pictures; `None`: that of the canvas or window.
    output: Option<G::Framebuffer>,
    limits: ResolutionLimits,
    particles: Particles<G>,
    embers: Particles<G>,
    solids: Solids<G>,
    targets: Targets<G>,
    /// Colour table of another palette than the black body, whose table all fires share.
    tinted: Option<(Tint, G::Texture)>,
    bounds: ParticleBounds,
    motion: Motion,
    carried: Option<CarriedNoise>,
    /// Position of the world in the last picture.
    viewport: Option<Viewport>,
    /// The source on a solid of the uploaded scene.
    source: Option<Source>,
    /// Index of the newest of the two targets of the noise advection.
    newest: usize,
    /// The drawn backdrop: its wall, ground and foot, and the picture's floor and size.
    scenery: Option<([f32; 3], [[f32; 2]; 2])>,
    /// Range of the measured quantity.
    measured: Option<[f32; 2]>,
}

impl<G: Graphics> Renderer<G> {
    /// A renderer with its own GPU resources, for a context with one fire.
    ///
    /// # Errors
    /// The driver rejects a shader, a texture or every format.
    pub fn new(gl: &G) -> Result<Renderer<G>, RenderError> {
        Renderer::within(gl, Rc::new(SharedResources::new(gl)?))
    }

    /// As [`new`](Renderer::new), with a given target format.
    ///
    /// # Errors
    /// The driver rejects a shader, a texture or this format.
    pub fn with_format(gl: &G, format: TargetFormat) -> Result<Renderer<G>, RenderError> {
        Renderer::within(gl, Rc::new(SharedResources::with_format(gl, format)?))
    }

    /// A renderer that shares GPU resources with others of the same context.
    ///
    /// # Errors
    /// The driver rejects a texture.
    pub fn within(gl: &G, shared: Rc<SharedResources<G>>) -> Result<Renderer<G>, RenderError> {
        let max_rows = shared.max_side;
        Ok(Renderer {
            shared,
            output: None,
            limits: ResolutionLimits::MEDIUM,
            particles: Particles::new(gl, max_rows)?,
            embers: Particles::new(gl, max_rows)?,
            solids: Solids::new(Particles::new(gl, max_rows)?),
            targets: Targets::new(),
            tinted: None,
            bounds: ParticleBounds::of(&[], &[]),
            motion: Motion::default(),
            carried: None,
            viewport: None,
            source: None,
            newest: 0,
            scenery: None,
            measured: None,
        })
    }

    /// Format of the off-screen targets.
    pub fn target_format(&self) -> TargetFormat {
        self.shared.format
    }

    /// State of the fine structure.
    pub fn motion(&self) -> Motion {
        self.motion
    }

    /// Reads the offsets of the advected noise. Only paused fires should: reading stalls the
    /// graphics pipeline.
    pub fn carried(&self, gl: &G) -> Option<CarriedNoise> {
        let (layout, target) = self.targets.get(NOISE_OFFSETS + self.newest)?;
        (self.shared.format == TargetFormat::Rgba16F).then(|| CarriedNoise {
            layout: *layout,
            texels: target.read(gl),
        })
    }

    /// Continues the state of another renderer of the same fire.
    pub fn resume(&mut self, motion: Motion, carried: Option<CarriedNoise>) {
        self.motion = motion;
        self.carried = carried;
    }

    /// Display mode of the last picture and the quantities of its first and last colour, in the
    /// unit of [`DisplayMode::quantity`]; `None` if the mode measures nothing.
    pub fn scale(&self) -> Option<(DisplayMode, [f32; 2])> {
        self.motion.scale.ends()
    }

    /// Sets the framebuffer of the next pictures, which the renderer does not free; `None`: that of the
    /// canvas or window. A context without a surface has no framebuffer of its own.
    pub fn set_output(&mut self, output: Option<G::Framebuffer>) {
        self.output = output;
    }

    /// Sets the limits of the resolution for the next pictures.
    pub fn set_limits(&mut self, limits: ResolutionLimits) {
        self.limits = limits;
    }

    /// Uploads particles, in the layout of a display mode, and embers to the graphics card.
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

    /// Uploads the solids of a scene where they are. Until the next call they stay in the pictures. Those that
    /// conduct heat have the temperatures \[K\] of their ids, or at first that of the scene; those that have
    /// fuel, what is left of them.
    pub fn upload_solids(
        &mut self,
        gl: &G,
        scene: &Scene,
        poses: &[Pose],
        temperatures: &[(u32, f32)],
        charred: &Charred,
    ) {
        self.source = Source::on_solid(scene.settings(), poses);
        self.solids.upload(gl, scene, poses, temperatures, charred);
    }

    /// Draws the uploaded particles and solids. Ignores a picture without pixels.
    ///
    /// # Errors
    /// The driver has no memory for targets of this size.
    pub fn paint(
        &mut self,
        gl: &G,
        view: &View,
        parameters: &Parameters,
    ) -> Result<(), RenderError> {
        self.paint_in_passes(gl, view, parameters, &mut |_| {})
    }

    /// As [`paint`](Renderer::paint); calls `on_pass` with the key of each pass after it was
    /// submitted.
    ///
    /// # Errors
    /// The driver has no memory for targets of this size.
    pub fn paint_in_passes(
        &mut self,
        gl: &G,
        view: &View,
        parameters: &Parameters,
        on_pass: &mut dyn FnMut(&'static str),
    ) -> Result<(), RenderError> {
        self.draw_frame(gl, view, parameters, &|_| true, on_pass)
    }

    /// Advances the state that the next picture continues, as a picture at that moment does, without
    /// drawing one.
    ///
    /// # Errors
    /// The driver has no memory for targets of this size.
    pub fn advance(
        &mut self,
        gl: &G,
        view: &View,
        parameters: &Parameters,
    ) -> Result<(), RenderError> {
        let continued = |image| matches!(image, Image::Flow | Image::NoiseOffsets);
        self.draw_frame(gl, view, parameters, &continued, &mut |_| {})
    }

    /// Draws the passes with these targets.
    fn draw_frame(
        &mut self,
        gl: &G,
        view: &View,
        parameters: &Parameters,
        draws: &dyn Fn(Image) -> bool,
        on_pass: &mut dyn FnMut(&'static str),
    ) -> Result<(), RenderError> {
        let size = [view.width, view.height];
        let Some(layout) = Layout::new(size, self.limits, self.shared.max_side) else {
            return Ok(());
        };
        let domain = [parameters.domain_width, parameters.domain_height];
        let viewport = Viewport::new(layout.picture, domain, view.camera);
        let before = self.viewport.replace(viewport).unwrap_or(viewport);
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
        self.motion.scale.add(mode, model, self.measured);
        let source = self.source.unwrap_or_else(|| Source::of(parameters));
        let mut frame = FrameUniforms {
            parameters,
            source,
            layout,
            format: self.shared.format,
            viewport,
            before,
            time: view.time,
            particles: self.particles.count(),
            embers: self.embers.count(),
            solids: self.solids.texture.count(),
            motion: self.motion,
            kernel: Kernel::of(parameters, &source),
            used: layout.field,
            reach: [0.0; 4],
            scenery_is_stale: true,
        };
        frame.fit(&self.bounds);
        self.fit_targets(gl, &frame)?;
        if mode == DisplayMode::Fire {
            self.motion.rise.advance(&self.bounds, view.time, model);
            let period = advection::period(frame.source.width);
            self.motion.advection.advance(view.time, period);
            self.newest = 1 - self.newest;
        }
        frame.motion = self.motion;
        if frame.has_backdrop() && draws(Image::Scenery) {
            let position = (
                [frame.wall(), frame.ground(), frame.wall_foot()],
                [viewport.floor, viewport.heights()],
            );
            frame.scenery_is_stale = self.scenery.replace(position) != Some(position);
        }
        self.draw(gl, &frame, draws, on_pass);
        gl.bind_vertex_array(None);
        Ok(())
    }

    /// Frees the resources, and the shared ones with their last user.
    pub fn destroy(mut self, gl: &G) {
        self.particles.destroy(gl);
        self.embers.destroy(gl);
        self.solids.texture.destroy(gl);
        self.targets.destroy(gl);
        if let Some((_, colours)) = &self.tinted {
            gl.delete_texture(colours);
        }
        if let Some(shared) = Rc::into_inner(self.shared) {
            shared.destroy(gl);
        }
    }
}
