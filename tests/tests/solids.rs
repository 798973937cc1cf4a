//! Laws of solids: gas flows around them and is never inside.

mod beside;
mod inside;

use hearth_core::params::Input;
use hearth_core::{Scene, Simulation};
use hearth_tests::fires::set_in_model;

type Numbers<'a> = &'a [(&'a str, f64)];

/// A scene in a closed domain of 3000 particles, with these choices and, if its model has them, numbers.
fn scene(choices: &[(&str, &'static str)], numbers: Numbers<'_>) -> Scene {
    let mut scene = Scene::default();
    for &(id, name) in [("edges", "periodic")].iter().chain(choices) {
        assert_eq!(scene.set(id, name), Ok(()));
    }
    for &(id, value) in [("particles", 3000.0)].iter().chain(numbers) {
        set_in_model(&mut scene, id, value);
    }
    scene
}

/// Adds a solid and returns its id.
fn add(scene: &mut Scene, shape: &str, numbers: Numbers<'_>) -> u32 {
    let mut fields = vec![
        ("kind", Input::Text("solid")),
        ("shape", Input::Text(shape)),
    ];
    fields.extend(numbers.iter().map(|&(name, x)| (name, Input::Number(x))));
    match scene.add(&fields) {
        Ok(id) => id,
        Err(refused) => panic!("{refused:?}"),
    }
}

fn change(fire: &mut Simulation, id: u32, numbers: Numbers<'_>) {
    let mut scene = fire.scene().clone();
    let fields = numbers.iter().map(|&(name, x)| (name, Input::Number(x)));
    assert_eq!(scene.change(id, &fields.collect::<Vec<_>>()), Ok(()));
    fire.set_scene(scene);
}

/// Air at rest without a fire.
const CALM: Numbers<'_> = &[
    ("fuel_power", 0.0),
    ("buoyancy", 0.0),
    ("ember_rate", 0.0),
    ("particles", 1500.0),
];

fn burn(fire: &mut Simulation, seconds: f64) -> f64 {
    let (start, mut heat) = (fire.time(), 0.0);
    while fire.time() < start + seconds {
        fire.step();
        heat += f64::from(fire.power().unwrap_or_default()) * fire.step_length();
    }
    heat / (fire.time() - start)
}

/// A ring with a gap, a star, and a bent line.
const OUTLINES: [(&str, &str, &str); 4] = [
    (
        "polygon",
        "points",
        "0,0.2 -0.12,-0.16 0.19,0.06 -0.19,0.06 0.12,-0.16",
    ),
    (
        "stroke",
        "points",
        "0.1,0.15 -0.15,0.15 -0.15,-0.15 0.15,-0.15 0.15,0.05 0.02,0",
    ),
    ("mask", "mask", "8x8:XsQsQoQoQoQoQsVPX"),
    (
        "polygon",
        "points",
        "-0.2,-0.05 0.2,-0.1 0.2,0.1 0.1,0 0,0.12",
    ),
];

/// Adds a solid with an outline and returns its id.
fn add_outline(scene: &mut Scene, number: usize, numbers: Numbers<'_>) -> u32 {
    let (shape, property, text) = OUTLINES[number % OUTLINES.len()];
    let id = add(scene, shape, numbers);
    assert_eq!(scene.change(id, &[(property, Input::Text(text))]), Ok(()));
    id
}

#[test]
fn the_same_scene_with_solids_gives_the_same_bits() {
    for choices in [&[][..], &[("edges", "open")], &[("model", "classic")]] {
        let bits = || {
            let mut scene = scene(choices, &[("particles", 900.0)]);
            let id = add(&mut scene, "line", &[("y", 0.6), ("angle", 30.0)]);
            let mut fire = Simulation::new(scene);
            burn(&mut fire, 0.2);
            change(&mut fire, id, &[("y", 0.65)]);
            burn(&mut fire, 0.2);
            let all = fire.positions().into_iter();
            all.flat_map(|at| at.to_array().map(f32::to_bits))
                .collect::<Vec<_>>()
        };
        assert_eq!(bits(), bits(), "{choices:?}");
    }
}
