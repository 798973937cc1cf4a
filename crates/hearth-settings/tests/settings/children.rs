//! Children of the element: a list laid over the objects of the settings.

use crate::harness::{Sent, after, imported, number, object, sent, set, text};
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, export, whole};

/// A child of the list: its number, its kind, what it states and what it states anew.
pub struct Child(
    pub u32,
    pub &'static str,
    pub &'static [(&'static str, &'static str)],
    pub &'static [&'static str],
);

/// The list as the element sends it: a new child states everything anew.
pub fn list(settings: &Settings, children: &[Child]) -> Vec<Untrusted> {
    let known = whole(settings);
    let all = children.iter().map(|Child(id, kind, values, changed)| {
        let mut known = known.field("children").list().iter();
        let is_known = known.any(|child| child.field("id") == &number(f64::from(*id)));
        let names = values.iter().map(|(name, _)| text(name));
        let changed = match is_known {
            true => changed.iter().map(|name| text(name)).collect(),
            false => names.collect(),
        };
        let values = values.iter();
        let values = values.map(|(name, value)| Untrusted::named(name, text(value)));
        object([
            ("id", number(f64::from(*id))),
            ("kind", text(kind)),
            ("values", Untrusted::Object(values.collect())),
            ("changed", Untrusted::List(changed)),
        ])
    });
    all.collect()
}

/// The list with children that have no object now.
pub fn hidden(settings: &Settings, children: &[Child]) -> Vec<Untrusted> {
    let mut all = list(settings, children);
    for child in &mut all {
        if let Untrusted::Object(fields) = child {
            fields[2].1 = Untrusted::Null;
        }
    }
    all
}

/// The settings with these children, none of whose values is refused.
pub fn laid(settings: &Settings, children: &[Child]) -> Settings {
    let mut errors = Vec::new();
    let laid = settings.with_children(&list(settings, children), &mut errors);
    assert_eq!(errors, []);
    laid
}

/// Each object as its id, its kind and these properties.
pub fn objects(settings: &Settings, names: &[&str]) -> Vec<String> {
    let all = settings.scene().objects().map(|object| {
        let mut words = vec![object.id.to_string(), object.kind.name.to_owned()];
        for name in names {
            let mut properties = object.properties();
            let found = properties.find(|(known, ..)| known == name);
            words.push(found.map_or("none".to_owned(), |(.., value)| format!("{value}")));
        }
        words.join(" ")
    });
    all.collect()
}

fn preset(settings: &Settings, name: &str) -> Settings {
    after(settings, Change::Preset(name))
}

pub fn file(settings: &Settings, config: &Untrusted) -> Settings {
    match settings.after_file(config) {
        Ok(after) => after,
        Err(errors) => panic!("{config:?} is refused: {errors:?}"),
    }
}

fn change(settings: &Settings, id: u32, values: &Sent) -> Settings {
    after(settings, Change::ChangeObject(id, values))
}

pub const SOURCE: Child = Child(1001, "source", &[("x", "0.2"), ("power", "80")], &[]);
const SOLID: Child = Child(1002, "solid", &[("x", "0.3")], &[]);

#[test]
fn a_child_is_an_object_with_the_properties_that_it_states() {
    let settings = laid(
        &Settings::default(),
        &[
            SOURCE,
            Child(
                1002,
                "source",
                &[("x", "-0.2"), ("birth_temperature", "1500")],
                &[],
            ),
            Child(
                1003,
                "solid",
                &[("shape", "box"), ("material", "iron")],
                &[],
            ),
        ],
    );
    assert_eq!(
        objects(&settings, &["x", "power", "width", "material"]),
        [
            "1 source 0.2 80 0.4 none",
            "1002 source -0.2 220 0.4 none",
            "1003 solid 0 none 0.2 iron"
        ]
    );
    let classic = set(&settings, "model", text("classic"));
    assert_eq!(
        objects(&classic, &["birth_temperature"])[1],
        "1002 source 1500"
    );
}

#[test]
fn the_first_source_replaces_that_of_the_settings_until_the_last_one_leaves() {
    let candle = after(&Settings::default(), Change::Preset("candle"));
    let page = set(&candle, "source_width", number(0.1));
    let bare = Child(1001, "source", &[("x", "0.2")], &["power"]);
    let second = Child(1002, "source", &[], &[]);
    let both = laid(&laid(&page, &[SOURCE]), &[SOURCE, second]);
    let sources = |settings: &Settings| {
        let all = objects(settings, &["x", "power", "width"]);
        all.into_iter()
            .filter(|object| object.contains("source"))
            .collect::<Vec<_>>()
    };
    assert_eq!(
        sources(&both),
        ["2 source 0.2 80 0.1", "1002 source 0 220 0.4"]
    );
    let power = page.parameters().fuel_power;
    let unstated = laid(&both, &[bare, Child(1002, "source", &[], &[])]);
    assert_eq!(sources(&unstated)[0], format!("2 source 0.2 {power} 0.1"));
    for settings in [&both, &unstated] {
        assert_eq!(whole(&laid(settings, &[])), whole(&page));
        // One after the other, in both orders.
        let second = laid(settings, &[Child(1002, "source", &[], &[])]);
        assert_eq!(sources(&second), [format!("2 source 0 {power} 0.1")]);
        assert_eq!(whole(&laid(&second, &[])), whole(&page));
        assert_eq!(whole(&laid(&laid(settings, &[SOURCE]), &[])), whole(&page));
    }
    // Another child takes over.
    let other = laid(&both, &[Child(1003, "source", &[("y", "0.5")], &[])]);
    assert_eq!(sources(&other)[0], format!("2 source 0 {power} 0.1"));
    assert_eq!(whole(&laid(&other, &[])), whole(&page));
    // What the page sets meanwhile of another property stays.
    let set = set(&laid(&page, &[SOURCE]), "source_oxygen", number(0.1));
    assert_eq!(laid(&set, &[]).parameters().source_oxygen, 0.1);
}

#[test]
fn a_fire_without_a_source_gets_that_of_its_child() {
    let empty = set(&Settings::default(), "objects", Untrusted::List(Vec::new()));
    let settings = laid(&empty, &[SOURCE]);
    assert_eq!(objects(&settings, &["x"]), ["1001 source 0.2"]);
    assert_eq!(objects(&laid(&settings, &[]), &[]), [""; 0]);
}

#[test]
fn what_a_child_states_anew_wins_and_what_a_call_sets_stays() {
    let of = |changed| [Child(1001, "solid", &[("x", "0.1"), ("y", "0.8")], changed)];
    let settings = laid(&Settings::default(), &of(&[]));
    let called = change(
        &settings,
        1001,
        &sent([("x", number(-0.2)), ("y", number(1.0))]),
    );
    for (changed, found) in [
        (&[] as &[&str], "1001 solid -0.2 1"),
        (&["x"], "1001 solid 0.1 1"),
        (&["x", "y"], "1001 solid 0.1 0.8"),
    ] {
        assert_eq!(objects(&laid(&called, &of(changed)), &["x", "y"])[1], found);
    }
    let fewer = Child(1001, "solid", &[], &["x", "y"]);
    assert_eq!(
        objects(&laid(&called, &[fewer]), &["x", "y"])[1],
        "1001 solid 0 0.5"
    );
    // What a call removes stays away until the child states something.
    let removed = after(&called, Change::RemoveObject(1001));
    assert_eq!(objects(&laid(&removed, &of(&[])), &[]), ["1 source"]);
    assert_eq!(
        objects(&laid(&removed, &of(&["y"])), &["x", "y"])[1],
        "1001 solid 0.1 0.8"
    );
    let source = laid(&Settings::default(), &[SOURCE]);
    let source = after(&source, Change::RemoveObject(1));
    assert_eq!(objects(&laid(&source, &[SOURCE]), &[]), [""; 0]);
    let again = Child(1001, "source", &[("x", "0.4")], &["x"]);
    assert_eq!(objects(&laid(&source, &[again]), &["x"]), ["1 source 0.4"]);
}

#[test]
fn objects_are_in_the_order_of_the_children_and_keep_their_ids() {
    let of = |number| Child(number, "solid", &[], &[]);
    let page = after(
        &laid(&Settings::default(), &[of(1001), of(1002)]),
        Change::AddObject(&sent([("kind", text("solid"))])),
    );
    for (children, found) in [
        (
            vec![1003, 1001, 1002],
            [
                "1 source",
                "1003 solid",
                "1001 solid",
                "2 solid",
                "1002 solid",
            ]
            .as_slice(),
        ),
        (
            vec![1002, 1001],
            &["1 source", "1002 solid", "1001 solid", "2 solid"],
        ),
        (vec![1002], &["1 source", "1002 solid", "2 solid"]),
        (vec![], &["1 source", "2 solid"]),
    ] {
        let children: Vec<_> = children.into_iter().map(of).collect();
        assert_eq!(objects(&laid(&page, &children), &[]), found);
    }
    // The parameters are the properties of the source that is first.
    let of = |number, values| Child(number, "source", values, &[]);
    let (near, far) = (|| of(1001, &[("x", "0.2")]), || of(1002, &[("x", "0.5")]));
    let sources = laid(&Settings::default(), &[near(), far()]);
    let turned = laid(&sources, &[far(), near()]);
    assert_eq!(
        [&sources, &turned].map(|settings| settings.parameters().source_x),
        [0.2, 0.5]
    );
    assert_eq!(laid(&turned, &[near(), far()]), sources);
}

#[test]
fn other_settings_keep_the_objects_of_children() {
    let none = Untrusted::List(Vec::new());
    for first in [
        Settings::default(),
        set(&Settings::default(), "objects", none.clone()),
    ] {
        let settings = laid(&first, &[SOURCE, SOLID]);
        let settings = change(&settings, 1002, &sent([("y", number(1.1))]));
        let wind = object([("values", object([("wind", number(1.0))]))]);
        let solids = object([(
            "objects",
            Untrusted::List(vec![object([("kind", text("solid"))])]),
        )]);
        let attribute = after(&settings, Change::State(&sent([("objects", none.clone())])));
        let candle = preset(&settings, "candle");
        for (name, other, count) in [
            ("candle", &candle, 4),
            ("default", &preset(&candle, "default"), 2),
            ("file", &file(&candle, &wind), 2),
            ("solids", &file(&candle, &solids), 3),
            ("attribute", &attribute, 2),
        ] {
            let all = objects(other, &["x", "y", "power", "width"]);
            assert_eq!(all.len(), count, "{name}: {all:?}");
            let source = all.iter().find(|object| object.contains("source"));
            let source = source.and_then(|object| object.split_once(' '));
            assert!(
                source.is_some_and(|(_, source)| {
                    let values: Vec<&str> = source.split(' ').collect();
                    [values[1], values[3]] == ["0.2", "80"]
                }),
                "{name}: {all:?}"
            );
            assert!(
                all.contains(&"1002 solid 0.3 1.1 none 0.2".to_owned()),
                "{name}: {all:?}"
            );
            // Nothing is laid twice.
            assert_eq!(
                laid(other, &[SOURCE, SOLID]).scene(),
                other.scene(),
                "{name}"
            );
        }
        // Settings that have the objects of children have them as they are.
        let moved = change(&settings, 1002, &sent([("x", number(-0.4))]));
        let back = file(&settings, &export(&moved));
        assert_eq!(objects(&back, &["x", "y"])[1], "1002 solid -0.4 1.1");
        // The source of the new settings returns with the last child.
        let bare = laid(&candle, &[]);
        assert_eq!(
            whole(&bare),
            whole(&after(&first, Change::Preset("candle")))
        );
    }
}

#[test]
fn settings_of_the_same_page_hold_the_objects_of_its_children_once() {
    let moved = change(
        &laid(&Settings::default(), &[SOLID]),
        1002,
        &sent([("x", number(0.1))]),
    );
    let again = laid(&imported(&export(&moved)), &[SOLID]);
    assert_eq!(objects(&again, &["x"]), ["1 source 0", "1002 solid 0.1"]);
    let back = Settings::with_children_of_file(&whole(&moved)).expect("whole settings");
    assert_eq!(back, moved);
    // An id that another object has is not that of the child.
    let taken = after(
        &Settings::default(),
        Change::AddObject(&sent([("kind", text("source")), ("id", number(1002.0))])),
    );
    let settings = laid(&taken, &[SOLID]);
    assert_eq!(
        objects(&settings, &["x"]),
        ["1 source 0", "1002 source 0", "2 solid 0.3"]
    );
    assert_eq!(laid(&settings, &[]).scene(), taken.scene());
}

#[test]
fn a_child_without_values_has_no_object_now() {
    let page = Settings::default();
    let shown = || {
        [
            Child(1001, "source", &[("x", "0.2")], &["x"]),
            Child(1002, "solid", &[], &["x"]),
        ]
    };
    let laid_both = laid(&page, &shown());
    for settings in [&page, &laid_both] {
        let gone = settings.with_children(&hidden(settings, &shown()), &mut Vec::new());
        assert_eq!(objects(&gone, &[]), [""; 0]);
        assert_eq!(
            objects(&laid(&gone, &shown()), &["x"]),
            objects(&laid_both, &["x"])
        );
        assert_eq!(whole(&laid(&gone, &[])), whole(&page));
    }
}

#[test]
fn what_is_refused_is_named_and_left_out() {
    let children = [
        Child(
            1001,
            "solid",
            &[("x", "0.1"), ("width", "0"), ("y", "0.7")],
            &[],
        ),
        Child(1002, "source", &[("power", "700"), ("x", "0.2")], &[]),
        Child(1003, "fluid", &[], &[]),
    ];
    let mut errors = Vec::new();
    let settings =
        Settings::default().with_children(&list(&Settings::default(), &children), &mut errors);
    let named: Vec<_> = errors
        .iter()
        .map(|error| (error.id.as_str(), error.range))
        .collect();
    assert_eq!(
        named,
        [
            ("children[0].width", Some((0.002, 10.0))),
            ("children[1].power", Some((0.0, 600.0))),
            ("children[2].kind", None)
        ]
    );
    assert_eq!(
        objects(&settings, &["x", "y", "width", "power"]),
        ["1001 solid 0.1 0.7 0.2 none", "1 source 0.2 0.25 0.4 220"]
    );
    let iron = [Child(
        1001,
        "solid",
        &[("material", "iron"), ("width", "0")],
        &["material", "width"],
    )];
    errors.clear();
    let changed = settings.with_children(&list(&settings, &iron), &mut errors);
    assert_eq!(errors.len(), 1);
    assert_eq!(
        objects(&changed, &["material", "width"])[0],
        "1001 solid iron 0.2"
    );
}
