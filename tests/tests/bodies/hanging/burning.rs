//! Hinges of bodies that burn through, break or are saved.

use hearth_core::params::Input;
use hearth_core::{FreeSolid, IgnitionTarget, Scene, Simulation, Vec2};
use hearth_tests::fires::{burn_on, watch};
use hearth_tests::sweep::heap::gas_in_what_is_left;

use super::{chain, ends, hang, hook, stretch};
use crate::bodies::{add, breaking, floor, free};

/// Links of paper that hang from a hook at that height, as ids.
fn paper(scene: &mut Scene, y: f64, count: u32) -> Vec<u32> {
    let nail = hook(scene, 0.0, y);
    let ids = chain(scene, nail, (0.0, y), 90.0, count);
    for &id in &ids {
        let burns = [
            ("fuel", Input::Text("paper")),
            ("load", Input::Number(0.6)),
            ("moisture", Input::Number(0.0)),
            ("density", Input::Number(100.0)),
        ];
        assert_eq!(scene.change(id, &burns), Ok(()));
    }
    ids
}

#[test]
fn what_hangs_falls_where_it_has_burnt_through() {
    let mut scene = floor(&[]);
    let ids = paper(&mut scene, 1.4, 8);
    let mut fire = Simulation::new(scene);
    burn_on(&mut fire, 0.5);
    assert_eq!(fire.ignite(IgnitionTarget::Object(ids[3])), Ok(()));
    let last = *ids.last().unwrap();
    let start = free(&fire, last).place.y;
    let mut fell = false;
    watch(&mut fire, 6.0, |fire| {
        assert_eq!(gas_in_what_is_left(fire), None);
        fell |= free(fire, last).place.y < start - 0.3;
    });
    assert!(fell, "{:?}", fire.free_solids());
}

#[test]
fn a_hinge_stays_with_the_part_that_has_its_place() {
    let mut scene = floor(&[("gravity", 0.0)]);
    let stick = breaking::stick_in(&mut scene, 1.2);
    let link = [
        ("x", -0.38),
        ("y", 1.1),
        ("angle", 90.0),
        ("width", 0.2),
        ("height", 0.04),
    ];
    let id = add(&mut scene, "line", "free", &link);
    hang(&mut scene, id, stick);
    let mut fire = Simulation::new(scene);
    assert_eq!(
        fire.ignite(IgnitionTarget::Place(Vec2::new(0.0, 1.2), 0.07)),
        Ok(())
    );
    while fire.free_solids().len() < 3 {
        assert!(fire.time() < 4.0);
        fire.step();
    }
    burn_on(&mut fire, 0.5);
    // The place of the hinge in the frame of the stick.
    let at = Vec2::new(-0.38, 0.0);
    let all = fire.free_solids();
    let end = ends(&free(&fire, id), 0.2)[0];
    let near = |body: &FreeSolid| {
        let place = body.place + Vec2::from_angle(body.angle.to_radians()).rotate(at);
        place.distance(end) < 2e-3
    };
    let left = all
        .iter()
        .find(|body| body.object == stick && body.centre.x < 0.0);
    assert!(left.is_some_and(near), "{all:?}");
}

#[test]
fn a_saved_fire_has_its_hinges_and_not_those_that_let_go() {
    let mut scene = floor(&[]);
    let ids = paper(&mut scene, 1.4, 6);
    let mut fire = Simulation::new(scene.clone());
    assert_eq!(fire.ignite(IgnitionTarget::Object(ids[3])), Ok(()));
    while free(&fire, ids[5]).place.y > 0.8 {
        assert!(fire.time() < 8.0);
        fire.step();
    }
    let bytes = fire.burning().unwrap_or_default();
    let before = fire.free_solids();
    let mut other = Simulation::new(scene);
    assert_eq!(other.restore_burning(&bytes), Ok(()));
    for (then, now) in before.iter().zip(other.free_solids()) {
        assert!(then.place.distance(now.place) < 1e-5, "{then:?} {now:?}");
    }
    burn_on(&mut other, 0.4);
    let most = stretch(&other.free_solids()[..2], Vec2::new(0.0, 1.4));
    assert!(most < 1e-3, "{most}");
    assert!(free(&other, ids[5]).place.y < 0.5);
}

#[test]
fn the_same_chain_has_the_same_bits() {
    let [first, second] = [(); 2].map(|()| {
        let mut scene = floor(&[]);
        let ids = paper(&mut scene, 1.2, 6);
        let mut fire = Simulation::new(scene);
        assert_eq!(fire.ignite(IgnitionTarget::Object(ids[5])), Ok(()));
        burn_on(&mut fire, 1.5);
        fire
    });
    assert_eq!(first.free_solids(), second.free_solids());
    assert_eq!(first.particles(), second.particles());
}
