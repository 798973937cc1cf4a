//! Children of the element: a list of objects beside those of the page.

use crate::harness::{Sent, after, imported, number, object, sent, set, text};
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, export, whole};

/// A child of the list: its number, its kind, what it states and what it states anew.
struct Child(
    u32,
    &'static str,
    &'static [(&'static str, &'static str)],
    &'static [&'static str],
);

/// The list as the element sends it: a new child states everything anew.
fn list(settings: &Settings, children: &[Child]) -> Vec<Untrusted> {
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
        let values = values.map(|(name, value)| Untrusted::field_of(name, text(value)));
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
fn hidden(settings: &Settings, children: &[Child]) -> Vec<Untrusted> {
    let mut all = list(settings, children);
    for child in &mut all {
        if let Untrusted::Object(fields) = child {
            fields[2].1 = Untrusted::Null;
        }
    }
    all
}

/// The settings with these children, none of whose values is refused.
fn with(settings: &Settings, children: &[Child]) -> Settings {
    let mut errors = Vec::new();
    let composed = settings.with_children(&list(settings, children), &mut errors);
    assert_eq!(errors, []);
    composed
}

/// Each object as its id, its kind and these properties.
fn objects(settings: &Settings, names: &[&str]) -> Vec<String> {
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

fn file(settings: &Settings, config: &Untrusted) -> Settings {
    match settings.after_file(config) {
        Ok(after) => after,
        Err(errors) => panic!("{config:?} is refused: {errors:?}"),
    }
}

fn change(settings: &Settings, id: u32, values: &Sent) -> Settings {
    after(settings, Change::ChangeObject(id, values))
}

const SOURCE: Child = Child(1001, "source", &[("x", "0.2"), ("power", "80")], &[]);
const SECOND: Child = Child(1002, "source", &[("x", "-0.2")], &[]);
const SOLID: Child = Child(1003, "solid", &[("x", "0.3")], &[]);

#[test]
fn a_child_is_an_object_with_its_number_and_the_properties_that_it_states() {
    const CLASSIC: Child = Child(1002, "source", &[("birth_temperature", "1500")], &[]);
    let settings = with(&Settings::default(), &[SOURCE, CLASSIC, SOLID]);
    assert_eq!(
        objects(&settings, &["x", "power", "width"]),
        [
            "1001 source 0.2 80 0.4",
            "1002 source 0 220 0.4",
            "1003 solid 0.3 none 0.2"
        ]
    );
    // What the model has no use for applies with another one.
    let classic = set(&settings, "model", text("classic"));
    assert_eq!(
        objects(&classic, &["birth_temperature"])[1],
        "1002 source 1500"
    );
}

#[test]
fn the_first_source_of_the_page_leaves_its_place_and_its_values_to_the_first_child() {
    let candle = after(&Settings::default(), Change::Preset("candle"));
    let page = after(
        &candle,
        Change::State(&sent([("source_width", number(0.1))])),
    );
    let power = candle
        .scene()
        .get("fuel_power")
        .map(|power| power.to_string());
    let power = power.unwrap_or_default();
    let sources = |settings: &Settings| {
        let all = objects(settings, &["x", "power", "width"]);
        let is_source = |object: &String| object.contains("source");
        all.into_iter().filter(is_source).collect::<Vec<_>>()
    };
    let both = with(&page, &[SOURCE, SECOND]);
    assert_eq!(
        sources(&both),
        ["1001 source 0.2 80 0.1", "1002 source -0.2 220 0.4"]
    );
    // The second one follows the first one, in either order; the page has its source again without both.
    let second = with(&both, &[SECOND]);
    assert_eq!(sources(&second), [format!("1002 source -0.2 {power} 0.1")]);
    assert_eq!(
        sources(&with(&both, &[SECOND, SOURCE]))[0],
        format!("1002 source -0.2 {power} 0.1")
    );
    for settings in [&both, &second] {
        assert_eq!(whole(&with(settings, &[])), whole(&page));
    }
    // What the page states of another property applies, and so does what it states of the same one without the child.
    let stated = sent([("source_oxygen", number(0.1)), ("fuel_power", number(80.0))]);
    let stated = after(&both, Change::State(&stated));
    assert_eq!(
        objects(&stated, &["oxygen", "power"])[0],
        "1001 source 0.1 80"
    );
    let left = with(&stated, &[]).scene().get("fuel_power");
    assert_eq!(left.and_then(|power| power.as_number()), Some(80.0));
}

#[test]
fn what_a_child_states_anew_wins_and_what_a_call_sets_stays() {
    let of = |changed| [Child(1001, "solid", &[("x", "0.1"), ("y", "0.8")], changed)];
    let settings = with(&Settings::default(), &of(&[]));
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
        assert_eq!(objects(&with(&called, &of(changed)), &["x", "y"])[1], found);
    }
    let fewer = Child(1001, "solid", &[], &["x", "y"]);
    assert_eq!(
        objects(&with(&called, &[fewer]), &["x", "y"])[1],
        "1001 solid 0 0.5"
    );
    // An id of a parameter names the child that is the first source.
    let source = with(&Settings::default(), &[SOURCE]);
    let source = set(&source, "fuel_power", number(80.0));
    let unstated = Child(1001, "source", &[("x", "0.2")], &["x"]);
    assert_eq!(
        objects(&with(&source, &[unstated]), &["power"]),
        ["1001 source 80"]
    );
}

#[test]
fn what_a_call_removes_stays_away_until_the_child_states_something() {
    let of = |changed| [Child(1001, "solid", &[("y", "0.8")], changed)];
    let removed = after(
        &with(&Settings::default(), &of(&[])),
        Change::RemoveObject(1001),
    );
    assert_eq!(objects(&with(&removed, &of(&[])), &[]), ["1 source"]);
    assert_eq!(
        objects(&with(&removed, &of(&["y"])), &["y"])[1],
        "1001 solid 0.8"
    );
    // The source of the page goes with the child that has its place, and the next one burns.
    let two = after(
        &Settings::default(),
        Change::AddObject(&sent([("kind", text("source"))])),
    );
    let removed = after(&with(&two, &[SOURCE]), Change::RemoveObject(1001));
    assert_eq!(objects(&removed, &[]), ["2 source"]);
    assert_eq!(objects(&with(&removed, &[]), &[]), ["2 source"]);
    let none = after(
        &Settings::default(),
        Change::Set(&sent([("objects", Untrusted::List(vec![]))])),
    );
    assert_eq!(
        objects(&with(&none, &[SOURCE]), &["x"]),
        ["1001 source 0.2"]
    );
}

#[test]
fn a_source_that_a_call_adds_burns_beside_a_child() {
    let none = sent([("objects", Untrusted::List(Vec::new()))]);
    let page = with(
        &after(&Settings::default(), Change::State(&none)),
        &[SOURCE],
    );
    let added = sent([("kind", text("source")), ("x", number(0.3))]);
    let two = after(&page, Change::AddObject(&added));
    let places = |settings: &Settings| {
        let all = settings
            .scene()
            .objects()
            .filter_map(|object| Some(object.source()?.x));
        all.collect::<Vec<_>>()
    };
    assert_eq!(places(&two), [0.2, 0.3]);
    assert_eq!(places(&file(&two, &export(&two))), [0.2, 0.3]);
    // It alone burns on without the child, and beside what the child states anew.
    assert_eq!(places(&with(&two, &[])), [0.3]);
    let moved = Child(1001, "source", &[("x", "0.1")], &["x"]);
    assert_eq!(places(&with(&two, &[moved])), [0.1, 0.3]);
    let other = after(&two, Change::Preset("default"));
    assert_eq!(places(&other), [0.2]);
}

#[test]
fn objects_of_the_page_come_before_those_of_children_in_the_order_of_the_document() {
    let page = with(&Settings::default(), &[SOLID, SECOND]);
    let page = after(&page, Change::AddObject(&sent([("kind", text("solid"))])));
    for (children, found) in [
        (
            vec![SECOND, SOLID],
            vec!["1002 source", "2 solid", "1003 solid"],
        ),
        (vec![SOLID], vec!["1 source", "2 solid", "1003 solid"]),
        (vec![], vec!["1 source", "2 solid"]),
    ] {
        assert_eq!(objects(&with(&page, &children), &[]), found);
    }
}

#[test]
fn other_settings_keep_the_objects_of_children() {
    let settings = with(&Settings::default(), &[SOURCE, SOLID]);
    let settings = change(&settings, 1003, &sent([("y", number(1.1))]));
    let candle = after(&settings, Change::Preset("candle"));
    let solids = Untrusted::List(vec![object([("kind", text("solid"))])]);
    let solids = object([("objects", solids)]);
    let none = sent([("objects", Untrusted::List(Vec::new()))]);
    for (name, other, count) in [
        ("candle", &candle, 4),
        ("file", &file(&candle, &object([])), 2),
        ("solids", &file(&candle, &solids), 3),
        ("attribute", &after(&settings, Change::State(&none)), 2),
    ] {
        let all = objects(other, &["x", "y", "power"]);
        assert_eq!(all.len(), count, "{name}: {all:?}");
        let source =
            |object: &String| object.starts_with("1001 source 0.2 ") && object.ends_with(" 80");
        assert!(all.iter().any(source), "{name}: {all:?}");
        assert!(
            all.contains(&"1003 solid 0.3 1.1 none".to_owned()),
            "{name}: {all:?}"
        );
    }
    // The source of the new settings returns with the last child.
    let bare = after(&Settings::default(), Change::Preset("candle"));
    assert_eq!(whole(&with(&candle, &[])), whole(&bare));
}

#[test]
fn settings_of_the_same_page_hold_the_objects_of_its_children_once() {
    let page = with(&Settings::default(), &[SOURCE, SOLID]);
    let moved = change(&page, 1003, &sent([("x", number(-0.4))]));
    let moved = set(&moved, "fuel_power", number(90.0));
    // A link that is opened before the children come, and a file that is opened beside them.
    let link = with(&imported(&export(&moved)), &[SOURCE, SOLID]);
    for same in [&link, &file(&page, &export(&moved))] {
        assert_eq!(same.scene(), moved.scene());
        // The source of the file returns without the children.
        assert_eq!(objects(&with(same, &[]), &["power"]).len(), 1);
    }
    assert_eq!(Settings::of_whole(&whole(&moved)), Ok(moved));
}

#[test]
fn a_child_whose_number_another_object_has_is_refused() {
    let taken = sent([("kind", text("source")), ("id", number(1003.0))]);
    let taken = after(&Settings::default(), Change::AddObject(&taken));
    let mut errors = Vec::new();
    let settings = taken.with_children(&list(&taken, &[SOLID]), &mut errors);
    assert_eq!(errors.len(), 1);
    assert_eq!(errors[0].id, "children[0].id");
    assert_eq!(settings.scene(), taken.scene());
    let free = after(&settings, Change::RemoveObject(1003));
    assert_eq!(objects(&free, &["x"]), ["1 source 0", "1003 solid 0.3"]);
}

#[test]
fn a_child_without_values_has_no_object_now() {
    let page = Settings::default();
    let shown = || {
        [
            Child(1001, "source", &[("x", "0.2")], &["x"]),
            Child(1003, "solid", &[], &["x"]),
        ]
    };
    let both = with(&page, &shown());
    for settings in [&page, &both] {
        let gone = settings.with_children(&hidden(settings, &shown()), &mut Vec::new());
        assert_eq!(objects(&gone, &[]), [""; 0]);
        assert_eq!(
            objects(&with(&gone, &shown()), &["x"]),
            objects(&both, &["x"])
        );
        assert_eq!(whole(&with(&gone, &[])), whole(&page));
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
        Child(1002, "source", &[("power", "3500"), ("x", "0.2")], &[]),
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
            ("children[1].power", Some((0.0, 3000.0))),
            ("children[2].kind", None)
        ]
    );
    assert_eq!(
        objects(&settings, &["x", "y", "width", "power"]),
        [
            "1002 source 0.2 0.25 0.4 220",
            "1001 solid 0.1 0.7 0.2 none"
        ]
    );
    let iron = [("material", "iron"), ("width", "0")].as_slice();
    let iron = [Child(1001, "solid", iron, &["material", "width"])];
    errors.clear();
    let changed = settings.with_children(&list(&settings, &iron), &mut errors);
    assert_eq!(errors.len(), 1);
    assert_eq!(
        objects(&changed, &["material", "width"])[1],
        "1001 solid iron 0.2"
    );
}

#[test]
fn a_child_for_which_there_is_no_room_gets_its_object_when_there_is() {
    let all: Vec<Child> = (1001..1066)
        .map(|number| Child(number, "solid", &[], &[]))
        .collect();
    let mut errors = Vec::new();
    let full = Settings::default().with_children(&list(&Settings::default(), &all), &mut errors);
    assert_eq!(full.scene().objects().len(), 65);
    assert_eq!(errors.len(), 1);
    assert_eq!(errors[0].id, "children[64].objects");
    assert!(
        errors[0].message.contains("must be at most 64 solids"),
        "{errors:?}"
    );
    let room = after(&full, Change::RemoveObject(1002));
    assert_eq!(room.scene().ids().last(), Some(1065));
    assert_eq!(with(&full, &all[1..]).scene().ids().last(), Some(1065));
}
