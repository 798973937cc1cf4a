//! The facade is the core by another name.

use hearth_fire::params::{Input, PARAMETERS};
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
fn parameters_and_scenes_are_within_reach() {
    assert!(PARAMETERS.iter().any(|param| param.id == "fuel_power"));
    assert!(Preset::all().iter().any(|preset| preset.name == "campfire"));
    let refused = Parameters::default().set("wind", Input::Number(99.0));
    assert!(refused.is_err());
}
