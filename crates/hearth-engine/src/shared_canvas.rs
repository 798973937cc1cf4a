//! The canvas on which all fires of an engine are drawn, one after another, with its WebGL2
//! context, which can be lost at any time.
//!
//! Browsers give a page few contexts and a worker fewer, and every context compiles the shaders
//! again. So all fires share one. JavaScript takes each picture away, as an `ImageBitmap` or as
//! a copy, before the next fire is drawn.
//!
//! A context is lost when the graphics driver restarts or a laptop changes its graphics card,
//! with everything that lived in it. The engine makes all of it again when the context is back;
//! the fires are not touched.

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

    /// The function that takes a picture away.
    pub type Show;

    // The binding of js-sys makes an object for each call, to catch exceptions that this
    // function never throws.
    #[wasm_bindgen(method, js_name = call)]
    fn take(this: &Show, of: &JsValue, fire: u32) -> bool;
}

/// A context that can be drawn in, and the resources that its fires share.
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
    /// Takes the canvas and its context, if it has one. `show(fire)` takes a picture away and
    /// returns whether it is shown already; it never throws.
    ///
    /// # Errors
    /// There is no WebGL2, or the driver refuses a shader.
    pub fn new(
        canvas: Canvas,
        context: Option<Context>,
        show: Show,
    ) -> Result<SharedCanvas, String> {
        let context = context.ok_or(
            "this browser gives no WebGL2 context: it may be switched off, \
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

    /// What to draw with, unless the context is lost.
    pub fn gpu(&self) -> Option<&Gpu> {
        self.gpu.as_ref()
    }

    /// Format of the render targets; empty while the context is lost.
    pub fn target_format(&self) -> &'static str {
        let gpu = self.gpu.as_ref();
        gpu.map_or("", |gpu| gpu.resources.target_format().name())
    }

    /// Drops what the lost context held.
    pub fn lose(&mut self) {
        self.gpu = None;
    }

    /// Makes everything again in the context that is back. If the context is already lost
    /// again, there is nothing to draw with until it is back once more.
    ///
    /// # Errors
    /// The driver's refusal.
    pub fn restore(&mut self) -> Result<(), String> {
        self.gpu = match Gpu::new(&self.context) {
            Ok(gpu) => Some(gpu),
            Err(_) if self.context.is_context_lost() => None,
            Err(error) => return Err(error.to_string()),
        };
        Ok(())
    }

    /// Gives the canvas that size; returns its actual size: a browser short of memory gives
    /// less than requested.
    pub fn make_room(&self, size: (u32, u32)) -> [u32; 2] {
        // Setting a size empties the canvas and allocates another buffer.
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

    /// Shows what was drawn as the picture of that fire; returns whether it is shown already,
    /// and not only on its way.
    pub fn show(&self, fire: u32) -> bool {
        self.show.take(&JsValue::UNDEFINED, fire)
    }
}

impl Drop for SharedCanvas {
    /// Frees the context at once: a browser allows a page only a few, and garbage collection
    /// may be late.
    fn drop(&mut self) {
        if let Ok(Some(extension)) = self.context.get_extension("WEBGL_lose_context") {
            let extension: WebglLoseContext = wasm_bindgen::JsCast::unchecked_into(extension);
            extension.lose_context();
        }
    }
}
