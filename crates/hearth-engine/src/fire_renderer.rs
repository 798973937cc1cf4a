//! The rendering of one fire in the context that all fires share.

use hearth_core::params::DisplayMode;
use hearth_core::scene::Pose;
use hearth_core::{Charred, Instance, Scene};
use hearth_render::{
    Camera, History, RenderError, Renderer, ResolutionLimits, Scale, View, atlas_size,
};

use crate::pass_times::PassTimes;
use crate::shared_canvas::{Gpu, SharedCanvas};
use crate::wall_clock::WallClock;
use crate::webgl::WebGl;

/// Maximum number of pictures in flight: one is shown while the next is drawn. Without a
/// maximum, a busy page would queue ever more of them.
const MAX_IN_FLIGHT: u32 = 2;

/// The GPU resources of a visible fire.
struct Drawing {
    gpu: Gpu,
    renderer: Option<Renderer<WebGl>>,
    passes: PassTimes,
}

/// What a picture of a fire shows.
pub struct FrameInput<'a> {
    /// The number of the fire.
    pub fire: u32,
    /// Size of the picture \[device pixels\].
    pub size: (u32, u32),
    /// Limits of the resolution of its targets.
    pub limits: ResolutionLimits,
    /// Part of the world in the picture.
    pub camera: Camera,
    /// Age of the fire \[s\].
    pub time: f64,
    /// Whether it is paused.
    pub is_paused: bool,
    /// Settings and objects.
    pub scene: &'a Scene,
    /// The particles.
    pub particles: &'a [Instance],
    /// The embers.
    pub embers: &'a [Instance],
    /// Where the solids are.
    pub poses: &'a [Pose],
    /// Temperatures of solids that conduct heat, by their ids \[K\].
    pub temperatures: &'a [(u32, f32)],
    /// What is left of solids with fuel.
    pub charred: &'a Charred,
    /// Whether the picture is an atlas of a picture of that size.
    pub sheets: bool,
    /// The fire's past.
    pub history: &'a History,
}

/// Draws a fire and limits its pictures in flight.
#[derive(Default)]
pub struct FireRenderer {
    drawing: Option<Drawing>,
    /// The colour scale, which outlives a lost context.
    scale: Scale,
    /// Number of drawn pictures that are not shown yet.
    in_flight: u32,
}

impl FireRenderer {
    /// Whether another picture may be drawn.
    pub fn is_ready(&self) -> bool {
        self.in_flight < MAX_IN_FLIGHT
    }

    /// Counts a picture in flight as shown.
    pub fn shown(&mut self) {
        self.in_flight = self.in_flight.saturating_sub(1);
    }

    /// Frees the GPU resources, because the context is lost or the fire cannot be drawn.
    pub fn free(&mut self) {
        self.drawing = None;
    }

    /// Times of the passes; `None` while the fire cannot be drawn.
    pub fn passes(&self) -> Option<&PassTimes> {
        self.drawing.as_ref().map(|drawing| &drawing.passes)
    }

    /// Display mode of the last picture and the quantities of its first and last colour; `None`
    /// if the mode measures no quantity.
    pub fn scale(&self) -> Option<(DisplayMode, [f32; 2])> {
        self.drawing.as_ref()?.renderer.as_ref()?.scale()
    }

    /// Number of slices of the last picture; 0 while the fire cannot be drawn.
    pub fn slices(&self) -> usize {
        let renderer = self
            .drawing
            .as_ref()
            .and_then(|drawing| drawing.renderer.as_ref());
        renderer.map_or(0, Renderer::slices)
    }

    /// Draws a picture and shows it. Returns the time at which the upload of the particles ended
    /// \[ms\].
    ///
    /// # Errors
    /// The driver rejects a resource.
    pub fn draw(
        &mut self,
        canvas: &SharedCanvas,
        input: &FrameInput<'_>,
        clock: &WallClock,
    ) -> Result<f64, String> {
        let Some(gpu) = canvas.gpu() else {
            return Ok(clock.now());
        };
        let &FrameInput {
            time,
            is_paused,
            scene,
            camera,
            sheets,
            ..
        } = input;
        let parameters = scene.world();
        let context = &gpu.gl.context;
        let mut scale = self.scale;
        let painted = self.begin(gpu).and_then(|drawing| {
            let gl: &WebGl = &gpu.gl;
            let Some(renderer) = &mut drawing.renderer else {
                return Ok(clock.now());
            };
            let passes = &mut drawing.passes;
            let (width, height) = input.size;
            let [width, height] = if sheets {
                canvas.resize(atlas_size([width, height], input.limits).into());
                [width, height]
            } else {
                canvas.resize((width, height))
            };
            renderer.upload(gl, parameters.display_mode, input.particles, input.embers);
            renderer.upload_solids(gl, scene, input.poses, input.temperatures, input.charred);
            let sent = clock.now();
            renderer.set_limits(input.limits);
            passes.begin(context, clock);
            let view = View {
                width,
                height,
                time,
                camera,
                is_paused,
                sheets,
            };
            let on_pass = &mut |name| passes.end(context, clock, name);
            let painted = renderer.paint_in_passes(gl, &view, scene, input.history, on_pass);
            passes.finish(context);
            scale = renderer.colour_scale();
            painted.map(|()| sent)
        });
        self.scale = scale;
        match painted {
            Ok(sent) => {
                if !canvas.show(input.fire) {
                    self.in_flight += 1;
                }
                Ok(sent)
            }
            // The event `webglcontextlost` follows.
            Err(_) if context.is_context_lost() => Ok(clock.now()),
            Err(error) => {
                self.free();
                Err(format!("{error}"))
            }
        }
    }

    fn begin(&mut self, gpu: &Gpu) -> Result<&mut Drawing, RenderError> {
        if self.drawing.is_none() {
            let gl: &WebGl = &gpu.gl;
            let mut renderer = Renderer::within(gl, gpu.resources.clone())?;
            renderer.resume(self.scale);
            self.drawing = Some(Drawing {
                gpu: gpu.clone(),
                renderer: Some(renderer),
                passes: PassTimes::new(&gpu.gl.context),
            });
        }
        self.drawing.as_mut().ok_or(RenderError::NoTarget)
    }
}

impl Drop for Drawing {
    fn drop(&mut self) {
        self.passes.free(&self.gpu.gl.context);
        if let Some(renderer) = self.renderer.take() {
            renderer.destroy(&*self.gpu.gl);
        }
    }
}
