//! A real canvas with a real WebGL2 context, and what was painted on it.

use hearth_core::params::DisplayMode;
use hearth_core::{Charred, Instance, Scene};
use hearth_render::{History, Moment, Renderer, View};
use js_sys::{Function, Reflect};
use wasm_bindgen::prelude::*;
use web_sys::{HtmlCanvasElement, WebGl2RenderingContext, WebglLoseContext};

/// The parts of a GL context: through `gl` Hearth paints, through `context`
/// the tests look and disturb.
pub struct Canvas {
    context: WebGl2RenderingContext,
    pub gl: glow::Context,
    view: View,
}

impl Canvas {
    /// A canvas of that many pixels, as the browser gives it.
    pub fn new(width: u32, height: u32) -> Result<Canvas, JsValue> {
        Canvas::disturbed(width, height, |_| Ok(()))
    }

    /// A canvas of a device that can draw into no float target.
    pub fn without_float_targets(width: u32, height: u32) -> Result<Canvas, JsValue> {
        Canvas::disturbed(width, height, |context| {
            let refuse = Function::new_with_args(
                "name",
                "return name.startsWith('EXT_color_buffer') ? null
                     : WebGL2RenderingContext.prototype.getExtension.call(this, name)",
            );
            Reflect::set(context, &"getExtension".into(), &refuse).map(|_| ())
        })
    }

    fn disturbed(
        width: u32,
        height: u32,
        disturb: impl Fn(&WebGl2RenderingContext) -> Result<(), JsValue>,
    ) -> Result<Canvas, JsValue> {
        let document = web_sys::window()
            .and_then(|window| window.document())
            .ok_or("no document")?;
        let canvas: HtmlCanvasElement = document.create_element("canvas")?.dyn_into()?;
        canvas.set_width(width);
        canvas.set_height(height);
        let context: WebGl2RenderingContext = canvas
            .get_context("webgl2")?
            .ok_or("this browser has no WebGL2")?
            .dyn_into()?;
        disturb(&context)?;
        Ok(Canvas {
            gl: glow::Context::from_webgl2_context(context.clone()),
            context,
            view: View {
                width,
                height,
                time: 1.0,
                ..View::default()
            },
        })
    }

    /// Takes the context away, as a driver's crash does.
    pub fn lose_context(&self) -> Result<(), JsValue> {
        let extension = self.context.get_extension("WEBGL_lose_context")?;
        extension
            .ok_or("no WEBGL_lose_context")?
            .unchecked_into::<WebglLoseContext>()
            .lose_context();
        Ok(())
    }

    /// The error of GL since the last call; 0 for none.
    pub fn gl_error(&self) -> u32 {
        self.context.get_error()
    }

    /// Paints `instances` with a renderer of its own and reads the picture.
    pub fn paint(&self, instances: &[Instance], scene: &Scene) -> Result<Pixels, JsValue> {
        let mut renderer = Renderer::new(&self.gl).map_err(words)?;
        let painted = self.paint_with(&mut renderer, instances, scene);
        renderer.destroy(&self.gl);
        painted
    }

    /// Paints `instances` with `renderer` and reads the picture.
    pub fn paint_with(
        &self,
        renderer: &mut Renderer,
        instances: &[Instance],
        scene: &Scene,
    ) -> Result<Pixels, JsValue> {
        self.paint_at(renderer, self.view.time, [instances, &[]], scene)
    }

    /// Paints particles and embers as they are at `time` \[s\], without a past, and reads the
    /// picture.
    pub fn paint_at(
        &self,
        renderer: &mut Renderer,
        time: f64,
        gas: [&[Instance]; 2],
        scene: &Scene,
    ) -> Result<Pixels, JsValue> {
        self.paint_after(&mut History::default(), renderer, time, gas, scene)
    }

    /// As [`paint_at`](Canvas::paint_at), after a past that it continues.
    pub fn paint_after(
        &self,
        history: &mut History,
        renderer: &mut Renderer,
        time: f64,
        [particles, embers]: [&[Instance]; 2],
        scene: &Scene,
    ) -> Result<Pixels, JsValue> {
        renderer.upload(&self.gl, scene.world().display_mode, particles, embers);
        let view = View { time, ..self.view };
        if scene.world().display_mode == DisplayMode::Fire {
            history.record(&Moment {
                time,
                scene,
                poses: &[],
                particles,
            });
        }
        let painted = renderer.paint(&self.gl, &view, scene, history);
        painted.map_err(words)?;
        let View { width, height, .. } = self.view;
        let mut rgba = vec![0; (width * height * 4) as usize];
        self.context
            .bind_framebuffer(WebGl2RenderingContext::FRAMEBUFFER, None);
        self.context.read_pixels_with_opt_u8_array(
            0,
            0,
            width as i32,
            height as i32,
            WebGl2RenderingContext::RGBA,
            WebGl2RenderingContext::UNSIGNED_BYTE,
            Some(&mut rgba),
        )?;
        Ok(Pixels {
            rgba,
            width,
            height,
            metre: height as f32 / scene.world().domain_height,
        })
    }
}

impl Drop for Canvas {
    fn drop(&mut self) {
        // A page may hold sixteen contexts only: give this one back.
        if !self.context.is_context_lost() {
            let _ = self.lose_context();
        }
    }
}

/// Paints a scene with its solids.
pub fn painted(canvas: &Canvas, scene: &Scene, gas: &[Instance]) -> Result<Pixels, JsValue> {
    let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
    renderer.upload_solids(
        &canvas.gl,
        scene,
        &scene.poses(0.0),
        &[],
        &Charred::default(),
    );
    let pixels = canvas.paint_with(&mut renderer, gas, scene);
    renderer.destroy(&canvas.gl);
    assert_eq!(canvas.gl_error(), 0);
    pixels
}

/// The painted pixels by places in the world of the fire.
pub struct Pixels {
    rgba: Vec<u8>,
    width: u32,
    height: u32,
    /// Pixels in a metre.
    metre: f32,
}

impl Pixels {
    /// The pixel at a place [m], as in [`Instance`]: origin in the lower
    /// middle, y up.
    pub fn at(&self, x: f32, y: f32) -> [u8; 4] {
        let column = (self.width as f32 / 2.0 + x * self.metre) as u32;
        let row = (y * self.metre) as u32;
        let from = (row.min(self.height - 1) * self.width + column.min(self.width - 1)) * 4;
        let mut pixel = [0; 4];
        pixel.copy_from_slice(&self.rgba[from as usize..from as usize + 4]);
        pixel
    }

    /// Every pixel with its place [m].
    pub fn all(&self) -> impl Iterator<Item = (f32, f32, [u8; 4])> + '_ {
        (0..self.height).flat_map(move |row| {
            (0..self.width).map(move |column| {
                let x = (column as f32 + 0.5 - self.width as f32 / 2.0) / self.metre;
                let y = (row as f32 + 0.5) / self.metre;
                (x, y, self.at(x, y))
            })
        })
    }
}

/// An error of Rust's as JavaScript's test runner shows it.
pub fn words(error: impl std::fmt::Display) -> JsValue {
    error.to_string().into()
}
