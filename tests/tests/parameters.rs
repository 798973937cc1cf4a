//! Every parameter has an effect, and a value out of range is an error with a message.

use hearth_core::params::{Input, Kind, Model, PARAMETERS, Param, Value};
use hearth_core::{Parameters, Scene, Simulation};
use hearth_tests::fires::{self, with};
use hearth_tests::sweep::is_shown_only;

/// The id of the first solid that is added.
const SOLID: f64 = 2.0;

/// A fire that has burned for so long, beside a solid for a parameter that is about one.
fn burn(param: &Param, mut scene: Scene, seconds: f64) -> Simulation {
    if !["source_shape", "source_solid"].contains(&param.id) {
        return fires::burn(scene, seconds);
    }
    // Each of the two has an effect with the other.
    let others = [
        ("source_shape", Input::Text("solid")),
        ("source_solid", Input::Number(SOLID)),
    ];
    let others = others.into_iter().filter(|(id, _)| *id != param.id);
    assert_eq!(scene.set_all(others), Ok(()));
    assert_eq!(scene.add(&[("kind", Input::Text("solid"))]), Ok(2));
    let mut fire = Simulation::new(scene);
    fires::burn_on(&mut fire, seconds);
    fire
}

/// Values of a parameter that are not its default.
fn others(model: Model, param: &Param) -> Vec<Input<'static>> {
    let domain = param.any_domain(model);
    match (param.kind, domain.default) {
        (Kind::Choice(names), _) => names.iter().map(|&name| Input::Text(name)).collect(),
        (Kind::Flag, default) => vec![Input::Flag(default == Value::Flag(false))],
        (Kind::Colour, _) => vec![Input::Text("#123456")],
        // A few particles more are as different as very many, and quicker.
        _ if param.id == "particles" => vec![Input::Number(1200.0)],
        _ if param.id == "max_particles" && model == Model::Combustion => {
            // Fewer than there are around the fire.
            vec![Input::Number(300.0)]
        }
        _ if param.id == "source_solid" => vec![Input::Number(SOLID)],
        _ if param.id == "spacing" => vec![Input::Number(0.05)],
        _ => [domain.range.0, domain.range.1].map(Input::Number).to_vec(),
    }
}

/// Whether a value of the parameter, of those that `burnt` takes, makes another
/// fire than none does, and whether it should.
fn changes<Fire: PartialEq>(
    model: Model,
    param: &Param,
    burnt: impl Fn(Option<(&'static str, Input<'static>)>) -> Fire,
) -> (bool, bool) {
    let plain = burnt(None);
    let changed = others(model, param)
        .into_iter()
        .any(|value| burnt(Some((param.id, value))) != plain);
    (changed, !is_shown_only(param))
}

fn used_by(model: Model) -> impl Iterator<Item = &'static Param> {
    let used = move |param: &&Param| param.id != "model" && param.domain(model).is_some();
    PARAMETERS.iter().filter(used)
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn parameters_of_the_physics_change_the_classic_fire_and_others_do_not() {
    for param in used_by(Model::Classic) {
        // Nothing reaches the speed limit but gas that is lifted as printed.
        let wild = ("printed_divisor", Input::Flag(param.id == "speed_limit"));
        // A vortex size has an effect only with vortices.
        let strength = if param.id == "turbulence_scale" {
            3.0
        } else {
            0.0
        };
        let stirred = ("turbulence", Input::Number(strength));
        // The domain is no wider than the source, so that there are walls to meet;
        // a source that moves needs room.
        let width = if param.id == "source_x" { 1.2 } else { 0.36 };
        let narrow = ("domain_width", Input::Number(width));
        let burnt = |more: Option<(&'static str, Input<'static>)>| {
            let values = [wild, stirred, narrow].into_iter().chain(more);
            burn(param, with(values), 1.0).particles()
        };
        let (changed, should) = changes(Model::Classic, param, burnt);
        assert_eq!(changed, should, "{}", param.id);
    }
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn parameters_of_the_physics_change_the_combustion_fire_and_others_do_not() {
    for param in used_by(Model::Combustion) {
        let strength = if param.id == "turbulence_scale" {
            3.0
        } else {
            0.0
        };
        let burnt = |more: Option<(&'static str, Input<'static>)>| {
            let mut scene = fires::combustion(&[("turbulence", strength)]);
            if ["floor", "max_particles", "spacing"].contains(&param.id) {
                scene = fires::in_the_open(scene, 1500);
            }
            assert_eq!(scene.set_all(more), Ok(()), "{}", param.id);
            let fire = burn(param, scene, 0.6);
            (fire.particles(), fire.embers().to_vec())
        };
        let (changed, should) = changes(Model::Combustion, param, burnt);
        assert_eq!(changed, should, "{}", param.id);
    }
}

#[test]
fn integers_end_exactly_at_their_range_and_zero_has_no_sign() {
    let mut parameters = Parameters::new(Model::Classic);
    let beyond = f64::from(u32::MAX) + 1.0;
    assert!(parameters.set("seed", Input::Number(beyond)).is_err());
    assert!(
        parameters
            .set("max_particles", Input::Number(100_001.0))
            .is_err()
    );
    assert_eq!(parameters.set("viscosity", Input::Number(-0.0)), Ok(()));
    assert!(parameters.viscosity.is_sign_positive());
}

#[test]
fn texts_can_be_values_of_every_kind() {
    let scene = with([
        ("viscosity", Input::Text(" 0.02 ")),
        ("max_particles", Input::Text("500")),
        ("walls", Input::Text("solid")),
        ("printed_euler", Input::Text("")),
        ("background", Input::Text("#102030")),
        ("seed", Input::Text("4294967295")),
    ]);
    let parameters = scene.world();
    assert_eq!(parameters.viscosity, 0.02);
    assert_eq!(parameters.max_particles, 500);
    assert!(parameters.printed_euler);
    assert_eq!(parameters.background.rgba, [16, 32, 48, 255]);
    assert_eq!(parameters.seed, u32::MAX);
    // What is written reads back as the same.
    for param in used_by(Model::Classic) {
        let value = scene.value(param);
        let mut again = Scene::of_model(Model::Classic);
        again
            .set(param.id, Input::Text(&value.to_string()))
            .expect(param.id);
        assert_eq!(again.get(param.id), Some(value));
    }
}
