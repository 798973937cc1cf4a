//! The renderer in a real browser: shaders compile and link, light stands
//! where the particles are and nowhere else, and the failure of a GPU is an
//! error with a message.
//!
//! Runs only in a browser; natively this file is empty.
#![cfg(target_arch = "wasm32")]

mod canvas;
mod combustion;
mod displays;
mod ground;
mod scale;
mod solids;
mod source;

use canvas::{Canvas, Pixels, words};
use hearth_core::params::{DisplayMode, Input, Model};
use hearth_core::{Instance, Scene};
use hearth_render::{History, Renderer, View};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::{console_log, wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

const WIDTH: u32 = 240;
const HEIGHT: u32 = 300;

/// Where puffs are set [m], all over the default domain.
const PLACES: [(f32, f32); 5] = [
    (0.0, 0.3),
    (-0.35, 0.9),
    (0.4, 1.2),
    (0.25, 0.4),
    (-0.2, 0.15),
];

/// How far from a puff's middle nothing of it may shine [m]: the puff itself
/// reaches 0.07 m, a particle is drawn within its own size beside it, and the
/// detail may carry light a little further.
const REACH: f32 = 0.3;

/// A puff of burning gas around a place: five by five particles.
fn puff((x, y): (f32, f32), temperature: f32) -> Vec<Instance> {
    let offsets = [-0.04, -0.02, 0.0, 0.02, 0.04];
    offsets
        .iter()
        .flat_map(|dy| offsets.map(|dx| [x + dx, y + dy, 0.0, 1.0, temperature, 1.0, 0.2, 0.8]))
        .collect()
}

/// The defaults with some values changed.
fn with(values: &[(&str, Input<'_>)]) -> Result<Scene, JsValue> {
    let mut parameters = Scene::of_model(Model::Classic);
    for &(id, input) in values {
        parameters.set(id, input).map_err(words)?;
    }
    Ok(parameters)
}

/// Brightness of the brightest channel.
fn light([r, g, b, _]: [u8; 4]) -> u8 {
    r.max(g).max(b)
}

/// The law of this file: light where the puff is, none away from it.
fn assert_light_only_at((x, y): (f32, f32), pixels: &Pixels) {
    let centre = pixels.at(x, y);
    assert!(light(centre) > 60, "the puff at {x}, {y} shows {centre:?}");
    for (px, py, pixel) in pixels.all() {
        assert!(
            (px - x).hypot(py - y) < REACH || light(pixel) < 10,
            "a puff at {x}, {y} makes {pixel:?} at {px}, {py}",
        );
    }
}

#[wasm_bindgen_test]
fn every_shader_compiles_and_links() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let renderer = Renderer::new(&canvas.gl).map_err(words)?;
    console_log!("fields are drawn into {:?}", renderer.target_format());
    renderer.destroy(&canvas.gl);
    assert_eq!(canvas.gl_error(), 0);
    Ok(())
}

#[wasm_bindgen_test]
fn light_is_at_the_particles() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    for place in PLACES {
        let pixels = canvas.paint(&puff(place, 1900.0), &Scene::of_model(Model::Classic))?;
        assert_light_only_at(place, &pixels);
    }
    assert_eq!(canvas.gl_error(), 0);
    Ok(())
}

#[wasm_bindgen_test]
fn cooler_gas_glows_darker_and_redder() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let parameters = with(&[
        ("detail", Input::Number(0.0)),
        ("bloom", Input::Number(0.0)),
    ])?;
    let at = |kelvin| -> Result<[u8; 4], JsValue> {
        let place = (0.0, 0.5);
        let pixels = canvas.paint(&puff(place, kelvin), &parameters)?;
        Ok(pixels.at(place.0, place.1))
    };
    let (hot, cool) = (at(1900.0)?, at(1100.0)?);
    let greenness = |[r, g, _, _]: [u8; 4]| f32::from(g) / f32::from(r.max(1));
    assert!(
        light(cool) < light(hot),
        "1100 K: {cool:?}, 1900 K: {hot:?}"
    );
    assert!(
        greenness(cool) < greenness(hot),
        "1100 K: {cool:?}, 1900 K: {hot:?}"
    );
    Ok(())
}

#[wasm_bindgen_test]
fn a_view_without_size_paints_nothing() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
    renderer.upload(
        &canvas.gl,
        DisplayMode::Fire,
        &puff((0.0, 0.3), 1900.0),
        &[],
    );
    for (width, height) in [(0, 0), (0, HEIGHT), (WIDTH, 0)] {
        let view = View {
            width,
            height,
            time: 0.0,
            ..View::default()
        };
        renderer
            .paint(
                &canvas.gl,
                &view,
                &Scene::of_model(Model::Classic),
                &History::default(),
            )
            .map_err(words)?;
        assert_eq!(canvas.gl_error(), 0, "{width} × {height}");
    }
    renderer.destroy(&canvas.gl);
    Ok(())
}

#[wasm_bindgen_test]
fn a_lost_context_gives_an_error() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    canvas.lose_context()?;
    match Renderer::new(&canvas.gl) {
        Ok(_) => Err("a renderer was made of a lost context".into()),
        Err(error) => {
            assert!(error.to_string().len() > 10, "no words: {error}");
            Ok(())
        }
    }
}
