//! The ground in a real browser: it begins below the fire, in the light of the fire and of the
//! background, and solids cast shadows on it.

use hearth_core::params::{Choice, Ground, Input};
use hearth_core::{Instance, Scene};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::canvas::{Canvas, Pixels, painted};
use crate::{HEIGHT, WIDTH, light, puff, with};

/// Height at which the ground begins \[m\]: a tenth of the domain above the source, with a margin.
const HORIZON: f32 = 0.15 + 0.02;

fn settings(ground: &str, background: &str) -> Result<Scene, JsValue> {
    with(&[
        ("ground", Input::Text(ground)),
        ("background", Input::Text(background)),
        ("source_height", Input::Number(0.0)),
    ])
}

/// Excess of red over green in a pixel that an eye calls reddish.
const REDDISH: u8 = 24;

/// The picture of a ground without solids.
fn ground(
    canvas: &Canvas,
    name: &str,
    background: &str,
    gas: &[Instance],
) -> Result<Pixels, JsValue> {
    painted(canvas, &settings(name, background)?, gas)
}

/// Whether no channel of two pixels differs by more than dithering.
fn same(first: [u8; 4], second: [u8; 4]) -> bool {
    first.iter().zip(second).all(|(a, b)| a.abs_diff(b) <= 1)
}

/// Sum of the light of the ground.
fn brightness(pixels: &Pixels) -> f32 {
    let below = pixels.all().filter(|(_, y, _)| *y < 0.5 * HORIZON);
    below.map(|(.., pixel)| f32::from(light(pixel))).sum()
}

#[wasm_bindgen_test]
fn a_ground_is_below_its_horizon_and_each_has_its_colours() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let mut seen: Vec<[u8; 4]> = Vec::new();
    for name in Ground::NAMES {
        let pixels = ground(&canvas, name, "#345678", &[])?;
        for (x, y, pixel) in pixels.all() {
            if y > HORIZON || *name == "none" {
                let background = [0x34, 0x56, 0x78, 255];
                assert!(same(pixel, background), "{name}: {pixel:?} at {x}, {y}");
            }
        }
        let [mut sum, mut count] = [[0_u32; 4], [0; 4]];
        for (.., pixel) in pixels.all().filter(|(_, y, _)| *y < 0.5 * HORIZON) {
            for channel in 0..4 {
                sum[channel] += u32::from(pixel[channel]);
                count[channel] += 1;
            }
        }
        let mean = std::array::from_fn(|i| (sum[i] / count[i]) as u8);
        assert!(
            !seen.iter().any(|pixel| same(*pixel, mean)),
            "{name}: {mean:?}"
        );
        seen.push(mean);
    }
    Ok(())
}

#[wasm_bindgen_test]
fn a_transparent_page_gets_only_the_light_on_the_ground() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let gas = puff((0.0, 0.4), 1900.0);
    for name in Ground::NAMES.iter().filter(|name| **name != "none") {
        let dark = ground(&canvas, name, "transparent", &[])?;
        assert!(dark.all().all(|(.., pixel)| same(pixel, [0; 4])), "{name}");
        let without = ground(&canvas, "none", "transparent", &gas)?;
        let lit = ground(&canvas, name, "transparent", &gas)?;
        assert!(brightness(&lit) > brightness(&without) + 1000.0, "{name}");
        for (x, y, pixel) in lit.all() {
            assert!(light(pixel) <= pixel[3], "{name}: {pixel:?} at {x}, {y}");
        }
    }
    Ok(())
}

#[wasm_bindgen_test]
fn the_light_on_a_ground_does_not_redden_a_white_page() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let gas = puff((0.0, 0.4), 1900.0);
    for name in Ground::NAMES.iter().filter(|name| **name != "none") {
        let pixels = ground(&canvas, name, "transparent", &gas)?;
        let [mut reddish, mut count] = [0.0; 2];
        for (x, y, [red, green, ..]) in pixels.all() {
            if x.hypot(y - 0.4) > 0.25 {
                count += 1.0;
                // A white page shows 1 − alpha more of each colour.
                reddish += f32::from(u8::from(red.saturating_sub(green) > REDDISH));
            }
        }
        let share = reddish / count;
        assert!(share <= 0.005, "{name}: {share} of the page");
    }
    Ok(())
}

#[wasm_bindgen_test]
fn a_bright_sky_lights_the_ground() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let under = |sky| Ok::<_, JsValue>(brightness(&ground(&canvas, "earth", sky, &[])?));
    assert!(under("#ffffff")? > 2.0 * under("#000000")?);
    Ok(())
}

#[wasm_bindgen_test]
fn a_solid_casts_its_shadow_away_from_the_fire() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    for side in [-1.0, 1.0] {
        let gas = puff((0.4 * side, 0.3), 1900.0);
        let with = |material| -> Result<Pixels, JsValue> {
            let mut scene = settings("sand", "#000000")?;
            scene
                .add(&[
                    ("kind", Input::Text("solid")),
                    ("y", Input::Number(0.08)),
                    ("width", Input::Number(0.16)),
                    ("material", Input::Text(material)),
                ])
                .map_err(|errors| format!("{errors:?}"))?;
            painted(&canvas, &scene, &gas)
        };
        let (without, shaded) = (with("none")?, with("stone")?);
        let [mut towards, mut away] = [0.0; 2];
        for ((x, y, before), (.., pixel)) in without.all().zip(shaded.all()) {
            if x.hypot(y - 0.08) > 0.1 {
                let lost = f32::from(light(before)) - f32::from(light(pixel));
                assert!(lost >= -1.0, "brighter at {x}, {y}: {before:?}, {pixel:?}");
                *(if x * side > 0.0 {
                    &mut towards
                } else {
                    &mut away
                }) += lost.max(0.0);
            }
        }
        assert!(away > 1.5 * towards && away > 500.0, "{away} and {towards}");
    }
    Ok(())
}
