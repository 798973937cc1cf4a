//! The rows of the parameters: revealing, dragging, typing and descriptions.

use egui::{Event, Key, Modifiers, vec2};
use hearth_core::params::{Input, Kind, Model, Param, Value};
use hearth_panel::state::{Command, MODEL};
use hearth_panel::theme::Measures;

use crate::harness::{Harness, LOWER, PHONE, TALL, models, set};

#[test]
fn a_revealed_parameter_has_a_visible_control() {
    for (model, size) in models().flat_map(|model| [TALL, LOWER, PHONE].map(|size| (model, size))) {
        let (width, height, _) = size;
        let mut harness = Harness::of_model(model, size);
        for id in harness.used().iter().map(|param| param.id).chain([MODEL]) {
            harness.reveal(id);
            let rail = harness.rect(id);
            assert!(rail.left() >= 0.0 && rail.right() <= width, "{id}");
            assert!(rail.bottom() <= height, "{id}");
        }
    }
}

#[test]
fn dragging_changes_every_slider_and_reset_restores_it() {
    for model in models() {
        drag_every_slider(Harness::of_model(model, TALL));
    }
}

fn drag_every_slider(mut harness: Harness) {
    for param in harness.used() {
        let (Kind::Number(_) | Kind::Integer(_)) = param.kind else {
            continue;
        };
        harness.reveal(param.id);
        let rail = harness.rect(param.id);
        let before = harness.value(param.id);
        let (low, high) = (rail.left_center(), rail.right_center());
        let (min, max) = harness.panel.state.fire.slider_range(param.into());
        // To the end that is not the default.
        let end = if before.as_number() == Some(max) {
            harness.drag(high, low);
            min
        } else {
            harness.drag(low, high);
            max
        };
        let value = harness.value(param.id).as_number();
        assert_eq!(value, Some(end), "{} dragged to its end", param.id);
        let last = harness.panel.take_commands().pop();
        assert_eq!(last, Some(set(param.id, harness.value(param.id))));
        harness.click(&format!("action:restore:{}", param.id));
        let commands = harness.panel.take_commands();
        assert_eq!(commands, [Command::Restore(param.into())], "{before:?}");
    }
}

#[test]
fn a_typed_value_out_of_range_is_refused_with_a_reason() {
    let mut harness = Harness::new(TALL);
    harness.reveal("viscosity");
    let before = harness.value("viscosity");
    harness.click("value:viscosity");
    harness.frame(vec![Event::Text("7".to_owned())]);
    harness.key(Key::Enter);
    assert_eq!(harness.value("viscosity"), before);
    assert!(harness.panel.take_commands().is_empty());
    let refusal = &harness.panel.state.fire.refusals["viscosity"];
    for part in ["viscosity", "7", "0.1 Pa·s"] {
        assert!(refusal.contains(part), "{refusal}");
    }

    harness.key(Key::Backspace);
    harness.frame(vec![Event::Text("0.02".to_owned())]);
    harness.key(Key::Enter);
    assert_eq!(harness.value("viscosity"), Value::Number(0.02));
    assert!(harness.panel.state.fire.refusals.is_empty());
    let commands = harness.panel.take_commands();
    assert_eq!(commands, [set("viscosity", Value::Number(0.02))]);
}

#[test]
fn shift_moves_the_knob_a_tenth_as_far() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    let rail = harness.rect("fuel_power");
    let start = rail.left_center() + vec2(40.0, 0.0);
    let value = |harness: &Harness| harness.value("fuel_power").as_number().unwrap_or_default();
    let before = value(&harness);
    harness.frame(vec![Event::PointerMoved(start)]);
    let press = |pos, pressed| Event::PointerButton {
        pos,
        button: egui::PointerButton::Primary,
        pressed,
        modifiers: Modifiers::SHIFT,
    };
    harness.frame_with(Modifiers::SHIFT, vec![press(start, true)]);
    assert_eq!(
        value(&harness),
        before,
        "a press leaves the knob where it is"
    );
    let end = start + vec2(100.0, 0.0);
    harness.frame_with(Modifiers::SHIFT, vec![Event::PointerMoved(end)]);
    harness.frame_with(Modifiers::SHIFT, vec![press(end, false)]);
    let moved = value(&harness) - before;
    let coarse = 440.0 * 100.0 / f64::from(rail.width());
    assert!((moved - coarse / 10.0).abs() < 5.0, "{moved} of {coarse}");
}

#[test]
fn keys_move_the_focused_slider() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    let rail = harness.rect("fuel_power");
    harness.drag(rail.left_center(), rail.center());
    let value = |harness: &Harness| harness.value("fuel_power").as_number().unwrap_or_default();
    let middle = value(&harness);
    harness.key(Key::ArrowUp);
    let step = value(&harness) - middle;
    assert!(step > 0.0);
    harness.key(Key::PageUp);
    assert!((value(&harness) - middle - 11.0 * step).abs() < 0.01);
    harness.key(Key::PageDown);
    harness.key(Key::ArrowLeft);
    assert!((value(&harness) - middle).abs() < 0.01);
    harness.key(Key::Home);
    assert_eq!(value(&harness), 0.0);
    harness.key(Key::End);
    assert_eq!(value(&harness), 440.0, "twice the scene's strength");
}

#[test]
fn the_wheel_changes_the_value_under_the_pointer_and_scrolls_elsewhere() {
    let mut harness = Harness::of_model(Model::Combustion, LOWER);
    let wheel = |lines: f32| Event::MouseWheel {
        unit: egui::MouseWheelUnit::Line,
        delta: vec2(0.0, lines),
        modifiers: Modifiers::NONE,
    };
    let value = |harness: &Harness| harness.value("turbulence").as_number().unwrap_or_default();
    let top = harness.rect("turbulence").top();
    let pos = harness.rect("value:turbulence").right_center() - vec2(4.0, 0.0);
    harness.frame(vec![Event::PointerMoved(pos)]);
    harness.frame(vec![Event::PointerMoved(pos)]);
    for _ in 0..3 {
        harness.frame(vec![wheel(1.0)]);
    }
    harness.wait();
    assert!(value(&harness) > 0.0);
    assert_eq!(harness.rect("turbulence").top(), top, "the rows stay");

    let before = value(&harness);
    let pos = harness.rect("turbulence").center();
    harness.frame(vec![Event::PointerMoved(pos)]);
    harness.frame(vec![wheel(-1.0)]);
    for _ in 0..10 {
        harness.wait();
    }
    assert_eq!(value(&harness), before);
    assert_ne!(
        harness
            .panel
            .rectangles()
            .get("turbulence")
            .map(|at| at.top()),
        Some(top)
    );
}

#[test]
fn a_finger_slides_horizontally_and_scrolls_vertically() {
    let mut harness = Harness::new(PHONE);
    harness.panel.state.device.finger = true;
    harness.reveal("viscosity");
    let before = harness.value("viscosity");
    let rail = harness.rect("viscosity");
    let start = rail.left_center() + vec2(60.0, 0.0);
    harness.drag(start, start + vec2(3.0, -60.0));
    assert_eq!(harness.value("viscosity"), before);
    assert!(harness.panel.take_commands().is_empty());
    harness.wait();
    assert_ne!(harness.panel.rectangles().get("viscosity"), Some(&rail));

    harness.reveal("viscosity");
    let start = harness.rect("viscosity").left_center() + vec2(60.0, 0.0);
    harness.drag(start, start + vec2(160.0, 3.0));
    assert_ne!(harness.value("viscosity"), before);
}

#[test]
fn a_double_click_on_the_name_resets() {
    let mut harness = Harness::new(TALL);
    harness
        .panel
        .state
        .fire
        .receive("gravity", Input::Number(3.0));
    harness.reveal("gravity");
    let pos = harness.rect("label:gravity").center();
    harness.frame(vec![Event::PointerMoved(pos)]);
    for pressed in [true, false, true, false] {
        harness.button(pos, pressed);
    }
    let commands = harness.panel.take_commands();
    let gravity = Param::find("gravity").expect("the table has it");
    assert_eq!(commands, [Command::Restore(gravity.into())]);
}

#[test]
fn flags_choices_and_colours_send_the_pressed_value() {
    for model in models() {
        press_every_button(Harness::of_model(model, TALL));
    }
}

fn press_every_button(mut harness: Harness) {
    for param in harness.used() {
        let before = harness.value(param.id);
        harness.reveal(param.id);
        match param.kind {
            Kind::Flag => harness.click(param.id),
            Kind::Choice(names) => {
                let other = names.iter().find(|&&name| Value::Choice(name) != before);
                let Some(other) = other else {
                    panic!("{} has only one name", param.id);
                };
                // A long list is closed.
                if !harness.in_sight(&format!("choice:{}:{other}", param.id)) {
                    harness.click(param.id);
                }
                harness.click(&format!("choice:{}:{other}", param.id));
            }
            Kind::Colour => {
                harness.click(param.id);
                harness.reveal(param.id);
                let hue = harness.rect(&format!("hue:{}", param.id));
                harness.drag(hue.left_center(), hue.center());
            }
            Kind::Number(_) | Kind::Integer(_) | Kind::Seed | Kind::Text(_) => continue,
        }
        assert_ne!(harness.value(param.id), before, "{}", param.id);
        let last = harness.panel.take_commands().pop();
        assert_eq!(last, Some(set(param.id, harness.value(param.id))));
        // Other parameters depend on the choice.
        let words = before.to_string();
        harness
            .panel
            .state
            .fire
            .receive(param.id, Input::Text(&words));
    }
}

#[test]
fn a_long_choice_opens_in_its_row_on_every_screen() {
    // The height of the page's sheet in a window of 640.
    for size in [TALL, (360.0, 281.0, Measures::COARSE)] {
        let mut harness = Harness::new(size);
        let Kind::Choice(names) = Param::find("display_mode").expect("the table has it").kind
        else {
            panic!("a display is a choice");
        };
        assert!(names.len() > 4);
        let name_of = |name: &str| format!("choice:display_mode:{name}");
        harness.reveal("display_mode");
        assert!(!names.iter().any(|name| harness.in_sight(&name_of(name))));
        harness.click("display_mode");
        // The whole list scrolls into view.
        for name in names.iter().rev() {
            let rail = harness.rect(&name_of(name));
            assert!(rail.width() > 90.0 && rail.right() <= size.0, "{name}");
            harness.click(&name_of(name));
            assert_eq!(harness.value("display_mode"), Value::Choice(name));
        }
        harness.click("display_mode");
        assert!(!harness.in_sight(&name_of("paper")));
    }
}

#[test]
fn arrow_keys_step_through_a_long_choice_and_stop_at_its_ends() {
    let mut harness = Harness::new(TALL);
    harness.reveal("palette");
    harness.click("palette");
    harness.key(Key::ArrowUp);
    assert_eq!(harness.value("palette"), Value::Choice("blackbody"));
    harness.key(Key::ArrowDown);
    assert_eq!(harness.value("palette"), Value::Choice("gas"));
    let last = harness.panel.take_commands().pop();
    assert_eq!(last, Some(set("palette", Value::Choice("gas"))));
    for _ in 0..9 {
        harness.key(Key::ArrowDown);
    }
    assert_eq!(harness.value("palette"), Value::Choice("custom"));
    // The page takes Space, to pause the fire.
    assert!(harness.in_sight("choice:palette:gas"));
    harness.key(Key::Space);
    assert!(harness.in_sight("choice:palette:gas"));
}

#[test]
fn a_parameter_without_effect_is_dimmed_explained_and_settable() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    harness.reveal("hot_colour");
    let words = "Only with palette custom";
    assert!(harness.texts().iter().any(|text| text == words));
    harness
        .panel
        .state
        .fire
        .receive("palette", Input::Text("custom"));
    harness.wait();
    assert!(!harness.texts().iter().any(|text| text == words));

    harness
        .panel
        .state
        .fire
        .receive("display_mode", Input::Text("density"));
    harness.reveal("bloom");
    let all = harness.texts();
    assert!(all.iter().any(|text| text == "Only with display fire"));
    assert!(
        all.iter()
            .any(|text| text == "Only with display fire, paper or sprites")
    );
    let rail = harness.rect("bloom");
    harness.drag(rail.left_center(), rail.right_center());
    assert_eq!(harness.value("bloom"), Value::Number(0.6));

    harness
        .panel
        .state
        .fire
        .receive("display_mode", Input::Text("fire"));
    harness.reveal("background");
    let words = "Not with wall bricks and display fire";
    assert!(!harness.texts().iter().any(|text| text == words));
    harness
        .panel
        .state
        .fire
        .receive("backdrop", Input::Text("bricks"));
    harness.wait();
    assert!(harness.texts().iter().any(|text| text == words));
    harness
        .panel
        .state
        .fire
        .receive("display_mode", Input::Text("density"));
    harness.wait();
    assert!(!harness.texts().iter().any(|text| text == words));
}
