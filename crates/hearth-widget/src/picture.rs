//! A canvas with its WebGL2 context, which can be lost at any time.
//!
//! Browsers take a context away when the graphics driver restarts, a laptop
//! changes its graphics card or a page has too many. Everything that lived in
//! it is gone then, so the renderer is made anew when the context comes back;
//! the fire itself is not touched.

use hearth_core::{Instance, Parameters};
use hearth_render::{Lines, RenderError, Renderer, View};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{
    Event, EventTarget, HtmlCanvasElement, OffscreenCanvas, WebGl2RenderingContext,
    WebGlContextAttributes, WebglLoseContext,
};

use crate::host::Host;
use crate::passes::Passes;
use crate::webgl::WebGl;

const LOST: &str = "webglcontextlost";
const RESTORED: &str = "webglcontextrestored";

/// What happened to a context.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContextEvent {
    /// It is gone.
    Lost,
    /// It is back, empty.
    Restored,
}

/// A canvas of a page or of a worker.
enum Canvas {
    Dom(HtmlCanvasElement),
    Offscreen(OffscreenCanvas),
}

impl Canvas {
    fn of(value: JsValue) -> Option<Canvas> {
        match value.dyn_into::<HtmlCanvasElement>() {
            Ok(canvas) => Some(Canvas::Dom(canvas)),
            Err(value) => value.dyn_into().ok().map(Canvas::Offscreen),
        }
    }

    fn context(&self) -> Option<WebGl2RenderingContext> {
        let attributes = WebGlContextAttributes::new();
        attributes.set_alpha(true);
        attributes.set_premultiplied_alpha(true);
        attributes.set_antialias(false);
        attributes.set_depth(false);
        attributes.set_stencil(false);
        attributes.set_preserve_drawing_buffer(false);
        let context = match self {
            Canvas::Dom(canvas) => {
                canvas.get_context_with_context_options("webgl2", attributes.as_ref())
            }
            Canvas::Offscreen(canvas) => {
                canvas.get_context_with_context_options("webgl2", attributes.as_ref())
            }
        };
        context.ok().flatten()?.dyn_into().ok()
    }

    fn target(&self) -> &EventTarget {
        match self {
            Canvas::Dom(canvas) => canvas,
            Canvas::Offscreen(canvas) => canvas,
        }
    }

    fn size(&self) -> (u32, u32) {
        match self {
            Canvas::Dom(canvas) => (canvas.width(), canvas.height()),
            Canvas::Offscreen(canvas) => (canvas.width(), canvas.height()),
        }
    }

    fn set_size(&self, (width, height): (u32, u32)) {
        match self {
            Canvas::Dom(canvas) => {
                canvas.set_width(width);
                canvas.set_height(height);
            }
            Canvas::Offscreen(canvas) => {
                canvas.set_width(width);
                canvas.set_height(height);
            }
        }
    }
}

/// What draws, while there is a context to draw with.
struct Drawing {
    gl: WebGl,
    renderer: Renderer<WebGl>,
    passes: Passes,
}

impl Drawing {
    fn new(context: &WebGl2RenderingContext) -> Result<Drawing, RenderError> {
        let gl = WebGl::new(context.clone());
        let renderer = Renderer::new(&gl)?;
        let passes = Passes::new(context);
        Ok(Drawing {
            gl,
            renderer,
            passes,
        })
    }
}

/// The name of an event and what hears it.
type Listener = (&'static str, Closure<dyn FnMut(Event)>);

/// A canvas that a fire is drawn on.
pub struct Picture {
    canvas: Canvas,
    context: WebGl2RenderingContext,
    drawing: Option<Drawing>,
    listeners: [Listener; 2],
}

impl Picture {
    /// Takes the canvas; `tell` hears when its context is lost or back.
    ///
    /// # Errors
    /// In words: it is no canvas, there is no WebGL2, or the driver refuses a
    /// shader.
    pub fn new(
        canvas: JsValue,
        tell: impl Fn(ContextEvent) + Clone + 'static,
    ) -> Result<Picture, String> {
        let canvas = Canvas::of(canvas).ok_or("what was sent is not a canvas")?;
        let context = canvas.context().ok_or(
            "this browser gives no WebGL2 context: it may be switched off, \
             or the graphics driver may be blocked",
        )?;
        let drawing = if context.is_context_lost() {
            None
        } else {
            Some(Drawing::new(&context).map_err(|error| error.to_string())?)
        };
        let listener = |event| {
            let tell = tell.clone();
            Closure::<dyn FnMut(Event)>::new(move |happened: Event| {
                // Without this the browser never gives the context back.
                happened.prevent_default();
                tell(event);
            })
        };
        let picture = Picture {
            canvas,
            context,
            drawing,
            listeners: [
                (LOST, listener(ContextEvent::Lost)),
                (RESTORED, listener(ContextEvent::Restored)),
            ],
        };
        for (name, listener) in &picture.listeners {
            let target = picture.canvas.target();
            let _ =
                target.add_event_listener_with_callback(name, listener.as_ref().unchecked_ref());
        }
        Ok(picture)
    }

    /// Whether there is something to draw with.
    pub fn drawable(&self) -> bool {
        self.drawing.is_some()
    }

    /// Format of the render targets; empty while nothing can be drawn.
    pub fn target_format(&self) -> &'static str {
        self.drawing
            .as_ref()
            .map_or("", |drawing| drawing.renderer.target_format().name())
    }

    /// How long each pass takes; nothing while nothing can be drawn.
    pub fn passes(&self) -> Option<&Passes> {
        self.drawing.as_ref().map(|drawing| &drawing.passes)
    }

    /// Forgets what the lost context held.
    pub fn lose(&mut self) {
        self.drawing = None;
    }

    /// Makes everything anew in the context that is back.
    ///
    /// # Errors
    /// The driver refuses, in words.
    pub fn restore(&mut self) -> Result<(), String> {
        let drawing = Drawing::new(&self.context).map_err(|error| error.to_string())?;
        self.drawing = Some(drawing);
        Ok(())
    }

    /// Sends the particles to the graphics card.
    pub fn upload(&mut self, instances: &[Instance], embers: &[Instance]) {
        if let Some(Drawing { gl, renderer, .. }) = &mut self.drawing {
            renderer.upload(gl, instances, embers);
        }
    }

    /// Draws what was sent. The canvas gets its size here, not when the size is
    /// announced: a canvas loses its picture with its size, and this way both are
    /// replaced in the same frame.
    ///
    /// # Errors
    /// The driver refuses, in words; nothing is drawn from then on.
    pub fn draw(
        &mut self,
        size: (u32, u32),
        lines: Lines,
        time: f64,
        parameters: &Parameters,
        host: &Host,
    ) -> Result<(), String> {
        let Some(Drawing {
            gl,
            renderer,
            passes,
        }) = &mut self.drawing
        else {
            return Ok(());
        };
        if self.canvas.size() != size {
            self.canvas.set_size(size);
        }
        let view = View {
            // A browser short of memory gives less than was asked for.
            width: self.context.drawing_buffer_width().max(0).unsigned_abs(),
            height: self.context.drawing_buffer_height().max(0).unsigned_abs(),
            time,
        };
        renderer.set_lines(lines);
        passes.begin(&self.context, host);
        let watch = &mut |pass| passes.end(&self.context, host, pass);
        let painted = renderer.paint_watched(gl, &view, parameters, watch);
        passes.finish(&self.context);
        match painted {
            Ok(()) => Ok(()),
            // The event that says so is on its way.
            Err(_) if self.context.is_context_lost() => Ok(()),
            Err(error) => {
                self.drawing = None;
                Err(error.to_string())
            }
        }
    }
}

impl Drop for Picture {
    /// Frees the context at once: a browser allows a page only a few, and its
    /// garbage collector takes its time.
    fn drop(&mut self) {
        for (name, listener) in &self.listeners {
            let target = self.canvas.target();
            let _ =
                target.remove_event_listener_with_callback(name, listener.as_ref().unchecked_ref());
        }
        if let Some(Drawing { gl, renderer, .. }) = self.drawing.take() {
            renderer.destroy(&gl);
        }
        if let Ok(Some(extension)) = self.context.get_extension("WEBGL_lose_context") {
            extension
                .unchecked_into::<WebglLoseContext>()
                .lose_context();
        }
    }
}
