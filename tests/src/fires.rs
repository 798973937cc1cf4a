//! Fires to test with.

use hearth_core::params::{Input, Model, ParamErrorKind};
use hearth_core::random::Random;
use hearth_core::scene::SceneSource;
use hearth_core::{Particle, Scene, Simulation, Vec2};

/// The classic model's defaults with these values changed.
///
/// # Panics
/// If a value is invalid, because the test is wrong.
pub fn with<'a>(values: impl IntoIterator<Item = (&'a str, Input<'a>)>) -> Scene {
    changed(Model::Classic, values)
}

/// The classic model's defaults with these numbers changed.
///
/// # Panics
/// As [`with`].
pub fn with_numbers(values: &[(&str, f64)]) -> Scene {
    with(numbers(values))
}

/// The combustion model's defaults in a closed domain with 1000 particles,
/// which is quick, and with these numbers changed.
///
/// # Panics
/// As [`with`].
pub fn combustion(values: &[(&str, f64)]) -> Scene {
    let closed = [
        ("edges", Input::Text("periodic")),
        ("particles", Input::Number(1000.0)),
    ];
    changed(Model::Combustion, closed.into_iter().chain(numbers(values)))
}

/// A combustion fire that uses all that its model has.
pub fn everything() -> Scene {
    combustion(&[
        ("gas_expansion", 1.0),
        ("kinematic_viscosity", 1e-3),
        ("turbulence", 3.0),
        ("vorticity_confinement", 0.3),
        ("wind", 0.5),
        ("emission_noise", 1.0),
        ("source_oxygen", 0.2),
        ("ember_rate", 500.0),
        ("ember_life_max", 0.8),
    ])
}

/// The same fire in the open, with at most `max_particles`: coarse, which is quick.
///
/// # Panics
/// As [`with`].
pub fn in_the_open(scene: impl Into<Scene>, max_particles: u32) -> Scene {
    let mut scene = scene.into();
    for (id, value) in [
        ("edges", Input::Text("open")),
        ("spacing", Input::Number(0.04)),
        ("max_particles", Input::Number(max_particles.into())),
    ] {
        if let Err(refusal) = scene.set(id, value) {
            panic!("{refusal}");
        }
    }
    scene
}

/// The same on a solid floor.
///
/// # Panics
/// As [`with`].
pub fn on_floor(scene: impl Into<Scene>) -> Scene {
    let mut scene = scene.into();
    if let Err(refusal) = scene.set("floor", Input::Text("solid")) {
        panic!("{refusal}");
    }
    scene
}

fn numbers<'a>(values: &'a [(&'a str, f64)]) -> impl Iterator<Item = (&'a str, Input<'a>)> {
    values.iter().map(|&(id, value)| (id, Input::Number(value)))
}

fn changed<'a>(model: Model, values: impl IntoIterator<Item = (&'a str, Input<'a>)>) -> Scene {
    let mut scene = Scene::of_model(model);
    for (id, value) in values {
        if let Err(refusal) = scene.set(id, value) {
            panic!("{refusal}");
        }
    }
    scene
}

/// The first source of a scene.
///
/// # Panics
/// If there is none, because the test is wrong.
pub fn source(scene: &Scene) -> SceneSource<'_> {
    match scene.first_source() {
        Some(source) => source,
        None => panic!("there is no source"),
    }
}

/// Sets a value of a scene, unless its model has no such parameter.
///
/// # Panics
/// As [`with`].
pub fn set_in_model<'a>(scene: &mut Scene, id: &str, input: impl Into<Input<'a>>) {
    match scene.set(id, input) {
        Ok(()) => {}
        Err(refusal) if matches!(refusal.kind, ParamErrorKind::OfModel(_)) => {}
        Err(refusal) => panic!("{refusal}"),
    }
}

/// A scene without its objects but the first source.
pub fn with_first_source(mut scene: Scene) -> Scene {
    let first = scene.first_source_id();
    let others: Vec<u32> = scene.ids().filter(|id| Some(*id) != first).collect();
    for id in others {
        let removed = scene.remove(id);
        debug_assert_eq!(removed, Ok(()));
    }
    scene
}

/// A scene with a polygon, a stroke and a mask around its source.
///
/// # Panics
/// If one of them is invalid, because the test is wrong.
pub fn beside_outlines(mut scene: Scene) -> Scene {
    for (shape, x, property, text) in [
        (
            "polygon",
            -0.2,
            "points",
            "0,0.15 -0.09,-0.12 0.14,0.04 -0.14,0.04 0.09,-0.12",
        ),
        ("stroke", 0.2, "points", "-0.1,0.1 0.1,0 -0.05,-0.1"),
        ("mask", 0.0, "mask", "8x4:3PSqSo"),
    ] {
        let added = scene.add(&[
            ("kind", Input::Text("solid")),
            ("shape", Input::Text(shape)),
            ("x", Input::Number(x)),
            ("y", Input::Number(0.4)),
            ("angle", Input::Number(15.0)),
            ("height", Input::Number(0.05)),
            (property, Input::Text(text)),
        ]);
        assert!(added.is_ok(), "{added:?}");
    }
    scene
}

/// A fire that has burned for so many simulated seconds.
pub fn burn(scene: impl Into<Scene>, seconds: f64) -> Simulation {
    let mut fire = Simulation::new(scene);
    burn_on(&mut fire, seconds);
    fire
}

/// Burns on for so many simulated seconds.
pub fn burn_on(fire: &mut Simulation, seconds: f64) {
    watch(fire, seconds, |_| ());
}

/// Simulates for a time and calls `after_step` after every step.
pub fn watch(fire: &mut Simulation, seconds: f64, mut after_step: impl FnMut(&Simulation)) {
    // Half a step early is not early: the time is a sum of rounded steps.
    let until = fire.time() + seconds;
    while fire.time() + 0.5 * fire.step_length() < until {
        fire.step();
        after_step(fire);
    }
}

/// A closed box, 0.8 m wide and high, of combustion gas that no burner heats:
/// nothing acts on it but itself, and what `values` switch on.
pub fn closed_box(values: &[(&str, f64)]) -> Scene {
    let closed = [
        ("domain_width", 0.8),
        ("domain_height", 0.8),
        ("seam", 0.0),
        ("gravity", 0.0),
        ("fuel_power", 0.0),
        ("radiative_cooling", 0.0),
    ];
    combustion(&[&closed, values].concat())
}

/// A simulation of that many columns and rows of gas, evenly spread over the
/// domain apart from a little disorder, each particle given to `shape`.
///
/// # Panics
/// Where a particle is refused: the test that made it is wrong.
pub fn filled(scene: Scene, side: u32, shape: impl Fn(&mut Particle)) -> Simulation {
    let world = scene.world();
    let size = Vec2::new(world.domain_width, world.domain_height);
    let mut random = Random::new(11);
    let gas: Vec<Particle> = (0..side * side)
        .map(|i| {
            let cell = Vec2::new((i % side) as f32, (i / side) as f32);
            let off = Vec2::new(random.between(0.4, 0.6), random.between(0.4, 0.6));
            let place = (cell + off) / side as f32;
            let mut particle = Particle::at((place - Vec2::new(0.5, 0.0)) * size);
            shape(&mut particle);
            particle
        })
        .collect();
    let mut fire = Simulation::new(scene);
    if let Err(refusal) = fire.set_particles(&gas) {
        panic!("{refusal}");
    }
    fire
}

/// The mean of what there is, in double precision; no number where there is nothing.
pub fn mean(numbers: impl IntoIterator<Item = f32>) -> f64 {
    let (mut sum, mut n) = (0.0, 0.0);
    for number in numbers {
        sum += f64::from(number);
        n += 1.0;
    }
    sum / n
}
