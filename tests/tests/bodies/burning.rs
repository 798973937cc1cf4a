//! Bodies that burn: what they weigh, and heaps of them.

use hearth_core::params::Input;
use hearth_core::random::Random;
use hearth_core::{IgnitionTarget, Simulation, Vec2};
use hearth_tests::fires::burn_on;
use hearth_tests::sweep::heap::{Heap, gas_in_what_is_left};

use super::{add, floor, free};

#[test]
fn a_burning_body_has_the_mass_the_centre_and_the_inertia_of_what_is_left() {
    let mut scene = floor(&[("gravity", 0.0)]);
    let plank = [
        ("y", 0.5),
        ("width", 0.6),
        ("height", 0.06),
        ("load", 0.5),
        ("moisture", 0.0),
    ];
    let id = add(&mut scene, "box", "free", &plank);
    assert_eq!(scene.change(id, &[("fuel", Input::Text("paper"))]), Ok(()));
    let mut fire = Simulation::new(scene);
    let before = free(&fire, id);
    // 500 kg/m³ of 0.6 m × 0.06 m, as a plank: m (a² + b²) / 12.
    let mass = 500.0 * 0.6 * 0.06;
    assert!((before.mass / mass - 1.0).abs() < 1e-3, "{before:?}");
    let inertia = mass * (0.36 + 0.0036) / 12.0;
    assert!((before.inertia / inertia - 1.0).abs() < 0.01, "{before:?}");
    assert_eq!(
        fire.ignite(IgnitionTarget::Place(Vec2::new(-0.3, 0.5), 0.2)),
        Ok(())
    );
    let left = |fire: &Simulation| {
        let fuel = fire.burning_solids();
        ((fuel[0].fuel + fuel[0].char) / fuel[0].first) as f32
    };
    while left(&fire) > 0.8 {
        assert!(fire.time() < 10.0, "{}", left(&fire));
        fire.step();
    }
    // The mass is looked at four times a second, before what stands no more falls.
    assert_eq!(fire.extinguish(IgnitionTarget::Object(id)), Ok(()));
    burn_on(&mut fire, 0.6);
    let (after, left) = (free(&fire, id), left(&fire));
    assert!(
        (after.mass / before.mass - left).abs() < 0.01,
        "{after:?} {left}"
    );
    assert!(after.inertia < before.inertia * left, "{after:?}");
    // Its left end has burnt.
    let pose = fire.poses().into_iter().find(|pose| pose.id == id);
    let along = pose.map_or(0.0, |pose| pose.frame.local(after.centre).x);
    assert!(along > 0.01, "{along}");
}

#[test]
fn a_heap_of_burning_bodies_stays_finite_and_without_gas_inside() {
    let mut scene = floor(&[]);
    for number in 0..12 {
        let row = f64::from(number / 4);
        let place = [
            ("x", 0.13 * (f64::from(number % 4) - 1.5) + 0.05 * row),
            ("y", 0.15 + 0.16 * row),
            ("angle", 31.0 * f64::from(number)),
            ("width", 0.12),
            ("height", 0.08),
            ("load", 0.4),
            ("density", 60.0),
        ];
        let shape = ["circle", "box", "line", "polygon"][number as usize % 4];
        let id = add(&mut scene, shape, "free", &place);
        let points = Input::Text("0,0.06 -0.05,-0.03 0.05,-0.03");
        let fuel = [("fuel", Input::Text("wood")), ("points", points)];
        assert_eq!(scene.change(id, &fuel), Ok(()));
    }
    let mut fire = Simulation::new(scene);
    burn_on(&mut fire, 0.5);
    assert_eq!(
        fire.ignite(IgnitionTarget::Place(Vec2::new(0.0, 0.2), 0.4)),
        Ok(())
    );
    while fire.time() < 10.0 {
        fire.step();
        assert_eq!(gas_in_what_is_left(&fire), None, "{} s", fire.time());
        for body in fire.free_solids() {
            assert!(body.place.is_finite() && body.velocity.is_finite() && body.spin.is_finite());
            // The place of a body may be beyond what is left of it.
            assert!(body.centre.y > -0.05, "{body:?}");
        }
    }
    // Some of it has burnt.
    assert!(fire.fuel_total().is_some_and(|fuel| fuel.left < 0.9));
    assert!(fire.positions().into_iter().all(Vec2::is_finite));
    assert!(fire.temperatures().into_iter().all(f32::is_finite));
}

/// This is a sample; `cargo measure soak` burns hundreds.
#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn random_heaps_of_burning_bodies_stay_finite_and_without_gas_inside() {
    for seed in 1..=6 {
        let heap = Heap::random(&mut Random::new(seed));
        let name = heap.described();
        assert_eq!(heap.burn(10.0).fault(), None, "{name}");
    }
}
