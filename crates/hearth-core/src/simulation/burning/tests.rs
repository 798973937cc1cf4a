use super::*;
use crate::params::{IN_DOMAIN, Input, Model, Parameters};
use crate::scene::Scene;

/// The defaults with these values changed and room for twice the particles of the domain.
fn with(values: &[(&str, f64)]) -> Parameters {
    let mut parameters = Parameters::new(Model::Combustion);
    for &(id, value) in values {
        assert_eq!(parameters.set(id, Input::Number(value)), Ok(()));
    }
    parameters.complete(
        &|id| values.iter().any(|&(known, _)| known == id),
        IN_DOMAIN,
    );
    parameters
}

fn burnt(parameters: Parameters, seconds: f64) -> Simulation {
    let mut fire = Simulation::new(parameters);
    while fire.time() < seconds {
        fire.step();
    }
    fire
}

#[test]
fn only_parameters_of_the_gas_change_the_digest() {
    let usual = Parameters::new(Model::Combustion);
    for (id, value) in [("exposure", 1.0), ("seed", 7.0), ("particles", 1200.0)] {
        assert_eq!(
            digest(&with(&[(id, value)]).into()),
            digest(&usual.clone().into()),
            "{id}"
        );
    }
    for (id, value) in [("fuel_power", 100.0), ("domain_width", 2.0), ("wind", 1.0)] {
        let mut scene = Scene::new(usual.clone());
        assert_eq!(scene.set(id, value), Ok(()));
        assert_ne!(digest(&scene), digest(&usual.clone().into()), "{id}");
    }
    assert_ne!(
        digest(&Parameters::new(Model::Classic).into()),
        digest(&usual.clone().into())
    );
}

#[test]
fn a_source_changes_the_digest_while_it_is_on() {
    let number = |id, value| (id, Input::Number(value));
    let source = ("kind", Input::Text("source"));
    for is_on in [false, true] {
        let digest_of = |first: f64, second: f64| {
            let mut scene = Scene::new(Parameters::new(Model::Combustion));
            assert_eq!(scene.set("fuel_power", first), Ok(()));
            assert_eq!(scene.set("source_enabled", is_on), Ok(()));
            assert_eq!(scene.add(&[source, number("power", second)]), Ok(2));
            digest(&scene)
        };
        let usual = digest_of(100.0, 100.0);
        assert_ne!(digest_of(100.0, 200.0), usual);
        assert_eq!(digest_of(200.0, 100.0) != usual, is_on);
    }
}

#[test]
fn a_restored_fire_continues() {
    let values = with(&[("particles", 1000.0), ("ember_rate", 200.0)]);
    let fire = burnt(values.clone(), 0.8);
    let bytes = fire.burning().unwrap_or_default();
    let mut other = Simulation::new(values);
    assert_eq!(other.restore_burning(&bytes), Ok(()));
    assert_eq!((other.time(), other.count()), (fire.time(), fire.count()));
    // Embers beyond the bounds are left out.
    let lost = fire.embers().len() - other.embers().len();
    assert!(50 * lost < fire.embers().len(), "{lost}");
    let hottest = |fire: &Simulation| fire.temperatures().into_iter().fold(0.0, f32::max);
    assert!((hottest(&fire) - hottest(&other)).abs() < 5.0);
    for (before, after) in fire.particles().iter().zip(other.particles()) {
        assert!(before.position.distance(after.position) < 1e-4);
        assert!(before.velocity.distance(after.velocity) < 0.05);
        assert!((before.temperature - after.temperature).abs() < 5.0);
        assert!((before.soot - after.soot).abs() < 0.01);
    }
    // The power is the same a moment later.
    let power = |mut fire: Simulation| {
        for _ in 0..50 {
            fire.step();
        }
        fire.power().unwrap_or_default()
    };
    let (before, after) = (power(fire), power(other));
    assert!(
        (after / before - 1.0).abs() < 0.2,
        "{before} and {after} kW/m"
    );
}

#[test]
fn the_same_bytes_and_seed_give_the_same_bits_at_any_number_of_particles() {
    let bytes = burnt(with(&[("particles", 1500.0)]), 0.5).burning();
    let bytes = bytes.unwrap_or_default();
    for n in [1000.0, 1500.0, 3000.0] {
        let [first, second] = [(); 2].map(|()| {
            let mut fire = Simulation::new(with(&[("particles", n)]));
            assert_eq!(fire.restore_burning(&bytes), Ok(()));
            for _ in 0..20 {
                fire.step();
            }
            fire
        });
        assert_eq!(first.particles(), second.particles());
        let found = f64::from(first.parameters().domain_particles());
        assert!((found / n - 1.0).abs() < 0.01, "{found} for {n}");
        assert!(first.temperatures().iter().any(|&kelvin| kelvin > 1000.0));
    }
}

#[test]
fn other_values_and_damaged_bytes_are_errors_and_change_nothing() {
    let values = with(&[("particles", 1000.0)]);
    let bytes = burnt(values.clone(), 0.1).burning().unwrap_or_default();
    let mut fire = burnt(with(&[("particles", 1000.0), ("wind", 1.0)]), 0.05);
    let before = fire.particles();
    assert_eq!(fire.restore_burning(&bytes), Err(BurningError::OtherValues));
    let mut classic = Simulation::new(Parameters::new(Model::Classic));
    assert_eq!(
        classic.restore_burning(&bytes),
        Err(BurningError::OtherValues)
    );
    assert_eq!(classic.burning(), None);

    let mut damaged: Vec<Vec<u8>> = [0, 3, HEADER - 1, HEADER, bytes.len() - 1]
        .map(|length| bytes[..length].to_vec())
        .to_vec();
    damaged.push([&bytes[..], &[0]].concat());
    // Magic, embers, particles, time, and each of the scales.
    for at in [0, 7, 22, 31, 35, 39, 43, 47, 51, 55] {
        let mut wrong = bytes.clone();
        wrong[at] = 0xff;
        damaged.push(wrong);
    }
    for wrong in damaged {
        let refused = fire.restore_burning(&wrong);
        assert!(matches!(refused, Err(BurningError::Damaged(message)) if !message.is_empty()));
    }
    let mut older = bytes.clone();
    older[4] = 2;
    let refused = fire.restore_burning(&older);
    assert_eq!(refused, Err(BurningError::OtherVersion(2)));
    let message = refused.map_or_else(|error| error.to_string(), |()| String::new());
    assert!(
        message.contains("version 2") && message.contains("must be 3"),
        "{message}"
    );
    assert_eq!(fire.particles(), before);
}

#[test]
fn any_columns_restore_a_finite_fire() {
    let values = with(&[("particles", 1000.0), ("ember_rate", 200.0)]);
    let bytes = burnt(values.clone(), 0.2).burning().unwrap_or_default();
    let mut random = Random::new(3);
    for _ in 0..3 {
        let mut wild = bytes.clone();
        for byte in &mut wild[HEADER..] {
            *byte = random.bits() as u8;
        }
        let mut fire = Simulation::new(values.clone());
        assert_eq!(fire.restore_burning(&wild), Ok(()));
        for _ in 0..20 {
            fire.step();
        }
        assert!(
            fire.particles()
                .iter()
                .all(|particle| particle.position.is_finite())
        );
    }
}
