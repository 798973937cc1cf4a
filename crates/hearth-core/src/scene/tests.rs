use super::*;
use crate::Simulation;
use crate::params::{AnyValue, Model, PARAMETERS, Param, Value};

mod fires;
mod off;

fn number(x: f64) -> Input<'static> {
    Input::Number(x)
}

const SOURCE: (&str, Input<'static>) = ("kind", Input::Text("source"));
const SOLID: (&str, Input<'static>) = ("kind", Input::Text("solid"));

fn value<'a>(scene: &'a Scene, index: usize, name: &str) -> Option<AnyValue<'a>> {
    let mut properties = scene.objects().nth(index)?.properties();
    properties
        .find(|property| property.0 == name)
        .map(|property| property.2)
}

fn ids(scene: &Scene) -> Vec<u32> {
    scene.objects().map(|object| object.id).collect()
}

fn words(refused: Result<impl Sized, Vec<ParamError>>) -> String {
    let all = refused.err().unwrap_or_default();
    let all: Vec<String> = all.iter().map(ParamError::to_string).collect();
    all.join("\n")
}

fn burnt(scene: &Scene, seconds: f64) -> Simulation {
    let mut fire = Simulation::new(scene.clone());
    while fire.time() < seconds {
        fire.step();
    }
    fire
}

#[test]
fn every_property_has_an_entry_and_one_name() {
    for kind in KINDS {
        let mut seen = Vec::new();
        for property in kind.properties() {
            assert!(property.entry().is_some(), "{}", property.id);
            let is_parameter = kind.name == "source" && !property.is_common();
            assert_eq!(
                is_parameter,
                Param::find(property.id).is_some(),
                "{}",
                property.id
            );
            assert!(!seen.contains(&property.id), "{}", property.id);
            assert!(!seen.contains(&property.name), "{}", property.name);
            seen.extend([property.id, property.name]);
        }
    }
}

#[test]
fn settings_alone_have_one_source_whose_properties_they_are() {
    for model in [Model::Classic, Model::Combustion] {
        let mut settings = Parameters::new(model);
        assert_eq!(settings.set("source_x", number(0.2)), Ok(()));
        let mut scene = Scene::new(settings);
        assert_eq!(ids(&scene), [1]);
        assert_eq!(value(&scene, 0, "x"), Some(Value::Number(0.2)));

        assert_eq!(scene.change(1, &[("x", number(-0.1))]), Ok(()));
        assert_eq!(scene.settings().source_x, -0.1);
        let mut settings = scene.settings().clone();
        assert_eq!(settings.set("source_x", number(0.3)), Ok(()));
        scene.set_settings(settings);
        assert_eq!(value(&scene, 0, "x"), Some(Value::Number(0.3)));
    }
}

#[test]
fn a_second_source_has_separate_properties_and_the_other_settings() {
    let mut scene = Scene::default();
    let added = scene.add(&[SOURCE, ("x", number(0.3)), ("power", number(50.0))]);
    assert_eq!(added, Ok(2));
    let mut settings = scene.settings().clone();
    for (id, x) in [("fuel_power", 100.0), ("wind", 1.0), ("source_width", 0.2)] {
        assert_eq!(settings.set(id, number(x)), Ok(()));
    }
    scene.set_settings(settings);
    let powers: Vec<f32> = scene.sources().map(|source| source.fuel_power).collect();
    assert_eq!(powers, [100.0, 50.0]);
    assert_eq!(scene.power(), 150.0);
    assert!(scene.sources().all(|source| source.wind == 1.0));
    assert_eq!(value(&scene, 1, "width"), Some(Value::Number(0.4)));
    assert_eq!(value(&scene, 1, "rate"), None, "it is the classic model's");
}

#[test]
fn a_source_keeps_its_properties_of_the_other_model() {
    let mut scene = Scene::default();
    let added = scene.add(&[SOURCE, ("rate", number(700.0)), ("power", number(50.0))]);
    assert!(added.is_ok());
    for (model, name, kept) in [("classic", "rate", 700.0), ("combustion", "power", 50.0)] {
        let mut settings = scene.settings().clone();
        assert_eq!(settings.set("model", Input::Text(model)), Ok(()));
        scene.set_settings(settings);
        assert_eq!(value(&scene, 1, name), Some(Value::Number(kept)));
    }
}

#[test]
fn the_next_source_becomes_the_first_and_the_last_keeps_its_values() {
    let mut scene = Scene::default();
    let before = scene.settings().clone();
    assert!(scene.add(&[SOURCE, ("x", number(0.3))]).is_ok());
    assert_eq!(scene.remove(1), Ok(()));
    assert_eq!(ids(&scene), [2]);
    assert_eq!(scene.settings().source_x, 0.3);
    assert_eq!(scene.settings().seed, before.seed);

    assert_eq!(scene.remove(2), Ok(()));
    assert_eq!((scene.objects().len(), scene.power()), (0, 0.0));
    assert_eq!(scene.settings().source_x, 0.3);
    assert_eq!(scene.add(&[SOURCE]), Ok(1));
    assert_eq!(value(&scene, 0, "x"), Some(Value::Number(0.3)));
}

#[test]
fn a_source_has_the_surface_of_its_solid() {
    let mut scene = Scene::default();
    assert_eq!(scene.add(&[SOLID, ("id", number(9.0))]), Ok(9));
    let on_solid = [
        SOURCE,
        ("shape", Input::Text("solid")),
        ("solid", number(9.0)),
    ];
    assert_eq!(scene.add(&on_solid), Ok(2));
    let id = |scene: &Scene| {
        let sources: Vec<_> = scene.sources().collect();
        let of = |source| scene.solid_of(source).is_some();
        sources
            .into_iter()
            .map(|source| of(source))
            .collect::<Vec<_>>()
    };
    assert_eq!(id(&scene), [false, true]);
    assert_eq!(value(&scene, 2, "solid"), Some(Value::Integer(9)));
    // The next source becomes the first, on its solid.
    assert_eq!(scene.remove(1), Ok(()));
    assert_eq!(scene.settings().source_solid, 9);
    assert_eq!(id(&scene), [true]);
    // A source and an id without an object have no surface.
    for other in [0.0, 2.0, 1e6] {
        assert_eq!(scene.change(2, &[("solid", number(other))]), Ok(()));
        assert_eq!(id(&scene), [false]);
    }
    for wrong in [-1.0, 0.5, 1e6 + 1.0] {
        assert!(scene.change(2, &[("solid", number(wrong))]).is_err());
    }
}

#[test]
fn an_error_names_object_property_value_and_range_and_changes_nothing() {
    let mut scene = Scene::default();
    let before = scene.clone();
    let text = |text| Input::Text(text);
    let cases: &[(&Fields<'_>, &str)] = &[
        (
            &[],
            "objects[1].kind = \"undefined\" is refused: it must be source or solid",
        ),
        (
            &[("kind", text("stone"))],
            "objects[1].kind = \"stone\" is refused: it must be source or solid",
        ),
        (
            &[SOURCE, ("power", number(700.0))],
            "objects[1].power = 700 is refused: it must be a number from 0 to 600 kW/m",
        ),
        (
            &[SOURCE, ("pwer", number(7.0))],
            "objects[1].property = \"pwer\" is refused: it must be one of name, enabled, shape, solid, x, y, angle, width, power, rate, \
             speed, spread, noise, temperature, oxygen, birth_temperature, life_min, life_max, taper",
        ),
        (
            &[SOLID, ("width", number(0.0))],
            "objects[1].width = 0 is refused: it must be a number from 0.002 to 10 m",
        ),
        (
            &[SOLID, ("material", text("straw"))],
            "objects[1].material = \"straw\" is refused: it must be one of stone, wood, iron, brick, \
             coal, wax, glass, none",
        ),
        (
            &[SOLID, ("power", number(7.0))],
            "objects[1].property = \"power\" is refused: it must be one of name, enabled, shape, x, y, angle, \
             width, height, corner, points, mask, material, front, thermal, temperature, \
             heat_capacity, fuel, load, moisture, motion, sway, heading, period, spin, density, hangs_from, \
             friction, restitution",
        ),
        (
            &[SOURCE, ("id", number(1.0))],
            "objects[1].id = 1 is refused: it must be a whole number from 1 to 1000000 that no other \
             object has",
        ),
    ];
    for (fields, expected) in cases {
        assert_eq!(&words(scene.add(fields)), expected);
        assert_eq!(scene, before);
    }
    let refused = words(scene.change(1, &[("x", number(9.0)), ("id", text("b"))]));
    assert_eq!(refused.lines().count(), 2, "{refused}");
    assert_eq!(
        words(scene.remove(7)),
        "id = 7 is refused: it must be the id of an object"
    );
    assert_eq!(scene, before);
}

#[test]
fn the_number_of_objects_is_limited() {
    let mut scene = Scene::default();
    while scene.objects().len() < MAX_OBJECTS {
        assert!(scene.add(&[SOURCE]).is_ok());
    }
    let refused = words(scene.add(&[SOURCE]));
    assert_eq!(
        refused,
        "objects = 65 sources is refused: it must be at most 64 sources"
    );
    while scene.solids().count() < MAX_OBJECTS {
        assert!(scene.add(&[SOLID]).is_ok());
    }
    assert_eq!(
        words(scene.add(&[SOLID])),
        "objects = 65 solids is refused: it must be at most 64 solids"
    );
    let ids = ids(&scene);
    assert!((1..ids.len()).all(|at| !ids[..at].contains(&ids[at])));
}

#[test]
fn a_scene_with_other_ids_is_the_same_scene() {
    let mut scene = Scene::default();
    let surface = |solid: f64| {
        [
            SOURCE,
            ("shape", Input::Text("solid")),
            ("solid", number(solid)),
        ]
    };
    assert_eq!(scene.add(&[SOLID]), Ok(2));
    assert_eq!(scene.change(1, &surface(2.0)), Ok(()));
    assert_eq!(scene.add(&surface(2.0)), Ok(3));
    assert_eq!(scene.add(&[SOLID, ("hangs_from", number(2.0))]), Ok(4));
    let before = scene.clone();
    scene.renumber(&|id| id + 7);
    assert_eq!(ids(&scene), [8, 9, 10, 11]);
    let hang = scene.solids().map(|solid| solid.hangs_from);
    assert!(hang.eq([0, 9]));
    assert!(
        scene
            .sources()
            .all(|source| scene.solid_of(source).is_some())
    );
    scene.renumber(&|id| id - 7);
    assert_eq!(scene, before);
}

#[test]
fn a_solid_has_properties_that_are_no_settings() {
    let mut scene = Scene::default();
    let settings = scene.settings().clone();
    let fields = [SOLID, ("x", number(0.3)), ("shape", Input::Text("box"))];
    assert_eq!(scene.add(&fields), Ok(2));
    assert_eq!(scene.add(&[SOURCE]), Ok(3));
    assert_eq!(scene.settings(), &settings);
    assert_eq!(value(&scene, 1, "shape"), Some(Value::Choice("box")));
    assert_eq!(value(&scene, 1, "height"), Some(Value::Number(0.1)));
    assert_eq!(
        scene.change(2, &[("x", number(-0.1)), ("angle", number(30.0))]),
        Ok(())
    );
    let solids: Vec<_> = scene.solids().map(|solid| (solid.x, solid.angle)).collect();
    assert_eq!(solids, [(-0.1, 30.0)]);
    assert_eq!(scene.remove(1), Ok(()));
    assert_eq!(ids(&scene), [2, 3]);
    assert_eq!(scene.sources().count(), 1);
    let first = scene.objects().filter(Object::is_first_source);
    assert_eq!(first.map(|object| object.id).collect::<Vec<_>>(), [3]);
    assert_eq!(scene.remove(2), Ok(()));
    assert_eq!(scene.solids().count(), 0);
}

#[test]
fn solids_change_no_source() {
    let mut scene = Scene::default();
    let mut plain = scene.clone();
    assert!(scene.add(&[SOLID]).is_ok());
    for scene in [&mut scene, &mut plain] {
        assert!(scene.add(&[SOURCE, ("x", number(0.3))]).is_ok());
    }
    assert!(scene.sources().eq(plain.sources()));
}

#[test]
fn a_cleared_scene_keeps_the_values_of_its_source() {
    let mut scene = Scene::default();
    assert_eq!(scene.change(1, &[("x", number(-0.3))]), Ok(()));
    assert_eq!(scene.add(&[SOURCE, ("id", number(7.0))]), Ok(7));
    scene.clear();
    assert_eq!(scene.objects().len(), 0);
    assert_eq!(scene.settings().source_x, -0.3);
    assert_eq!(scene.add(&[("power", number(20.0)), SOURCE]), Ok(1));
    assert_eq!(scene.settings().fuel_power, 20.0);
}

#[test]
fn a_parameter_that_is_not_a_property_is_the_same_for_every_source() {
    let of_sources = |id: &str| Kind::SOURCE.properties().any(|property| property.id == id);
    let mut scene = Scene::default();
    assert!(scene.add(&[SOURCE]).is_ok());
    let sources: Vec<&Parameters> = scene.sources().collect();
    for param in PARAMETERS {
        let same = param.get(sources[0]) == param.get(sources[1]);
        assert!(
            same || param.id == "seed" || of_sources(param.id),
            "{}",
            param.id
        );
    }
}

#[test]
fn outlines_are_refused_with_their_form_and_masks_share_a_number_of_pixels() {
    let mut scene = Scene::default();
    let text = Input::Text;
    assert_eq!(
        words(scene.add(&[SOLID, ("points", text("0,0 1"))])),
        "objects[1].points = \"0,0 1\" is refused: it must be 2 to 256 pairs of numbers from -10 to \
         10 m, such as \"0,0.1 0.2,-0.1\""
    );
    assert_eq!(
        words(scene.add(&[SOLID, ("mask", number(7.0))])),
        "objects[1].mask = 7 is refused: it must be the text of a mask of at most 256 × 256 pixels \
         that is opaque somewhere, as hearth-fire/mask makes it"
    );
    let largest = format!("256x256:{}", "_".repeat(16));
    for _ in 0..4 {
        assert!(scene.add(&[SOLID, ("mask", text(&largest))]).is_ok());
    }
    assert!(scene.add(&[SOLID]).is_ok());
    let id = scene.objects().last().map_or(0, |last| last.id);
    let before = scene.clone();
    assert_eq!(
        words(scene.change(id, &[("mask", text("1x1:P"))])),
        "objects[5].mask = 262145 is refused: it must be smaller: all masks of a scene have at most \
         262144 pixels"
    );
    assert_eq!(scene, before);
}

#[test]
fn a_moved_solid_keeps_its_field_and_another_outline_changes_it() {
    let mut scene = Scene::default();
    let points = ("points", Input::Text("0,0 0.3,0.1"));
    let added = scene.add(&[SOLID, ("shape", Input::Text("stroke")), points]);
    assert_eq!(added, Ok(2));
    let field = |scene: &Scene| {
        let surface = scene.surfaces().next().map(|(.., surface)| surface.clone());
        surface.and_then(|surface| surface.field).expect("a field")
    };
    let first = field(&scene);
    for (name, input, kept) in [
        ("x", number(0.2), true),
        ("angle", number(30.0), true),
        ("material", Input::Text("iron"), true),
        ("height", number(0.05), false),
    ] {
        assert_eq!(scene.change(2, &[(name, input)]), Ok(()));
        assert_eq!(
            std::sync::Arc::ptr_eq(&field(&scene), &first),
            kept,
            "{name}"
        );
    }
    assert_eq!(scene.change(2, &[("shape", Input::Text("box"))]), Ok(()));
    assert!(
        scene
            .surfaces()
            .all(|(.., surface)| surface.field.is_none())
    );
}
