//! Objects with names, and objects that are off.

use super::*;

const OFF: (&str, Input<'static>) = ("enabled", Input::Flag(false));

fn text(words: &str) -> Input<'_> {
    Input::Text(words)
}

fn bits(fire: &Simulation) -> Vec<u32> {
    let all = fire.positions().into_iter();
    let bits = all.flat_map(|at| at.to_array().map(f32::to_bits));
    bits.collect()
}

fn names(scene: &Scene) -> Vec<&str> {
    scene.objects().map(|object| object.name()).collect()
}

#[test]
fn an_object_of_any_kind_keeps_its_name() {
    let mut scene = Scene::default();
    let longest = "é".repeat(64);
    assert_eq!(scene.change(1, &[("name", text("Wick"))]), Ok(()));
    assert_eq!(scene.add(&[SOLID, ("name", text("Wax, white"))]), Ok(2));
    assert_eq!(scene.add(&[SOURCE, ("name", text(&longest))]), Ok(3));
    assert_eq!(names(&scene), ["Wick", "Wax, white", &longest]);
    for index in 0..3 {
        let name = names(&scene)[index];
        assert_eq!(value(&scene, index, "name"), Some(AnyValue::Text(name)));
    }
    assert_eq!(scene.remove(1), Ok(()));
    scene.set_world(Parameters::default());
    assert_eq!(names(&scene), ["Wax, white", &longest]);
    assert_eq!(scene.change(2, &[("name", text(""))]), Ok(()));
    assert_eq!(names(&scene)[0], "");
}

#[test]
fn a_long_name_and_one_of_two_lines_are_refused() {
    let mut scene = Scene::default();
    let before = scene.clone();
    let long = "a".repeat(65);
    for wrong in [text(&long), text("a\nb"), text("a\tb"), number(7.0)] {
        let refused = words(scene.change(1, &[("name", wrong)]));
        let expected = "it must be a line of at most 64 characters";
        assert!(refused.starts_with("objects[0].name = "), "{refused}");
        assert!(refused.ends_with(expected), "{refused}");
        assert_eq!(scene, before);
    }
}

#[test]
fn a_fire_burns_as_without_its_objects_that_are_off() {
    for model in [Model::Combustion, Model::Classic] {
        let plain = few(model);
        let mut scene = plain.clone();
        let source = [SOURCE, ("x", number(0.3)), OFF];
        let free = ("motion", text("free"));
        let fuel = ("fuel", text("wood"));
        assert_eq!(scene.add(&[SOLID, OFF, free]), Ok(2));
        assert_eq!(scene.add(&[SOLID, OFF, fuel]), Ok(3));
        assert_eq!(scene.add(&source), Ok(4));
        assert_eq!((scene.has_free(), scene.has_fuel()), (false, false));
        assert_eq!(scene.power(), plain.power());
        assert_eq!(bits(&burnt(&scene, 0.1)), bits(&burnt(&plain, 0.1)));
        let on = [("enabled", Input::Flag(true))];
        for id in 2..=4 {
            assert_eq!(scene.change(id, &on), Ok(()));
        }
        assert_eq!((scene.solids().count(), scene.sources().count()), (2, 2));
    }
}

#[test]
fn a_source_on_a_solid_that_is_off_is_off() {
    let mut scene = Scene::default();
    assert_eq!(scene.add(&[SOLID]), Ok(2));
    let on_solid = [("shape", text("solid")), ("solid", number(2.0))];
    assert_eq!(scene.change(1, &on_solid), Ok(()));
    assert_eq!(scene.sources().count(), 1);
    assert_eq!(scene.change(2, &[OFF]), Ok(()));
    assert_eq!((scene.sources().count(), scene.power()), (0, 0.0));
    assert_eq!(scene.change(1, &[("shape", text("line"))]), Ok(()));
    assert_eq!(scene.sources().count(), 1);
}

#[test]
fn masks_of_solids_that_are_off_count() {
    let mut scene = Scene::default();
    let largest = format!("256x256:{}", "_".repeat(16));
    let mask = ("mask", text(&largest));
    for _ in 0..4 {
        assert!(scene.add(&[SOLID, mask, OFF]).is_ok());
    }
    assert!(scene.add(&[SOLID, mask, OFF]).is_err());
}
