//! A fire that stands aside is the picture of one in the middle, moved aside.

use hearth_core::params::Model;
use hearth_core::{Instance, Scene};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::canvas::{Canvas, Pixels, words};
use crate::light;

const WIDTH: u32 = 320;
const HEIGHT: u32 = 320;
/// Height of the domain \[m\]: ten pixels are five centimetres.
const METRES: f64 = 1.6;
/// How far the fire stands aside, in pixels of the picture and \[m\].
const ASIDE: (usize, f32) = (80, 0.4);

/// Gas on a source that stands at `x`, in a wide domain, whose sides fade far away.
fn painted(model: Model, x: f32) -> Result<Pixels, JsValue> {
    let mut scene = Scene::of_model(model);
    for (id, value) in [
        ("domain_width", 6.0),
        ("domain_height", METRES),
        ("source_x", x.into()),
        ("source_width", 0.4),
        ("source_height", 0.2),
        ("detail", 0.0),
    ] {
        scene.set(id, value).map_err(words)?;
    }
    let gas: Vec<Instance> = (0..400)
        .map(|i| {
            let across = (i % 20) as f32 / 19.0 - 0.5;
            let place = [x + 0.4 * across, 0.2 + 0.04 * (i / 20) as f32];
            match model {
                Model::Classic => [place[0], place[1], 0.0, 1.0, 1700.0, 1.0, 0.2, 0.8],
                Model::Combustion => [place[0], place[1], 0.0, 1.0, 1500.0, 8e-4, 0.4, 0.1],
            }
        })
        .collect();
    Canvas::new(WIDTH, HEIGHT)?.paint(&gas, &scene)
}

#[wasm_bindgen_test]
fn the_picture_moves_with_the_source() -> Result<(), JsValue> {
    for model in [Model::Classic, Model::Combustion] {
        let (middle, aside) = (painted(model, 0.0)?, painted(model, ASIDE.1)?);
        let (middle, aside): (Vec<_>, Vec<_>) = (middle.all().collect(), aside.all().collect());
        let (mut bright, mut apart) = (0, 0);
        for (at, &(_, _, pixel)) in middle.iter().enumerate() {
            if light(pixel) > 20 {
                let (_, _, moved) = aside[at + ASIDE.0];
                bright += 1;
                apart += u32::from(light(pixel).abs_diff(light(moved)));
            }
        }
        // The texels of the fields stand elsewhere in the gas, so rims differ a little.
        let apart = f64::from(apart) / f64::from(bright);
        assert!(
            bright > 5000 && apart < 3.0,
            "{model:?}: {apart} of {bright}"
        );
    }
    Ok(())
}
