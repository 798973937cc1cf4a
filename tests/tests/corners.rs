//! Stability at the corners of the parameter ranges: the fire stays finite and inside without
//! clamping, and recovers.
//!
//! This is a sample; `cargo measure soak` goes to hundreds of corners.

use hearth_core::params::{Input, Model, PARAMETERS, Param};
use hearth_core::random::Random;
use hearth_core::{Scene, Simulation};
use hearth_tests::{fires, on_all_cores, sweep};

/// Simulated time of a corner \[s\].
const SECONDS: f64 = 2.0;

/// Simulated time of one slider at its end in the combustion model \[s\]: the
/// fire is lit and its first puff has risen. The corners burn longer.
const LIT: f64 = 0.6;

/// Simulated time after a parameter of a burning fire jumps \[s\]: a pulse crosses the fire.
const JUMP: f64 = 0.15;

fn each_slider_at_either_end(model: Model, seconds: f64) {
    let ends = sweep::swept(model).flat_map(|param| [(param, false), (param, true)]);
    on_all_cores(ends.collect(), |(param, upper)| {
        let parameters = sweep::at_end(model, param, upper);
        let name = sweep::described(&parameters);
        let outcome = sweep::burn(&mut Simulation::new(parameters), seconds);
        assert_eq!(outcome.fault(), None, "{name}");
    });
}

fn random_corners(model: Model, corners: u32, seed: u32) {
    let mut random = Random::new(seed);
    let corners = (0..corners).map(|_| sweep::corner(model, &mut random));
    on_all_cores(corners.collect(), |parameters| {
        let outcome = sweep::there_and_back(&parameters, SECONDS);
        assert_eq!(outcome.fault(), None, "{}", sweep::described(&parameters));
    });
}

#[test]
fn the_classic_fire_is_stable_at_both_ends_of_each_parameter() {
    each_slider_at_either_end(Model::Classic, SECONDS);
}

#[test]
fn the_combustion_fire_is_stable_at_both_ends_of_each_parameter() {
    each_slider_at_either_end(Model::Combustion, LIT);
}

#[test]
fn the_classic_fire_is_stable_at_random_corners_and_recovers() {
    random_corners(Model::Classic, 24, 2026);
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn the_combustion_fire_is_stable_at_random_corners_and_recovers() {
    random_corners(Model::Combustion, 8, 2026);
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn the_open_fire_is_stable_at_random_corners_and_recovers() {
    let mut random = Random::new(2027);
    for _ in 0..12 {
        let parameters = sweep::open_corner(&mut random);
        let outcome = sweep::there_and_back(&parameters, SECONDS);
        assert_eq!(outcome.fault(), None, "{}", sweep::described(&parameters));
    }
}

#[test]
fn the_open_fire_is_stable_at_both_ends_of_each_parameter() {
    for param in sweep::swept(Model::Combustion) {
        for upper in [false, true] {
            let mut parameters = fires::in_the_open(sweep::usual(Model::Combustion), 1500);
            let end = Input::Number(sweep::end(Model::Combustion, param, upper));
            assert_eq!(parameters.set(param.id, end), Ok(()));
            let name = sweep::described(&parameters);
            let outcome = sweep::burn(&mut Simulation::new(parameters), LIT);
            assert_eq!(outcome.fault(), None, "{name}");
        }
    }
}

#[test]
fn the_open_fire_goes_on_when_a_parameter_jumps_to_either_end_and_back() {
    let usual = fires::in_the_open(sweep::usual(Model::Combustion), 2500);
    let mut burning = Simulation::new(usual.clone());
    sweep::burn(&mut burning, 1.0);
    let ends = sweep::swept(Model::Combustion).flat_map(|param| [(param, false), (param, true)]);
    on_all_cores(ends.collect(), |(param, upper)| {
        let mut fire = burning.clone();
        let end = Input::Number(sweep::end(Model::Combustion, param, upper));
        assert_eq!(fire.set(param.id, end), Ok(()));
        let outcome = sweep::burn(&mut fire, JUMP);
        assert_eq!(outcome.fault(), None, "{} at {end}", param.id);
        fire.set_scene(usual.clone());
        let outcome = sweep::burn(&mut fire, JUMP);
        assert_eq!(outcome.fault(), None, "{} back from {end}", param.id);
    });
}

#[test]
fn the_printed_equations_stay_finite_alone_and_combined() {
    let printed = |p: &&Param| p.id.starts_with("printed_");
    let flags: Vec<&str> = PARAMETERS.iter().filter(printed).map(|p| p.id).collect();
    assert_eq!(flags.len(), 5);
    let fares = |ids: &[&'static str]| {
        let values = ids.iter().map(|&id| (id, Input::Flag(true)));
        // What the printed forms do at the speed limit is the paper's affair.
        let outcome = sweep::burn(&mut Simulation::new(fires::with(values)), SECONDS);
        assert_eq!(outcome.broken, None, "{ids:?}");
    };
    flags.iter().for_each(|&flag| fares(&[flag]));
    fares(&flags);
}

/// Burns at the defaults, then at `extreme` values, then at the defaults again.
fn driven_to_extremes(defaults: Scene, extreme: &[(&str, Input<'_>)]) -> Simulation {
    let mut fire = Simulation::new(defaults.clone());
    sweep::burn(&mut fire, SECONDS);
    let mut parameters = defaults.clone();
    assert_eq!(parameters.set_all(extreme.iter().copied()), Ok(()));
    fire.set_scene(parameters);
    sweep::burn(&mut fire, SECONDS);
    fire.set_scene(defaults);
    fire
}

#[test]
fn a_fire_beyond_the_speed_limit_recovers() {
    let mut fire = driven_to_extremes(
        Scene::of_model(Model::Classic),
        &[
            ("gas_constant", Input::Number(6.0)),
            ("buoyancy", Input::Number(1.0)),
            ("gravity", Input::Number(20.0)),
            ("printed_divisor", Input::Flag(true)),
        ],
    );
    assert!(fire.report().clamped > 0, "nothing was clamped");
    assert_eq!(sweep::burn(&mut fire, SECONDS).fault(), None);
    assert_eq!(fire.report().clamped, 0);
    assert!((700..=1000).contains(&fire.count()), "{}", fire.count());
}
