//! Display modes in a real browser: a colour stands for what the gas is, in every
//! format; nothing shows a texel or exceeds its alpha; sprites are where it glows.

mod fields;

use hearth_core::params::{Choice, DisplayMode, Input, Model};
use hearth_core::{Instance, Scene, Simulation};
use hearth_render::{History, Renderer, View};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::canvas::{Canvas, Pixels, words};
use crate::light;
use crate::scale::colour;

const WIDTH: u32 = 240;
const HEIGHT: u32 = 360;

fn every_mode() -> impl Iterator<Item = DisplayMode> {
    DisplayMode::NAMES
        .iter()
        .filter_map(|name| DisplayMode::from_name(name))
}

/// A model's defaults, with a closed domain of 3000 particles in the combustion model: gas is
/// everywhere in it.
fn closed(model: Model) -> Result<Scene, JsValue> {
    let mut parameters = Scene::of_model(model);
    if model == Model::Combustion {
        for (id, input) in [
            ("edges", Input::Text("periodic")),
            ("particles", Input::Number(3000.0)),
        ] {
            parameters.set(id, input).map_err(words)?;
        }
    }
    Ok(parameters)
}

/// A fire of that model that has burnt.
fn burnt(model: Model) -> Result<Simulation, JsValue> {
    let mut fire = Simulation::new(closed(model)?);
    while fire.time() < 0.8 {
        fire.step();
    }
    Ok(fire)
}

/// Its instances in that mode.
fn instances(fire: &mut Simulation, mode: DisplayMode) -> Result<Vec<Instance>, JsValue> {
    fire.set("display_mode", Input::Text(mode.name()))
        .map_err(words)?;
    let mut instances = Vec::new();
    fire.write_instances(&mut instances);
    Ok(instances)
}

/// Its picture in that mode, and what the colours stand for.
fn shown(
    canvas: &Canvas,
    fire: &mut Simulation,
    mode: DisplayMode,
) -> Result<(Pixels, Option<[f32; 2]>), JsValue> {
    let instances = instances(fire, mode)?;
    let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
    let pixels = canvas.paint_with(&mut renderer, &instances, fire.scene())?;
    let scale = renderer.scale().map(|(_, ends)| ends);
    renderer.destroy(&canvas.gl);
    Ok((pixels, scale))
}

/// Largest difference in a channel.
fn off(pixel: [u8; 4], expected: [f32; 3]) -> f32 {
    let channels = pixel.iter().zip(expected);
    channels.fold(0.0, |most, (&shown, expected)| {
        most.max((f32::from(shown) - expected).abs())
    })
}

#[wasm_bindgen_test]
fn a_disc_has_the_colour_of_its_particle_and_a_smooth_rim() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let mut parameters = Scene::of_model(Model::Classic);
    let set = [
        ("display_mode", Input::Text("particles")),
        // A spacing of 0.1 m: discs of 19 pixels.
        ("particle_mass", Input::Number(2e-3)),
        ("rest_density", Input::Number(0.5)),
    ];
    parameters.set_all(set).map_err(|_| "refused")?;
    let kelvins = [400.0, 900.0, 1400.0, 1900.0];
    let particles: Vec<Instance> = (0..)
        .zip(kelvins)
        .map(|(i, kelvin)| {
            let x = -0.3 + 0.2 * i as f32;
            [x, 0.75, 0.0, 0.0, kelvin, 1e-4, 0.0, kelvin]
        })
        .collect();
    let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
    let pixels = canvas.paint_with(&mut renderer, &particles, &parameters)?;
    let (_, [least, most]) = renderer.scale().ok_or("no scale")?;
    renderer.destroy(&canvas.gl);
    for &[x, y, _, _, kelvin, ..] in &particles {
        let expected = colour((kelvin - least) / (most - least), false);
        let pixel = pixels.at(x, y);
        assert!(off(pixel, expected) <= 2.0 && pixel[3] == 255, "{pixel:?}");
    }
    let radius = 0.4 * parameters.world().spacing();
    let mut between = 0;
    for (x, y, [.., alpha]) in pixels.all() {
        let nearest = particles
            .iter()
            .map(|particle| (x - particle[0]).hypot(y - particle[1]));
        let nearest = nearest.fold(f32::INFINITY, f32::min);
        assert!(nearest > radius - 0.008 || alpha == 255);
        assert!(nearest < radius + 0.008 || alpha == 0);
        between += u32::from((1..255).contains(&alpha));
    }
    assert!(between > 60, "{between} pixels of four rims");
    Ok(())
}

#[wasm_bindgen_test]
fn particles_smaller_than_a_pixel_are_visible() -> Result<(), JsValue> {
    let canvas = Canvas::new(40, 60)?;
    let mut fire = Simulation::new(closed(Model::Combustion)?);
    let (pixels, _) = shown(&canvas, &mut fire, DisplayMode::Particles)?;
    let seen = pixels.all().filter(|(_, _, pixel)| pixel[3] > 100).count();
    assert!(seen > 1200, "{seen} of 2400 pixels");
    Ok(())
}

#[wasm_bindgen_test]
fn every_mode_differs_from_the_fire() -> Result<(), JsValue> {
    for canvas in [
        Canvas::new(WIDTH, HEIGHT)?,
        Canvas::without_float_targets(WIDTH, HEIGHT)?,
    ] {
        for model in [Model::Classic, Model::Combustion] {
            let mut fire = burnt(model)?;
            let (usual, nothing) = shown(&canvas, &mut fire, DisplayMode::Fire)?;
            assert_eq!(nothing, None);
            for mode in every_mode().filter(|&mode| mode != DisplayMode::Fire) {
                let (pixels, scale) = shown(&canvas, &mut fire, mode)?;
                assert_eq!(scale.is_some(), mode.quantity().is_some(), "{mode:?}");
                let all = || pixels.all().zip(usual.all());
                let seen = all().filter(|((.., pixel), _)| light(*pixel) > 30).count();
                assert!(seen > 300, "{model:?}, {mode:?}: {seen} pixels");
                let others = all().filter(|((.., a), (.., b))| light(*a).abs_diff(light(*b)) > 20);
                let others = others.count();
                assert!(others > 300, "{model:?}, {mode:?}: {others} pixels");
                for (x, y, pixel) in pixels.all() {
                    assert!(light(pixel) <= pixel[3], "{mode:?}: {pixel:?} at {x}, {y}");
                }
            }
        }
        assert_eq!(canvas.gl_error(), 0);
    }
    Ok(())
}

#[wasm_bindgen_test]
fn the_background_is_visible_without_gas() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let mut fire = burnt(Model::Classic)?;
    fire.set("background", Input::Text("#204060"))
        .map_err(words)?;
    for mode in every_mode() {
        let (pixels, _) = shown(&canvas, &mut fire, mode)?;
        let pixel = pixels.at(-0.45, 1.4);
        assert!(
            off(pixel, [0x20, 0x40, 0x60].map(|channel| channel as f32)) <= 3.0,
            "{mode:?}: {pixel:?}"
        );
        assert!(
            pixels.all().all(|(_, _, pixel)| pixel[3] == 255),
            "{mode:?}"
        );
    }
    Ok(())
}

#[wasm_bindgen_test]
fn removed_particles_leave_no_trace() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    for model in [Model::Classic, Model::Combustion] {
        let mut fire = burnt(model)?;
        let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
        for mode in every_mode() {
            let particles = instances(&mut fire, mode)?;
            canvas.paint_with(&mut renderer, &particles, fire.scene())?;
            let pixels = canvas.paint_with(&mut renderer, &[], fire.scene())?;
            assert!(
                pixels.all().all(|(_, _, pixel)| pixel == [0; 4]),
                "{model:?}, {mode:?}"
            );
        }
        renderer.destroy(&canvas.gl);
    }
    Ok(())
}

#[wasm_bindgen_test]
fn sprites_do_not_depend_on_the_order_and_rotate_smoothly() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    for model in [Model::Classic, Model::Combustion] {
        let mut fire = burnt(model)?;
        let mut sprites = instances(&mut fire, DisplayMode::Sprites)?;
        let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
        let mut paint = |sprites: &[Instance], time| {
            canvas.paint_at(&mut renderer, time, [sprites, &[]], fire.scene())
        };
        let first = paint(&sprites, 1.0)?;
        let later = paint(&sprites, 1.0 + 1.0 / 60.0)?;
        let much_later = paint(&sprites, 4.0)?;
        // Two turns of the slowest are a period: nothing is seen to begin again.
        let again = paint(&sprites, 37.0)?;
        sprites.reverse();
        let reversed = paint(&sprites, 1.0)?;
        renderer.destroy(&canvas.gl);
        let apart = |a: &Pixels, b: &Pixels| {
            let pairs = a.all().zip(b.all());
            let pairs = pairs.map(|((.., a), (.., b))| off(a, [b[0], b[1], b[2]].map(f32::from)));
            pairs.fold(0.0, f32::max)
        };
        assert!(apart(&first, &reversed) <= 8.0);
        assert!(apart(&first, &again) <= 8.0);
        assert!(apart(&first, &later) <= 24.0);
        assert!(apart(&first, &much_later) > 24.0);
    }
    Ok(())
}

#[wasm_bindgen_test]
fn no_mode_panics_without_a_context() -> Result<(), JsValue> {
    let mut fire = burnt(Model::Combustion)?;
    for mode in every_mode() {
        let canvas = Canvas::new(WIDTH, HEIGHT)?;
        let particles = instances(&mut fire, mode)?;
        let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
        let mode = fire.parameters().display_mode;
        renderer.upload(&canvas.gl, mode, &particles, &[]);
        canvas.lose_context()?;
        let view = View {
            width: WIDTH,
            height: HEIGHT,
            time: 0.0,
            ..View::default()
        };
        // An error or a picture without effect: neither stops the page.
        let _ = renderer.paint(&canvas.gl, &view, fire.scene(), &History::default());
        renderer.destroy(&canvas.gl);
    }
    Ok(())
}
