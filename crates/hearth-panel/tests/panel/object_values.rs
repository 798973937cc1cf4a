//! Values of objects: the ranges of their sliders, requests that are pending, and reports of the fire.

use hearth_core::params::{Input, Model, Param, Parameters, Value};
use hearth_core::scene::{Object, Scene};
use hearth_panel::state::fire::{Entry, Fire};
use hearth_panel::state::{Fields, Subject};

use crate::harness::{Harness, TALL, models};
use crate::objects::{number, select, solid, source, text, with_objects};

/// A panel with the solid 3 selected, and the row of its coordinate x.
fn with_coordinate() -> (Harness, Option<Subject>) {
    let mut harness = with_objects(Model::Combustion, TALL);
    let mut rows = select(&mut harness, 3).into_iter();
    let coordinate = rows.find(|row| row.id == "solid:x");
    (harness, coordinate)
}

#[test]
fn a_slider_spans_the_domain_and_a_value_beyond_it() {
    let (mut harness, coordinate) = with_coordinate();
    let coordinate = coordinate.expect("a coordinate");
    let fire = &mut harness.panel.state.fire;
    assert_eq!(fire.slider_range(coordinate), (-1.8, 1.8));
    assert_eq!(fire.range_of(coordinate), (-10.0, 10.0));
    assert!(fire.set(coordinate, Entry::Number(-4.0).input()).is_ok());
    assert_eq!(fire.slider_range(coordinate), (-4.0, 1.8));
}

#[test]
fn an_older_list_does_not_move_a_dragged_slider() {
    let (mut harness, coordinate) = with_coordinate();
    let coordinate = coordinate.expect("a coordinate");
    let fire = &mut harness.panel.state.fire;
    let old = [source(1), solid(3, "line", "wood")];
    assert!(fire.set(coordinate, Entry::Number(0.4).input()).is_ok());
    fire.sent(coordinate);
    fire.sent(coordinate);
    fire.receive_objects(&old);
    assert_eq!(fire.value(coordinate), Value::Number(0.4));
    assert!(!fire.answered(coordinate));
    assert!(fire.answered(coordinate));
    fire.receive_objects(&old);
    assert_eq!(fire.value(coordinate), Value::Number(0.0));
    // The properties of the first source are parameters, which have requests of their own.
    let width = Param::find("source_width").expect("the table has it");
    assert!(fire.set(width, Entry::Number(0.3).input()).is_ok());
    fire.sent(width.into());
    fire.receive_objects(&old);
    assert_eq!(fire.value(width), Value::Number(0.3));
}

/// The fields of all objects of a scene, as a fire reports them.
fn report(scene: &Scene) -> Vec<Fields> {
    let fields = |object: Object<'_>| {
        let mut fields = vec![
            text("kind", object.kind.name),
            number("id", object.id.into()),
        ];
        for (name, _, value) in object.properties() {
            fields.push((name.to_owned(), value.into()));
        }
        fields
    };
    scene.objects().map(fields).collect()
}

#[test]
fn each_report_of_objects_gives_the_scene_that_it_describes() {
    let add = |scene: &mut Scene, fields: &[Fields]| {
        for fields in fields {
            let fields: Vec<_> = fields
                .iter()
                .map(|(name, entry)| (name.as_str(), entry.input()))
                .collect();
            assert!(scene.add(&fields).is_ok());
        }
    };
    let change = |scene: &mut Scene, id, name, value| {
        assert!(scene.change(id, &[(name, Input::Number(value))]).is_ok());
    };
    for model in models() {
        let mut fire = Fire::default();
        let mut reported = Scene::new(Parameters::new(model));
        let mut report_after = |what: &str, act: &mut dyn FnMut(&mut Scene)| {
            act(&mut reported);
            fire.objects.set_world(reported.world().clone());
            fire.receive_objects(&report(&reported));
            assert_eq!(fire.objects, reported, "{what}");
        };
        let stroke = |id| {
            let mut fields = solid(id, "stroke", "stone");
            fields.push(text("points", "-0.1,0 0,0.1 0.1,0"));
            fields
        };
        report_after("objects", &mut |scene| {
            add(
                scene,
                &[source(2), stroke(3), stroke(4), solid(5, "box", "none")],
            )
        });
        report_after("another stroke", &mut |scene| add(scene, &[stroke(6)]));
        report_after("a coordinate", &mut |scene| change(scene, 4, "x", 0.3));
        report_after("a thicker stroke", &mut |scene| {
            change(scene, 4, "height", 0.02)
        });
        report_after("a wider source", &mut |scene| {
            change(scene, 2, "width", 0.2)
        });
        report_after("a wider first source", &mut |scene| {
            change(scene, 1, "width", 0.3)
        });
        report_after("an object less", &mut |scene| {
            assert!(scene.remove(3).is_ok())
        });
        report_after("another first source", &mut |scene| {
            assert!(scene.remove(1).is_ok())
        });
        report_after("another order", &mut |scene| {
            let mut all = report(scene);
            all.reverse();
            scene.clear();
            add(scene, &all);
        });
        report_after("another kind of the same id", &mut |scene| {
            assert!(scene.remove(6).is_ok());
            add(scene, &[source(6)]);
        });
        report_after("nothing", &mut Scene::clear);
    }
}
