//! The canvas on which an engine draws all its fires, one after another, and its WebGL2
//! context.
//!
//! Browsers limit the number of contexts, and each context compiles the shaders again, so all
//! fires share one. JavaScript takes each picture, as an `ImageBitmap` or a copy, before the
//! next fire is drawn.
//!
//! A context and its resources are lost when the graphics driver restarts or a laptop switches
//! its graphics card. The engine creates the resources again when the context is restored. The
//! simulations are not affected.

use std::rc::Rc;

use hearth_render::{RenderError, SharedResources};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::{WebGl2RenderingContext as Context, WebglLoseContext};

use crate::webgl::WebGl;

#[wasm_bindgen]
extern "C" {
    /// A canvas of a page or of a worker.
    pub type Canvas;

    #[wasm_bindgen(method, getter)]
    fn width(this: &Canvas) -> u32;

    #[wasm_bindgen(method, getter)]
    fn height(this: &Canvas) -> u32;

    #[wasm_bindgen(method, setter)]
    fn set_width(this: &Canvas, width: u32);

    #[wasm_bindgen(method, setter)]
    fn set_height(this: &Canvas, height: u32);

    /// The function that takes a picture from the canvas.
    pub type Show;

    // The binding of js-sys creates an object per call to catch exceptions, which this function
    // never throws.
    #[wasm_bindgen(method, js_name = call)]
    fn take(this: &Show, of: &JsValue, fire: u32) -> bool;
}

/// A context and the resources that its fires share.
#[derive(Clone)]
pub struct Gpu {
    /// The context.
    pub gl: Rc<WebGl>,
    /// Shaders and constant textures.
    pub resources: Rc<SharedResources<WebGl>>,
}

impl Gpu {
    fn new(context: &Context) -> Result<Gpu, RenderError> {
        let gl = WebGl::new(context.clone());
        let resources = Rc::new(SharedResources::new(&gl)?);
        let gl = Rc::new(gl);
        Ok(Gpu { gl, resources })
    }
}

/// The canvas, its context, and the function that shows pictures.
pub struct SharedCanvas {
    canvas: Canvas,
    context: Context,
    gpu: Option<Gpu>,
    show: Show,
}

impl SharedCanvas {
    /// Wraps a canvas and its context. `show(fire)` takes a picture from the canvas and returns
    /// whether it is already shown; it never throws.
    ///
    /// # Errors
    /// The browser has no WebGL2, or the driver rejects a shader.
    pub fn new(
        canvas: Canvas,
        context: Option<Context>,
        show: Show,
    ) -> Result<SharedCanvas, String> {
        let context = context.ok_or(
            "this browser gives no WebGL2 context: WebGL may be switched off, \
             or the graphics driver may be blocked",
        )?;
        let mut shared = SharedCanvas {
            canvas,
            context,
            gpu: None,
            show,
        };
        shared.restore()?;
        Ok(shared)
    }

    /// The context to draw with; `None` while it is lost.
    pub fn gpu(&self) -> Option<&Gpu> {
        self.gpu.as_ref()
    }

    /// Format of the render targets; empty while the context is lost.
    pub fn target_format(&self) -> &'static str {
        let gpu = self.gpu.as_ref();
        gpu.map_or("", |gpu| gpu.resources.target_format().name())
    }

    /// Drops the resources of the lost context.
    pub fn lose(&mut self) {
        self.gpu = None;
    }

    /// Creates the resources again in the restored context. If the context is lost again at
    /// once, the next restoration does it.
    ///
    /// # Errors
    /// The driver rejects a resource.
    pub fn restore(&mut self) -> Result<(), String> {
        self.gpu = match Gpu::new(&self.context) {
            Ok(gpu) => Some(gpu),
            Err(_) if self.context.is_context_lost() => None,
            Err(error) => return Err(format!("{error}")),
        };
        Ok(())
    }

    /// Resizes the canvas; returns its actual size, which is smaller if the browser is short of
    /// memory.
    pub fn resize(&self, size: (u32, u32)) -> [u32; 2] {
        // Setting the same size would clear the canvas and allocate another buffer.
        if (self.canvas.width(), self.canvas.height()) != size {
            self.canvas.set_width(size.0);
            self.canvas.set_height(size.1);
        }
        let (width, height) = (
            self.context.drawing_buffer_width(),
            self.context.drawing_buffer_height(),
        );
        [width, height].map(|side| side.max(0).unsigned_abs())
    }

    /// Shows the canvas as the picture of a fire. Returns whether the picture is already shown;
    /// otherwise [`Engine::shown`](crate::Engine::shown) follows.
    pub fn show(&self, fire: u32) -> bool {
        self.show.take(&JsValue::UNDEFINED, fire)
    }
}

impl Drop for SharedCanvas {
    /// Frees the context without waiting for garbage collection: browsers allow only a few.
    fn drop(&mut self) {
        if let Ok(Some(extension)) = self.context.get_extension("WEBGL_lose_context") {
            let extension: WebglLoseContext = wasm_bindgen::JsCast::unchecked_into(extension);
            extension.lose_context();
        }
    }
}
