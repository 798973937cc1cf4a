//! The rows that are texts, and the objects that are off.

use std::sync::Mutex;

use egui::{Color32, ColorImage, Event, Key};
use hearth_core::params::{Model, Param};
use hearth_panel::browser_text;
use hearth_panel::state::fire::Entry;
use hearth_panel::state::{Command, Subject};

use crate::harness::{Harness, PHONE, TALL};
use crate::objects::{select, solid, source, text, with_objects};

fn row(rows: &[Subject], id: &str) -> Subject {
    let found = rows.iter().copied().find(|row| row.id == id);
    found.unwrap_or_else(|| panic!("no row {id}"))
}

/// Types a text into the row of a value, in place of the present one.
fn type_into(harness: &mut Harness, id: &str, text: &str) {
    harness.reveal(id);
    harness.click(&format!("value:{id}"));
    harness.wait();
    harness.frame(vec![Event::Text(text.to_owned())]);
    harness.key(Key::Enter);
    harness.wait();
}

fn shows(harness: &mut Harness, wanted: &str) -> bool {
    harness.texts().iter().any(|text| text == wanted)
}

#[test]
fn a_name_is_typed_listed_and_reset() {
    for size in [TALL, PHONE] {
        let mut harness = with_objects(Model::Combustion, size);
        for (id, name, listed) in [
            (1, "Wick", "Wick · Source 1"),
            (3, "Back log, split", "Back log, split · Solid 3"),
        ] {
            let rows = select(&mut harness, id);
            let row = rows[0];
            type_into(&mut harness, row.id, name);
            let commands = harness.panel.take_commands();
            assert_eq!(commands, [Command::Set(row, Entry::Text(name.to_owned()))]);
            assert!(shows(&mut harness, listed), "{listed}");
            assert!(harness.panel.state.fire.is_changed());
            harness.reveal(row.id);
            harness.click(&format!("action:restore:{}", row.id));
            let commands = harness.panel.take_commands();
            assert_eq!(commands, [Command::Restore(row)]);
        }
    }
}

#[test]
fn a_name_from_browser_text_is_drawn_by_the_browser_in_the_list_its_row_and_its_field() {
    static DRAWN: Mutex<Vec<String>> = Mutex::new(Vec::new());
    let mut harness = with_objects(Model::Combustion, TALL);
    browser_text::draw_with(&harness.ctx, |text, _| {
        DRAWN.lock().unwrap().push(text.to_owned());
        Some(ColorImage::filled([300, 20], Color32::WHITE))
    });
    let mut log = solid(2, "line", "wood");
    log.push(text("name", "עץ יבש"));
    harness.panel.state.fire.receive_objects(&[source(1), log]);
    select(&mut harness, 2);
    harness.reveal("solid:name");
    let drawn = || std::mem::take(&mut *DRAWN.lock().unwrap());
    assert_eq!(drawn(), ["\u{2068}עץ יבש\u{2069} · Solid 2", "עץ יבש"]);
    harness.reveal("solid:name");
    assert!(drawn().is_empty(), "pictures are kept");
    let texts = harness.texts();
    assert!(
        !texts.iter().any(|text| browser_text::is_from_right(text)),
        "{texts:?}"
    );
    for text in ["Back log", "Φωτιά", "火", "é̂"] {
        assert!(!browser_text::is_from_right(text), "{text}");
    }
}

#[test]
fn letters_that_the_font_lacks_are_drawn_by_the_browser_in_rows_fields_and_messages() {
    static DRAWN: Mutex<Vec<String>> = Mutex::new(Vec::new());
    let mut harness = with_objects(Model::Combustion, TALL);
    browser_text::draw_with(&harness.ctx, |text, _| {
        DRAWN.lock().unwrap().push(text.to_owned());
        Some(ColorImage::filled([12, 20], Color32::WHITE))
    });
    let drawn = || std::mem::take(&mut *DRAWN.lock().unwrap());
    let mut log = solid(2, "line", "wood");
    log.push(text("name", "A Лес?"));
    harness.panel.state.fire.receive_objects(&[source(1), log]);
    select(&mut harness, 2);
    harness.reveal("solid:name");
    assert_eq!(drawn(), ["A Лес? · Solid 2", "A Лес?"]);
    harness.click("value:solid:name");
    assert_eq!(drawn(), ["Л", "е", "с"]);
    assert!(shows(&mut harness, "A ———?"));
    harness.frame(vec![Event::Text("火".to_owned())]);
    harness.wait();
    assert_eq!(drawn(), ["火"]);
    harness.key(Key::Escape);
    harness.panel.state.controller.message = "no scene is named “Лес”".to_owned();
    harness.wait();
    assert_eq!(drawn().concat(), "Лес");
}

#[test]
fn a_name_that_is_too_long_is_refused_with_a_message_and_kept_in_its_field() {
    let mut harness = with_objects(Model::Combustion, TALL);
    select(&mut harness, 3);
    type_into(&mut harness, "solid:name", &"a".repeat(65));
    let refusal = harness.panel.state.fire.refusals.get("solid:name");
    assert!(
        refusal.is_some_and(|words| words.ends_with("it must be a line of at most 64 characters"))
    );
    assert!(harness.panel.take_commands().is_empty());
    assert!(harness.panel.state.open.field.is_some());
}

#[test]
fn outlines_have_rows_that_show_their_size_and_take_texts() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    let mut star = solid(2, "polygon", "stone");
    star.push(text("points", "-0.2,0 0.2,0 0,0.3"));
    harness.panel.state.fire.receive_objects(&[source(1), star]);
    let rows = select(&mut harness, 2);
    harness.reveal("solid:points");
    assert!(shows(&mut harness, "3 points, 0.4 × 0.3"));
    harness.reveal("solid:mask");
    assert!(shows(&mut harness, "16 × 16 cells"));
    let points = row(&rows, "solid:points");
    type_into(&mut harness, points.id, "0,0 0.1,0 0.1,0.1 0,0.1");
    let outline = Entry::Text("0,0 0.1,0 0.1,0.1 0,0.1".to_owned());
    let written = Command::Set(points, outline);
    assert_eq!(harness.panel.take_commands(), [written]);
    assert!(shows(&mut harness, "4 points, 0.1 × 0.1"));
    type_into(&mut harness, points.id, "0,0 0.1");
    let refusal = harness.panel.state.fire.refusals.get(points.id);
    assert!(refusal.is_some_and(|words| words.contains("pairs of numbers")));
    assert!(harness.panel.take_commands().is_empty());
}

#[test]
fn the_eye_of_an_object_switches_it_off_and_on() {
    for size in [TALL, PHONE] {
        let mut harness = with_objects(Model::Combustion, size);
        harness.click("enabled:3");
        let commands = harness.panel.take_commands();
        let [Command::Set(row, Entry::Flag(false))] = commands[..] else {
            panic!("{commands:?}");
        };
        assert_eq!(
            (row.id, row.object.map(|owner| owner.id)),
            ("solid:enabled", Some(3))
        );
        assert!(shows(&mut harness, "Solid 3 · wood line · off"));
        harness.click("enabled:3");
        let commands = harness.panel.take_commands();
        assert_eq!(commands, [Command::Set(row, Entry::Flag(true))]);
        // The properties of the first source are parameters.
        harness.click("enabled:1");
        let enabled = Param::find("source_enabled").expect("the table has it");
        let commands = harness.panel.take_commands();
        assert_eq!(commands, [Command::Set(enabled.into(), Entry::Flag(false))]);
        assert!(shows(&mut harness, "Source 1 · off"));
    }
}
