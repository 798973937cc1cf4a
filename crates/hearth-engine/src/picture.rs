//! The picture of one fire: what it needs for itself in the context that all share.

use hearth_core::params::{DisplayMode, Model};
use hearth_core::{Instance, Parameters};
use hearth_render::{Camera, Carried, Lines, Motion, Renderer, View};

use crate::easel::{Easel, Ground};
use crate::passes::Passes;
use crate::wall_clock::WallClock;
use crate::webgl::WebGl;

/// Pictures of a fire that may be on their way at once: one is shown while the next
/// is made. A page that is busy would else be sent ever more of them.
const MOST_ON_THE_WAY: u32 = 2;

/// What draws, while there is a context to draw with and somebody looks.
struct Drawing {
    ground: Ground,
    renderer: Option<Renderer<WebGl>>,
    passes: Passes,
}

/// The picture of a fire.
#[derive(Default)]
pub struct Picture {
    drawing: Option<Drawing>,
    /// How far the fine structure has come: a context that is lost takes none of it.
    motion: Motion,
    /// And where it was in a picture that stood still.
    carried: Option<Carried>,
    on_the_way: u32,
}

impl Picture {
    /// Whether the last pictures have been shown, so that another may follow.
    pub fn is_awaited(&self) -> bool {
        self.on_the_way < MOST_ON_THE_WAY
    }

    /// A picture that was on its way is shown.
    pub fn shown(&mut self) {
        self.on_the_way = self.on_the_way.saturating_sub(1);
    }

    /// Frees everything: the context is lost, or nobody looks.
    pub fn put_away(&mut self) {
        self.drawing = None;
    }

    /// How long each pass takes; nothing while nothing is drawn.
    pub fn passes(&self) -> Option<&Passes> {
        self.drawing.as_ref().map(|drawing| &drawing.passes)
    }

    /// The display that it was drawn with, and what its first and its last colour
    /// stand for, where they measure something.
    pub fn scale(&self) -> Option<(DisplayMode, [f32; 2])> {
        self.drawing.as_ref()?.renderer.as_ref()?.scale()
    }

    /// Draws these particles and shows them as the picture of `fire`, which `stands` still
    /// or burns; returns when the particles had been sent to the graphics card \[ms\].
    ///
    /// # Errors
    /// The driver refuses, in words.
    #[allow(clippy::too_many_arguments)]
    pub fn draw(
        &mut self,
        fire: u32,
        easel: &Easel,
        size: (u32, u32),
        lines: Lines,
        (instances, embers): (&[Instance], &[Instance]),
        (time, parameters): (f64, &Parameters),
        camera: Camera,
        stands: bool,
        host: &WallClock,
    ) -> Result<f64, String> {
        let Some(ground) = easel.ground() else {
            return Ok(host.now());
        };
        let context = &ground.gl.context;
        let mut motion = self.motion;
        let mut carried = None;
        let painted = self.begin(ground).and_then(|drawing| {
            let gl: &WebGl = &ground.gl;
            let Some(renderer) = &mut drawing.renderer else {
                return Ok(host.now());
            };
            let passes = &mut drawing.passes;
            let [width, height] = easel.make_room(size);
            renderer.upload(gl, parameters.display_mode, instances, embers);
            let sent = host.now();
            renderer.set_lines(lines);
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
        // A context that is gone gives nothing back.
        if !context.is_context_lost() {
            self.carried = carried;
        }
        match painted {
            Ok(sent) => {
                if !easel.show(fire) {
                    self.on_the_way += 1;
                }
                Ok(sent)
            }
            // The event that says so is on its way.
            Err(_) if context.is_context_lost() => Ok(host.now()),
            Err(error) => {
                self.put_away();
                Err(error.to_string())
            }
        }
    }

    fn begin(&mut self, ground: &Ground) -> Result<&mut Drawing, hearth_render::RenderError> {
        if self.drawing.is_none() {
            let gl: &WebGl = &ground.gl;
            let mut renderer = Renderer::within(gl, ground.studio.clone())?;
            renderer.resume(self.motion, self.carried.take());
            self.drawing = Some(Drawing {
                ground: ground.clone(),
                renderer: Some(renderer),
                passes: Passes::new(&ground.gl.context),
            });
        }
        self.drawing
            .as_mut()
            .ok_or(hearth_render::RenderError::NoTarget)
    }
}

impl Drop for Drawing {
    fn drop(&mut self) {
        self.passes.free(&self.ground.gl.context);
        if let Some(renderer) = self.renderer.take() {
            renderer.destroy(&*self.ground.gl);
        }
    }
}
