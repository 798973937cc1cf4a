//! The panel, used as a person uses it, without a browser.

mod first;
mod hands;
mod rows;

use egui::{Event, vec2};
use hearth_core::params::{Input, Param, Value};
use hearth_panel::SHARE;
use hearth_panel::desk::Desk;
use hearth_panel::fire::{Command, MODEL, Stats};
use hearth_panel::theme::Measures;

use hands::{Hands, PHONE, TALL, models};

#[test]
fn the_header_names_the_scene() {
    for size in [TALL, PHONE] {
        let mut hands = Hands::new(size);
        hands.panel.desk.scene = "Campfire, changed".to_owned();
        hands.wait();
        let texts = hands.texts();
        assert!(texts.iter().any(|text| text == "Campfire, changed"));
        hands.click("action:scenes");
        assert_eq!(hands.panel.take_commands(), [Command::Scenes]);
    }
}

#[test]
fn the_dice_throws_another_seed() {
    let mut hands = Hands::new(TALL);
    hands.reveal("seed");
    let before = hands.value("seed");
    hands.click("dice:seed");
    assert_ne!(hands.value("seed"), before);
}

#[test]
fn a_click_on_the_frame_rate_tells_what_takes_how_long() {
    let mut hands = Hands::new(TALL);
    let times = |names: &[&str]| {
        names
            .iter()
            .map(|name| ((*name).to_owned(), 1.25))
            .collect()
    };
    hands.panel.fire.measure(Stats {
        stages: times(&["sort", "density", "forces", "integrate", "upload"]),
        passes: times(&["gas", "flame", "present"]),
        quality: "low".to_owned(),
        reason: "as asked for".to_owned(),
        ..Stats::default()
    });
    hands.wait();
    let folded = hands.place("search").top();
    hands.click("action:times");
    assert!(hands.place("search").top() > folded + 30.0);
    hands.click("action:times");
    assert_eq!(hands.place("search").top(), folded);
}

#[test]
fn buttons_ask_for_what_they_say() {
    let mut hands = Hands::new(TALL);
    hands.panel.fire.learn("gravity", Input::Number(3.0));
    hands.panel.desk = Desk {
        undo: true,
        redo: true,
        fullscreen: true,
        ..Desk::default()
    };
    hands.wait();
    for (button, asked) in [
        ("action:pause", Command::Pause),
        ("action:reset", Command::Reset),
        ("action:scenes", Command::Scenes),
        ("quality:low", Command::Quality("low")),
        ("quality:auto", Command::Quality("auto")),
        ("action:reset-all", Command::RestoreAll),
        ("action:undo", Command::Undo),
        ("action:redo", Command::Redo),
        ("action:picture", Command::Picture),
        ("action:fullscreen", Command::Fullscreen),
        ("action:help", Command::Help),
    ] {
        hands.click(button);
        assert_eq!(hands.panel.take_commands(), [asked], "{button}");
    }
    hands.panel.fire.paused = true;
    hands.click("action:pause");
    hands.click("action:step");
    assert_eq!(hands.panel.take_commands(), [Command::Play, Command::Step]);
}

#[test]
fn a_slow_press_is_a_press() {
    let mut hands = Hands::new(TALL);
    let pos = hands.place("action:pause").center();
    hands.frame(vec![Event::PointerMoved(pos)]);
    hands.button(pos, true);
    hands.time += 5.0;
    hands.wait();
    hands.button(pos, false);
    assert_eq!(hands.panel.take_commands(), [Command::Pause]);
}

#[test]
fn what_cannot_be_done_at_present_cannot_be_pressed() {
    let mut hands = Hands::new(TALL);
    for button in ["action:undo", "action:redo"] {
        hands.click(button);
    }
    assert_eq!(hands.panel.take_commands(), []);
    assert!(!hands.panel.rectangles().contains_key("action:fullscreen"));
}

#[test]
fn what_can_be_shared_unfolds_and_says_what_it_copied() {
    for size in [TALL, PHONE] {
        let mut hands = Hands::new(size);
        hands.panel.desk.link = true;
        hands.panel.desk.iframe = true;
        assert!(!hands.panel.rectangles().contains_key("action:paste"));
        if size == PHONE {
            hands.click("action:more");
        }
        hands.click("action:share");
        for what in ["link", "element", "iframe", "json"] {
            hands.click(&format!("action:copy:{what}"));
            assert_eq!(hands.panel.take_commands(), [Command::Copy(what)]);
        }
        hands.panel.desk.done = "copy:json".to_owned();
        hands.panel.desk.said = "Copied".to_owned();
        let below = hands.place("action:paste");
        hands.wait();
        assert_eq!(hands.place("action:paste"), below, "nothing moves");
        hands.click("action:paste");
        assert_eq!(hands.panel.take_commands(), [Command::Paste]);
        hands.click("action:share");
        assert!(!hands.panel.rectangles().contains_key("action:paste"));
        hands.reveal("gravity");
        hands.reveal(SHARE);
        hands.panel.desk.link = false;
        hands.panel.desk.iframe = false;
        hands.wait();
        for what in ["link", "iframe"] {
            let name = format!("action:copy:{what}");
            assert!(!hands.panel.rectangles().contains_key(&name), "{what}");
        }
        hands.place("action:copy:json");
    }
}

#[test]
fn what_went_wrong_is_said() {
    let mut hands = Hands::new(TALL);
    let folded = hands.place("search").top();
    hands.panel.desk.said = "There is no picture".to_owned();
    hands.wait();
    assert!(hands.place("search").top() > folded);
}

#[test]
fn a_narrow_panel_keeps_its_buttons_free() {
    let mut hands = Hands::new((240.0, 110.0, Measures::FINE));
    hands.panel.desk.scene = "A scene of a long name, changed".to_owned();
    hands.wait();
    hands.click("action:pause");
    assert_eq!(hands.panel.take_commands(), [Command::Pause]);
}

#[test]
fn the_words_on_a_button_stay_inside_it() {
    for measures in [Measures::FINE, Measures::COARSE] {
        for width in [288.0, 340.0] {
            for model in models() {
                let mut hands = Hands::of_model(model, (width, 2000.0, measures));
                for (text, place) in hands.painted_texts() {
                    let mut buttons = hands.panel.rectangles().iter().filter(|(name, button)| {
                        let words = ["quality:", "choice:", "action:"];
                        let worded = words.iter().any(|kind| name.starts_with(kind));
                        worded && button.contains(place.center())
                    });
                    if let Some((name, button)) = buttons.next() {
                        let room = button.x_range();
                        assert!(
                            room.contains(place.left()) && room.contains(place.right()),
                            "{text} of {name} at {width}: {place} in {button}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn a_notice_stays_until_somebody_goes_on() {
    let mut hands = Hands::new(TALL);
    hands.panel.fire.notice = Some("the fire refused something".to_owned());
    hands.wait();
    assert!(hands.panel.fire.notice.is_some());
    hands.click("action:pause");
    assert_eq!(hands.panel.fire.notice, None);
}

#[test]
fn a_search_leaves_what_it_finds_and_a_reveal_ends_it() {
    let mut hands = Hands::new(TALL);
    hands.click("search");
    hands.frame(vec![Event::Text("viscosity".to_owned())]);
    hands.wait();
    assert!(hands.panel.rectangles().contains_key("viscosity"));
    assert!(!hands.panel.rectangles().contains_key("gravity"));
    hands.reveal("gravity");
    hands.place("gravity");
}

#[test]
fn a_heading_folds_its_group_and_a_reveal_unfolds_it() {
    let mut hands = Hands::new(TALL);
    hands.click("group:Basics");
    assert!(!hands.panel.rectangles().contains_key("source_width"));
    let kept = hands.panel.take_commands();
    let Some(Command::Remember(memory)) = kept.first() else {
        panic!("{kept:?} does not keep what is folded");
    };
    assert!(memory.folded.contains("Basics") && memory.folded.contains("Physics"));
    hands.reveal("source_width");
    hands.place("source_width");
}

#[test]
fn a_panel_without_room_paints_nothing_and_comes_back() {
    let mut hands = Hands::new((0.0, 0.0, Measures::FINE));
    assert!(hands.panel.rectangles().is_empty());
    hands.size = vec2(340.0, 900.0);
    hands.wait();
    hands.place("action:pause");
}

#[test]
fn another_model_brings_its_own_rows_ranges_and_defaults() {
    let mut hands = Hands::new(TALL);
    hands.panel.fire.learn("source_width", Input::Number(0.2));
    hands.click("choice:model:combustion");
    let asked = hands.panel.take_commands();
    assert_eq!(asked, [Command::Set(MODEL, Value::Choice("combustion"))]);
    hands.reveal("ember_size");
    hands.place("ember_size");
    hands.reveal("walls");
    assert!(!hands.panel.rectangles().contains_key("walls"));
    hands.reveal("fuel_power");
    hands.place("fuel_power");
    let width = Param::find("source_width").expect("the table has it");
    assert_eq!(hands.panel.fire.range_of(width), (0.01, 1.0));
    assert_eq!(hands.value("source_width"), Value::Number(0.4));

    hands.click("choice:model:classic");
    assert_eq!(hands.value("source_width"), Value::Number(0.2));
    hands.reveal("fuel_power");
    assert!(!hands.panel.rectangles().contains_key("fuel_power"));
    assert!(
        !hands
            .used()
            .iter()
            .any(|param| param.group == "Sparks and smoke")
    );
    hands.reveal("walls");
    hands.place("walls");
}

fn label(param: &Param) -> String {
    format!("label:{}", param.id)
}

#[test]
fn another_model_keeps_search_and_place() {
    let mut hands = Hands::new(TALL);
    hands.reveal("emission_noise");
    for name in ["combustion", "classic"] {
        let shared = hands.used().into_iter().filter(|param| {
            models().all(|model| param.domain(model).is_some())
                && hands.panel.rectangles().contains_key(&label(param))
        });
        let uppermost = shared.map(label).min_by(|a, b| {
            let top = |name: &str| hands.place(name).top();
            top(a).total_cmp(&top(b))
        });
        let uppermost = uppermost.expect("both models have some row in sight");
        let before = hands.place(&uppermost);
        hands.click(&format!("choice:model:{name}"));
        let now = hands.place(&uppermost);
        assert!((now.top() - before.top()).abs() < 1.0, "{before} → {now}");
    }

    hands.click("search");
    hands.frame(vec![Event::Text("source height".to_owned())]);
    hands.click("choice:model:combustion");
    hands.place("source_height");
    assert!(!hands.panel.rectangles().contains_key("exposure"));
}

#[test]
fn what_is_being_typed_goes_with_its_row() {
    let mut hands = Hands::new(TALL);
    hands.reveal("viscosity");
    hands.click("value:viscosity");
    hands.frame(vec![Event::Text("0.09".to_owned())]);
    hands.panel.fire.learn(MODEL, Input::Text("combustion"));
    hands.wait();
    hands.panel.fire.learn(MODEL, Input::Text("classic"));
    hands.wait();
    assert_eq!(hands.value("viscosity"), Value::Number(0.005));
    assert!(hands.panel.take_commands().is_empty());
}
