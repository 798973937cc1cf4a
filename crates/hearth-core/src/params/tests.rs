//! Laws of the table that concern two models at once.

use super::*;
use crate::scene::Scene;

/// A value of the entry's kind that is not the default of the domain.
fn another(param: &Param, domain: &Domain) -> Value {
    match domain.default {
        Value::Number(x) if x == domain.range.1 as f32 => Value::Number(domain.range.0 as f32),
        Value::Number(_) => Value::Number(domain.range.1 as f32),
        Value::Integer(_) => Value::Integer(domain.range.0 as u32),
        Value::Seed(n) => Value::Seed(n + 1),
        Value::Flag(on) => Value::Flag(!on),
        Value::Colour(_) => Value::Colour(Colour::rgb(1, 2, 3)),
        Value::Choice(name) => match param.kind {
            Kind::Choice(names) => Value::Choice(names.iter().find(|&&n| n != name).unwrap()),
            _ => panic!("{} is no choice", param.id),
        },
        Value::Text(_) => panic!("{} is an outline", param.id),
    }
}

fn set(parameters: &mut Parameters, id: &str, value: Value) {
    let text = value.to_string();
    assert_eq!(parameters.set(id, Input::Text(&text)), Ok(()), "{id}");
}

fn switch(parameters: &mut Parameters, model: Model) {
    set(parameters, "model", Value::Choice(model.name()));
}

const BOTH: [(Model, Model); 2] = [
    (Model::Classic, Model::Combustion),
    (Model::Combustion, Model::Classic),
];

#[test]
fn another_model_keeps_shared_values_and_has_its_defaults_for_the_rest() {
    for (here, there) in BOTH {
        let mut scene = Scene::of_model(here);
        let all = || PARAMETERS.iter().filter(|param| param.id != "model");
        for param in all() {
            if let Some(domain) = param.domain(here) {
                let text = another(param, domain).to_string();
                assert_eq!(scene.set(param.id, &*text), Ok(()), "{}", param.id);
            }
        }
        // The way back restores nothing.
        for model in [there, here] {
            assert_eq!(scene.set("model", model.name()), Ok(()));
            assert_eq!(scene.model(), model);
            for param in all() {
                let Some(domain) = param.domain(model) else {
                    continue;
                };
                let expected = match domain.model {
                    None => another(param, domain),
                    Some(_) => domain.default,
                };
                assert_eq!(scene.value(param), expected, "{}", param.id);
            }
        }
    }
}

#[test]
fn a_parameter_of_the_other_model_is_refused_by_name() {
    for (here, there) in BOTH {
        let hidden = |param: &&Param| param.domain(here).is_none();
        for param in PARAMETERS.iter().filter(hidden) {
            let mut scene = Scene::of_model(here);
            let before = scene.clone();
            let value = param.any_domain(there).default.to_string();
            let refused = scene.set(param.id, &*value).map_err(|error| error.kind);
            assert_eq!(refused, Err(ParamErrorKind::OfModel(there)), "{}", param.id);
            assert_eq!(scene, before);
        }
    }
    let refused = Parameters::new(Model::Combustion).set("viscosity", 0.1);
    assert_eq!(
        refused.map_err(|error| error.to_string()),
        Err("viscosity = 0.1 is refused: only the classic model has it".to_owned())
    );
}

#[test]
fn each_model_has_its_own_range() {
    let mut parameters = Parameters::new(Model::Combustion);
    assert_eq!(parameters.set("buoyancy", Input::Number(1.5)), Ok(()));
    assert!(
        parameters
            .set("max_particles", Input::Number(150.0))
            .is_err()
    );
    switch(&mut parameters, Model::Classic);
    assert!(parameters.set("buoyancy", Input::Number(1.5)).is_err());
    assert_eq!(
        parameters.set("max_particles", Input::Number(150.0)),
        Ok(())
    );
    assert_eq!(parameters.max_particles, 150);
    switch(&mut parameters, Model::Combustion);
    assert_eq!(parameters.buoyancy, 1.0);
    assert_eq!(parameters.max_particles, 6000);
}

#[test]
fn several_values_take_the_model_first() {
    // 500 particles are too few for combustion, a buoyancy of 1.5 too much for the classic model.
    let classic = [
        ("max_particles", Input::Number(500.0)),
        ("bloom", Input::Number(0.5)),
        ("model", Input::Text("classic")),
    ];
    let combustion = [
        ("buoyancy", Input::Number(1.5)),
        ("model", Input::Text("combustion")),
    ];
    for model in [Model::Classic, Model::Combustion] {
        let mut parameters = Parameters::new(model);
        assert_eq!(parameters.set_all(classic), Ok(()));
        assert_eq!(parameters.model(), Model::Classic);
        assert_eq!((parameters.max_particles, parameters.bloom), (500, 0.5));
        assert_eq!(parameters.set_all(combustion), Ok(()));
        assert_eq!(parameters.model(), Model::Combustion);
        assert_eq!((parameters.buoyancy, parameters.bloom), (1.5, 0.5));
    }
}

#[test]
fn several_values_are_set_all_or_none() {
    for model in [Model::Classic, Model::Combustion] {
        let mut parameters = Parameters::new(model);
        let before = parameters.clone();
        let refused = parameters
            .set_all([
                ("bloom", Input::Number(0.5)),
                ("wind", Input::Number(99.0)),
                ("model", Input::Text("combustion")),
                ("viscocity", Input::Number(0.0)),
            ])
            .unwrap_err();
        let ids: Vec<&str> = refused.iter().map(|error| error.id.as_str()).collect();
        assert_eq!(ids, ["wind", "viscocity"]);
        assert_eq!(parameters, before);
        assert!(
            parameters
                .set_all([("model", Input::Text("paper"))])
                .is_err()
        );
        assert_eq!(parameters, before);
    }
}

#[test]
fn restoring_the_model_restores_nothing_else() {
    let mut parameters = Parameters::default();
    set(&mut parameters, "bloom", Value::Number(0.5));
    let before = parameters.clone();
    for name in Model::NAMES {
        set(&mut parameters, "model", Value::Choice(name));
        assert_eq!(parameters.restore("model"), Ok(()));
        assert_eq!(parameters, before);
    }
}

#[test]
fn every_default_is_in_its_own_range() {
    for param in PARAMETERS {
        for domain in param.domains {
            for model in [Model::Classic, Model::Combustion] {
                if domain.model.is_none_or(|own| own == model) {
                    let text = domain.default.to_string();
                    let set = Scene::of_model(model).set(param.id, Input::Text(&text));
                    assert_eq!(set, Ok(()), "{}", param.id);
                }
            }
        }
    }
}

#[test]
fn the_smoothing_length_follows_the_spacing_or_the_number_of_particles() {
    let mut parameters = Parameters::new(Model::Combustion);
    assert_eq!(parameters.smoothing_length(), 1.5 * parameters.spacing);
    set(&mut parameters, "particles", Value::Integer(12_000));
    assert_eq!(parameters.smoothing_length(), 1.5 * parameters.spacing);

    set(&mut parameters, "edges", Value::Choice("periodic"));
    let spacing = (1.2_f32 * 1.8 / 12_000.0).sqrt();
    assert!((parameters.spacing() - spacing).abs() < 1e-6);
    assert!((parameters.smoothing_length() - 1.5 * spacing).abs() < 1e-6);
    set(&mut parameters, "particles", Value::Integer(3000));
    assert!((parameters.spacing() - 2.0 * spacing).abs() < 1e-6);
    let classic = Parameters::new(Model::Classic);
    assert_eq!(classic.smoothing_length(), classic.smoothing_radius);
    // A lattice of that spacing is as dense as the gas at rest.
    let density = classic.particle_mass / (classic.spacing() * classic.spacing());
    assert!((density / classic.rest_density - 1.0).abs() < 1e-6);
}

#[test]
fn every_condition_of_a_parameter_can_be_met() {
    for (param, about) in PARAMETERS.iter().zip(DESCRIPTIONS) {
        for &(id, names) in about.when.iter().chain(about.unless) {
            let choice = Param::find(id).expect("it is of the table");
            let Kind::Choice(all) = choice.kind else {
                panic!("{id} of {} is no choice", param.id);
            };
            assert!(names.iter().all(|name| all.contains(name)), "{}", param.id);
            assert!(!names.is_empty() && names.len() < all.len(), "{}", param.id);
            for domain in param.domains {
                let model = domain.model.unwrap_or_default();
                assert!(choice.domain(model).is_some(), "{}", param.id);
            }
        }
    }
}

#[test]
fn a_parameter_without_effect_names_its_unmet_conditions_and_can_be_set() {
    let mut parameters = Parameters::default();
    let unmet = |parameters: &Parameters, id| {
        let param = Param::find(id).expect("it is of the table");
        let ids = param
            .unmet_conditions(|id| parameters.get(id))
            .map(|&(id, _)| id);
        ids.collect::<Vec<_>>()
    };
    assert_eq!(unmet(&parameters, "cool_colour"), ["palette"]);
    let colour = Colour::rgb(1, 2, 3);
    set(&mut parameters, "cool_colour", Value::Colour(colour));
    assert_eq!(parameters.cool_colour, colour);
    set(&mut parameters, "palette", Value::Choice("custom"));
    assert!(unmet(&parameters, "cool_colour").is_empty());
    set(&mut parameters, "display_mode", Value::Choice("density"));
    assert_eq!(unmet(&parameters, "cool_colour"), ["display_mode"]);
    assert_eq!(unmet(&parameters, "bloom"), ["display_mode"]);
    assert!(unmet(&parameters, "viscosity").is_empty());
}
