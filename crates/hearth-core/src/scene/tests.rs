use super::*;
use crate::Simulation;
use crate::params::{AnyValue, Model, Param, Value};

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

/// The defaults of a model, of few particles in the combustion model.
fn few(model: Model) -> Scene {
    let mut scene = Scene::of_model(model);
    if model == Model::Combustion {
        assert_eq!(scene.set("particles", 1500.0), Ok(()));
    }
    scene
}

#[test]
fn every_property_has_an_entry_and_one_name() {
    for kind in KINDS {
        let mut seen = Vec::new();
        for property in kind.properties() {
            assert!(property.entry().is_some(), "{}", property.id());
            let is_parameter = kind.name == "source" && !property.is_common();
            assert_eq!(
                is_parameter,
                Param::find(property.id()).is_some(),
                "{}",
                property.id()
            );
            assert!(!seen.contains(&property.id()), "{}", property.id());
            assert!(!seen.contains(&property.name), "{}", property.name);
            seen.extend([property.id(), property.name]);
        }
    }
}

#[test]
fn ids_of_properties_read_and_write_the_first_source() {
    for model in [Model::Classic, Model::Combustion] {
        let mut scene = Scene::of_model(model);
        assert_eq!(ids(&scene), [1]);
        assert_eq!(scene.add(&[SOURCE]), Ok(2));
        assert_eq!(scene.set("source_x", 0.2), Ok(()));
        assert_eq!(value(&scene, 0, "x"), Some(Value::Number(0.2)));
        assert_eq!(value(&scene, 1, "x"), Some(Value::Number(0.0)));
        assert_eq!(scene.change(1, &[("x", number(-0.1))]), Ok(()));
        assert_eq!(scene.get("source_x"), Some(Value::Number(-0.1)));
    }
    let mut none = Scene::default();
    none.clear();
    let empty = none.clone();
    let refused = none.set("fuel_power", 100.0);
    assert_eq!(
        refused.map_err(|error| error.to_string()),
        Err(
            "fuel_power = 100 is refused: it is a property of the first source, and there is none"
                .to_owned()
        )
    );
    assert_eq!(none, empty);
    assert_eq!(none.set("wind", 1.0), Ok(()));
}

#[test]
fn sources_have_separate_properties_and_one_world() {
    let mut scene = Scene::default();
    let added = scene.add(&[SOURCE, ("x", number(0.3)), ("power", number(50.0))]);
    assert_eq!(added, Ok(2));
    for (id, x) in [("fuel_power", 100.0), ("wind", 1.0), ("source_width", 0.2)] {
        assert_eq!(scene.set(id, x), Ok(()));
    }
    let powers: Vec<f32> = scene.sources().map(|source| source.power).collect();
    assert_eq!(powers, [100.0, 50.0]);
    assert_eq!(scene.power(), 150.0);
    assert!(scene.sources().all(|source| source.world.wind == 1.0));
    assert_eq!(value(&scene, 1, "width"), Some(Value::Number(0.4)));
    assert_eq!(value(&scene, 1, "rate"), None, "it is the classic model's");
}

#[test]
fn every_source_keeps_in_another_model_what_both_models_have() {
    let mut scene = Scene::default();
    let fields = [SOURCE, ("x", number(0.3)), ("power", number(50.0))];
    assert_eq!(scene.change(1, &fields), Ok(()));
    assert_eq!(scene.add(&fields), Ok(2));
    scene.set_world(Parameters::new(Model::Classic));
    let mut expected = Scene::of_model(Model::Classic);
    assert_eq!(expected.change(1, &[("x", number(0.3))]), Ok(()));
    assert_eq!(expected.add(&[SOURCE, ("x", number(0.3))]), Ok(2));
    assert_eq!(scene, expected);
    assert_eq!(
        words(scene.change(2, &[("power", number(50.0))])),
        "objects[1].power = 50 is refused: only the combustion model has it"
    );
}

#[test]
fn the_first_source_is_the_first_of_those_that_are_there() {
    let mut scene = Scene::default();
    assert_eq!(scene.add(&[SOURCE, ("x", number(0.3))]), Ok(2));
    let seeds = |scene: &Scene| {
        scene
            .sources()
            .map(|source| source.seed)
            .collect::<Vec<_>>()
    };
    let both = seeds(&scene);
    assert_ne!(both[0], both[1]);
    // Order alone decides which one is the first, and the seeds.
    scene.arrange(&[2, 1]);
    assert_eq!(scene.get("source_x"), Some(Value::Number(0.3)));
    assert_eq!(seeds(&scene), both);

    assert_eq!(scene.remove(2), Ok(()));
    assert_eq!(scene.get("source_x"), Some(Value::Number(0.0)));
    assert_eq!(seeds(&scene), both[..1]);
    // A new source has the defaults, not the values of a former one.
    assert_eq!(scene.set("source_x", 0.2), Ok(()));
    assert_eq!(scene.remove(1), Ok(()));
    assert_eq!((scene.objects().len(), scene.power()), (0, 0.0));
    assert_eq!(scene.add(&[SOURCE]), Ok(1));
    assert_eq!(scene, Scene::default());
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
        let sources = scene.sources();
        let are_on_solids = sources.map(|source| scene.solid_of(&source).is_some());
        are_on_solids.collect::<Vec<_>>()
    };
    assert_eq!(id(&scene), [false, true]);
    assert_eq!(value(&scene, 2, "solid"), Some(Value::Integer(9)));
    assert_eq!(scene.remove(1), Ok(()));
    assert_eq!(scene.get("source_solid"), Some(Value::Integer(9)));
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
            &[SOURCE, ("power", number(3500.0))],
            "objects[1].power = 3500 is refused: it must be a number from 0 to 3000 kW/m",
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
             coal, wax, glass, cloth, none",
        ),
        (
            &[SOLID, ("power", number(7.0))],
            "objects[1].property = \"power\" is refused: it must be one of name, enabled, shape, x, y, angle, \
             width, height, corner, points, mask, material, plane, thermal, temperature, \
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
fn a_solid_has_properties_that_are_no_parameters() {
    let mut scene = Scene::default();
    let settings = scene.world().clone();
    let fields = [SOLID, ("x", number(0.3)), ("shape", Input::Text("box"))];
    assert_eq!(scene.add(&fields), Ok(2));
    assert_eq!(scene.add(&[SOURCE]), Ok(3));
    assert_eq!(scene.world(), &settings);
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
    assert_eq!(scene.first_source_id(), Some(3));
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
    let values = |source: SceneSource<'_>| (source.seed, (*source).clone());
    assert!(scene.sources().map(values).eq(plain.sources().map(values)));
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
