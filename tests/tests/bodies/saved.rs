//! Saved fires: free bodies go on where they were.

use hearth_core::burning::BurningError;
use hearth_core::params::Input;
use hearth_core::{Scene, Simulation, Vec2};
use hearth_tests::fires::burn_on;
use hearth_tests::sweep::crowd::gas_inside;

use super::{add, floor};

/// Bytes of a free body at the end of a saved fire.
const BODY: usize = 32;

/// A box that rests on another, and a polygon that falls and turns.
fn heap() -> Scene {
    let mut scene = floor(&[]);
    add(
        &mut scene,
        "circle",
        "still",
        &[("x", 0.6), ("width", 0.2), ("y", 0.6)],
    );
    for y in [0.05, 0.151] {
        let place = [("width", 0.1), ("height", 0.1), ("y", y)];
        add(&mut scene, "box", "free", &place);
    }
    let id = add(&mut scene, "polygon", "free", &[("x", 0.55), ("y", 4.2)]);
    let points = Input::Text("0,0.1 -0.08,-0.05 0.12,-0.05");
    assert_eq!(scene.change(id, &[("points", points)]), Ok(()));
    scene
}

fn saved() -> (Simulation, Vec<u8>) {
    let mut fire = Simulation::new(heap());
    burn_on(&mut fire, 1.5);
    let bytes = fire.burning().unwrap_or_default();
    assert!(bytes.len() > 3 * BODY);
    (fire, bytes)
}

#[test]
fn a_saved_fire_has_its_free_solids_where_they_were() {
    let (mut fire, bytes) = saved();
    let before = fire.free_solids();
    assert!(before[0].asleep && before[1].asleep && !before[2].asleep);
    let spin = before[2].spin.abs();
    assert!(
        spin > 0.5 || before[2].velocity.length() > 0.5,
        "{:?}",
        before[2]
    );
    let mut other = Simulation::new(heap());
    assert_eq!(other.restore_burning(&bytes), Ok(()));
    let same = |fire: &Simulation, other: &Simulation, error: f32| {
        let all = fire.free_solids().into_iter().zip(other.free_solids());
        for (then, now) in all {
            let path = then.place.distance(now.place);
            assert!(path < error, "{then:?} {now:?}");
            assert!(
                (then.angle - now.angle).abs() < 100.0 * error,
                "{then:?} {now:?}"
            );
            assert!(then.velocity.distance(now.velocity) < 10.0 * error);
            assert!(
                (then.spin - now.spin).abs() < 100.0 * error,
                "{then:?} {now:?}"
            );
            assert_eq!((then.asleep, then.mass), (now.asleep, now.mass));
        }
    };
    same(&fire, &other, 1e-5);
    assert_eq!(gas_inside(&other), None);
    // The picture shows them there.
    let frames = |fire: &Simulation| -> Vec<Vec2> {
        fire.poses().iter().map(|pose| pose.frame.centre).collect()
    };
    let places = frames(&fire).into_iter().zip(frames(&other));
    assert!(
        places
            .into_iter()
            .all(|(first, second)| first.distance(second) < 1e-5)
    );
    // They go on alike, and those that sleep do not wake.
    for fire in [&mut fire, &mut other] {
        burn_on(fire, 0.1);
    }
    // Within the path of a step.
    same(&fire, &other, 3e-2);
    // At another spacing, too.
    let mut scene = heap();
    assert_eq!(scene.set("spacing", 0.05), Ok(()));
    let mut finer = Simulation::new(scene);
    assert_eq!(finer.restore_burning(&bytes), Ok(()));
    for (then, now) in before.iter().zip(finer.free_solids()) {
        assert!(then.place.distance(now.place) < 1e-5, "{then:?} {now:?}");
    }
}

#[test]
fn a_damaged_free_solid_is_refused_and_changes_nothing() {
    let (_, bytes) = saved();
    let mut fire = Simulation::new(heap());
    burn_on(&mut fire, 0.1);
    let before = (fire.free_solids(), fire.particles());
    let first = bytes.len() - 3 * BODY;
    for (number, value) in [
        (0, f32::NAN),
        (1, 1e9),
        (2, 7.0),
        (3, f32::INFINITY),
        (4, -11.0),
        (6, f32::NAN),
        (7, 0.5),
    ] {
        let mut wrong = bytes.clone();
        let at = first + BODY + 4 * number;
        wrong[at..at + 4].copy_from_slice(&value.to_le_bytes());
        let refused = fire.restore_burning(&wrong);
        assert!(
            matches!(refused, Err(BurningError::Damaged(_))),
            "{number}: {refused:?}"
        );
    }
    for length in [first, first + BODY, bytes.len() - 1, bytes.len() - 4] {
        let refused = fire.restore_burning(&bytes[..length]);
        assert!(
            matches!(refused, Err(BurningError::Damaged(_))),
            "{length}: {refused:?}"
        );
    }
    assert_eq!((fire.free_solids(), fire.particles()), before);
}

#[test]
fn a_broken_solid_is_whole_again() {
    let mut scene = floor(&[("gravity", 0.0)]);
    let size = [("y", 1.0), ("width", 0.8), ("height", 0.04), ("load", 0.6)];
    let id = add(&mut scene, "box", "free", &size);
    assert_eq!(scene.change(id, &[("fuel", Input::Text("paper"))]), Ok(()));
    let mut fire = Simulation::new(scene.clone());
    let middle = hearth_core::IgnitionTarget::Place(Vec2::new(0.0, 1.0), 0.07);
    assert_eq!(fire.ignite(middle), Ok(()));
    while fire.free_solids().len() < 2 {
        assert!(fire.time() < 3.0);
        fire.step();
    }
    let bytes = fire.burning().unwrap_or_default();
    for mut other in [fire, Simulation::new(scene)] {
        assert_eq!(other.restore_burning(&bytes), Ok(()));
        assert_eq!(other.free_solids().len(), 1);
        burn_on(&mut other, 0.1);
    }
}
