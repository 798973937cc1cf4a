//! The panel at the first visit: a short header, simple controls first, a visible slider on every
//! screen, and truthful numbers.

use egui::{Event, Key, vec2};
use hearth_core::params::{Input, Model, Param, Value};
use hearth_panel::state::Command;
use hearth_panel::state::fire::Stats;
use hearth_panel::state::{QUALITY, SEARCH};
use hearth_panel::theme::Measures;

use crate::harness::{Harness, PHONE, TALL, models};

#[test]
fn the_header_leaves_most_of_the_height_to_the_sliders() {
    for model in models() {
        let harness = Harness::of_model(model, (340.0, 800.0, Measures::FINE));
        let first = harness.rect("group:Basics").top();
        assert!(first <= 184.0, "the rows of {model:?} begin at {first}");
        for id in [
            "source_width",
            "palette",
            "exposure",
            "smoke_opacity",
            "time_scale",
        ] {
            harness.rect(id);
        }
    }
}

#[test]
fn every_phone_shows_a_slider() {
    // The sheet of 320 × 568 and of 390 × 844, and the column of 844 × 390.
    for size in [(320.0, 234.0), (390.0, 355.0), (340.0, 390.0)] {
        for model in models() {
            let harness = Harness::of_model(model, (size.0, size.1, Measures::COARSE));
            let first = match model {
                Model::Classic => "emission_rate",
                Model::Combustion => "fuel_power",
            };
            harness.rect(first);
        }
    }
}

#[test]
fn simple_controls_come_first_and_physics_is_folded() {
    for model in models() {
        let harness = Harness::of_model(model, (340.0, 9000.0, Measures::FINE));
        let used = harness.used();
        let basics = used
            .iter()
            .filter(|param| param.group() == "Basics")
            .count();
        assert!(
            (10..=12).contains(&basics),
            "{basics} simple controls of {model:?}"
        );
        let mut groups: Vec<&str> = used.iter().map(|param| param.group()).collect();
        groups.dedup();
        let order = [
            "Basics",
            "Fire",
            "Look",
            "Air",
            "Sparks and smoke",
            "World",
            "Time",
            "Physics",
        ];
        let there = order.into_iter().filter(|name| groups.contains(name));
        assert_eq!(groups, there.collect::<Vec<_>>());
        for param in used {
            assert_eq!(
                harness.in_sight(param.id),
                param.group() != "Physics",
                "{}",
                param.id
            );
        }
    }
}

#[test]
fn reset_restores_the_scene() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    harness
        .panel
        .state
        .fire
        .start_from([("fuel_power", Input::Number(90.0))], None);
    harness
        .panel
        .state
        .fire
        .receive("fuel_power", Input::Number(90.0));
    harness.wait();
    assert!(!harness.in_sight("action:restore:fuel_power"));
    harness.click("action:reset-all");
    assert!(
        harness.panel.take_commands().is_empty(),
        "nothing is changed"
    );

    harness
        .panel
        .state
        .fire
        .receive("fuel_power", Input::Number(220.0));
    harness.wait();
    harness.rect("action:restore:fuel_power");
    harness.click("action:reset-all");
    assert_eq!(harness.panel.take_commands(), [Command::RestoreAll]);
}

#[test]
fn a_page_selects_and_orders_the_parameters() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    let ids = ["wind", "palette", "fuel_power", "walls"];
    harness.panel.state.only = Some(ids.into_iter().filter_map(Param::find).collect());
    harness.wait();
    let tops = ids[..3].iter().map(|id| harness.rect(id).top());
    assert!(tops.collect::<Vec<_>>().is_sorted());
    for absent in [
        "walls",
        "exposure",
        "search",
        "group:Basics",
        "choice:model:classic",
        QUALITY,
    ] {
        assert!(!harness.in_sight(absent), "{absent}");
    }
    harness.click("action:pause");
    assert_eq!(harness.panel.take_commands(), [Command::Pause]);
}

#[test]
fn a_phone_opens_the_tools_on_request() {
    let mut harness = Harness::new(PHONE);
    assert!(!harness.in_sight("action:reset"));
    harness.click("action:more");
    harness.click("action:reset");
    assert_eq!(harness.panel.take_commands(), [Command::Reset]);
    harness.click("action:more");
    assert!(!harness.in_sight("action:reset"));
}

#[test]
fn revealing_the_quality_scrolls_to_it() {
    for size in [TALL, PHONE] {
        let mut harness = Harness::new(size);
        harness.reveal(QUALITY);
        harness.click("quality:low");
        assert_eq!(harness.panel.take_commands(), [Command::Quality("low")]);
    }
}

#[test]
fn a_search_shows_the_best_match_first_and_escape_clears_it() {
    for size in [TALL, PHONE] {
        let mut harness = Harness::of_model(Model::Combustion, size);
        harness.reveal(SEARCH);
        harness.frame(vec![Event::Text("wind".to_owned())]);
        harness.wait();
        assert!(harness.panel.is_typing(&harness.ctx));
        if size == TALL {
            let others = ["turbulence", "seam"]
                .into_iter()
                .filter(|id| harness.in_sight(id));
            for other in others {
                assert!(
                    harness.rect("wind").top() < harness.rect(other).top(),
                    "{other}"
                );
            }
            harness.rect("wind");
        }
        harness.key(Key::Escape);
        assert!(harness.panel.is_typing(&harness.ctx), "it is cleared first");
        if size == TALL {
            harness.rect("fuel_power");
        }
        harness.key(Key::Escape);
        assert!(!harness.panel.is_typing(&harness.ctx));
    }
}

fn texts_with(harness: &mut Harness, stats: Stats) -> Vec<String> {
    harness.panel.state.fire.measure(stats);
    harness.wait();
    harness.texts()
}

#[test]
fn measurements_are_shown_as_they_are() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    for (id, input) in [
        ("edges", Input::Text("periodic")),
        ("particles", Input::Number(3000.0)),
    ] {
        harness.panel.state.fire.receive(id, input);
    }
    let stats = Stats {
        fps: 60.0,
        particles: 1176.0,
        quality: "low".to_owned(),
        ..Stats::default()
    };
    let texts = texts_with(&mut harness, stats.clone());
    let words = "1\u{a0}176 of 3\u{a0}000 (quality low)";
    assert!(texts.iter().any(|text| text == words), "{texts:?}");
    let slow = Stats {
        slowed: true,
        time_scale: 0.3,
        ..stats
    };
    let texts = texts_with(&mut harness, slow);
    assert!(
        texts.iter().any(|text| text == "0.3 × real time"),
        "{texts:?}"
    );
    harness
        .panel
        .state
        .fire
        .receive("particles", Input::Number(50_000.0));
    harness.reveal("particles");
    let texts = harness.texts();
    let note = "Expensive value: the fire runs at 0.3 × real time";
    assert!(texts.iter().any(|text| text == note), "{texts:?}");
}

#[test]
fn open_air_shows_its_particles_and_the_share_that_sleeps() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    harness
        .panel
        .state
        .fire
        .receive("particles", Input::Number(3000.0));
    let mut stats = Stats {
        particles: 742.0,
        ..Stats::default()
    };
    let texts = texts_with(&mut harness, stats.clone());
    assert!(
        texts.iter().any(|text| text == "742 particles"),
        "{texts:?}"
    );
    stats.asleep = 0.12;
    let texts = texts_with(&mut harness, stats.clone());
    let words = "742 particles (12 % asleep)";
    assert!(texts.iter().any(|text| text == words), "{texts:?}");
    // A fine spacing is expensive, as many particles are.
    (stats.slowed, stats.time_scale) = (true, 0.3);
    harness
        .panel
        .state
        .fire
        .receive("spacing", Input::Number(0.01));
    harness.reveal("spacing");
    let texts = texts_with(&mut harness, stats);
    let note = "Expensive value: the fire runs at 0.3 × real time";
    assert!(texts.iter().any(|text| text == note), "{texts:?}");
}

#[test]
fn the_classic_model_explains_its_number_of_particles() {
    let mut harness = Harness::new(TALL);
    harness.reveal("max_particles");
    let stats = Stats {
        particles: 742.0,
        ..Stats::default()
    };
    let texts = texts_with(&mut harness, stats);
    assert!(
        texts.iter().any(|text| text.starts_with("742 are alive")),
        "{texts:?}"
    );
}

#[test]
fn the_value_under_the_pointer_can_be_copied() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    assert_eq!(harness.panel.hovered_value(), None);
    let pos = harness.rect("fuel_power").center();
    harness.frame(vec![Event::PointerMoved(pos)]);
    harness.wait();
    let copied = harness.panel.hovered_value();
    assert_eq!(copied, Some(("220".to_owned(), "Strength")));
    assert_eq!(harness.value("fuel_power"), Value::Number(220.0));
}

#[test]
fn a_row_has_a_tooltip_while_the_pointer_rests_and_none_while_it_drags_or_turns() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    let rail = harness.rect("fuel_power");
    let name = harness.rect("label:fuel_power");
    let tooltip = |harness: &Harness| {
        let (text, row) = harness.panel.tooltip()?;
        Some((text.to_owned(), row))
    };
    assert_eq!(tooltip(&harness), None);
    harness.frame(vec![Event::PointerMoved(rail.center())]);
    harness.wait();
    let (text, row) = tooltip(&harness).expect("the pointer rests");
    assert!(text.ends_with("Attribute fuel-power"), "{text}");
    assert!(row.contains_rect(rail) && row.contains_rect(name));

    harness.button(rail.center(), true);
    harness.frame(vec![Event::PointerMoved(rail.center() + vec2(20.0, 0.0))]);
    assert_eq!(tooltip(&harness), None, "it drags");
    harness.button(rail.center() + vec2(20.0, 0.0), false);
    harness.wait();
    harness.frame(vec![Event::MouseWheel {
        unit: egui::MouseWheelUnit::Line,
        delta: vec2(0.0, -1.0),
        modifiers: egui::Modifiers::NONE,
    }]);
    harness.wait();
    assert_eq!(tooltip(&harness), None, "it has turned");
    let other = harness.rect("wind").center();
    harness.frame(vec![Event::PointerMoved(other)]);
    let (text, _) = tooltip(&harness).expect("it moves freely");
    assert!(text.ends_with("Attribute wind"), "{text}");
    harness.frame(vec![Event::PointerGone]);
    harness.wait();
    assert_eq!(tooltip(&harness), None, "it is gone");
}

#[test]
fn the_scene_is_named_whole() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    for scene in [
        "Candle, changed",
        "Burning word",
        "Sheltered candle, changed",
    ] {
        scene.clone_into(&mut harness.panel.state.controller.scene);
        let button = harness.rect("action:scenes");
        let texts = harness.painted_texts();
        let found = texts.iter().find(|(text, _)| text == scene);
        assert!(
            found.is_some_and(|(_, rect)| button.contains_rect(*rect)),
            "{texts:?}"
        );
    }
}

#[test]
fn a_choice_reads_as_words_and_has_room_below_its_label() {
    let mut harness = Harness::of_model(Model::Combustion, TALL);
    let texts = harness.texts();
    for words in ["Black body", "Bricks", "None"] {
        assert!(
            texts.iter().any(|text| text == words),
            "{words} in {texts:?}"
        );
    }
    let (label, names) = (harness.rect("label:backdrop"), harness.rect("backdrop"));
    assert!(names.top() - label.bottom() >= 3.0);
}
