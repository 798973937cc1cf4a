//! The front door: what the README and the first page of the documentation use.

use hearth_fire::preset::Preset;
use hearth_fire::{Parameters, Simulation, Vec2};

#[test]
fn a_fire_of_the_facade_burns_as_one_of_the_core() {
    let mut fire = Simulation::new(Parameters::default());
    let mut core = hearth_core::Simulation::new(hearth_core::Parameters::default());
    for _ in 0..20 {
        fire.step();
        core.step();
    }
    let positions: Vec<Vec2> = fire.positions();
    assert!(!positions.is_empty());
    assert_eq!(positions, core.positions());
}

#[test]
fn the_first_examples_burn_a_scene_with_its_solids() {
    for text in [include_str!("../README.md"), include_str!("../src/lib.rs")] {
        let (_, example) = text.split_once("```").expect("an example");
        let example = example.split_once("campfire").map(|(_, rest)| rest);
        assert!(
            example.is_some_and(|rest| rest.contains(".scene()")),
            "{text}"
        );
    }
    let campfire = Preset::find("campfire").expect("the scene").scene();
    let solids = campfire.solids().count();
    assert!(solids >= 6, "{solids}");
    assert_eq!(Simulation::new(campfire).poses().len(), solids);
}

#[test]
fn every_crate_that_computes_says_how_a_dev_build_is_fast() {
    let lines = "[profile.dev.package.\"*\"]\nopt-level = 3\n";
    for name in ["core", "fire", "render", "cli"] {
        let path = format!("{}/../hearth-{name}/README.md", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(text.contains(lines), "{path}");
    }
}

#[test]
fn a_value_is_a_number_a_flag_or_a_text() {
    let mut fire = Simulation::new(Parameters::default());
    assert_eq!(fire.set("fuel_power", 200.0), Ok(()));
    assert_eq!(fire.set("wind", 0.5_f32), Ok(()));
    assert_eq!(fire.set("seed", 7), Ok(()));
    assert_eq!(fire.set("max_particles", 20_000_u32), Ok(()));
    assert_eq!(fire.set("floor", "solid"), Ok(()));
    let refused = fire.set("wind", 99.0).map_err(|error| error.to_string());
    assert!(refused.is_err_and(|words| words.starts_with("wind = 99 is refused")));
}

#[test]
fn an_unknown_scene_is_refused_with_the_similar_or_the_first_names_and_the_number_of_the_others() {
    let refused = |name: &str| Preset::find(name).map_err(|error| error.to_string()).err();
    for similar in ["campfir", "Campfire", "camp-fire"] {
        let words = format!("there is no preset \"{similar}\"; did you mean \"campfire\"?");
        assert_eq!(refused(similar), Some(words));
    }
    let all = refused(&"nonsense".repeat(100)).unwrap_or_default();
    let named = all.matches(", ").count() + 1;
    let more = format!(" and {} more", Preset::all().len() - named);
    assert!(
        all.len() <= 300 && named > 5 && all.ends_with(&more),
        "{all}"
    );
}
