//! Gas and embers are outside of solids, however these move.

use std::collections::BTreeMap;

use hearth_core::params::Input;
use hearth_core::random::Random;
use hearth_core::scene::Surface;
use hearth_core::{Scene, Simulation, Vec2};
use hearth_tests::sweep::crowd::{Crowd, MOST};

use super::{add, add_outline, burn, change, scene};

fn assert_outside(fire: &Simulation, case: u32) {
    for at in fire.positions() {
        assert!(at.is_finite(), "case {case}");
        for ((_, solid, surface), pose) in fire.scene().surfaces().zip(fire.poses()) {
            let surface = Surface {
                frame: pose.frame,
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

#[test]
fn no_gas_is_inside_of_moving_solids() {
    let shapes = ["box", "line", "box", "circle"];
    no_gas_is_inside(&mut |scene, number, random| {
        add(scene, shapes[number % 4], &random_solid(random))
    });
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn no_gas_is_inside_of_moving_outlines() {
    no_gas_is_inside(&mut |scene, number, random| {
        add_outline(scene, number, &random_solid(random))
    });
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
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
        let mut scene = scene(choices, &[("particles", 900.0)]);
        let mut ids = Vec::new();
        for number in 0..8 {
            ids.push(add(&mut scene, number, &mut random));
        }
        let mut fire = Simulation::new(scene);
        assert_outside(&fire, case);
        for step in 0..60 {
            let id = ids[random.bits() as usize % ids.len()];
            let solid = fire.scene().objects().find(|object| object.id == id);
            let Some(solid) = solid.and_then(|object| object.solid().cloned()) else {
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
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn no_gas_is_inside_of_as_many_moving_solids_as_a_scene_holds() {
    for (choices, seed) in [
        (&[][..], 1),
        (&[("edges", "open")], 2),
        (&[("model", "classic")], 3),
    ] {
        let scene = scene(choices, &[("particles", 900.0)]);
        let crowd = Crowd::of(scene, MOST, MOST, &mut Random::new(seed));
        assert_eq!(crowd.burn(0.3).fault(), None, "{choices:?}");
    }
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
    assert_eq!(restored.removed().map(|gas| gas.particles), Some(0));
}

#[test]
fn gas_that_a_solid_moves_onto_is_pushed_away_or_counted_as_removed() {
    let mut scene = scene(&[], &[("particles", 1500.0)]);
    let id = add(
        &mut scene,
        "circle",
        &[("x", 0.4), ("y", 0.4), ("width", 0.35)],
    );
    let mut fire = Simulation::new(scene);
    burn(&mut fire, 0.5);
    assert_eq!(fire.removed().map(|gas| gas.particles), Some(0));
    let state = |fire: &Simulation| -> BTreeMap<u64, (Vec2, f32)> {
        let all = fire.positions().into_iter().zip(fire.temperatures());
        fire.ids().into_iter().zip(all).collect()
    };
    let before = state(&fire);
    change(&mut fire, id, &[("x", 0.0)]);
    let after = state(&fire);
    let removed = fire.removed().unwrap_or_default();
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
fn embers_bounce_off_solids() {
    let numbers = [("ember_rate", 300.0), ("particles", 900.0)];
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
