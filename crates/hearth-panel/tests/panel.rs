//! The panel, used as a person uses it, without a browser: it is painted, and
//! pointer and keys go where it says its controls are.
//!
//! A character that the font lacks panics, so everything that is painted here
//! is painted without boxes.

use egui::{Event, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, Shape, vec2};
use hearth_core::params::{Choice, Input, Kind, Model, Param, Value};
use hearth_panel::desk::Desk;
use hearth_panel::fire::{Command, MODEL, Stats};
use hearth_panel::theme::{self, Measures};
use hearth_panel::{Panel, SHARE};

struct Hands {
    ctx: egui::Context,
    panel: Panel,
    size: egui::Vec2,
    time: f64,
}

impl Hands {
    /// A panel of the classic model.
    fn new(size: Size) -> Hands {
        Hands::of_model(Model::Classic, size)
    }

    fn of_model(model: Model, (width, height, measures): Size) -> Hands {
        let ctx = egui::Context::default();
        theme::apply(&ctx);
        ctx.set_missing_glyph_policy(egui::MissingGlyphPolicy::Panic);
        let mut hands = Hands {
            ctx,
            panel: Panel::new(measures),
            size: vec2(width, height),
            time: 0.0,
        };
        hands.panel.fire.learn(MODEL, Input::Text(model.name()));
        hands.wait();
        hands
    }

    /// What the panel shows of the table.
    fn used(&self) -> Vec<&'static Param> {
        self.panel.fire.used().collect()
    }

    fn frame(&mut self, events: Vec<Event>) {
        self.time += 0.1;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, self.size)),
            time: Some(self.time),
            events,
            ..RawInput::default()
        };
        let mut output = self.ctx.run_ui(input, |ui| self.panel.ui(ui));
        output.textures_delta.clear();
    }

    /// Every text that is painted.
    fn texts(&mut self) -> Vec<String> {
        let painted = self.painted_texts();
        painted.into_iter().map(|(text, _)| text).collect()
    }

    /// Every text that is painted, and where.
    fn painted_texts(&mut self) -> Vec<(String, Rect)> {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, self.size)),
            time: Some(self.time),
            ..RawInput::default()
        };
        let mut output = self.ctx.run_ui(input, |ui| self.panel.ui(ui));
        output.textures_delta.clear();
        let shapes = output.shapes.iter().map(|clipped| &clipped.shape);
        let texts = shapes.filter_map(|shape| match shape {
            Shape::Text(text) => {
                let place = text.galley.rect.translate(text.pos.to_vec2());
                Some((text.galley.text().to_owned(), place))
            }
            _ => None,
        });
        texts.collect()
    }

    fn wait(&mut self) {
        for _ in 0..3 {
            self.frame(Vec::new());
        }
    }

    fn place(&self, name: &str) -> Rect {
        *self
            .panel
            .rectangles()
            .get(name)
            .unwrap_or_else(|| panic!("{name} is not in sight"))
    }

    fn in_sight(&self, name: &str) -> bool {
        self.panel.rectangles().contains_key(name)
    }

    fn reveal(&mut self, id: &str) {
        self.panel.reveal(id);
        self.wait();
    }

    fn button(&mut self, pos: Pos2, pressed: bool) {
        self.frame(vec![
            Event::PointerMoved(pos),
            Event::PointerButton {
                pos,
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            },
        ]);
    }

    fn click(&mut self, name: &str) {
        let pos = self.place(name).center();
        self.frame(vec![Event::PointerMoved(pos)]);
        self.button(pos, true);
        self.button(pos, false);
        self.wait();
    }

    fn drag(&mut self, from: Pos2, to: Pos2) {
        self.frame(vec![Event::PointerMoved(from)]);
        self.button(from, true);
        for part in 1..=10 {
            let pos = from + (to - from) * (part as f32 / 10.0);
            self.frame(vec![Event::PointerMoved(pos)]);
        }
        self.button(to, false);
        self.wait();
    }

    fn key(&mut self, key: Key) {
        for pressed in [true, false] {
            self.frame(vec![Event::Key {
                key,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: Modifiers::NONE,
            }]);
        }
        self.wait();
    }

    fn value(&self, id: &str) -> Value {
        let value = self.panel.fire.parameters.get(id);
        value.unwrap_or_else(|| panic!("there is no {id}"))
    }
}

/// Width, height, and for whose hand.
type Size = (f32, f32, Measures);

const TALL: Size = (340.0, 900.0, Measures::FINE);
const LOWER: Size = (340.0, 600.0, Measures::FINE);
const PHONE: Size = (360.0, 288.0, Measures::COARSE);

/// Every model.
fn models() -> impl Iterator<Item = Model> {
    Model::NAMES
        .iter()
        .filter_map(|name| Model::from_name(name))
}

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
        assert_eq!(asked, [Command::Restore(vec![param.id])], "{before:?}");
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
    assert_eq!(asked, [Command::Restore(vec!["gravity"])]);
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
    let all = hands.used().iter().map(|param| param.id).collect();
    for (button, asked) in [
        ("action:pause", Command::Pause),
        ("action:reset", Command::Reset),
        ("action:scenes", Command::Scenes),
        ("quality:low", Command::Quality("low")),
        ("quality:auto", Command::Quality("auto")),
        ("action:reset-all", Command::Restore(all)),
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
    hands.panel.fire.stats.particles = 10_000.0;
    hands.panel.fire.stats.slowed = true;
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
    hands.click("group:World");
    assert!(!hands.panel.rectangles().contains_key("gravity"));
    hands.reveal("gravity");
    hands.place("gravity");
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
    assert!(hands.panel.rectangles().contains_key("group:Gas"));
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
    assert!(!hands.panel.rectangles().contains_key("group:Embers"));
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
