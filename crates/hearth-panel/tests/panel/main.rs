//! Tests of the panel without a browser.

mod first;
mod harness;
mod names;
mod object_values;
mod objects;
mod rows;

use egui::{Event, vec2};
use hearth_core::params::{Input, Param, Value};
use hearth_panel::state::fire::Stats;
use hearth_panel::state::{Command, ControllerState, CopyForm, MODEL};
use hearth_panel::state::{SHARE, TOOLS};
use hearth_panel::theme::Measures;

use harness::{Harness, PHONE, TALL, models, set};

#[test]
fn the_header_names_the_scene() {
    for size in [TALL, PHONE] {
        let mut harness = Harness::new(size);
        harness.panel.state.controller.scene = "Campfire, changed".to_owned();
        harness.wait();
        let texts = harness.texts();
        assert!(texts.iter().any(|text| text == "Campfire, changed"));
        harness.click("action:scenes");
        assert_eq!(harness.panel.take_commands(), [Command::Scenes]);
    }
}

#[test]
fn the_dice_sets_a_random_seed() {
    let mut harness = Harness::new(TALL);
    harness.reveal("seed");
    let before = harness.value("seed");
    harness.click("dice:seed");
    assert_ne!(harness.value("seed"), before);
}

#[test]
fn a_click_on_the_frame_rate_shows_the_times_of_a_frame() {
    let mut harness = Harness::new(TALL);
    let times = |names: &[&str]| {
        names
            .iter()
            .map(|name| ((*name).to_owned(), 1.25))
            .collect()
    };
    harness.panel.state.fire.measure(Stats {
        stages: times(&["sort", "density", "forces", "integrate", "upload"]),
        passes: times(&["gas", "flame", "composite"]),
        quality: "low".to_owned(),
        reason: "as asked for".to_owned(),
        ..Stats::default()
    });
    harness.wait();
    let folded = harness.rect("search").top();
    harness.click("action:times");
    assert!(harness.rect("search").top() > folded + 30.0);
    harness.click("action:times");
    assert_eq!(harness.rect("search").top(), folded);
}

#[test]
fn buttons_send_their_commands() {
    let mut harness = Harness::new(TALL);
    harness
        .panel
        .state
        .fire
        .receive("gravity", Input::Number(3.0));
    harness.panel.state.controller = ControllerState {
        undo: true,
        redo: true,
        fullscreen: true,
        ..ControllerState::default()
    };
    harness.wait();
    for (button, command) in [
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
        harness.click(button);
        assert_eq!(harness.panel.take_commands(), [command], "{button}");
    }
    harness.panel.state.fire.paused = true;
    harness.click("action:pause");
    harness.click("action:step");
    assert_eq!(
        harness.panel.take_commands(),
        [Command::Play, Command::Step]
    );
}

#[test]
fn a_long_press_is_a_click() {
    let mut harness = Harness::new(TALL);
    let pos = harness.rect("action:pause").center();
    harness.frame(vec![Event::PointerMoved(pos)]);
    harness.button(pos, true);
    harness.time += 5.0;
    harness.wait();
    harness.button(pos, false);
    assert_eq!(harness.panel.take_commands(), [Command::Pause]);
}

#[test]
fn unavailable_buttons_are_disabled() {
    let mut harness = Harness::new(TALL);
    for button in ["action:undo", "action:redo"] {
        harness.click(button);
    }
    assert_eq!(harness.panel.take_commands(), []);
    assert!(!harness.panel.rectangles().contains_key("action:fullscreen"));
}

/// Forms of copies with these names.
fn copy_forms(names: &[&str]) -> Vec<CopyForm> {
    let form = |name: &&str| CopyForm {
        name: (*name).to_owned(),
        ..CopyForm::default()
    };
    names.iter().map(form).collect()
}

#[test]
fn copy_and_paste_fold_again_when_the_focus_goes_on_unless_a_press_has_opened_them() {
    let mut harness = Harness::new(TALL);
    let link = CopyForm {
        name: "link".to_owned(),
        button: "Link".to_owned(),
        hint: String::new(),
    };
    harness.panel.state.controller.copies = vec![link];
    harness.reveal(SHARE);
    assert!(harness.in_sight("action:copy:link"));
    harness.reveal(SHARE);
    harness.reveal(TOOLS);
    assert!(!harness.in_sight("action:copy:link"));
    harness.click("action:share");
    harness.reveal(SHARE);
    harness.reveal(TOOLS);
    assert!(harness.in_sight("action:copy:link"));
}

#[test]
fn the_share_buttons_open_and_confirm_a_copy() {
    for size in [TALL, PHONE] {
        let mut harness = Harness::new(size);
        harness.panel.state.controller.copies =
            copy_forms(&["link", "element", "iframe", "json", CopyForm::REPORT]);
        assert!(!harness.panel.rectangles().contains_key("action:paste"));
        if size == PHONE {
            harness.click("action:more");
        }
        harness.click("action:share");
        for what in ["link", "element", "iframe", "json"] {
            harness.click(&format!("action:copy:{what}"));
            assert_eq!(
                harness.panel.take_commands(),
                [Command::Copy(what.to_owned())]
            );
        }
        harness.panel.state.controller.done = "copy:json".to_owned();
        harness.panel.state.controller.message = "Copied".to_owned();
        let below = harness.rect("action:paste");
        harness.wait();
        assert_eq!(harness.rect("action:paste"), below, "nothing moves");
        harness.click("action:paste");
        assert_eq!(harness.panel.take_commands(), [Command::Paste]);
        harness.click("action:share");
        assert!(!harness.panel.rectangles().contains_key("action:paste"));
        harness.reveal("gravity");
        harness.reveal(SHARE);
        harness.panel.state.controller.copies = copy_forms(&["element", "json"]);
        harness.wait();
        for what in ["link", "iframe", CopyForm::REPORT] {
            let name = format!("action:copy:{what}");
            assert!(!harness.panel.rectangles().contains_key(&name), "{what}");
        }
        harness.rect("action:copy:json");
    }
}

#[test]
fn an_error_of_the_controller_is_shown() {
    let mut harness = Harness::new(TALL);
    let folded = harness.rect("search").top();
    harness.panel.state.controller.message = "There is no picture".to_owned();
    harness.wait();
    assert!(harness.rect("search").top() > folded);
}

#[test]
fn buttons_do_not_overlap_in_a_narrow_panel() {
    let mut harness = Harness::new((240.0, 110.0, Measures::FINE));
    harness.panel.state.controller.scene = "A scene of a long name, changed".to_owned();
    harness.wait();
    harness.click("action:pause");
    assert_eq!(harness.panel.take_commands(), [Command::Pause]);
}

#[test]
fn the_text_of_a_button_stays_inside_it() {
    for measures in [Measures::FINE, Measures::COARSE] {
        for width in [288.0, 340.0] {
            for model in models() {
                let mut harness = Harness::of_model(model, (width, 2000.0, measures));
                for (text, rect) in harness.painted_texts() {
                    let mut buttons = harness.panel.rectangles().iter().filter(|(name, button)| {
                        let words = ["quality:", "choice:", "action:"];
                        let worded = words.iter().any(|kind| name.starts_with(kind));
                        worded && button.contains(rect.center())
                    });
                    if let Some((name, button)) = buttons.next() {
                        let room = button.x_range();
                        assert!(
                            room.contains(rect.left()) && room.contains(rect.right()),
                            "{text} of {name} at {width}: {rect} in {button}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn a_notice_stays_until_the_next_command() {
    let mut harness = Harness::new(TALL);
    harness.panel.state.fire.notice = Some("the fire refused something".to_owned());
    harness.wait();
    assert!(harness.panel.state.fire.notice.is_some());
    harness.click("action:pause");
    assert_eq!(harness.panel.state.fire.notice, None);
}

#[test]
fn a_heading_folds_its_group_and_a_reveal_opens_it() {
    let mut harness = Harness::new(TALL);
    harness.click("group:Basics");
    assert!(!harness.panel.rectangles().contains_key("source_width"));
    let kept = harness.panel.take_commands();
    let Some(Command::Remember(memory)) = kept.first() else {
        panic!("{kept:?} does not keep what is folded");
    };
    assert!(memory.folded.contains("Basics") && memory.folded.contains("Physics"));
    harness.reveal("source_width");
    harness.rect("source_width");
}

#[test]
fn a_panel_without_space_paints_nothing_until_it_has_some() {
    let mut harness = Harness::new((0.0, 0.0, Measures::FINE));
    assert!(harness.panel.rectangles().is_empty());
    harness.size = vec2(340.0, 900.0);
    harness.wait();
    harness.rect("action:pause");
}

#[test]
fn each_model_has_its_own_rows_ranges_and_defaults() {
    let mut harness = Harness::new(TALL);
    harness
        .panel
        .state
        .fire
        .receive("source_width", Input::Number(0.2));
    harness.reveal(MODEL);
    harness.click("choice:model:combustion");
    let commands = harness.panel.take_commands();
    assert_eq!(commands, [set(MODEL, Value::Choice("combustion"))]);
    harness.reveal("ember_size");
    harness.rect("ember_size");
    harness.reveal("walls");
    assert!(!harness.panel.rectangles().contains_key("walls"));
    harness.reveal("fuel_power");
    harness.rect("fuel_power");
    let width = Param::find("source_width").expect("the table has it");
    assert_eq!(harness.panel.state.fire.range_of(width), (0.01, 6.0));
    assert_eq!(harness.value("source_width"), Value::Number(0.4));

    harness.reveal(MODEL);
    harness.click("choice:model:classic");
    assert_eq!(harness.value("source_width"), Value::Number(0.36));
    harness.reveal("fuel_power");
    assert!(!harness.panel.rectangles().contains_key("fuel_power"));
    assert!(
        !harness
            .used()
            .iter()
            .any(|param| param.group() == "Sparks and smoke")
    );
    harness.reveal("walls");
    harness.rect("walls");
}

fn label(param: &Param) -> String {
    format!("label:{}", param.id)
}

#[test]
fn a_change_of_the_model_keeps_search_and_scroll_position() {
    let mut harness = Harness::new(TALL);
    for name in ["combustion", "classic"] {
        harness.reveal(MODEL);
        let shared = harness.used().into_iter().filter(|param| {
            models().all(|model| param.domain(model).is_some())
                && harness.panel.rectangles().contains_key(&label(param))
        });
        let uppermost = shared.map(label).min_by(|a, b| {
            let top = |name: &str| harness.rect(name).top();
            top(a).total_cmp(&top(b))
        });
        let uppermost = uppermost.expect("both models have some row in sight");
        let before = harness.rect(&uppermost);
        harness.click(&format!("choice:model:{name}"));
        let now = harness.rect(&uppermost);
        assert!((now.top() - before.top()).abs() < 1.0, "{before} → {now}");
    }

    harness.click("search");
    harness.frame(vec![Event::Text("source height".to_owned())]);
    harness
        .panel
        .state
        .fire
        .receive(MODEL, Input::Text("combustion"));
    harness.wait();
    harness.rect("source_height");
    assert!(!harness.panel.rectangles().contains_key("exposure"));
}

#[test]
fn an_open_field_closes_with_its_row() {
    let mut harness = Harness::new(TALL);
    harness.reveal("viscosity");
    harness.click("value:viscosity");
    harness.frame(vec![Event::Text("0.09".to_owned())]);
    harness
        .panel
        .state
        .fire
        .receive(MODEL, Input::Text("combustion"));
    harness.wait();
    harness
        .panel
        .state
        .fire
        .receive(MODEL, Input::Text("classic"));
    harness.wait();
    assert_eq!(harness.value("viscosity"), Value::Number(0.005));
    assert!(harness.panel.take_commands().is_empty());
}
