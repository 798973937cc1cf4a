//! Objects that no page should make: each is an error and the scene stays as it was, or a
//! fire burns on with no gas inside.

use std::fmt::Write as _;

use hearth_core::params::Input;
use hearth_core::random::Random;
use hearth_core::scene::KINDS;
use hearth_core::{Scene, Simulation};
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, objects};
use hearth_tests::fires::set_in_model;
use hearth_tests::sweep::crowd::gas_inside;

/// Longest refusal in bytes.
const LONGEST: usize = 600;
/// Numbers that no property of an object accepts.
const NUMBERS: [f64; 5] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300];
/// Most points of an outline.
const POINTS: usize = 256;

type Named<'a> = (&'a str, Input<'a>);

fn text(name: &'static str, value: &'static str) -> Named<'static> {
    (name, Input::Text(value))
}

fn number(name: &'static str, value: f64) -> Named<'static> {
    (name, Input::Number(value))
}

/// The same fields as a page sends them.
fn sent(fields: &[Named<'_>]) -> Vec<(String, Untrusted)> {
    let fields = fields.iter();
    fields
        .map(|&(name, input)| {
            let value = match input {
                Input::Number(x) => Untrusted::Number(x),
                Input::Flag(on) => Untrusted::Flag(on),
                Input::Text(text) => Untrusted::Text(text.into()),
                Input::Default => Untrusted::Null,
            };
            (name.to_owned(), value)
        })
        .collect()
}

/// The library and the bindings refuse these fields of a new object, or of the object with that
/// id, with a message; the scene stays.
fn assert_refused(scene: &Scene, id: Option<u32>, fields: &[Named<'_>]) {
    let mut changed = scene.clone();
    let refused = match id {
        None => changed.add(fields).err(),
        Some(id) => changed.change(id, fields).err(),
    };
    assert_eq!(&changed, scene, "{fields:?} change the scene");
    let words: Vec<String> = refused.iter().flatten().map(ToString::to_string).collect();
    assert!(!words.is_empty(), "{fields:?} are accepted");
    let sent = sent(fields);
    let list = [("objects".to_owned(), objects(scene))];
    let settings = Settings::default()
        .after(&Change::Set(&list))
        .unwrap_or_else(|errors| panic!("{errors:?}"));
    let change = match id {
        None => Change::AddObject(&sent),
        Some(id) => Change::ChangeObject(id, &sent),
    };
    let refused = settings.after(&change).err();
    let more = refused.iter().flatten().map(|error| error.message.clone());
    let more: Vec<String> = more.collect();
    assert!(!more.is_empty(), "{fields:?} are accepted by the bindings");
    for words in words.iter().chain(&more) {
        let is_message = (10..LONGEST).contains(&words.len()) && words.contains(' ');
        assert!(is_message, "{fields:?}: {words:?}");
    }
}

#[test]
fn every_property_refuses_what_is_no_value_of_it() {
    let mut scene = Scene::default();
    assert_eq!(scene.add(&[text("kind", "solid")]), Ok(2));
    for (kind, id) in KINDS.iter().zip(1..) {
        for property in kind.properties() {
            let all = NUMBERS.map(Input::Number).into_iter();
            // An empty text is a flag, as an attribute without a value is.
            let long = "n".repeat(65);
            // Words are a name, which is a line.
            let texts = match property.is_common() {
                true => ["\0", "two\nlines", &long],
                false => ["\0", "NaN", "no such choice"],
            };
            let texts = texts.map(Input::Text);
            for input in all.chain(texts) {
                let fields = [(property.name, input)];
                assert_refused(&scene, Some(id), &fields);
                let kind = ("kind", Input::Text(kind.name));
                assert_refused(&scene, None, &[kind, fields[0]]);
            }
        }
    }
}

/// Points of an outline as a function of their index.
fn outline(at: impl Fn(usize) -> [f64; 2]) -> String {
    let mut text = String::new();
    for [x, y] in (0..POINTS).map(at) {
        let _ = write!(text, "{x:.4},{y:.4} ");
    }
    text
}

#[test]
fn a_fire_with_any_valid_object_stays_finite() {
    let chance = |seed: u32, size: f32| {
        let mut random = Random::new(seed);
        let all: Vec<[f64; 2]> = (0..POINTS)
            .map(|_| [0, 1].map(|_| f64::from(random.between(-size, size))))
            .collect();
        outline(|i| all[i])
    };
    let (crossing, huge) = (chance(1, 0.3), chance(2, 10.0));
    let (equal, collinear) = (outline(|_| [0.1, 0.1]), outline(|i| [i as f64 * 1e-3, 0.0]));
    let twice = outline(|i| [[0.0, 0.0], [0.2, 0.0], [0.1, 0.2]][i / 2 % 3]);
    let opaque = format!("256x256:{}", "_".repeat(16));
    let dots = format!("128x128:{}", "PA".repeat(8192));
    let mut objects: Vec<Vec<Named<'_>>> = Vec::new();
    for shape in ["polygon", "stroke"] {
        for points in [&crossing, &huge, &equal, &collinear, &twice] {
            objects.push(vec![text("shape", shape), ("points", Input::Text(points))]);
        }
    }
    for mask in [&opaque, &dots, "1x1:P"] {
        for size in [0.002, 0.3, 10.0] {
            let sizes = [number("width", size), number("height", 0.3)];
            let mask = [text("shape", "mask"), ("mask", Input::Text(mask))];
            objects.push([mask, sizes].concat());
        }
    }
    for shape in ["circle", "box", "line"] {
        for (width, height) in [(10.0, 10.0), (0.002, 0.002), (10.0, 0.002), (0.002, 10.0)] {
            let corner = number("corner", 5.0);
            let sizes = [number("width", width), number("height", height), corner];
            objects.push([&[text("shape", shape)], &sizes[..]].concat());
        }
    }
    for (model, edges) in [
        ("combustion", "periodic"),
        ("combustion", "open"),
        ("classic", "open"),
    ] {
        for object in &objects {
            let mut scene = Scene::default();
            for (id, name) in [("model", model), ("edges", edges)] {
                set_in_model(&mut scene, id, name);
            }
            for (id, value) in [
                ("max_particles", 400.0),
                ("particles", 400.0),
                ("spacing", 0.06),
            ] {
                set_in_model(&mut scene, id, value);
            }
            let place = [text("kind", "solid"), text("thermal", "conducting")];
            let first = [&place, &object[..]].concat();
            // Over the source, and another that closes on it.
            assert_eq!(scene.add(&first), Ok(2), "{object:?}");
            assert_eq!(
                scene.add(&[&first, &[number("x", 0.3)][..]].concat()),
                Ok(3)
            );
            // One hangs from that which moves, and one from that.
            for (x, from) in [(-0.3, 3.0), (-0.5, 4.0)] {
                let hangs = [text("motion", "free"), number("hangs_from", from)];
                let fields = [&first[..], &hangs, &[number("x", x)]].concat();
                assert!(scene.add(&fields).is_ok(), "{object:?}");
            }
            let mut fire = Simulation::new(scene.clone());
            for step in 0..24 {
                fire.step();
                if step % 4 == 3 {
                    let x = number("x", 0.3 - 0.015 * f64::from(step));
                    let angle = number("angle", f64::from(10 * step));
                    assert_eq!(scene.change(3, &[x, angle]), Ok(()));
                    fire.set_scene(scene.clone());
                }
                assert_eq!(gas_inside(&fire), None, "{model} {edges}: {object:?}");
                assert!(fire.time().is_finite() && fire.power().is_none_or(f32::is_finite));
                assert!(fire.positions().into_iter().all(|at| at.is_finite()));
                assert!(fire.temperatures().into_iter().all(f32::is_finite));
                assert!(fire.solid_temperatures().all(|solid| solid.1.is_finite()));
                for body in fire.free_solids() {
                    assert!(
                        body.place.is_finite() && body.velocity.is_finite(),
                        "{body:?}"
                    );
                }
            }
        }
    }
}
