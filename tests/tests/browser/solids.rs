//! Solids in a real browser: each covers its shape and nothing else, in the light of the fire.

use hearth_core::params::{Choice, DisplayMode, Input, Material, Model, Parameters, Shape};
use hearth_core::scene::MAX_OBJECTS;
use hearth_core::{Charred, Instance, Scene, Vec2};
use hearth_render::Renderer;
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::canvas::{Canvas, painted, words};
use crate::{HEIGHT, WIDTH, light, puff};

/// How far from a surface its soft edge reaches \[m\]: two pixels of 6 mm.
const EDGE: f32 = 0.012;

/// A star that crosses itself.
const STAR: &str = "0,0.3 -0.18,-0.24 0.285,0.09 -0.285,0.09 0.18,-0.24";
/// Two posts with a beam: 8 × 4 pixels.
const ARCH: &str = "8x4:3PSqSo";

type Fields<'a> = [(&'a str, Input<'a>)];

/// A scene without sources, with these solids.
fn scene(settings: Parameters, solids: &[&Fields<'_>]) -> Result<Scene, JsValue> {
    let mut scene = Scene::new(settings);
    scene.clear();
    for solid in solids {
        let fields = [&[("kind", Input::Text("solid"))], *solid].concat();
        scene.add(&fields).map_err(|errors| format!("{errors:?}"))?;
    }
    Ok(scene)
}

/// A scene with one solid, whose gas does not move the picture of another.
fn with_one(solid: &Fields<'_>) -> Result<Scene, JsValue> {
    scene(Parameters::new(Model::Classic), &[solid])
}

/// A circle 0.4 m wide at this place.
fn circle(x: f64, y: f64) -> [(&'static str, Input<'static>); 3] {
    [("x", x), ("y", y), ("width", 0.4)].map(|(name, value)| (name, Input::Number(value)))
}

#[wasm_bindgen_test]
fn a_solid_is_opaque_and_nothing_around_it_is() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    for shape in Shape::NAMES {
        let fields = [
            ("shape", Input::Text(shape)),
            ("x", Input::Number(-0.1)),
            ("y", Input::Number(0.8)),
            ("angle", Input::Number(25.0)),
            ("width", Input::Number(0.5)),
            ("height", Input::Number(0.2)),
            ("corner", Input::Number(0.05)),
            ("points", Input::Text(STAR)),
            ("mask", Input::Text(ARCH)),
        ];
        for material in Material::NAMES {
            let fields = [&fields[..], &[("material", Input::Text(material))]].concat();
            let scene = with_one(&fields)?;
            let pixels = painted(&canvas, &scene, &[])?;
            for (_, _, surface) in scene.surfaces() {
                for (x, y, pixel) in pixels.all() {
                    let (distance, _) = surface.distance(Vec2::new(x, y));
                    let what = format!("{material} {shape}: {pixel:?} at {x}, {y}");
                    assert!(light(pixel) <= pixel[3], "{what}");
                    if distance > EDGE || *material == "none" {
                        assert_eq!(pixel, [0; 4], "{what}");
                    } else if distance < -EDGE {
                        let covers = if *material == "glass" {
                            20..255
                        } else {
                            255..256
                        };
                        assert!(covers.contains(&u16::from(pixel[3])), "{what}");
                    }
                }
            }
        }
    }
    Ok(())
}

#[wasm_bindgen_test]
fn a_solid_is_bright_on_the_side_of_the_fire() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let stone = with_one(&circle(0.0, 0.6))?;
    let bright = |gas: &[Instance], side: f32| -> Result<f32, JsValue> {
        let pixels = painted(&canvas, &stone, gas)?;
        let half = pixels
            .all()
            .filter(|(x, y, _)| x * side > 0.0 && x.hypot(y - 0.6) < 0.19);
        Ok(half.map(|(_, _, pixel)| f32::from(light(pixel))).sum())
    };
    for side in [-1.0, 1.0] {
        let gas = puff((0.4 * side, 0.6), 1900.0);
        let (towards, away, dark) = (
            bright(&gas, side)?,
            bright(&gas, -side)?,
            bright(&[], side)?,
        );
        // Displayed values are compressed: 1.25 times as high is 1.7 times as bright.
        assert!(towards > 1.25 * away, "{side}: {towards} and {away}");
        assert!(away > dark, "{side}: {away} and {dark}");
    }
    Ok(())
}

#[wasm_bindgen_test]
fn an_invisible_solid_changes_no_pixel() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let gas = puff((0.2, 0.6), 1900.0);
    for mode in DisplayMode::NAMES {
        let mut settings = Parameters::new(Model::Classic);
        settings
            .set("display_mode", Input::Text(mode))
            .map_err(words)?;
        let invisible = [&circle(0.0, 0.6)[..], &[("material", Input::Text("none"))]].concat();
        let without = painted(&canvas, &scene(settings.clone(), &[])?, &gas)?;
        let with = painted(&canvas, &scene(settings, &[&invisible])?, &gas)?;
        assert!(without.all().eq(with.all()), "{mode}");
    }
    Ok(())
}

#[wasm_bindgen_test]
fn as_many_solids_as_a_scene_holds_are_drawn_and_removed() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let place = |at: usize| {
        [
            (at % 8) as f64 * 0.15 - 0.525,
            (at / 8) as f64 * 0.17 + 0.12,
        ]
    };
    let solids: Vec<_> = (0..MAX_OBJECTS)
        .map(|at| {
            let [x, y] = place(at);
            [("x", x), ("y", y), ("width", 0.1)].map(|(name, value)| (name, Input::Number(value)))
        })
        .collect();
    let solids: Vec<_> = solids.iter().map(|solid| &solid[..]).collect();
    let settings = Parameters::new(Model::Classic);
    let empty = scene(settings.clone(), &[])?;
    let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
    renderer.upload_solids(
        &canvas.gl,
        &scene(settings, &solids)?,
        &[],
        &[],
        &Charred::default(),
    );
    let pixels = canvas.paint_with(&mut renderer, &[], &empty)?;
    for [x, y] in (0..MAX_OBJECTS).map(place) {
        let pixel = pixels.at(x as f32, y as f32);
        assert_eq!(pixel[3], 255, "{pixel:?} at {x}, {y}");
    }
    renderer.upload_solids(&canvas.gl, &empty, &[], &[], &Charred::default());
    let pixels = canvas.paint_with(&mut renderer, &[], &empty)?;
    renderer.destroy(&canvas.gl);
    assert!(pixels.all().all(|(_, _, pixel)| pixel == [0; 4]));
    Ok(())
}

#[wasm_bindgen_test]
fn display_modes_show_the_outline() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let gas = puff((0.2, 0.6), 1900.0);
    let modes = DisplayMode::NAMES.iter().filter(|mode| **mode != "fire");
    for mode in modes {
        let mut settings = Parameters::new(Model::Classic);
        settings
            .set("display_mode", Input::Text(mode))
            .map_err(words)?;
        let without = painted(&canvas, &scene(settings.clone(), &[])?, &gas)?;
        let with = painted(&canvas, &scene(settings, &[&circle(0.0, 0.6)])?, &gas)?;
        let mut drawn = 0;
        for ((x, y, before), (_, _, pixel)) in without.all().zip(with.all()) {
            let distance = x.hypot(y - 0.6) - 0.2;
            // The dark line is half of five pixels wide.
            if distance.abs() > 2.0 * EDGE {
                assert_eq!(before, pixel, "{mode} at {x}, {y}");
            } else if distance.abs() < 0.25 * EDGE {
                assert!(light(pixel) > 150, "{mode}: {pixel:?} at {x}, {y}");
                drawn += 1;
            }
        }
        assert!(drawn > 100, "{mode}: {drawn} pixels");
    }
    Ok(())
}

#[wasm_bindgen_test]
fn a_hot_surface_glows_redder_when_it_is_cooler() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let at = |kelvin: f64| {
        let hot = [
            ("material", Input::Text("iron")),
            ("thermal", Input::Text("fixed")),
            ("temperature", Input::Number(kelvin)),
        ];
        let scene = with_one(&[&circle(0.0, 0.6)[..], &hot].concat())?;
        Ok::<_, JsValue>(painted(&canvas, &scene, &[])?.at(0.0, 0.6))
    };
    let (cold, red, yellow) = (at(400.0)?, at(1150.0)?, at(1700.0)?);
    assert!(
        light(cold) < 60 && red[0] > 90 && yellow[0] > 200,
        "{cold:?} {red:?} {yellow:?}"
    );
    let greenness = |[r, g, ..]: [u8; 4]| f32::from(g) / f32::from(r);
    assert!(
        greenness(red) + 0.1 < greenness(yellow),
        "{red:?} {yellow:?}"
    );
    Ok(())
}

#[wasm_bindgen_test]
fn an_outline_is_drawn_again_when_it_changes_and_moves_without_an_upload() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let mut renderer = Renderer::new(&canvas.gl).map_err(words)?;
    let fields = [("shape", Input::Text("stroke")), ("y", Input::Number(0.6))];
    let mut scene = with_one(&fields)?;
    let rings = [
        ("points", Input::Text("-0.2,0 0.2,0")),
        ("height", Input::Number(0.06)),
    ];
    let id = scene.objects().last().map_or(0, |object| object.id);
    for (change, [x, y], beside) in [
        (&rings[..], [0.1, 0.6], [0.0, 0.75]),
        (&[("angle", Input::Number(90.0))], [0.0, 0.75], [0.1, 0.6]),
        (
            &[("points", Input::Text("0,-0.2 0,0.2"))],
            [0.1, 0.6],
            [0.0, 0.75],
        ),
        (&[("y", Input::Number(0.75))], [0.1, 0.75], [0.1, 0.6]),
    ] {
        scene
            .change(id, change)
            .map_err(|errors| format!("{errors:?}"))?;
        renderer.upload_solids(
            &canvas.gl,
            &scene,
            &scene.poses(0.0),
            &[],
            &Charred::default(),
        );
        let pixels = canvas.paint_with(&mut renderer, &[], &scene)?;
        assert_eq!(pixels.at(x, y)[3], 255, "{change:?}");
        assert_eq!(pixels.at(beside[0], beside[1])[3], 0, "{change:?}");
    }
    renderer.destroy(&canvas.gl);
    Ok(())
}

#[wasm_bindgen_test]
fn a_solid_before_the_fire_hides_it() -> Result<(), JsValue> {
    let canvas = Canvas::new(WIDTH, HEIGHT)?;
    let gas = puff((0.0, 0.6), 1900.0);
    let at = |plane: &str| -> Result<[u8; 4], JsValue> {
        let fields = [&circle(0.0, 0.6)[..], &[("plane", Input::Text(plane))]].concat();
        Ok(painted(&canvas, &with_one(&fields)?, &gas)?.at(0.0, 0.6))
    };
    let (before, behind) = (at("before")?, at("behind")?);
    assert!(
        light(before) + 40 < light(behind) && before[3] == 255,
        "{before:?} and {behind:?}"
    );
    Ok(())
}
