//! Bodies that burn through: each part goes on as a body of its own.

use hearth_core::params::Input;
use hearth_core::{Charred, FreeSolid, IgnitionTarget, Scene, Simulation, Vec2};
use hearth_tests::fires::burn_on;
use hearth_tests::sweep::heap::gas_in_what_is_left;

use super::{add, floor, free};

/// Height of the stick, and how far its fire is lit \[m\].
const HEIGHT: f64 = 1.2;
const LIT: f32 = 0.07;

/// A stick of paper that lies in the air, and its id.
fn stick(gravity: f64) -> (Scene, u32) {
    let mut scene = floor(&[("gravity", gravity)]);
    let id = stick_in(&mut scene, HEIGHT);
    (scene, id)
}

pub fn stick_in(scene: &mut Scene, y: f64) -> u32 {
    let size = [
        ("y", y),
        ("width", 0.8),
        ("height", 0.04),
        ("load", 0.6),
        ("moisture", 0.0),
    ];
    let id = add(scene, "box", "free", &size);
    assert_eq!(scene.change(id, &[("fuel", Input::Text("paper"))]), Ok(()));
    id
}

fn lit(scene: Scene) -> Simulation {
    let mut fire = Simulation::new(scene);
    let middle = Vec2::new(0.0, HEIGHT as f32);
    assert_eq!(fire.ignite(IgnitionTarget::Place(middle, LIT)), Ok(()));
    fire
}

/// Burns until a body breaks. Returns the bodies before that step and after it.
fn until_it_breaks(fire: &mut Simulation) -> (Vec<FreeSolid>, Vec<FreeSolid>) {
    while fire.time() < 4.0 {
        let before = fire.free_solids();
        fire.step();
        let after = fire.free_solids();
        if after.len() > before.len() {
            return (before, after);
        }
    }
    panic!("nothing has broken: {:?}", fire.free_solids());
}

/// The mass that is left of a solid, and all that it has given off [kg/m].
fn balance(fire: &Simulation) -> (f64, f64, f64) {
    let all = fire.burning_solids();
    assert_eq!(all.len(), 1);
    let solid = all[0];
    let given = solid.gas + solid.oxidised + solid.fallen;
    (solid.fuel + solid.char, given, solid.first)
}

#[test]
fn a_stick_that_burns_through_in_its_middle_becomes_two_bodies() {
    let (scene, id) = stick(0.0);
    let mut fire = lit(scene);
    let whole = free(&fire, id);
    let (before, after) = until_it_breaks(&mut fire);
    assert_eq!(before.len(), 1);
    let [rest, part] = after[..] else {
        panic!("{after:?}");
    };
    assert_eq!((rest.id, rest.object, part.object), (id, id, id));
    assert!(part.id > 1_000_000);
    // One is to the left, one to the right, each of less than half of the mass and of an eighth of the
    // inertia.
    assert!(rest.centre.x * part.centre.x < 0.0, "{after:?}");
    for body in [rest, part] {
        assert!((0.15..0.35).contains(&body.centre.x.abs()), "{body:?}");
        assert!(body.mass > 0.3 * whole.mass && body.mass < 0.5 * whole.mass);
        assert!(body.inertia < 0.125 * whole.inertia, "{body:?}");
        // The place is that of the solid of which it is a part.
        assert!(body.place.distance(before[0].place) < 1e-3, "{body:?}");
    }
    // The mass is that of what is left, less the gas that has not left its cells yet.
    let (left, given, first) = balance(&fire);
    let share = (rest.mass + part.mass) / whole.mass;
    assert!((f64::from(share) - left / first).abs() < 1e-2, "{share}");
    assert!(((left + given) / first - 1.0).abs() < 1e-4);
    let mut drawn = Charred::default();
    fire.write_charred(&mut drawn);
    let drawn: Vec<_> = (drawn.solids.iter())
        .map(|body| (body.id, body.part.is_some()))
        .collect();
    assert_eq!(drawn, [(id, false), (id, true)]);
    assert_eq!(gas_in_what_is_left(&fire), None);
    // Nothing is lost later on, and both are one solid to its readers.
    while fire.time() < 6.0 {
        fire.step();
        assert_eq!(gas_in_what_is_left(&fire), None, "{} s", fire.time());
        let (left, given, first) = balance(&fire);
        let error = (left + given) / first - 1.0;
        assert!(error.abs() < 1e-4, "{error} at {} s", fire.time());
        for body in fire.free_solids() {
            assert!(body.velocity.is_finite() && body.spin.is_finite() && body.mass >= 0.0);
        }
    }
}

#[test]
fn each_part_goes_on_with_the_velocity_of_its_material() {
    let (mut scene, id) = stick(9.81);
    // Its right end falls onto a peg, so it turns.
    add(
        &mut scene,
        "circle",
        "still",
        &[("x", 0.35), ("y", HEIGHT - 0.13), ("width", 0.1)],
    );
    let mut fire = lit(scene);
    let (before, after) = until_it_breaks(&mut fire);
    let whole = before[0];
    assert!(whole.spin.abs() > 1.0, "{whole:?}");
    for part in &after {
        let path = part.centre - whole.centre;
        let fall = Vec2::new(0.0, -9.81 * fire.step_length() as f32);
        let expected = whole.velocity + path.perp() * whole.spin + fall;
        let error = part.velocity.distance(expected);
        // Gas acts in the step, too.
        assert!(error < 0.2, "{error}: {part:?} of {whole:?}");
        assert!((part.spin / whole.spin - 1.0).abs() < 0.1, "{part:?}");
    }
    // Both fall.
    burn_on(&mut fire, 0.15);
    let two = [free(&fire, id), fire.free_solids()[1]];
    let apart = two[0].angle - two[1].angle;
    assert!(two.iter().all(|body| body.centre.y < 1.0), "{two:?}");
    assert!(apart.is_finite());
}

#[test]
fn nothing_breaks_that_does_not_burn() {
    let mut scene = floor(&[]);
    for (number, shape) in ["box", "line", "polygon", "mask", "circle"]
        .iter()
        .enumerate()
    {
        let place = [
            ("y", 0.2 + 0.2 * number as f64),
            ("angle", 35.0 * number as f64),
            ("width", 0.3),
            ("height", 0.02),
        ];
        let id = add(&mut scene, shape, "free", &place);
        let outline = [
            ("fuel", Input::Text("wood")),
            // Two letters: they are apart from the start.
            ("mask", Input::Text("8x4:3PSqSo")),
            ("points", Input::Text("0,0.06 -0.05,-0.03 0.05,-0.03")),
        ];
        assert_eq!(scene.change(id, &outline), Ok(()));
    }
    let mut fire = Simulation::new(scene);
    burn_on(&mut fire, 2.0);
    assert_eq!(fire.free_solids().len(), 5);
    assert_eq!(fire.fuel_total().map(|fuel| fuel.unbroken), Some(0));
}

#[test]
fn a_change_of_the_scene_keeps_the_parts_and_reset_restores_the_whole() {
    let (mut scene, id) = stick(0.0);
    let mut fire = lit(scene.clone());
    let whole = free(&fire, id);
    until_it_breaks(&mut fire);
    let (broken, left) = (fire.free_solids(), balance(&fire));
    // The scene is as it was.
    assert_eq!(fire.scene().objects().len(), scene.objects().len());
    let same = |fire: &Simulation| {
        for (then, now) in broken.iter().zip(fire.free_solids()) {
            assert_eq!((then.id, then.place), (now.id, now.place));
            assert!(
                (now.mass / then.mass - 1.0).abs() < 0.01,
                "{then:?} {now:?}"
            );
            assert!(then.centre.distance(now.centre) < 1e-3, "{then:?} {now:?}");
        }
        assert_eq!(balance(fire), left);
    };
    let friction = [("friction", Input::Number(0.9))];
    assert_eq!(scene.change(id, &friction), Ok(()));
    fire.set_scene(scene.clone());
    same(&fire);
    // Another spacing, as of another quality.
    let mut coarse = scene.clone();
    assert_eq!(coarse.set("spacing", 0.08), Ok(()));
    fire.set_scene(coarse);
    same(&fire);
    burn_on(&mut fire, 0.2);
    // Another fuel makes it anew, and another place leaves the part where it is.
    let mut other = scene.clone();
    assert_eq!(other.change(id, &[("x", Input::Number(0.5))]), Ok(()));
    fire.set_scene(other.clone());
    let moved = fire.free_solids();
    assert_eq!(moved.len(), 2);
    assert!((moved[0].place.x - 0.5).abs() < 1e-6 && moved[1].place.x < 0.1);
    assert_eq!(other.change(id, &[("load", Input::Number(1.0))]), Ok(()));
    fire.set_scene(other.clone());
    assert_eq!(fire.free_solids().len(), 1);
    burn_on(&mut fire, 0.1);
    fire.set_scene(scene.clone());
    fire.reset();
    assert_eq!(free(&fire, id), whole);
    assert_eq!(fire.free_solids().len(), 1);
    assert_eq!(balance(&fire).0, balance(&fire).2);
    // A removed solid takes its parts along.
    assert_eq!(
        fire.ignite(IgnitionTarget::Place(Vec2::new(0.0, HEIGHT as f32), LIT)),
        Ok(())
    );
    until_it_breaks(&mut fire);
    assert_eq!(scene.remove(id), Ok(()));
    fire.set_scene(scene);
    assert_eq!(
        (fire.free_solids(), fire.burning_solids()),
        (vec![], vec![])
    );
    burn_on(&mut fire, 0.1);
}

#[test]
fn an_object_is_lit_and_put_out_with_its_parts() {
    let (scene, id) = stick(0.0);
    let mut fire = lit(scene);
    until_it_breaks(&mut fire);
    assert_eq!(fire.extinguish(IgnitionTarget::Object(id)), Ok(()));
    let left = balance(&fire).0;
    burn_on(&mut fire, 0.5);
    // Gas that it has given off still leaves its cells.
    let lost = 1.0 - balance(&fire).0 / left;
    assert!(lost < 0.02, "{lost}");
    assert_eq!(fire.ignite(IgnitionTarget::Object(id)), Ok(()));
    burn_on(&mut fire, 1.0);
    let now = fire.free_solids();
    assert!(now.iter().all(|body| body.mass < 4.0), "{now:?}");
}

#[test]
fn among_as_many_solids_as_there_may_be_nothing_breaks() {
    let (mut scene, id) = stick(0.0);
    for number in 0..63 {
        let place = [("x", -5.0 - 0.05 * f64::from(number)), ("width", 0.02)];
        add(&mut scene, "circle", "still", &place);
    }
    let mut fire = lit(scene.clone());
    let unbroken = |fire: &Simulation| fire.fuel_total().map(|fuel| fuel.unbroken);
    while unbroken(&fire) == Some(0) {
        assert!(fire.time() < 1.5);
        fire.step();
    }
    assert_eq!(unbroken(&fire), Some(1));
    assert_eq!(fire.free_solids().len(), 1);
    // With room for it, it breaks.
    let last = scene.objects().last().map(|object| object.id);
    assert_eq!(scene.remove(last.unwrap()), Ok(()));
    fire.set_scene(scene);
    until_it_breaks(&mut fire);
    assert_eq!(unbroken(&fire), Some(0));
    assert_eq!(free(&fire, id).object, id);
}

#[test]
fn the_same_fire_breaks_with_the_same_bits() {
    let [first, second] = [(); 2].map(|()| {
        let mut fire = lit(stick(9.81).0);
        burn_on(&mut fire, 1.5);
        fire
    });
    assert_eq!(first.free_solids(), second.free_solids());
    assert!(first.free_solids().len() > 1);
    assert_eq!(first.particles(), second.particles());
}
