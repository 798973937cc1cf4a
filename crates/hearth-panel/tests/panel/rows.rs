//! The rows of the parameters: each is found, moved, typed into, and says what it is.

use egui::{Event, Key, Modifiers, vec2};
use hearth_core::params::{Input, Kind, Model, Param, Value};
use hearth_panel::fire::{Command, MODEL};
use hearth_panel::theme::Measures;

use crate::hands::{Hands, LOWER, PHONE, TALL, models};

#[test]
fn every_parameter_has_a_control_in_sight_once_it_is_revealed() {
    for (model, size) in models().flat_map(|model| [TALL, LOWER, PHONE].map(|size| (model, size))) {
        let (width, height, _) = size;
        let mut hands = Hands::of_model(model, size);
        for id in hands.used().iter().map(|param| param.id).chain([MODEL]) {
            hands.reveal(id);
            let place = hands.place(id);
            assert!(place.left() >= 0.0 && place.right() <= width, "{id}");
            assert!(place.bottom() <= height, "{id}");
        }
    }
}

#[test]
fn dragging_changes_every_slider_and_reset_brings_it_back() {
    for model in models() {
        drag_every_slider(Hands::of_model(model, TALL));
    }
}

fn drag_every_slider(mut hands: Hands) {
    for param in hands.used() {
        let (Kind::Number(_) | Kind::Integer(_)) = param.kind else {
            continue;
        };
        hands.reveal(param.id);
        let place = hands.place(param.id);
        let before = hands.value(param.id);
        let (low, high) = (place.left_center(), place.right_center());
        let (min, max) = hands.panel.fire.range_of(param);
        // To the end where there is a way back to the default.
        let end = if before.as_number() == Some(max) {
            hands.drag(high, low);
            min
        } else {
            hands.drag(low, high);
            max
        };
        let value = hands.value(param.id).as_number();
        assert_eq!(value, Some(end), "{} dragged to its end", param.id);
        let last = hands.panel.take_commands().pop();
        assert_eq!(last, Some(Command::Set(param.id, hands.value(param.id))));
        hands.click(&format!("action:restore:{}", param.id));
        let asked = hands.panel.take_commands();
        assert_eq!(asked, [Command::Restore(param.id)], "{before:?}");
    }
}

#[test]
fn what_is_typed_out_of_range_is_refused_aloud_and_changes_nothing() {
    let mut hands = Hands::new(TALL);
    hands.reveal("viscosity");
    let before = hands.value("viscosity");
    hands.click("value:viscosity");
    hands.frame(vec![Event::Text("7".to_owned())]);
    hands.key(Key::Enter);
    assert_eq!(hands.value("viscosity"), before);
    assert!(hands.panel.take_commands().is_empty());
    let refusal = &hands.panel.fire.refusals["viscosity"];
    for part in ["viscosity", "7", "0.1 Pa·s"] {
        assert!(refusal.contains(part), "{refusal}");
    }

    hands.key(Key::Backspace);
    hands.frame(vec![Event::Text("0.02".to_owned())]);
    hands.key(Key::Enter);
    assert_eq!(hands.value("viscosity"), Value::Number(0.02));
    assert!(hands.panel.fire.refusals.is_empty());
    let asked = hands.panel.take_commands();
    assert_eq!(asked, [Command::Set("viscosity", Value::Number(0.02))]);
}

#[test]
fn with_shift_the_knob_goes_a_tenth_as_far() {
    let mut hands = Hands::of_model(Model::Combustion, TALL);
    let place = hands.place("fuel_power");
    let start = place.left_center() + vec2(40.0, 0.0);
    let value = |hands: &Hands| hands.value("fuel_power").as_number().unwrap_or_default();
    let before = value(&hands);
    hands.frame(vec![Event::PointerMoved(start)]);
    let press = |pos, pressed| Event::PointerButton {
        pos,
        button: egui::PointerButton::Primary,
        pressed,
        modifiers: Modifiers::SHIFT,
    };
    hands.frame_with(Modifiers::SHIFT, vec![press(start, true)]);
    assert_eq!(value(&hands), before, "a press leaves the knob where it is");
    let end = start + vec2(100.0, 0.0);
    hands.frame_with(Modifiers::SHIFT, vec![Event::PointerMoved(end)]);
    hands.frame_with(Modifiers::SHIFT, vec![press(end, false)]);
    let moved = value(&hands) - before;
    let coarse = 600.0 * 100.0 / f64::from(place.width());
    assert!((moved - coarse / 10.0).abs() < 5.0, "{moved} of {coarse}");
}

#[test]
fn keys_move_the_slider_that_has_the_focus() {
    let mut hands = Hands::of_model(Model::Combustion, TALL);
    let place = hands.place("fuel_power");
    hands.drag(place.left_center(), place.center());
    let value = |hands: &Hands| hands.value("fuel_power").as_number().unwrap_or_default();
    let middle = value(&hands);
    hands.key(Key::ArrowUp);
    let step = value(&hands) - middle;
    assert!(step > 0.0);
    hands.key(Key::PageUp);
    assert!((value(&hands) - middle - 11.0 * step).abs() < 0.01);
    hands.key(Key::PageDown);
    hands.key(Key::ArrowLeft);
    assert!((value(&hands) - middle).abs() < 0.01);
    hands.key(Key::Home);
    assert_eq!(value(&hands), 0.0);
    hands.key(Key::End);
    assert_eq!(value(&hands), 600.0);
}

#[test]
fn the_wheel_turns_the_value_that_is_pointed_at_and_scrolls_elsewhere() {
    let mut hands = Hands::of_model(Model::Combustion, LOWER);
    let wheel = |lines: f32| Event::MouseWheel {
        unit: egui::MouseWheelUnit::Line,
        delta: vec2(0.0, lines),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Unknown,
        modifiers: Modifiers::NONE,
    };
    let value = |hands: &Hands| hands.value("turbulence").as_number().unwrap_or_default();
    let top = hands.place("turbulence").top();
    let pos = hands.place("value:turbulence").right_center() - vec2(4.0, 0.0);
    hands.frame(vec![Event::PointerMoved(pos)]);
    hands.frame(vec![Event::PointerMoved(pos)]);
    for _ in 0..3 {
        hands.frame(vec![wheel(1.0)]);
    }
    hands.wait();
    assert!(value(&hands) > 0.0);
    assert_eq!(hands.place("turbulence").top(), top, "the rows stay");

    let before = value(&hands);
    let pos = hands.place("turbulence").center();
    hands.frame(vec![Event::PointerMoved(pos)]);
    hands.frame(vec![wheel(-1.0)]);
    for _ in 0..10 {
        hands.wait();
    }
    assert_eq!(value(&hands), before);
    assert_ne!(
        hands
            .panel
            .rectangles()
            .get("turbulence")
            .map(|at| at.top()),
        Some(top)
    );
}

#[test]
fn a_finger_slides_sideways_and_scrolls_up_and_down() {
    let mut hands = Hands::new(PHONE);
    hands.panel.finger = true;
    hands.reveal("viscosity");
    let before = hands.value("viscosity");
    let place = hands.place("viscosity");
    let start = place.left_center() + vec2(60.0, 0.0);
    hands.drag(start, start + vec2(3.0, -60.0));
    assert_eq!(hands.value("viscosity"), before);
    assert!(hands.panel.take_commands().is_empty());
    hands.wait();
    assert_ne!(hands.panel.rectangles().get("viscosity"), Some(&place));

    hands.reveal("viscosity");
    let start = hands.place("viscosity").left_center() + vec2(60.0, 0.0);
    hands.drag(start, start + vec2(160.0, 3.0));
    assert_ne!(hands.value("viscosity"), before);
}

#[test]
fn a_double_click_on_the_name_resets() {
    let mut hands = Hands::new(TALL);
    hands.panel.fire.learn("gravity", Input::Number(3.0));
    hands.reveal("gravity");
    let pos = hands.place("label:gravity").center();
    hands.frame(vec![Event::PointerMoved(pos)]);
    for pressed in [true, false, true, false] {
        hands.button(pos, pressed);
    }
    let asked = hands.panel.take_commands();
    assert_eq!(asked, [Command::Restore("gravity")]);
}

#[test]
fn flags_choices_and_colours_ask_for_what_was_pressed() {
    for model in models() {
        press_every_button(Hands::of_model(model, TALL));
    }
}

fn press_every_button(mut hands: Hands) {
    for param in hands.used() {
        let before = hands.value(param.id);
        hands.reveal(param.id);
        match param.kind {
            Kind::Flag => hands.click(param.id),
            Kind::Choice(names) => {
                let other = names.iter().find(|&&name| Value::Choice(name) != before);
                let Some(other) = other else {
                    panic!("{} has only one name", param.id);
                };
                // A list of many is folded.
                if !hands.in_sight(&format!("choice:{}:{other}", param.id)) {
                    hands.click(param.id);
                }
                hands.click(&format!("choice:{}:{other}", param.id));
            }
            Kind::Colour => {
                hands.click(param.id);
                hands.reveal(param.id);
                let hue = hands.place(&format!("hue:{}", param.id));
                hands.drag(hue.left_center(), hue.center());
            }
            Kind::Number(_) | Kind::Integer(_) | Kind::Seed => continue,
        }
        assert_ne!(hands.value(param.id), before, "{}", param.id);
        let last = hands.panel.take_commands().pop();
        assert_eq!(last, Some(Command::Set(param.id, hands.value(param.id))));
    }
}

#[test]
fn a_long_choice_unfolds_in_its_row_on_every_screen() {
    // As much of a window of 640 as the page's sheet has.
    for size in [TALL, (360.0, 281.0, Measures::COARSE)] {
        let mut hands = Hands::new(size);
        let Kind::Choice(names) = Param::find("display_mode").expect("the table has it").kind
        else {
            panic!("a display is a choice");
        };
        assert!(names.len() > 4);
        let name_of = |name: &str| format!("choice:display_mode:{name}");
        hands.reveal("display_mode");
        assert!(!names.iter().any(|name| hands.in_sight(&name_of(name))));
        hands.click("display_mode");
        // All of it comes into sight.
        for name in names.iter().rev() {
            let place = hands.place(&name_of(name));
            assert!(place.width() > 90.0 && place.right() <= size.0, "{name}");
            hands.click(&name_of(name));
            assert_eq!(hands.value("display_mode"), Value::Choice(name));
        }
        hands.click("display_mode");
        assert!(!hands.in_sight(&name_of("paper")));
    }
}

#[test]
fn the_arrow_keys_go_through_a_long_choice_and_stop_at_its_ends() {
    let mut hands = Hands::new(TALL);
    hands.reveal("palette");
    hands.click("palette");
    hands.key(Key::ArrowUp);
    assert_eq!(hands.value("palette"), Value::Choice("blackbody"));
    hands.key(Key::ArrowDown);
    assert_eq!(hands.value("palette"), Value::Choice("gas"));
    let last = hands.panel.take_commands().pop();
    assert_eq!(last, Some(Command::Set("palette", Value::Choice("gas"))));
    for _ in 0..9 {
        hands.key(Key::ArrowDown);
    }
    assert_eq!(hands.value("palette"), Value::Choice("custom"));
    // The page takes Space, to pause the fire.
    assert!(hands.in_sight("choice:palette:gas"));
    hands.key(Key::Space);
    assert!(hands.in_sight("choice:palette:gas"));
}

#[test]
fn what_counts_for_nothing_is_dimmed_says_why_and_is_set_all_the_same() {
    let mut hands = Hands::of_model(Model::Combustion, TALL);
    hands.reveal("hot_colour");
    let words = "Only with palette custom";
    assert!(hands.texts().iter().any(|text| text == words));
    hands.panel.fire.learn("palette", Input::Text("custom"));
    hands.wait();
    assert!(!hands.texts().iter().any(|text| text == words));

    hands
        .panel
        .fire
        .learn("display_mode", Input::Text("density"));
    hands.reveal("bloom");
    let all = hands.texts();
    assert!(all.iter().any(|text| text == "Only with display fire"));
    assert!(
        all.iter()
            .any(|text| text == "Only with display fire, paper or sprites")
    );
    let place = hands.place("bloom");
    hands.drag(place.left_center(), place.right_center());
    assert_eq!(hands.value("bloom"), Value::Number(0.6));

    hands.panel.fire.learn("display_mode", Input::Text("fire"));
    hands.reveal("background");
    let words = "Not with backdrop bricks and display fire";
    assert!(!hands.texts().iter().any(|text| text == words));
    hands.panel.fire.learn("backdrop", Input::Text("bricks"));
    hands.wait();
    assert!(hands.texts().iter().any(|text| text == words));
    hands
        .panel
        .fire
        .learn("display_mode", Input::Text("density"));
    hands.wait();
    assert!(!hands.texts().iter().any(|text| text == words));
}
