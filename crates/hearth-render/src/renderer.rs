//! The renderer of one fire: particles in, pictures out.

mod draw;
mod fit;
mod slices;

use std::rc::Rc;

use hearth_core::params::{Backdrop, DisplayMode, Model};
use hearth_core::scene::Pose;
use hearth_core::{Charred, Instance, Scene, SourcePlace};

use crate::advection::Phase;
use crate::bounds::{Bounds, ParticleBounds};
use crate::camera::Camera;
use crate::embers::Paths;
use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::frame_uniforms::{Advected, Batch, FrameUniforms};
use crate::gl::Graphics;
use crate::history::History;
use crate::kernel::Kernel;
use crate::palette::Tint;
use crate::particles::Particles;
use crate::resolution::{Layout, ResolutionLimits};
use crate::ring::Ring;
use crate::scale::{Scale, extremes};
use crate::shared::SharedResources;
use crate::slices::{Count, MAX_SLICES, Slice};
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
    /// Whether the fire stands still: then another number of slices is shown at once.
    pub is_paused: bool,
    /// Whether a fire without solids and embers is drawn as an [atlas](crate::atlas_size): from the left, the light of the front
    /// slice in four, that of each slice behind it in one, then the glow below the light on smoke. A cell is empty
    /// where no slice is visible.
    pub sheets: bool,
}

/// Draws a fire into a framebuffer, with premultiplied alpha.
pub struct Renderer<G: Graphics = glow::Context> {
    shared: Rc<SharedResources<G>>,
    /// The framebuffer of the pictures; `None`: that of the canvas or window.
    output: Option<G::Framebuffer>,
    limits: ResolutionLimits,
    particles: Particles<G>,
    embers: Particles<G>,
    paths: Paths,
    solids: Solids<G>,
    targets: Targets<G>,
    /// Colour table of a tint.
    tinted: Option<(Tint, G::Texture)>,
    bounds: ParticleBounds,
    ember_bounds: Bounds,
    /// Past particles.
    ring: Ring<G>,
    /// The advected noise of each slice.
    noise: [slices::Noise; MAX_SLICES],
    /// Number of slices of the last picture.
    slices: usize,
    /// Number of slices that scene and quality want, as they fade.
    count: Count,
    scale: Scale,
    /// The sources of the uploaded scene, those on solids alone.
    on_solids: Vec<Option<SourcePlace>>,
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
            paths: Paths::default(),
            solids: Solids::new(Particles::new(gl, max_rows)?),
            targets: Targets::new(),
            tinted: None,
            bounds: ParticleBounds::of(&[]),
            ember_bounds: Bounds::of_all(&[]),
            ring: Ring::new(max_rows),
            noise: Default::default(),
            slices: 0,
            count: Count::default(),
            scale: Scale::default(),
            on_solids: Vec::new(),
            scenery: None,
            measured: None,
        })
    }

    /// Format of the off-screen targets.
    pub fn target_format(&self) -> TargetFormat {
        self.shared.format
    }

    /// The colour scale of the last picture.
    pub fn colour_scale(&self) -> Scale {
        self.scale
    }

    /// Continues the colour scale of another renderer of the same fire.
    pub fn resume(&mut self, scale: Scale) {
        self.scale = scale;
    }

    /// Number of slices of the last picture.
    pub fn slices(&self) -> usize {
        self.slices
    }

    /// Display mode of the last picture and the quantities of its first and last colour, in the
    /// unit of [`DisplayMode::quantity`]; `None` if the mode measures nothing.
    pub fn scale(&self) -> Option<(DisplayMode, [f32; 2])> {
        self.scale.ends()
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
        self.bounds = ParticleBounds::of(instances);
        self.ember_bounds = Bounds::of_all(embers);
        self.measured = mode.quantity().and_then(|_| extremes(instances));
        self.particles.upload(gl, instances);
        self.embers.upload(gl, self.paths.records(embers));
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
        let places = scene
            .sources()
            .map(|source| SourcePlace::on_solid(&source, poses));
        self.on_solids.clear();
        self.on_solids.extend(places);
        self.solids.upload(gl, scene, poses, temperatures, charred);
    }

    /// Draws the uploaded particles and solids, with the fine structure and the slices of a history. Ignores a picture without pixels.
    ///
    /// # Errors
    /// The driver has no memory for targets of this size.
    pub fn paint(
        &mut self,
        gl: &G,
        view: &View,
        scene: &Scene,
        history: &History,
    ) -> Result<(), RenderError> {
        self.paint_in_passes(gl, view, scene, history, &mut |_| {})
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
        scene: &Scene,
        history: &History,
        on_pass: &mut dyn FnMut(&'static str),
    ) -> Result<(), RenderError> {
        let size = [view.width, view.height];
        let parameters = scene.world();
        let has_wall = parameters.backdrop == Backdrop::Bricks && !view.sheets;
        let limits = if has_wall {
            self.limits.before_wall()
        } else {
            self.limits
        };
        let Some(layout) = Layout::new(size, limits, self.shared.max_side) else {
            return Ok(());
        };
        let domain = [parameters.domain_width, parameters.domain_height];
        let viewport = Viewport::new(layout.picture, domain, view.camera);
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
        self.scale.add(mode, model, self.measured);
        let on_solids = self.on_solids.iter().chain(std::iter::repeat(&None));
        let places = scene.sources().zip(on_solids);
        // The gas of turned sources streams to all sides, also under the others.
        let turned = scene.sources().any(|source| source.angle != 0.0);
        let mut places: Vec<_> = places
            .map(|(source, on_solid)| on_solid.unwrap_or_else(|| SourcePlace::of(&source)))
            .collect();
        let first = places.first().copied();
        let source = first.unwrap_or_else(|| SourcePlace::first(scene, &[]));
        // Fuels burn on without any source.
        if places.is_empty() {
            places.push(source);
        }
        let sources: Vec<_> = places
            .iter()
            .map(|place| {
                let at_every_height = f32::from(place.on_solid || turned);
                [place.base.x, place.base.y, place.width, at_every_height]
            })
            .collect();
        let present = Slice::present(view.time);
        let mut frame = FrameUniforms {
            parameters,
            birth_temperature: scene.read_first_source(|source| source.birth_temperature),
            source,
            sources: &sources,
            layout,
            format: self.shared.format,
            viewport,
            before: viewport,
            time: view.time,
            particles: Batch::present(self.particles.count()),
            embers: self.embers.count(),
            solids: if view.sheets {
                0
            } else {
                self.solids.texture.count()
            },
            cladding: 0,
            sheets: view.sheets,
            slice: present,
            phase: Phase::default(),
            advected: Advected::default(),
            risen: history.rise.distance_at(view.time),
            flame_height: history.rise.flame_height(source.base.y),
            scale: self.scale,
            kernel: Kernel::of(parameters, &source),
            used: layout.field,
            reach: Bounds::default(),
            behind: None,
            scenery_is_stale: true,
        };
        if frame.enlarges() && frame.has_wall() {
            frame.cladding = self.solids.cladding;
        }
        frame.fit(if frame.burns_as(Model::Combustion) {
            &self.bounds.visible
        } else {
            &self.bounds.all
        });
        let mut slices = vec![present];
        // Eight bits store roots, which do not blend. The classic model's gas is a cloud without sheets.
        if frame.advects_noise() {
            let wanted = self.limits.slices.min(parameters.depth as usize);
            let count = self.count.advance(view.time, wanted, view.is_paused);
            slices = history.slices(view.time, count, &source);
            self.ring.upload(gl, history)?;
        }
        frame.behind = (slices.len() > 1).then(Bounds::default);
        self.fit_targets(gl, &frame, &slices)?;
        let slices = self.slice_frames(&mut frame, history, &slices);
        self.slices = slices.len();
        if frame.has_backdrop() {
            let position = (
                [frame.wall(), frame.ground(), frame.wall_foot()],
                [viewport.floor, viewport.heights()],
            );
            frame.scenery_is_stale = self.scenery.replace(position) != Some(position);
        }
        self.draw(gl, &frame, &slices, on_pass);
        gl.bind_vertex_array(None);
        Ok(())
    }

    /// Frees the resources, and the shared ones with their last user.
    pub fn destroy(mut self, gl: &G) {
        self.particles.destroy(gl);
        self.embers.destroy(gl);
        self.solids.texture.destroy(gl);
        self.ring.destroy(gl);
        self.targets.destroy(gl);
        if let Some((_, colours)) = &self.tinted {
            gl.delete_texture(colours);
        }
        if let Some(shared) = Rc::into_inner(self.shared) {
            shared.destroy(gl);
        }
    }
}
