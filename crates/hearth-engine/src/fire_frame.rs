//! The frame of one fire: what it needs for itself in the context that all fires share.

use hearth_core::params::{DisplayMode, Model};
use hearth_core::{Instance, Parameters};
use hearth_render::{Camera, CarriedNoise, Motion, RenderError, Renderer, ResolutionLimits, View};

use crate::pass_times::PassTimes;
use crate::shared_canvas::{Gpu, SharedCanvas};
use crate::wall_clock::WallClock;
use crate::webgl::WebGl;

/// Pictures of a fire that may be on their way at once: one is shown while the next is drawn.
/// Without a bound, a busy page would queue ever more of them.
const MAX_ON_THE_WAY: u32 = 2;

/// What draws while the fire is on stage and has a context.
struct Drawing {
    gpu: Gpu,
    renderer: Option<Renderer<WebGl>>,
    passes: PassTimes,
}

/// The frame of a fire.
#[derive(Default)]
pub struct FireFrame {
    drawing: Option<Drawing>,
    /// How far the fine structure has come, which outlives a lost context.
    motion: Motion,
    /// Where the gas had carried the noise in a picture that stood still.
    carried: Option<CarriedNoise>,
    on_the_way: u32,
}

impl FireFrame {
    /// Whether the last pictures have been shown, so that another may follow.
    pub fn is_awaited(&self) -> bool {
        self.on_the_way < MAX_ON_THE_WAY
    }

    /// Counts a picture that was on its way as shown.
    pub fn shown(&mut self) {
        self.on_the_way = self.on_the_way.saturating_sub(1);
    }

    /// Frees everything: the context is lost, or the fire is off stage.
    pub fn free(&mut self) {
        self.drawing = None;
    }

    /// How long each pass takes, while something is drawn.
    pub fn passes(&self) -> Option<&PassTimes> {
        self.drawing.as_ref().map(|drawing| &drawing.passes)
    }

    /// The display mode of the last picture and the quantities of its first and its last
    /// colour, if the mode measures one.
    pub fn scale(&self) -> Option<(DisplayMode, [f32; 2])> {
        self.drawing.as_ref()?.renderer.as_ref()?.scale()
    }

    /// Draws these particles and shows them as the picture of `fire`, which `stands` still or
    /// burns; returns when the upload of the particles had ended \[ms\].
    ///
    /// # Errors
    /// The driver's refusal.
    #[allow(clippy::too_many_arguments)]
    pub fn draw(
        &mut self,
        fire: u32,
        canvas: &SharedCanvas,
        size: (u32, u32),
        limits: ResolutionLimits,
        (instances, embers): (&[Instance], &[Instance]),
        (time, parameters): (f64, &Parameters),
        camera: Camera,
        stands: bool,
        host: &WallClock,
    ) -> Result<f64, String> {
        let Some(gpu) = canvas.gpu() else {
            return Ok(host.now());
        };
        let context = &gpu.gl.context;
        let mut motion = self.motion;
        let mut carried = None;
        let painted = self.begin(gpu).and_then(|drawing| {
            let gl: &WebGl = &gpu.gl;
            let Some(renderer) = &mut drawing.renderer else {
                return Ok(host.now());
            };
            let passes = &mut drawing.passes;
            let [width, height] = canvas.make_room(size);
            renderer.upload(gl, parameters.display_mode, instances, embers);
            let sent = host.now();
            renderer.set_limits(limits);
            passes.begin(context, host);
            let view = View {
                width,
                height,
                time,
                camera,
            };
            let watch = &mut |pass| passes.end(context, host, pass);
            let painted = renderer.paint_watched(gl, &view, parameters, watch);
            passes.finish(context);
            motion = renderer.motion();
            if stands && parameters.model() == Model::Combustion {
                carried = renderer.carried(gl);
            }
            painted.map(|()| sent)
        });
        self.motion = motion;
        // A lost context reads back nothing.
        if !context.is_context_lost() {
            self.carried = carried;
        }
        match painted {
            Ok(sent) => {
                if !canvas.show(fire) {
                    self.on_the_way += 1;
                }
                Ok(sent)
            }
            // The event of the loss is on its way.
            Err(_) if context.is_context_lost() => Ok(host.now()),
            Err(error) => {
                self.free();
                Err(error.to_string())
            }
        }
    }

    fn begin(&mut self, gpu: &Gpu) -> Result<&mut Drawing, RenderError> {
        if self.drawing.is_none() {
            let gl: &WebGl = &gpu.gl;
            let mut renderer = Renderer::within(gl, gpu.resources.clone())?;
            renderer.resume(self.motion, self.carried.take());
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
