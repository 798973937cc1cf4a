//! Laws of the bodies.

use super::*;
use crate::params::Input;

const BOX: Bounds = Bounds {
    bottom: 0.0,
    width: 2.0,
    height: 2.0,
    periodic_x: true,
    periodic_y: true,
};

fn scene(x: f64) -> Scene {
    let mut scene = Scene::default();
    let fields = [
        ("kind", Input::Text("solid")),
        ("x", Input::Number(x)),
        ("y", Input::Number(1.0)),
    ];
    assert_eq!(scene.add(&fields), Ok(2));
    scene
}

#[test]
fn a_motion_has_the_speed_of_its_path_over_its_time_and_ends() {
    let mut solids = Solids::of(&scene(0.0), &BOX, 0.1);
    let velocity = |solids: &Solids| solids.bodies[0].velocity_at(Vec2::ZERO);
    for frame in 1..4 {
        for _ in 0..4 {
            solids.end_motions(0.005);
        }
        solids.update(&scene(0.01 * f64::from(frame)), 0.0, &BOX, 0.1);
        // The solid was at rest before, for an unknown time.
        let speed = if frame == 1 {
            0.01 / LONGEST_MOTION
        } else {
            0.5
        };
        assert!((velocity(&solids) - Vec2::new(speed, 0.0)).length() < 1e-3);
    }
    solids.end_motions(0.019);
    assert!(velocity(&solids).x > 0.4);
    solids.end_motions(0.002);
    assert_eq!(velocity(&solids), Vec2::ZERO);
    solids.update(&scene(0.9), 0.0, &BOX, 0.1);
    assert!((velocity(&solids).x - MAX_SPEED).abs() < 1e-5);
}

#[test]
fn gas_passes_a_solid_behind_or_before_the_fire_unless_it_burns_moves_freely_or_carries_a_source() {
    let is_obstacle = |fields: &[(&str, Input)]| {
        let mut scene = scene(0.0);
        assert_eq!(scene.change(2, fields), Ok(()));
        !Solids::of(&scene, &BOX, 0.1).bodies.is_empty()
    };
    assert!(is_obstacle(&[("plane", Input::Text("within"))]));
    for plane in ["behind", "before"] {
        let plane = ("plane", Input::Text(plane));
        assert!(!is_obstacle(&[plane]));
        assert!(is_obstacle(&[plane, ("fuel", Input::Text("wood"))]));
        assert!(is_obstacle(&[plane, ("motion", Input::Text("free"))]));
        let mut scene = scene(0.0);
        assert_eq!(scene.change(2, &[plane]), Ok(()));
        let source = [
            ("shape", Input::Text("solid")),
            ("solid", Input::Number(2.0)),
        ];
        assert_eq!(scene.change(1, &source), Ok(()));
        assert_eq!(Solids::of(&scene, &BOX, 0.1).bodies.len(), 1);
    }
}

#[test]
fn a_solid_at_a_periodic_edge_has_an_image() {
    assert_eq!(Solids::of(&scene(0.0), &BOX, 0.1).bodies.len(), 1);
    let solids = Solids::of(&scene(0.95), &BOX, 0.1);
    assert_eq!(solids.bodies.len(), 2);
    assert!(solids.touch(Vec2::new(-0.99, 1.0), 0.0));
    // One that is as wide as the domain has none, which would overlap it: it has no end.
    let mut wide = scene(0.5);
    let fields = [("shape", Input::Text("box")), ("width", Input::Number(2.0))];
    assert_eq!(wide.change(2, &fields), Ok(()));
    let plate = Solids::of(&wide, &BOX, 0.1);
    assert_eq!(plate.bodies.len(), 1);
    assert!((0..20).all(|i| plate.touch(Vec2::new(0.1 * i as f32 - 1.0, 1.0), 0.0)));
    // A disc that is wider than the domain covers it with its images.
    let disc = [
        ("shape", Input::Text("circle")),
        ("width", Input::Number(2.2)),
    ];
    assert_eq!(wide.change(2, &disc), Ok(()));
    let discs = Solids::of(&wide, &BOX, 0.1);
    assert!((0..20).all(|i| discs.touch(Vec2::new(0.1 * i as f32 - 1.0, 1.0), 0.0)));
    // One far outside has none.
    assert_eq!(Solids::of(&scene(2.0), &BOX, 0.1).bodies.len(), 1);
}

#[test]
fn a_place_outside_keeps_the_gap_to_all_solids() {
    let mut scene = scene(0.0);
    let fields = [
        ("kind", Input::Text("solid")),
        ("x", Input::Number(0.15)),
        ("y", Input::Number(1.0)),
    ];
    assert_eq!(scene.add(&fields), Ok(3));
    let solids = Solids::of(&scene, &BOX, 0.1);
    let place = solids.outside(Vec2::new(0.075, 1.05), 0.01, 0.1, false);
    assert!(
        place.is_some_and(|place| !solids.touch(place, 0.008)),
        "{place:?}"
    );
    let deep = solids.outside(Vec2::new(0.0, 1.0), 0.01, 0.05, false);
    assert_eq!(deep, None);
    // Two that return a position to the same place leave none.
    let closed = [("x", Input::Number(0.205))];
    assert_eq!(scene.change(3, &closed), Ok(()));
    let solids = Solids::of(&scene, &BOX, 0.1);
    for place in [0.1, 0.1025, 0.105] {
        let place = solids.outside(Vec2::new(place, 1.0), 0.01, 0.1, false);
        let free = place.is_none_or(|place| !solids.touch(place, 0.0));
        assert!(free, "{place:?}");
    }
}
