//! The objects: the list, the buttons, the rows of the selected one, and the search.

use egui::Event;
use hearth_core::params::Model;
use hearth_core::scene::Kind;
use hearth_panel::state::fire::Entry;
use hearth_panel::state::objects::has_row;
use hearth_panel::state::{Command, Fields, OBJECTS, SEARCH, Subject};

use crate::harness::{Harness, PHONE, Size, TALL, models};

pub fn text(name: &str, value: &str) -> (String, Entry) {
    (name.to_owned(), Entry::Text(value.to_owned()))
}

pub fn number(name: &str, value: f64) -> (String, Entry) {
    (name.to_owned(), Entry::Number(value))
}

pub fn source(id: u32) -> Fields {
    vec![text("kind", "source"), number("id", f64::from(id))]
}

pub fn solid(id: u32, shape: &str, material: &str) -> Fields {
    vec![
        text("kind", "solid"),
        number("id", f64::from(id)),
        text("shape", shape),
        text("material", material),
    ]
}

/// A panel of a fire with two sources, a line and a box, which its scene has as well.
pub fn with_objects(model: Model, size: Size) -> Harness {
    let mut harness = Harness::of_model(model, size);
    let objects = [
        source(1),
        source(2),
        solid(3, "line", "wood"),
        solid(4, "box", "none"),
    ];
    let name = hearth_core::params::Input::Text(model.name());
    let fire = &mut harness.panel.state.fire;
    fire.receive_objects(&objects);
    fire.start_from([("model", name)], Some(&objects));
    harness.reveal(OBJECTS);
    harness
}

pub fn select(harness: &mut Harness, id: u32) -> Vec<Subject> {
    harness.reveal(OBJECTS);
    harness.click(&format!("object:{id}"));
    assert_eq!(
        harness.panel.take_commands(),
        [Command::Select(Some(id))],
        "{id}"
    );
    let fire = &harness.panel.state.fire;
    let object = fire.object(id);
    object.map_or_else(Vec::new, |object| fire.properties(object).collect())
}

#[test]
fn the_objects_follow_the_basics_and_can_be_folded() {
    let mut harness = with_objects(Model::Combustion, (340.0, 2000.0, TALL.2));
    let top = |harness: &Harness, name: &str| harness.rect(name).top();
    let tops = ["group:Basics", "group:Objects", "group:Fire"];
    assert!(tops.map(|name| top(&harness, name)).is_sorted());
    harness.click("group:Objects");
    assert!(!harness.in_sight("object:1"));
    let remembered = harness.panel.take_commands();
    assert!(
        matches!(&remembered[..], [Command::Remember(memory)] if memory.folded.contains(OBJECTS))
    );
    // A page that selects parameters has no objects.
    harness.panel.state.only = Some(harness.used().into_iter().take(3).collect());
    harness.wait();
    assert!(!harness.in_sight("group:Objects") && !harness.in_sight("action:add:solid"));
}

#[test]
fn the_list_names_every_object_and_selects_one() {
    for size in [TALL, PHONE] {
        let mut harness = with_objects(Model::Combustion, size);
        let texts = harness.texts();
        for name in [
            "Source 1",
            "Source 2",
            "Solid 3 · wood line",
            "Solid 4 · invisible box",
        ] {
            assert!(texts.iter().any(|text| text == name), "{name} in {texts:?}");
        }
        select(&mut harness, 3);
        harness.reveal(OBJECTS);
        harness.click("object:3");
        assert_eq!(harness.panel.take_commands(), [Command::Select(None)]);
    }
}

#[test]
fn the_rows_are_the_properties_that_the_model_uses() {
    for model in models() {
        let mut harness = with_objects(model, TALL);
        for (id, kind) in [(2, Kind::SOURCE), (3, Kind::SOLID)] {
            let used = kind.properties();
            let used = used.filter(|property| has_row(*property, model));
            let used: Vec<_> = used
                .map(|property| format!("{}:{}", kind.name, property.name))
                .collect();
            let rows = select(&mut harness, id);
            assert_eq!(rows.iter().map(|row| row.id).collect::<Vec<_>>(), used);
            for row in rows {
                harness.reveal(row.id);
                harness.rect(row.id);
            }
        }
    }
}

#[test]
fn rows_of_a_source_on_a_solid_follow_its_own_shape_and_offer_the_ids_of_the_solids() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    let mut on_solid = source(2);
    on_solid.extend([text("shape", "solid"), number("solid", 40.0)]);
    let fire = &mut harness.panel.state.fire;
    fire.receive_objects(&[source(1), on_solid, solid(40, "box", "wood")]);
    let rows = select(&mut harness, 2);
    let fire = &harness.panel.state.fire;
    let row = |name: &str| rows.iter().copied().find(|row| row.id == name);
    for (name, has_effect) in [
        ("source:shape", true),
        ("source:solid", true),
        ("source:power", true),
        ("source:x", false),
        ("source:width", false),
        ("source:speed", false),
    ] {
        let row = row(name).expect(name);
        let idle = !fire.unmet_conditions(row).is_empty() || !fire.met_exclusions(row).is_empty();
        assert_eq!(!idle, has_effect, "{name}");
    }
    // The first source is a line.
    let width = hearth_core::params::Param::find("source_width").expect("a parameter");
    assert!(fire.unmet_conditions(width.into()).is_empty());
    let solid = row("source:solid").expect("a row");
    assert_eq!(fire.slider_range(solid), (0.0, 40.0));
}

#[test]
fn the_first_source_has_its_parameters_and_its_name_only() {
    let mut harness = with_objects(Model::Combustion, TALL);
    let rows = select(&mut harness, 1);
    assert_eq!(
        rows.iter().map(|row| row.id).collect::<Vec<_>>(),
        ["source:name"]
    );
    let texts = harness.texts();
    let words = "The first source: its properties are in Basics and Fire.";
    assert!(texts.iter().any(|text| text == words), "{texts:?}");
    assert!(
        !harness
            .panel
            .rectangles()
            .keys()
            .any(|name| name.starts_with("source:") && name != "source:name")
    );
}

#[test]
fn a_condition_names_the_property_that_decides() {
    let mut harness = with_objects(Model::Combustion, (340.0, 2000.0, TALL.2));
    select(&mut harness, 3);
    let texts = harness.texts();
    assert!(
        texts.iter().any(|text| text == "Only with shape box"),
        "{texts:?}"
    );
    harness.click("solid:shape");
    harness.click("choice:solid:shape:box");
    let texts = harness.texts();
    assert!(
        !texts.iter().any(|text| text == "Only with shape box"),
        "{texts:?}"
    );
    let words = "Only with heat fixed or conducting";
    assert!(texts.iter().any(|text| text == words), "{texts:?}");
}

#[test]
fn what_is_typed_counts_when_another_object_is_selected() {
    let mut harness = with_objects(Model::Combustion, (340.0, 2000.0, TALL.2));
    let rows = select(&mut harness, 3);
    let width = rows
        .iter()
        .find(|row| row.id == "solid:width")
        .expect("a width");
    harness.click("value:solid:width");
    harness.frame(vec![Event::Text("0.7".to_owned())]);
    harness.click("object:4");
    let commands = harness.panel.take_commands();
    let set = Command::Set(*width, Entry::Number(0.7));
    assert!(commands.contains(&set), "{commands:?}");
    assert!(commands.contains(&Command::Select(Some(4))));
    assert!(harness.panel.state.open.field.is_none());
}

#[test]
fn buttons_send_their_commands() {
    let mut harness = with_objects(Model::Combustion, TALL);
    harness.click("action:duplicate");
    harness.click("action:delete");
    harness.click("action:ignite");
    assert!(harness.panel.take_commands().is_empty(), "none is selected");
    select(&mut harness, 3);
    for (button, command) in [
        ("action:add:source", Command::Add("source")),
        ("action:add:solid", Command::Add("solid")),
        ("action:duplicate", Command::Duplicate(3)),
        ("action:delete", Command::Remove(3)),
        ("action:to:back", Command::Order(3, false)),
        ("action:to:front", Command::Order(3, true)),
        ("action:ignite", Command::Act("ignite", 3)),
        ("action:extinguish", Command::Act("extinguish", 3)),
        ("action:water", Command::Act("water", 3)),
        ("action:sparks", Command::Act("sparks", 3)),
        ("action:blow", Command::Act("blow", 3)),
    ] {
        harness.reveal(OBJECTS);
        harness.click(button);
        assert_eq!(harness.panel.take_commands(), [command], "{button}");
    }
}

#[test]
fn a_button_at_the_limit_is_disabled_with_a_reason() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    let mut objects = vec![source(1)];
    objects.extend((2..66).map(|id| solid(id, "circle", "stone")));
    harness.panel.state.fire.receive_objects(&objects);
    harness.reveal(OBJECTS);
    harness.click("action:add:solid");
    assert!(harness.panel.take_commands().is_empty());
    harness.click("action:add:source");
    assert_eq!(harness.panel.take_commands(), [Command::Add("source")]);
    let texts = harness.texts();
    let words = "A scene has at most 64 solids.";
    assert!(texts.iter().any(|text| text == words), "{texts:?}");
}

#[test]
fn a_search_finds_properties_and_objects() {
    for size in [TALL, PHONE] {
        let mut harness = with_objects(Model::Combustion, size);
        harness.reveal(SEARCH);
        harness.frame(vec![Event::Text("corner radius".to_owned())]);
        harness.wait();
        harness.reveal("");
        // The line has no corners.
        if size == TALL {
            harness.rect("object:4");
            harness.rect("solid:corner");
            assert!(!harness.in_sight("object:3"));
        }
        harness.panel.state.search.text = "wood".to_owned();
        harness.wait();
        let texts = harness.texts();
        assert!(
            texts.iter().any(|text| text == "Solid 3 · wood line"),
            "{texts:?}"
        );
        harness.panel.state.fire.receive_objects(&[source(1)]);
        harness.panel.state.search.text = "corner".to_owned();
        harness.wait();
        let texts = harness.texts();
        let words = "Corner radius is a property of a solid: add one.";
        assert!(texts.iter().any(|text| text == words), "{texts:?}");
    }
}
