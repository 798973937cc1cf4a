//! The one canvas on which all fires of an engine are drawn, one after another,
//! with its WebGL2 context, which can be lost at any time.
//!
//! Browsers give a page few contexts, and a worker fewer; and whatever a context
//! has compiled, another one has to compile again. So there is one. What is drawn
//! on it is shown elsewhere at once: the engine's surroundings take each picture
//! away, as an `ImageBitmap` or as a copy, before the next fire is drawn.
//!
//! Browsers take a context away when the graphics driver restarts or a laptop
//! changes its graphics card. Everything that lived in it is gone then, so all of
//! it is made anew when the context comes back; the fires are not touched.

use std::rc::Rc;

use hearth_render::{RenderError, Studio};
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

    /// What takes a picture away.
    pub type Show;

    // js-sys's own makes an object for each call, to catch what it never throws.
    #[wasm_bindgen(method, js_name = call)]
    fn take(this: &Show, of: &JsValue, fire: u32) -> bool;
}

/// A context that can be drawn in, and what its fires share.
#[derive(Clone)]
pub struct Ground {
    /// The context.
    pub gl: Rc<WebGl>,
    /// What is compiled in it.
    pub studio: Rc<Studio<WebGl>>,
}

impl Ground {
    fn new(context: &Context) -> Result<Ground, RenderError> {
        let gl = WebGl::new(context.clone());
        let studio = Rc::new(Studio::new(&gl)?);
        let gl = Rc::new(gl);
        Ok(Ground { gl, studio })
    }
}

/// The canvas, its context, and the way on from it.
pub struct Easel {
    canvas: Canvas,
    context: Context,
    ground: Option<Ground>,
    show: Show,
}

impl Easel {
    /// Takes the canvas and its context, where it has one; `show(fire)` takes a picture
    /// away, and says whether it is shown already. It never throws.
    ///
    /// # Errors
    /// In words: there is no WebGL2, or the driver refuses a shader.
    pub fn new(canvas: Canvas, context: Option<Context>, show: Show) -> Result<Easel, String> {
        let context = context.ok_or(
            "this browser gives no WebGL2 context: it may be switched off, \
             or the graphics driver may be blocked",
        )?;
        let mut easel = Easel {
            canvas,
            context,
            ground: None,
            show,
        };
        easel.restore()?;
        Ok(easel)
    }

    /// What to draw in, while there is such.
    pub fn ground(&self) -> Option<&Ground> {
        self.ground.as_ref()
    }

    /// Format of the render targets; empty while nothing can be drawn.
    pub fn target_format(&self) -> &'static str {
        let ground = self.ground.as_ref();
        ground.map_or("", |ground| ground.studio.target_format().name())
    }

    /// Forgets what the lost context held.
    pub fn lose(&mut self) {
        self.ground = None;
    }

    /// Makes everything anew in the context that is back. Where it is lost again
    /// already, there is nothing to draw in until it is back once more.
    ///
    /// # Errors
    /// The driver refuses, in words.
    pub fn restore(&mut self) -> Result<(), String> {
        self.ground = match Ground::new(&self.context) {
            Ok(ground) => Some(ground),
            Err(_) if self.context.is_context_lost() => None,
            Err(error) => return Err(error.to_string()),
        };
        Ok(())
    }

    /// Makes room for a picture of that size; returns the size that there is: a
    /// browser short of memory gives less than was asked for.
    pub fn make_room(&self, size: (u32, u32)) -> [u32; 2] {
        // The canvas is emptied by it, and another buffer is not free.
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

    /// Shows what was drawn as the picture of that fire; whether it is shown
    /// already, and not only on its way.
    pub fn show(&self, fire: u32) -> bool {
        self.show.take(&JsValue::UNDEFINED, fire)
    }
}

impl Drop for Easel {
    /// Frees the context at once: a browser allows a page only a few, and its
    /// garbage collector takes its time.
    fn drop(&mut self) {
        if let Ok(Some(extension)) = self.context.get_extension("WEBGL_lose_context") {
            let extension: WebglLoseContext = wasm_bindgen::JsCast::unchecked_into(extension);
            extension.lose_context();
        }
    }
}
