//! Laws of solids: gas flows around them and is never inside.
#![cfg(not(target_arch = "wasm32"))]

use std::collections::BTreeMap;

use hearth_core::params::Input;
use hearth_core::random::Random;
use hearth_core::scene::Surface;
use hearth_core::{Particle, Scene, Simulation, Vec2};
use hearth_tests::sweep::crowd::{Crowd, MOST};

type Numbers<'a> = &'a [(&'a str, f64)];

/// A scene in a closed domain of 3000 particles, with these choices and numbers of the settings.
fn scene(choices: &[(&str, &'static str)], numbers: Numbers<'_>) -> Scene {
    let mut settings = Scene::default().settings().clone();
    for &(id, name) in [("edges", "periodic")].iter().chain(choices) {
        assert_eq!(settings.set(id, Input::Text(name)), Ok(()));
    }
    for &(id, value) in [("max_particles", 3000.0)].iter().chain(numbers) {
        assert_eq!(settings.set(id, Input::Number(value)), Ok(()));
    }
    Scene::new(settings)
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
    ("max_particles", 1500.0),
];

fn burn(fire: &mut Simulation, seconds: f64) -> f64 {
    let (start, mut heat) = (fire.time(), 0.0);
    while fire.time() < start + seconds {
        fire.step();
        heat += f64::from(fire.power()) * fire.step_length();
    }
    heat / (fire.time() - start)
}

fn assert_outside(fire: &Simulation, case: u32) {
    for at in fire.positions() {
        assert!(at.is_finite(), "case {case}");
        for (_, solid, surface) in fire.scene().surfaces() {
            let surface = Surface {
                frame: solid.frame_at(surface, fire.time()),
                field: surface.field.clone(),
            };
            let (distance, _) = surface.distance(at);
            assert!(
                distance > 0.0,
                "case {case}: {distance} m at {at}: {solid:?}"
            );
        }
    }
}

fn restlessness(fire: &Simulation) -> f32 {
    let velocities = fire.velocities();
    let sum: f32 = velocities.iter().map(|v| v.length_squared()).sum();
    (sum / velocities.len() as f32).sqrt()
}

/// The properties of a random solid that may cross the edges of the domain.
fn random_solid(random: &mut Random) -> Vec<(&'static str, f64)> {
    let mut between = |low: f32, high: f32| f64::from(random.between(low, high));
    vec![
        ("x", between(-0.7, 0.7)),
        ("y", between(-0.1, 1.6)),
        ("angle", between(-180.0, 180.0)),
        ("width", between(0.01, 0.4)),
        ("height", between(0.005, 0.15)),
        ("corner", between(0.0, 0.05)),
    ]
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
fn no_gas_is_inside_of_moving_solids() {
    let shapes = ["box", "line", "box", "circle"];
    no_gas_is_inside(&mut |scene, number, random| {
        add(scene, shapes[number % 4], &random_solid(random))
    });
}

#[test]
fn no_gas_is_inside_of_moving_outlines() {
    no_gas_is_inside(&mut |scene, number, random| {
        add_outline(scene, number, &random_solid(random))
    });
}

#[test]
fn no_gas_is_inside_of_solids_that_move_by_themselves() {
    no_gas_is_inside(&mut |scene, number, random| {
        let id = if number % 2 == 0 {
            add_outline(scene, number, &random_solid(random))
        } else {
            add(
                scene,
                ["box", "line"][number / 2 % 2],
                &random_solid(random),
            )
        };
        let motion = ["sway", "spin", "sway"][number % 3];
        let mut between = |low: f32, high: f32| f64::from(random.between(low, high));
        let numbers = [
            ("sway", between(0.0, 1.0)),
            ("heading", between(-180.0, 180.0)),
            ("period", between(0.5, 4.0)),
            ("spin", between(-720.0, 720.0)),
        ];
        let mut fields = vec![("motion", Input::Text(motion))];
        fields.extend(numbers.map(|(name, x)| (name, Input::Number(x))));
        assert_eq!(scene.change(id, &fields), Ok(()));
        id
    });
}

#[test]
fn a_solid_that_moves_by_itself_is_at_the_same_place_in_a_restored_fire() {
    let mut scene = scene(&[("edges", "open")], &[]);
    let id = add(&mut scene, "box", &[("y", 0.8), ("period", 1.0)]);
    let fields = [("motion", Input::Text("sway"))];
    assert_eq!(scene.change(id, &fields), Ok(()));
    let mut fire = Simulation::new(scene.clone());
    burn(&mut fire, 0.3);
    let saved = fire.burning().unwrap_or_default();
    let mut restored = Simulation::new(scene);
    assert!(restored.restore_burning(&saved).is_ok());
    assert_outside(&restored, 0);
    // At the place of the start there is gas now.
    assert_eq!(restored.positions().len(), fire.positions().len());
    for _ in 0..20 {
        restored.step();
        assert_outside(&restored, 0);
    }
    assert_eq!(restored.removed().particles, 0);
}

fn no_gas_is_inside(add: &mut dyn FnMut(&mut Scene, usize, &mut Random) -> u32) {
    for case in 0..24 {
        let mut random = Random::new(case);
        let choices: &[&[(&str, &str)]] = &[
            &[],
            &[("edges", "open"), ("floor", "solid")],
            &[("edges", "open")],
            &[("model", "classic"), ("walls", "solid")],
        ];
        let choices = choices[case as usize % 4];
        let mut scene = scene(choices, &[("max_particles", 900.0)]);
        let mut ids = Vec::new();
        for number in 0..8 {
            ids.push(add(&mut scene, number, &mut random));
        }
        let mut fire = Simulation::new(scene);
        assert_outside(&fire, case);
        for step in 0..60 {
            let id = ids[random.bits() as usize % ids.len()];
            let solid = fire.scene().objects().find(|one| one.id == id);
            let Some(solid) = solid.and_then(|one| one.solid().cloned()) else {
                panic!("case {case}: solid {id} is gone");
            };
            let near = |x: f32, random: &mut Random| f64::from(x + random.between(-0.02, 0.02));
            match step % 4 {
                0 => change(&mut fire, id, &random_solid(&mut random)),
                1 => {
                    let (x, y) = (near(solid.x, &mut random), near(solid.y, &mut random));
                    change(&mut fire, id, &[("x", x), ("y", y)]);
                }
                2 => change(
                    &mut fire,
                    id,
                    &[("angle", near(solid.angle, &mut random) * 0.9)],
                ),
                _ => {}
            }
            assert_outside(&fire, case);
            fire.step();
            assert_outside(&fire, case);
        }
    }
}

#[test]
fn no_gas_is_inside_of_as_many_moving_solids_as_a_scene_holds() {
    for (choices, seed) in [
        (&[][..], 1),
        (&[("edges", "open")], 2),
        (&[("model", "classic")], 3),
    ] {
        let scene = scene(choices, &[("max_particles", 900.0)]);
        let settings = scene.settings().clone();
        let crowd = Crowd::of(settings, MOST, MOST, &mut Random::new(seed));
        assert_eq!(crowd.burn(0.3).fault(), None, "{choices:?}");
    }
}

#[test]
fn gas_that_a_solid_moves_onto_is_pushed_away_or_counted_as_removed() {
    let mut scene = scene(&[], &[("max_particles", 1500.0)]);
    let id = add(
        &mut scene,
        "circle",
        &[("x", 0.4), ("y", 0.4), ("width", 0.35)],
    );
    let mut fire = Simulation::new(scene);
    burn(&mut fire, 0.5);
    assert_eq!(fire.removed().particles, 0);
    let state = |fire: &Simulation| -> BTreeMap<u64, (Vec2, f32)> {
        let all = fire.positions().into_iter().zip(fire.temperatures());
        fire.ids().into_iter().zip(all).collect()
    };
    let before = state(&fire);
    change(&mut fire, id, &[("x", 0.0)]);
    let after = state(&fire);
    let removed = fire.removed();
    assert_eq!(removed.particles as usize, before.len() - after.len());
    assert!(removed.particles > 5);
    let mass = f64::from(fire.parameters().ambient_density) * 1.2 * 1.8 / 1500.0;
    let share = removed.mass / (removed.particles as f64 * mass);
    assert!((share - 1.0).abs() < 0.05, "{share}");
    // It is in the flame.
    assert!(removed.heat > 200.0 * removed.mass, "{removed:?}");
    let spacing = fire.parameters().spacing();
    for (id, (place, temperature)) in &after {
        let (from, before) = before[id];
        assert_eq!(*temperature, before);
        assert!(place.distance(from) < 1.2 * spacing);
    }
}

#[test]
fn still_air_beside_solids_stays_still() {
    let wide: Numbers<'_> = &[("source_width", 1.0), ("max_particles", 3000.0)];
    for (choices, numbers) in [
        (&[][..], &[][..]),
        (&[("edges", "open"), ("floor", "solid")][..], wide),
    ] {
        let mut scene = scene(choices, &[CALM, numbers].concat());
        if numbers.is_empty() {
            let size = [("width", 0.3), ("height", 0.2), ("angle", 20.0)];
            add(
                &mut scene,
                "box",
                &[&[("x", 0.3), ("y", 1.2)], &size[..]].concat(),
            );
            add(
                &mut scene,
                "line",
                &[("x", -0.2), ("height", 0.01), ("angle", 70.0)],
            );
        } else {
            // Within the band of air around the source.
            let size = [("width", 0.1), ("height", 0.06), ("corner", 0.03)];
            add(&mut scene, "box", &[&[("y", 0.25)], &size[..]].concat());
        }
        let mut fire = Simulation::new(scene);
        burn(&mut fire, 4.0);
        let rms = restlessness(&fire);
        assert!(rms <= 0.01, "{choices:?}: {rms} m/s");
    }
}

#[test]
fn a_source_keeps_its_power_beside_solids() {
    for choices in [&[][..], &[("edges", "open"), ("floor", "solid")]] {
        let mut scene = scene(choices, &[("max_particles", 1500.0)]);
        let power = |scene: &Scene| {
            let mut fire = Simulation::new(scene.clone());
            burn(&mut fire, 1.5);
            // Eddies of a second change the power by a tenth.
            burn(&mut fire, 5.0)
        };
        let bare = power(&scene);
        for x in [-0.22, 0.22] {
            add(
                &mut scene,
                "circle",
                &[("x", x), ("y", 0.35), ("width", 0.1)],
            );
        }
        let beside = power(&scene);
        assert!(
            (beside / bare - 1.0).abs() < 0.05,
            "{beside} for {bare} kW/m"
        );
    }
}

#[test]
fn gas_on_one_side_of_a_thin_plate_does_not_feel_the_other_side() {
    let mut scene = scene(
        &[],
        &[CALM, &[("seam", 0.0), ("kinematic_viscosity", 0.01)]].concat(),
    );
    for y in [0.45, 1.35] {
        add(
            &mut scene,
            "line",
            &[("y", y), ("width", 2.0), ("height", 0.01)],
        );
    }
    let mut fire = Simulation::new(scene);
    burn(&mut fire, 1.0);
    let middle = |at: Vec2| (0.45..1.35).contains(&at.y);
    let particles: Vec<Particle> = fire.particles();
    let moving = particles.iter().map(|one| {
        let speed = if middle(one.position) { 1.0 } else { 0.0 };
        Particle {
            velocity: Vec2::new(speed, 0.0),
            ..*one
        }
    });
    assert_eq!(fire.set_particles(&moving.collect::<Vec<_>>()), Ok(()));
    burn(&mut fire, 0.2);
    let mean = |inside: bool| {
        let all = fire.positions().into_iter().zip(fire.velocities());
        let these: Vec<f32> = all
            .filter(|one| middle(one.0) == inside)
            .map(|one| one.1.x)
            .collect();
        these.iter().sum::<f32>() / these.len() as f32
    };
    assert!(mean(true) > 0.6, "{}", mean(true));
    assert!(mean(false).abs() < 0.01, "{}", mean(false));
}

#[test]
fn a_surface_of_fixed_temperature_heats_the_gas_and_an_adiabatic_one_does_not() {
    for (thermal, heated) in [("fixed", true), ("adiabatic", false)] {
        let mut scene = scene(&[], CALM);
        let id = add(&mut scene, "circle", &[("y", 0.9), ("temperature", 1200.0)]);
        let fields = [("thermal", Input::Text(thermal))];
        assert_eq!(scene.change(id, &fields), Ok(()));
        let mut fire = Simulation::new(scene);
        burn(&mut fire, 1.0);
        let hottest = fire.temperatures().into_iter().fold(0.0, f32::max);
        assert!((hottest > 320.0) == heated, "{thermal}: {hottest} K");
        assert!(hottest <= 1200.0);
    }
}

#[test]
fn a_moving_solid_pushes_the_gas() {
    let mut scene = scene(&[], CALM);
    let id = add(&mut scene, "circle", &[("x", -0.3), ("y", 0.9)]);
    let mut fire = Simulation::new(scene);
    burn(&mut fire, 0.5);
    let mut x = -0.3;
    for _ in 0..30 {
        burn(&mut fire, 1.0 / 60.0);
        x += 0.5 / 60.0;
        change(&mut fire, id, &[("x", x)]);
    }
    burn(&mut fire, 0.01);
    let all = fire.positions().into_iter().zip(fire.velocities());
    let ahead = |at: Vec2| (at - Vec2::new(x as f32 + 0.13, 0.9)).length() < 0.04;
    let pushed: Vec<f32> = all.filter(|one| ahead(one.0)).map(|one| one.1.x).collect();
    let mean = pushed.iter().sum::<f32>() / pushed.len() as f32;
    assert!((0.2..0.7).contains(&mean), "{mean} m/s of {}", pushed.len());
    assert_eq!(fire.removed().particles, 0);
}

#[test]
fn embers_bounce_off_solids() {
    let numbers = [("ember_rate", 300.0), ("max_particles", 900.0)];
    let mut scene = scene(&[], &numbers);
    add(
        &mut scene,
        "box",
        &[("y", 0.7), ("width", 0.6), ("height", 0.2)],
    );
    let mut fire = Simulation::new(scene);
    for _ in 0..400 {
        fire.step();
        for ember in fire.embers() {
            for (_, _, surface) in fire.scene().surfaces() {
                let (distance, _) = surface.distance(ember.position);
                assert!(distance > -1e-5, "{distance} m at {}", ember.position);
            }
        }
    }
    assert!(fire.embers().len() > 20);
}

#[test]
fn the_same_scene_with_solids_gives_the_same_bits() {
    for choices in [&[][..], &[("edges", "open")], &[("model", "classic")]] {
        let bits = || {
            let mut scene = scene(choices, &[("max_particles", 900.0)]);
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

#[test]
fn a_source_keeps_its_power_beside_outlines() {
    for choices in [&[][..], &[("edges", "open"), ("floor", "solid")]] {
        let mut scene = scene(choices, &[("max_particles", 1500.0)]);
        let power = |scene: &Scene| {
            let mut fire = Simulation::new(scene.clone());
            burn(&mut fire, 1.5);
            burn(&mut fire, 2.5)
        };
        let bare = power(&scene);
        add_outline(&mut scene, 0, &[("x", -0.4), ("y", 0.35)]);
        add_outline(&mut scene, 1, &[("x", 0.4), ("y", 0.35), ("height", 0.02)]);
        let beside = power(&scene);
        assert!(
            (beside / bare - 1.0).abs() < 0.05,
            "{beside} for {bare} kW/m"
        );
    }
}

#[test]
fn gas_in_a_closed_ring_does_not_feel_the_gas_around_it() {
    let mut scene = scene(&[], &[CALM, &[("max_particles", 3000.0)]].concat());
    let id = add(&mut scene, "stroke", &[("y", 0.9), ("height", 0.01)]);
    let ring = "-0.3,-0.3 0.3,-0.3 0.3,0.3 -0.3,0.3 -0.3,-0.3";
    assert_eq!(scene.change(id, &[("points", Input::Text(ring))]), Ok(()));
    let mut fire = Simulation::new(scene);
    burn(&mut fire, 0.5);
    let inside = |at: Vec2| at.x.abs() < 0.3 && (at.y - 0.9).abs() < 0.3;
    let moving = fire.particles().into_iter().map(|one| Particle {
        velocity: if inside(one.position) {
            Vec2::ZERO
        } else {
            Vec2::new(0.5, 0.0)
        },
        temperature: if inside(one.position) {
            800.0
        } else {
            one.temperature
        },
        ..one
    });
    assert_eq!(fire.set_particles(&moving.collect::<Vec<_>>()), Ok(()));
    burn(&mut fire, 0.3);
    let all = fire.positions().into_iter().zip(fire.temperatures());
    let hottest = all
        .filter(|one| !inside(one.0))
        .map(|one| one.1)
        .fold(0.0, f32::max);
    assert!(hottest < 320.0, "{hottest} K outside");
}
