//! Laws of solids that forces move: they fall, stack, slide, float and burn as rigid bodies do, and
//! the gas and they exchange momentum.

mod breaking;
mod burning;
mod gas;
mod hanging;
mod saved;

use hearth_core::params::Input;
use hearth_core::{FreeSolid, Scene, Simulation, Vec2};
use hearth_tests::fires::{burn_on, combustion, in_the_open, on_floor, watch, with_numbers};
use hearth_tests::sweep::crowd::gas_inside;

const GRAVITY: f32 = 9.81;

/// Coarse open air without a source, on a floor.
fn floor(values: &[(&str, f64)]) -> Scene {
    let unlit = [("fuel_power", 0.0), ("ember_rate", 0.0)];
    let mut scene = on_floor(in_the_open(combustion(&[&unlit, values].concat()), 1500));
    assert_eq!(scene.set("spacing", 0.06), Ok(()));
    scene
}

/// Adds a solid of that shape and motion.
fn add(scene: &mut Scene, shape: &str, motion: &str, numbers: &[(&str, f64)]) -> u32 {
    let mut fields = vec![
        ("kind", Input::Text("solid")),
        ("shape", Input::Text(shape)),
        ("motion", Input::Text(motion)),
    ];
    fields.extend(numbers.iter().map(|&(name, x)| (name, Input::Number(x))));
    match scene.add(&fields) {
        Ok(id) => id,
        Err(refused) => panic!("{refused:?}"),
    }
}

fn free(fire: &Simulation, id: u32) -> FreeSolid {
    let found = fire.free_solids().into_iter().find(|body| body.id == id);
    match found {
        Some(found) => found,
        None => panic!("no free solid {id}"),
    }
}

/// A scene of the classic model without any particle: bodies alone, quick.
fn alone() -> Scene {
    let mut scene = with_numbers(&[("time_step", 0.002)]);
    assert_eq!(scene.set("walls", "solid"), Ok(()));
    scene.clear();
    scene
}

#[test]
fn five_boxes_stand_for_a_minute() {
    for mut scene in [alone(), floor(&[])] {
        let box_of = [("width", 0.1), ("height", 0.1), ("x", 0.0)];
        let ids: Vec<u32> = (0..5)
            .map(|number| {
                let y = ("y", 0.05 + 0.1 * f64::from(number));
                add(&mut scene, "box", "free", &[&box_of[..], &[y]].concat())
            })
            .collect();
        let mut fire = Simulation::new(scene);
        let start = fire.free_solids();
        watch(&mut fire, 60.0, |fire| {
            for (then, now) in start.iter().zip(fire.free_solids()) {
                let path = then.place.distance(now.place);
                assert!(
                    path < 1e-3,
                    "{} moved {path} m at {} s",
                    then.id,
                    fire.time()
                );
            }
        });
        assert!(ids.into_iter().all(|id| free(&fire, id).asleep));
    }
}

#[test]
fn a_light_body_under_a_heavy_one_stays_on_the_floor() {
    for mut scene in [alone(), floor(&[])] {
        let sized = |y, width, height, density| {
            let place = [("y", y), ("width", width), ("height", height)];
            [&place[..], &[("density", density)]].concat()
        };
        let light = add(&mut scene, "box", "free", &sized(0.025, 0.1, 0.05, 2.0));
        add(&mut scene, "box", "free", &sized(0.26, 0.6, 0.4, 8000.0));
        let mut fire = Simulation::new(scene);
        watch(&mut fire, 3.0, |fire| {
            // It may be 2 cm in the floor, and lie on any side.
            let depth = 0.025 - free(fire, light).place.y;
            assert!(depth < 0.021, "{depth} m at {} s", fire.time());
        });
    }
}

/// How far a box slides in a second on a line at that angle, with that friction.
fn slid(degrees: f64, friction: f64) -> f32 {
    let mut scene = alone();
    let slope = [
        ("width", 3.0),
        ("height", 0.1),
        ("y", 0.5),
        ("angle", degrees),
    ];
    add(&mut scene, "line", "still", &slope);
    let up = Vec2::from_angle(degrees.to_radians() as f32).perp() * 0.1;
    let place = [
        ("x", f64::from(up.x)),
        ("y", f64::from(0.5 + up.y)),
        ("angle", degrees),
        ("width", 0.16),
        ("height", 0.1),
        ("friction", friction),
    ];
    let id = add(&mut scene, "box", "free", &place);
    let mut fire = Simulation::new(scene);
    let before = free(&fire, id).place;
    burn_on(&mut fire, 1.0);
    free(&fire, id).place.distance(before)
}

#[test]
fn a_box_holds_and_slides_at_its_friction_angle() {
    for friction in [0.2, 0.5, 0.8] {
        let angle = f64::atan(friction).to_degrees();
        let (held, moved) = (slid(angle - 2.0, friction), slid(angle + 2.0, friction));
        assert!(held < 1e-3, "{friction}: it slid {held} m");
        // ½ g (sin α − μ cos α) t², with 10 % for the start.
        let (sine, cosine) = (angle + 2.0).to_radians().sin_cos();
        let path = 0.5 * GRAVITY * (sine - friction * cosine) as f32;
        assert!(
            (moved / path - 1.0).abs() < 0.1,
            "{friction}: {moved} m, not {path} m"
        );
    }
}

#[test]
fn a_body_falls_by_gravity_and_bounces_by_its_restitution() {
    for restitution in [0.0, 0.5, 0.9] {
        let mut scene = alone();
        let ball = [
            ("width", 0.1),
            ("y", 0.35),
            ("density", 10_000.0),
            ("restitution", restitution),
        ];
        let id = add(&mut scene, "circle", "free", &ball);
        let mut fire = Simulation::new(scene);
        burn_on(&mut fire, 0.2);
        let fallen = 0.35 - free(&fire, id).place.y;
        // Half of g t², within the path of a step.
        assert!((fallen - 0.5 * GRAVITY * 0.04).abs() < 4e-3, "{fallen}");
        let mut highest = 0.0_f32;
        burn_on(&mut fire, 0.07);
        watch(&mut fire, 0.4, |fire| {
            highest = highest.max(free(fire, id).place.y)
        });
        let height = 0.05 + 0.3 * (restitution * restitution) as f32;
        assert!(
            (highest - height).abs() < 0.015,
            "{restitution}: {highest}, not {height}"
        );
    }
}

#[test]
fn none_tunnels_at_three_metres_a_second() {
    for shape in ["circle", "box", "line", "polygon", "mask"] {
        for angle in [0.0, 20.0, 90.0] {
            let mut scene = alone();
            // The thinnest wall, 1 m below: it is reached at the largest speed.
            add(
                &mut scene,
                "line",
                "still",
                &[("width", 2.0), ("height", 0.002), ("y", 0.2)],
            );
            let place = [
                ("y", 1.3),
                ("width", 0.03),
                ("height", 0.004),
                ("angle", angle),
            ];
            let id = add(&mut scene, shape, "free", &place);
            let outline = match shape {
                "mask" => ("mask", Input::Text("8x4:3PSqSo")),
                _ => ("points", Input::Text("0,0.02 -0.02,-0.01 0.02,-0.01")),
            };
            assert_eq!(scene.change(id, &[outline]), Ok(()));
            let mut fire = Simulation::new(scene);
            let mut fastest = 0.0_f32;
            watch(&mut fire, 2.0, |fire| {
                let now = free(fire, id);
                fastest = fastest.max(now.velocity.length());
                assert!(now.place.y > 0.2, "{shape} at {angle}°: {now:?}");
            });
            assert!(fastest > 2.9, "{fastest}");
        }
    }
}

#[test]
fn bindings_read_each_free_body() {
    let mut scene = alone();
    let square = |x: f64| [("x", x), ("y", 0.5), ("angle", 30.0)];
    add(&mut scene, "box", "still", &square(-0.3));
    for x in [0.0, 0.3] {
        add(&mut scene, "box", "free", &square(x));
    }
    let mut fire = Simulation::new(scene);
    burn_on(&mut fire, 0.1);
    let (solids, numbers) = (fire.free_solids(), fire.free_solid_numbers());
    assert_eq!((solids.len(), numbers.len()), (2, 22));
    for (body, read) in solids.iter().zip(numbers.chunks(11)) {
        let (sine, cosine) = body.angle.to_radians().sin_cos();
        assert_eq!(read[..3], [body.id as f32, body.place.x, body.place.y]);
        assert!((read[3] - cosine).abs() < 1e-5 && (read[4] - sine).abs() < 1e-5);
        assert_eq!(
            read[5..9],
            [body.velocity.x, body.velocity.y, body.spin, body.mass]
        );
        assert_eq!(read[9..], [0.0, body.object as f32]);
    }
}

#[test]
fn the_scene_keeps_the_start_and_a_changed_place_puts_a_body_there() {
    for mut scene in [alone(), floor(&[])] {
        let ball = [("x", 0.1), ("y", 0.5), ("width", 0.1)];
        let id = add(&mut scene, "circle", "free", &ball);
        let mut fire = Simulation::new(scene.clone());
        burn_on(&mut fire, 0.2);
        let fallen = free(&fire, id);
        assert!(fallen.place.y < 0.4);
        // The scene is as it was set; the pose is where the body is.
        assert_eq!(fire.scene(), &scene);
        let pose = fire.poses().pop().unwrap();
        assert_eq!((pose.id, pose.frame.centre), (id, fallen.place));
        // Another property keeps the motion.
        assert_eq!(
            scene.change(id, &[("friction", Input::Number(0.9))]),
            Ok(())
        );
        fire.set_scene(scene.clone());
        assert_eq!(free(&fire, id), fallen);
        assert_eq!(scene.change(id, &[("x", Input::Number(-0.2))]), Ok(()));
        fire.set_scene(scene.clone());
        let put = free(&fire, id);
        assert_eq!(
            (put.place, put.velocity),
            (Vec2::new(-0.2, 0.5), Vec2::ZERO)
        );
        burn_on(&mut fire, 0.1);
        fire.reset();
        assert_eq!(free(&fire, id), put);
        assert_eq!(gas_inside(&fire), None);
    }
}
