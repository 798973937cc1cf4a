//! What a page's script holds: fires, and a painter for a context of its own.

use std::rc::Rc;

use hearth_core::params::Input;
use hearth_core::preset::Preset;
use hearth_core::{Charred, Instance, Scene, Simulation};
use hearth_render::{
    Chromaticity, Renderer, ResolutionLimits, SharedResources, TargetFormat, View, chromaticity,
};
use js_sys::{Float32Array, Uint8Array};
use wasm_bindgen::prelude::*;
use web_sys::WebGl2RenderingContext as Context;

use crate::snapshot::Snapshot;

/// Time between the two pictures of a fire that stands still \[s\]: what the gas
/// carries along needs one before the last.
const BEFORE: f64 = 1.0 / 60.0;

/// A fire that can be painted: one that was kept, or one that burns.
#[wasm_bindgen]
pub struct Fire {
    scene: Scene,
    instances: Vec<Instance>,
    embers: Vec<Instance>,
    time: f64,
    burning: Option<Simulation>,
}

#[wasm_bindgen]
impl Fire {
    /// The fire that a snapshot keeps, in a display mode, or in the first that it keeps.
    pub fn kept(snapshot: &[u8], mode: &str) -> Result<Fire, JsValue> {
        let snapshot = Snapshot::read(snapshot)?;
        let mode = match mode {
            "" => snapshot.names().next().ok_or("a snapshot of nothing")?,
            mode => mode,
        };
        let instances = snapshot.instances(mode);
        let mut fire = Fire {
            scene: snapshot.scene()?,
            instances: instances.ok_or_else(|| format!("no display mode {mode} is kept"))?,
            embers: snapshot.embers(),
            time: snapshot.time,
            burning: None,
        };
        fire.set("display_mode", mode)?;
        Ok(fire)
    }

    /// A fire of a preset that is about to be lit.
    pub fn lit(preset: &str) -> Result<Fire, JsValue> {
        let known = Preset::find(preset).ok_or_else(|| format!("no preset {preset}"))?;
        let scene = known.scene();
        Ok(Fire {
            burning: Some(Simulation::new(scene.clone())),
            scene,
            instances: Vec::new(),
            embers: Vec::new(),
            time: 0.0,
        })
    }

    /// Sets a parameter.
    pub fn set(&mut self, id: &str, value: &str) -> Result<(), JsValue> {
        if let Some(fire) = &mut self.burning {
            fire.set(id, Input::Text(value)).map_err(words)?;
        }
        let mut settings = self.scene.settings().clone();
        settings.set(id, Input::Text(value)).map_err(words)?;
        self.scene.set_settings(settings);
        Ok(())
    }

    /// How long it has burnt \[s\].
    #[wasm_bindgen(getter)]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// A parameter's value.
    pub fn value(&self, id: &str) -> Option<String> {
        self.scene.settings().get(id).map(|value| value.to_string())
    }

    /// Burns on until it has burnt for so long \[s\].
    pub fn burn(&mut self, until: f64) {
        let Some(fire) = &mut self.burning else {
            return;
        };
        while fire.time() < until {
            fire.step();
        }
        fire.write_instances(&mut self.instances);
        fire.write_embers(&mut self.embers);
        self.time = fire.time();
    }
}

/// The names of all presets.
#[wasm_bindgen]
pub fn presets() -> Vec<String> {
    Preset::all()
        .iter()
        .map(|preset| preset.name.to_owned())
        .collect()
}

/// Where a black body of that temperature stands in CIE's chart: x, y.
#[wasm_bindgen]
pub fn locus(kelvin: f64) -> Vec<f64> {
    let Chromaticity { x, y } = chromaticity(kelvin);
    vec![x, y]
}

/// Linear light before it is made a picture.
#[wasm_bindgen]
pub struct Light {
    width: u32,
    height: u32,
    rgba: Vec<f32>,
}

#[wasm_bindgen]
impl Light {
    /// Its columns.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Its rows, the lowest first.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Linear sRGB and coverage.
    #[wasm_bindgen(getter)]
    pub fn rgba(&self) -> Float32Array {
        Float32Array::from(self.rgba.as_slice())
    }
}

/// A context with the GPU resources that all its fires share.
#[wasm_bindgen]
pub struct Painter {
    context: Context,
    gl: Rc<glow::Context>,
    shared: Rc<SharedResources>,
}

#[wasm_bindgen]
impl Painter {
    /// A painter that keeps fields in the format of that name, or in the best.
    #[wasm_bindgen(constructor)]
    pub fn new(context: Context, format: &str) -> Result<Painter, JsValue> {
        let gl = glow::Context::from_webgl2_context(context.clone());
        let shared = match format {
            "" => SharedResources::new(&gl),
            "rgba16f" => SharedResources::with_format(&gl, TargetFormat::Rgba16F),
            "rgba8" => SharedResources::with_format(&gl, TargetFormat::Rgba8),
            other => return Err(format!("no format {other}").into()),
        };
        Ok(Painter {
            context,
            gl: Rc::new(gl),
            shared: Rc::new(shared.map_err(words)?),
        })
    }

    /// The format of its fields.
    #[wasm_bindgen(getter)]
    pub fn format(&self) -> String {
        self.shared.target_format().name().to_owned()
    }

    /// A painter of one fire, at that quality.
    pub fn of_one_fire(&self, quality: &str) -> Result<FirePainter, JsValue> {
        let renderer = Renderer::within(&*self.gl, Rc::clone(&self.shared));
        let mut renderer = renderer.map_err(words)?;
        renderer.set_limits(match quality {
            "low" => ResolutionLimits::LOW,
            "medium" => ResolutionLimits::MEDIUM,
            "high" => ResolutionLimits::HIGH,
            other => return Err(format!("no quality {other}").into()),
        });
        Ok(FirePainter {
            context: self.context.clone(),
            gl: Rc::clone(&self.gl),
            renderer: Some(renderer),
        })
    }
}

/// Paints one fire, picture after picture.
#[wasm_bindgen]
pub struct FirePainter {
    context: Context,
    gl: Rc<glow::Context>,
    renderer: Option<Renderer>,
}

#[wasm_bindgen]
impl FirePainter {
    /// Paints a fire as it burns now.
    pub fn paint(&mut self, fire: &Fire, width: u32, height: u32) -> Result<(), JsValue> {
        self.draw(fire, [width, height], fire.time, &mut |_| {})
    }

    /// Paints a fire that stands still, and has just moved.
    pub fn paint_still(&mut self, fire: &Fire, width: u32, height: u32) -> Result<(), JsValue> {
        self.draw(fire, [width, height], fire.time - BEFORE, &mut |_| {})?;
        self.paint(fire, width, height)
    }

    /// Paints a fire and returns its light before glow and tone map, without that of embers;
    /// none in display modes without light.
    pub fn light(
        &mut self,
        fire: &Fire,
        width: u32,
        height: u32,
    ) -> Result<Option<Light>, JsValue> {
        let context = self.context.clone();
        let mut read = Ok(None);
        self.draw(fire, [width, height], fire.time, &mut |pass| {
            if pass == "shade" || pass == "flame" {
                read = target(&context).map(Some);
            }
        })?;
        read
    }

    /// The picture, from its upper left: premultiplied sRGB.
    pub fn pixels(&self, width: u32, height: u32) -> Result<Uint8Array, JsValue> {
        let row = width as usize * 4;
        let mut rgba = vec![0; row * height as usize];
        self.context.bind_framebuffer(Context::FRAMEBUFFER, None);
        self.context.read_pixels_with_opt_u8_array(
            0,
            0,
            width as i32,
            height as i32,
            Context::RGBA,
            Context::UNSIGNED_BYTE,
            Some(&mut rgba),
        )?;
        let upright: Vec<u8> = rgba.chunks_exact(row).rev().flatten().copied().collect();
        Ok(Uint8Array::from(upright.as_slice()))
    }

    /// Frees what it made in the context.
    pub fn destroy(&mut self) {
        if let Some(renderer) = self.renderer.take() {
            renderer.destroy(&self.gl);
        }
    }

    fn draw(
        &mut self,
        fire: &Fire,
        [width, height]: [u32; 2],
        time: f64,
        watch: &mut dyn FnMut(&'static str),
    ) -> Result<(), JsValue> {
        let renderer = self.renderer.as_mut().ok_or("the painter is destroyed")?;
        let mode = fire.scene.settings().display_mode;
        renderer.upload(&self.gl, mode, &fire.instances, &fire.embers);
        renderer.upload_solids(
            &self.gl,
            &fire.scene,
            &fire.scene.poses(time),
            &[],
            &Charred::default(),
        );
        let view = View {
            width,
            height,
            time,
            ..View::default()
        };
        let painted = renderer.paint_in_passes(&*self.gl, &view, fire.scene.settings(), watch);
        painted.map_err(words)
    }
}

/// The light in the target that was drawn into last, which holds square roots.
fn target(context: &Context) -> Result<Light, JsValue> {
    let view = context.get_parameter(Context::VIEWPORT)?;
    let view = js_sys::Int32Array::new(&view).to_vec();
    let [.., width, height] = view[..] else {
        return Err("no viewport".into());
    };
    let roots = Float32Array::new_with_length((width * height * 4) as u32);
    context.read_pixels_with_opt_array_buffer_view(
        0,
        0,
        width,
        height,
        Context::RGBA,
        Context::FLOAT,
        Some(&roots),
    )?;
    let mut rgba = roots.to_vec();
    for pixel in rgba.chunks_exact_mut(4) {
        pixel[..3].iter_mut().for_each(|root| *root *= *root);
    }
    Ok(Light {
        width: width as u32,
        height: height as u32,
        rgba,
    })
}

/// An error of Rust's as a page's script catches it.
fn words(error: impl std::fmt::Display) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}
