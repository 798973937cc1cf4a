//! The combustion model's fire in a real browser: gas is drawn as gas and not
//! as particles, fire and smoke apart, its fine structure goes with it, embers
//! shine.

use hearth_core::params::{Input, Model};
use hearth_core::{Instance, Scene};
use hearth_render::{History, Renderer, ResolutionLimits};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::canvas::{Canvas, Pixels, words};
use crate::light;

const WIDTH: u32 = 240;
const HEIGHT: u32 = 320;

/// Where the block of gas stands \[m\]: left, lower, right, upper edge.
const BLOCK: [f32; 4] = [-0.3, 0.6, 0.3, 1.3];

/// The defaults of the combustion model with some values changed.
fn with(values: &[(&str, Input<'_>)]) -> Result<Scene, JsValue> {
    let mut parameters = Scene::of_model(Model::Combustion);
    for &(id, input) in values {
        parameters.set(id, input).map_err(words)?;
    }
    Ok(parameters)
}

/// Without fine structure and glow, and with that number of particles.
fn plain(particles: f64) -> Result<Scene, JsValue> {
    with(&[
        ("detail", Input::Number(0.0)),
        ("bloom", Input::Number(0.0)),
        ("max_particles", Input::Number(particles)),
    ])
}

/// A particle at a place, with the state that all of a block have.
type State = [f32; 3];

/// A block of gas at rest or in motion: temperature \[K\], soot, upward speed [m/s].
/// Its particles fill it without a gap, in rows that are shifted against each
/// other.
fn block([kelvin, soot, speed]: State, parameters: &Scene) -> Vec<Instance> {
    let spacing = parameters.world().spacing();
    let [left, lower, right, upper] = BLOCK;
    let [columns, rows] =
        [right - left, upper - lower].map(|side| (side / spacing).ceil() as usize);
    (0..rows * columns)
        .map(|at| {
            let (column, row) = (at % columns, at / columns);
            let x = left + (column as f32 + 0.25 + 0.5 * (row % 2) as f32) * spacing;
            let y = lower + (row as f32 + 0.5) * spacing;
            [x, y, 0.0, speed, kelvin, spacing * spacing, soot, 0.1]
        })
        .collect()
}

/// The pixels of the block's inside, where no kernel of the edge reaches.
fn inside(pixels: &Pixels) -> Vec<[u8; 4]> {
    let margin = 0.18;
    let [left, lower, right, upper] = BLOCK;
    pixels
        .all()
        .filter(|&(x, y, _)| {
            (left + margin..right - margin).contains(&x)
                && (lower + margin..upper - margin).contains(&y)
        })
        .map(|(_, _, pixel)| pixel)
        .collect()
}

/// Mean of every channel.
fn mean(pixels: &[[u8; 4]]) -> [f32; 4] {
    let mut sum = [0.0; 4];
    for pixel in pixels {
        for (sum, &channel) in sum.iter_mut().zip(pixel) {
            *sum += f32::from(channel) / pixels.len() as f32;
        }
    }
    sum
}

/// Largest difference of two pixels in a channel.
fn off(a: [f32; 4], b: [f32; 4]) -> f32 {
    a.iter()
        .zip(b)
        .fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

fn ember(x: f32, y: f32, size: f32) -> Instance {
    [x, y, 0.0, 0.0, 1300.0, size, 0.1, 0.9]
}

/// Light of a whole picture, in full pixels.
fn all_light(pixels: &Pixels) -> f32 {
    pixels
        .all()
        .map(|(_, _, pixel)| f32::from(light(pixel)) / 255.0)
        .sum()
}

#[wasm_bindgen_test]
fn single_particles_of_a_block_of_gas_are_invisible() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    for particles in [1000.0, 3000.0, 12_000.0] {
        let parameters = plain(particles)?;
        let pixels = inside(&canvas.paint(&block([1400.0, 0.4, 0.0], &parameters), &parameters)?);
        let whole = mean(&pixels);
        assert!(whole[0] > 100.0, "{particles}: {whole:?}");
        for pixel in pixels {
            let [r, g, b, a] = pixel;
            let apart = off([r, g, b, a].map(f32::from), whole);
            assert!(apart < 4.0, "{particles}: {pixel:?} in {whole:?}");
        }
    }
    Ok(())
}

#[wasm_bindgen_test]
fn temperature_and_soot_do_not_depend_on_the_particles() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    for state in [[1100.0, 1.2, 0.0], [1400.0, 0.2, 0.0], [1900.0, 0.05, 0.0]] {
        let shown = |particles| -> Result<[f32; 4], JsValue> {
            let parameters = plain(particles)?;
            Ok(mean(&inside(
                &canvas.paint(&block(state, &parameters), &parameters)?,
            )))
        };
        let (few, many) = (shown(1500.0)?, shown(12_000.0)?);
        assert!(off(few, many) < 3.0, "{state:?}: {few:?}, {many:?}");
    }
    Ok(())
}

#[wasm_bindgen_test]
fn hotter_and_sootier_gas_is_brighter() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let parameters = plain(3000.0)?;
    let shown = |kelvin, soot| -> Result<[f32; 4], JsValue> {
        let gas = block([kelvin, soot, 0.0], &parameters);
        Ok(mean(&inside(&canvas.paint(&gas, &parameters)?)))
    };
    let [r, g, ..] = shown(1300.0, 0.2)?;
    let [hot_r, hot_g, ..] = shown(1700.0, 0.2)?;
    let [sooty_r, ..] = shown(1300.0, 0.6)?;
    assert!(hot_r > r + 10.0 && sooty_r > r + 10.0);
    assert!(hot_g / hot_r > g / r, "hotter gas is less red");
    Ok(())
}

#[wasm_bindgen_test]
fn fire_and_smoke_are_separate_layers() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let shown = |state: State, layers| -> Result<[f32; 4], JsValue> {
        let mut parameters = plain(3000.0)?;
        let more = [
            ("layers", Input::Text(layers)),
            ("smoke_opacity", Input::Number(1.0)),
        ];
        parameters.set_all(more).map_err(|_| "refused")?;
        let gas = block(state, &parameters);
        Ok(mean(&inside(&canvas.paint(&gas, &parameters)?)))
    };
    let (hot, cold) = ([1700.0, 0.3, 0.0], [500.0, 0.3, 0.0]);
    assert_eq!(shown(hot, "smoke")?, [0.0; 4]);
    assert_eq!(shown(cold, "fire")?, [0.0; 4]);
    assert_eq!(shown(hot, "fire")?, shown(hot, "both")?);
    let [fire, ..] = shown(hot, "fire")?;
    let [r, g, b, a] = shown(cold, "smoke")?;
    let [beside_fire, .., hides] = shown(cold, "both")?;
    assert!(fire > 150.0, "fire of {fire}");
    // Smoke is grey and hides what is behind it. Where it is alone, more light
    // falls on it, so that it is seen on black too.
    assert!((a - hides).abs() < 1.0 && a > 80.0);
    assert!(r > 1.5 * beside_fire && beside_fire > 10.0);
    assert!((r - b).abs() < 0.4 * r && g < 0.7 * a);
    Ok(())
}

#[wasm_bindgen_test]
fn no_colour_exceeds_its_alpha() -> Result<(), JsValue> {
    for canvas in [
        Canvas::new(WIDTH, HEIGHT)?,
        Canvas::without_float_targets(WIDTH, HEIGHT)?,
    ] {
        let embers = [ember(0.0, 0.9, 0.02), ember(0.4, 1.5, 0.004)];
        for layers in ["both", "fire", "smoke"] {
            let mut parameters = with(&[("bloom", Input::Number(0.6))])?;
            parameters
                .set("layers", Input::Text(layers))
                .map_err(words)?;
            let mut gas = block([1500.0, 0.4, 1.0], &parameters);
            // Hot at one side, cold at the other.
            for particle in &mut gas {
                particle[4] += 2500.0 * particle[0];
            }
            let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
            let pixels = canvas.paint_at(&mut renderer, 1.0, [&gas, &embers], &parameters)?;
            renderer.destroy(&canvas.gl);
            for (x, y, pixel) in pixels.all() {
                assert!(light(pixel) <= pixel[3], "{layers}: {pixel:?} at {x}, {y}");
            }
        }
        assert_eq!(canvas.gl_error(), 0);
    }
    Ok(())
}

#[wasm_bindgen_test]
fn light_stays_near_the_gas() -> Result<(), JsValue> {
    for canvas in [
        Canvas::new(WIDTH, HEIGHT)?,
        Canvas::without_float_targets(WIDTH, HEIGHT)?,
    ] {
        let parameters = with(&[("bloom", Input::Number(0.0))])?;
        let gas = block([1700.0, 0.5, 0.0], &parameters);
        let pixels = canvas.paint(&gas, &parameters)?;
        assert!(mean(&inside(&pixels))[0] > 100.0);
        let [left, lower, right, upper] = BLOCK;
        for (x, y, pixel) in pixels.all() {
            let near = (left - 0.15..right + 0.15).contains(&x)
                && (lower - 0.15..upper + 0.15).contains(&y);
            assert!(near || light(pixel) < 4, "{pixel:?} at {x}, {y}");
        }
    }
    Ok(())
}

#[wasm_bindgen_test]
fn fine_structure_moves_with_the_gas() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let parameters = with(&[("bloom", Input::Number(0.0))])?;
    let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
    let speed = 3.0;
    let gas = block([1400.0, 0.4, speed], &parameters);
    let mut history = History::default();
    let mut pictures = Vec::new();
    for frame in 0..=5 {
        let time = 1.0 + f64::from(frame) / 60.0;
        let gas = [&gas[..], &[]];
        let renderer = &mut renderer;
        pictures.push(canvas.paint_after(&mut history, renderer, time, gas, &parameters)?);
    }
    renderer.destroy(&canvas.gl);
    // A pattern lives for 0.14 s, so only what is a frame ago is alike.
    let (before, after) = (&pictures[4], &pictures[5]);
    let way = speed / 60.0;
    // How little a place looks like that place, so much lower, a frame before.
    let change = |way: f32| -> f32 {
        after
            .all()
            .filter(|&(x, y, _)| x.abs() < 0.15 && (0.85..1.15).contains(&y))
            .map(|(x, y, pixel)| f32::from(light(pixel).abs_diff(light(before.at(x, y - way)))))
            .sum()
    };
    let (carried, resting) = (change(way), change(0.0));
    assert!(carried < 0.6 * resting, "{carried} against {resting}");
    Ok(())
}

#[wasm_bindgen_test]
fn an_ember_shines_and_glows_around() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let shown = |bloom| -> Result<Pixels, JsValue> {
        let parameters = with(&[("bloom", Input::Number(bloom))])?;
        let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
        let embers = [ember(0.2, 1.2, 0.02)];
        let pixels = canvas.paint_at(&mut renderer, 1.0, [&[], &embers], &parameters)?;
        renderer.destroy(&canvas.gl);
        Ok(pixels)
    };
    let (bare, glowing) = (shown(0.0)?, shown(0.6)?);
    let [r, g, b, _] = bare.at(0.2, 1.2);
    assert!(r > 150 && r > g && g >= b, "{:?}", [r, g, b]);
    for (x, y, pixel) in bare.all() {
        let near = (x - 0.2).hypot(y - 1.2) < 0.06;
        assert!(near || pixel == [0; 4], "{pixel:?} at {x}, {y}");
    }
    let beyond = (0.2, 1.27);
    assert!(light(glowing.at(beyond.0, beyond.1)) > 3);
    assert_eq!(canvas.gl_error(), 0);
    Ok(())
}

#[wasm_bindgen_test]
fn a_spark_has_no_hard_straight_edge_at_low_quality() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let parameters = with(&[
        ("bloom", Input::Number(0.0)),
        ("exposure", Input::Number(2.0)),
    ])?;
    let pixel = parameters.world().domain_height / HEIGHT as f32;
    for turn in 0..8 {
        let (sin, cos) = (0.4 * turn as f32).sin_cos();
        let [x, y, _, _, _, size, age, life] = ember(0.1, 1.0, 0.003);
        let spark = [x, y, 1.5 * cos, 1.5 * sin, 1700.0, size, age, life];
        let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
        renderer.set_limits(ResolutionLimits::LOW);
        let pixels = canvas.paint_at(&mut renderer, 1.0, [&[], &[spark]], &parameters)?;
        renderer.destroy(&canvas.gl);
        assert!(all_light(&pixels) > 1.0);
        let at = |x: f32, y: f32| light(pixels.at(x, y));
        for (x, y, _) in pixels
            .all()
            .filter(|&(x, y, _)| (x - 0.1).hypot(y - 1.0) < 0.15)
        {
            for (along, across) in [((pixel, 0.0), (0.0, pixel)), ((0.0, pixel), (pixel, 0.0))] {
                let steps = [0.0, 1.0, 2.0].map(|number| {
                    let (x, y) = (x + number * along.0, y + number * along.1);
                    at(x, y).abs_diff(at(x + across.0, y + across.1))
                });
                let least = steps.into_iter().min();
                assert!(least < Some(128), "{steps:?} at {x}, {y}");
            }
        }
    }
    Ok(())
}

#[wasm_bindgen_test]
fn an_ember_smaller_than_a_pixel_does_not_flicker() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let parameters = with(&[("bloom", Input::Number(0.0))])?;
    let pixel = parameters.world().domain_height / HEIGHT as f32;
    let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
    let mut seen: Vec<f32> = Vec::new();
    for step in 0..9 {
        let at = step as f32 / 8.0 * pixel;
        let embers = [ember(at, 1.0 + 0.7 * at, 0.4 * pixel)];
        let pixels = canvas.paint_at(&mut renderer, 1.0, [&[], &embers], &parameters)?;
        seen.push(all_light(&pixels));
    }
    renderer.destroy(&canvas.gl);
    let least = seen.iter().copied().fold(f32::INFINITY, f32::min);
    let most = seen.iter().copied().fold(0.0, f32::max);
    assert!(least > 0.1 && most < 1.4 * least, "{seen:?}");
    Ok(())
}
