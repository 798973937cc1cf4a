//! Solids that hang from others by hinges.

mod burning;

use std::f32::consts::PI;

use hearth_core::params::Input;
use hearth_core::{FreeSolid, Scene, Simulation, Vec2};
use hearth_tests::fires::{burn_on, closed_box, watch, with_numbers};

use super::{GRAVITY, add, alone, floor, free};

/// Length of a link \[m\].
const LINK: f64 = 0.05;

fn hang(scene: &mut Scene, id: u32, from: u32) {
    let hangs = [("hangs_from", Input::Number(from.into()))];
    assert_eq!(scene.change(id, &hangs), Ok(()));
}

/// A chain of links that begins at a place, each of them at that angle. The first hangs from a solid.
fn chain(scene: &mut Scene, from: u32, (x, y): (f64, f64), angle: f64, count: u32) -> Vec<u32> {
    let (sine, cosine) = angle.to_radians().sin_cos();
    let mut ids = Vec::new();
    for number in 0..count {
        let along = LINK * (f64::from(number) + 0.5);
        let link = [
            ("x", x - along * cosine),
            ("y", y - along * sine),
            ("angle", angle),
            ("width", LINK),
            ("height", 0.02),
        ];
        let id = add(scene, "line", "free", &link);
        hang(scene, id, ids.last().copied().unwrap_or(from));
        ids.push(id);
    }
    ids
}

/// The upper and the lower end of a link of this length.
fn ends(link: &FreeSolid, length: f64) -> [Vec2; 2] {
    let path = Vec2::from_angle(link.angle.to_radians()) * (0.5 * length as f32);
    [link.place + path, link.place - path]
}

/// The greatest distance of two ends that are at one place.
fn stretch(links: &[FreeSolid], hook: Vec2) -> f32 {
    let mut end = hook;
    let mut most = 0.0_f32;
    for link in links {
        let [upper, lower] = ends(link, LINK);
        most = most.max(upper.distance(end));
        end = lower;
    }
    most
}

fn hook(scene: &mut Scene, x: f64, y: f64) -> u32 {
    add(
        scene,
        "circle",
        "still",
        &[("x", x), ("y", y), ("width", 0.03)],
    )
}

#[test]
fn a_chain_of_twenty_links_hangs_for_a_minute() {
    // Gas that is never quite at rest keeps one awake.
    for (mut scene, sleeps) in [(alone(), true), (floor(&[]), false)] {
        let nail = hook(&mut scene, 0.1, 1.4);
        let ids = chain(&mut scene, nail, (0.1, 1.4), 90.0, 20);
        let mut fire = Simulation::new(scene);
        watch(&mut fire, 60.0, |fire| {
            let most = stretch(&fire.free_solids(), Vec2::new(0.1, 1.4));
            assert!(most < 1e-3, "{most} m at {} s", fire.time());
        });
        assert!(!sleeps || ids.into_iter().all(|id| free(&fire, id).asleep));
        let end = fire.free_solids()[19].place;
        assert!((end.x - 0.1).abs() < 5e-3, "{end}");
    }
}

#[test]
fn a_chain_that_swings_does_not_stretch() {
    let mut scene = alone();
    let nail = hook(&mut scene, 0.0, 1.4);
    chain(&mut scene, nail, (0.0, 1.4), 60.0, 20);
    let mut fire = Simulation::new(scene);
    watch(&mut fire, 5.0, |fire| {
        let most = stretch(&fire.free_solids(), Vec2::new(0.0, 1.4));
        assert!(most < 1e-3, "{most} m at {} s", fire.time());
    });
}

#[test]
fn a_pendulum_has_the_period_of_its_formula_and_keeps_its_energy() {
    let (length, tilt) = (0.4, 10.0_f64);
    let mut scene = alone();
    let nail = hook(&mut scene, 0.0, 1.0);
    let (sine, cosine) = (90.0 - tilt).to_radians().sin_cos();
    let rod = [
        ("x", -0.5 * length * cosine),
        ("y", 1.0 - 0.5 * length * sine),
        ("angle", 90.0 - tilt),
        ("width", length),
        ("height", 0.04),
    ];
    let id = add(&mut scene, "line", "free", &rod);
    hang(&mut scene, id, nail);
    let mut fire = Simulation::new(scene);
    let rod = free(&fire, id);
    let arm = 0.5 * length as f32;
    let around = rod.inertia + rod.mass * arm * arm;
    // The first term of the series in the amplitude.
    let wide = (tilt.to_radians() as f32).powi(2) / 16.0;
    let expected = 2.0 * PI * (around / (rod.mass * GRAVITY * arm)).sqrt() * (1.0 + wide);
    let (mut before, mut crossings) = (-1.0_f32, Vec::new());
    let (mut last, mut widest) = (0.0_f32, 0.0_f32);
    watch(&mut fire, 12.0, |fire| {
        let now = free(fire, id).angle - 90.0;
        if before < 0.0 && now >= 0.0 {
            crossings.push(fire.time() as f32);
            (last, widest) = (widest, 0.0);
        }
        widest = widest.max(now);
        before = now;
    });
    let count = crossings.len() - 1;
    let period = (crossings[count] - crossings[0]) / count as f32;
    assert!(count > 8, "{count}");
    assert!(
        (period / expected - 1.0).abs() < 0.02,
        "{period} s, not {expected} s"
    );
    // Energy is the square of the amplitude.
    let left = (last / tilt as f32).powi(2);
    assert!((0.9..1.01).contains(&left), "{left} of the energy");
}

#[test]
fn a_hinge_at_a_solid_that_sways_at_the_greatest_speed_does_not_stretch() {
    let mut scene = alone();
    let sway = [
        ("y", 1.2),
        ("width", 0.1),
        ("height", 0.05),
        ("sway", 0.3),
        ("period", 0.63),
    ];
    let from = add(&mut scene, "box", "sway", &sway);
    chain(&mut scene, from, (0.0, 1.2), 90.0, 4);
    let mut fire = Simulation::new(scene);
    let mut fastest = 0.0_f32;
    watch(&mut fire, 5.0, |fire| {
        let poses = fire.poses();
        let frame = poses.iter().find(|pose| pose.id == from).unwrap().frame;
        let links = fire.free_solids();
        let most = stretch(&links, frame.centre);
        assert!(most < 2e-3, "{most} m at {} s", fire.time());
        fastest = fastest.max(links[0].velocity.length());
    });
    assert!(fastest > 1.5, "{fastest}");
}

#[test]
fn hinged_bodies_exchange_momentum_that_is_opposite() {
    let mut scene = closed_box(&[("gravity", 0.0), ("turbulence", 0.0)]);
    let ball = add(
        &mut scene,
        "circle",
        "free",
        &[("x", 0.05), ("y", 0.6), ("width", 0.1), ("density", 20.0)],
    );
    for id in chain(&mut scene, ball, (0.05, 0.6), 70.0, 4) {
        assert_eq!(
            scene.change(id, &[("density", Input::Number(20.0))]),
            Ok(())
        );
    }
    let places = Simulation::new(scene.world().clone()).count();
    let mut fire = Simulation::new(scene);
    let particle = f64::from(fire.parameters().ambient_density) * 0.64 / places as f64;
    let gust = |at: Vec2, _: Vec2| {
        if at.x < -0.1 {
            Vec2::new(20.0, 5.0)
        } else {
            Vec2::ZERO
        }
    };
    while fire.time() < 0.1 {
        fire.step_in_stages(Some(&gust), &mut |_| ());
    }
    let (gas, bodies) = super::gas::momenta(&fire, particle);
    let (whole, mut moved) = (gas + bodies, 0.0_f64);
    watch(&mut fire, 2.0, |fire| {
        let (now, of_bodies) = super::gas::momenta(fire, particle);
        moved = moved.max((of_bodies - bodies).length());
        let change = (now + of_bodies - whole).length() / whole.length();
        assert!(change < 1e-5, "{change} at {} s", fire.time());
    });
    assert!(moved > 0.05 * whole.length(), "{moved} of {whole}");
}

#[test]
fn two_that_hang_from_each_other_do_not_collide_and_others_do() {
    let apart = |hinged: bool| {
        let mut scene = alone();
        assert_eq!(scene.set("gravity", 0.0), Ok(()));
        let size = [("y", 1.0), ("width", 0.1), ("height", 0.1)];
        let support = add(&mut scene, "box", "free", &size);
        let other = add(
            &mut scene,
            "box",
            "free",
            &[&size[..], &[("x", 0.098)]].concat(),
        );
        if hinged {
            hang(&mut scene, other, support);
        }
        let mut fire = Simulation::new(scene);
        burn_on(&mut fire, 1.0);
        free(&fire, support)
            .place
            .distance(free(&fire, other).place)
    };
    assert!((apart(true) - 0.098).abs() < 1e-4, "{}", apart(true));
    assert!(apart(false) > 0.0995, "{}", apart(false));
}

#[test]
fn a_solid_that_cannot_hang_falls_and_a_chain_in_a_circle_stays_finite() {
    for from in [0, 2, 77] {
        let mut scene = alone();
        let id = add(&mut scene, "box", "free", &[("y", 1.0)]);
        hang(&mut scene, id, from);
        let mut fire = Simulation::new(scene);
        burn_on(&mut fire, 0.2);
        assert!(free(&fire, id).place.y < 0.85, "from {from}");
    }
    let mut scene = alone();
    let ids = chain(&mut scene, 0, (0.0, 1.4), 90.0, 3);
    hang(&mut scene, ids[0], ids[2]);
    let mut fire = Simulation::new(scene);
    watch(&mut fire, 3.0, |fire| {
        for body in fire.free_solids() {
            assert!(body.place.is_finite() && body.spin.is_finite(), "{body:?}");
        }
    });
}

#[test]
fn a_bad_reference_is_an_error_with_its_range() {
    let mut scene = alone();
    let id = add(&mut scene, "box", "free", &[]);
    for (value, words) in [
        (-1.0, "objects[0].hangs_from = -1"),
        (1e7, "objects[0].hangs_from = 10000000"),
        (1.5, "objects[0].hangs_from = 1.5"),
    ] {
        let refused = scene.change(id, &[("hangs_from", Input::Number(value))]);
        let text = format!("{}", refused.unwrap_err()[0]);
        assert!(text.starts_with(words), "{text}");
        assert!(text.contains("0") && text.contains("1000000"), "{text}");
    }
}

#[test]
fn a_chain_follows_a_hook_that_moves_and_falls_without_it() {
    let mut scene = alone();
    let nail = hook(&mut scene, 0.0, 1.4);
    let ids = chain(&mut scene, nail, (0.0, 1.4), 90.0, 5);
    let mut fire = Simulation::new(scene.clone());
    burn_on(&mut fire, 2.0);
    assert!(free(&fire, ids[4]).asleep);
    // It wakes and follows.
    for step in 1..=50 {
        let x = Input::Number(0.004 * f64::from(step));
        assert_eq!(scene.change(nail, &[("x", x)]), Ok(()));
        fire.set_scene(scene.clone());
        burn_on(&mut fire, 0.01);
    }
    burn_on(&mut fire, 0.2);
    let most = stretch(&fire.free_solids(), Vec2::new(0.2, 1.4));
    assert!(most < 2e-3, "{most}");
    // Another property of a link changes nothing.
    assert_eq!(
        scene.change(ids[2], &[("friction", Input::Number(0.9))]),
        Ok(())
    );
    fire.set_scene(scene.clone());
    burn_on(&mut fire, 0.1);
    let most = stretch(&fire.free_solids(), Vec2::new(0.2, 1.4));
    assert!(most < 2e-3, "{most}");
    assert_eq!(scene.remove(nail), Ok(()));
    fire.set_scene(scene);
    burn_on(&mut fire, 0.3);
    assert!(ids.into_iter().all(|id| free(&fire, id).velocity.y < -1.5));
}

#[test]
fn two_hinged_bodies_keep_both_momenta() {
    let mut scene = with_numbers(&[("time_step", 0.002), ("gravity", 0.0)]);
    assert_eq!(scene.set("walls", "open"), Ok(()));
    scene.clear();
    // One moves with a solid that sways until it is removed.
    let from = add(
        &mut scene,
        "circle",
        "sway",
        &[("y", 2.0), ("sway", 0.3), ("period", 2.0)],
    );
    chain(&mut scene, from, (0.0, 2.0), 50.0, 6);
    let mut fire = Simulation::new(scene.clone());
    burn_on(&mut fire, 0.7);
    assert_eq!(scene.remove(from), Ok(()));
    fire.set_scene(scene);
    let totals = |fire: &Simulation| {
        let mut sums = [0.0; 3];
        for body in fire.free_solids() {
            let (mass, spin) = (f64::from(body.mass), f64::from(body.spin));
            let (at, v) = (body.centre.as_dvec2(), body.velocity.as_dvec2());
            let turning = f64::from(body.inertia) * spin + mass * at.perp_dot(v);
            for (sum, part) in sums.iter_mut().zip([mass * v.x, mass * v.y, turning]) {
                *sum += part;
            }
        }
        sums
    };
    let before = totals(&fire);
    let scale = before[0].hypot(before[1]);
    assert!(scale > 0.1, "{before:?}");
    watch(&mut fire, 1.0, |fire| {
        for (now, then) in totals(fire).into_iter().zip(before) {
            assert!((now - then).abs() < 0.01 * scale, "{now}, not {then}");
        }
    });
}
