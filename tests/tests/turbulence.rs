//! Turbulence stirs, in both models, by chance and yet the same each time.

use hearth_core::params::Model;
use hearth_core::{Particle, Scene, Simulation};
use hearth_tests::fires::{burn, burn_on, combustion, watch, with_numbers};

/// A fire of either model with these values.
fn of(model: Model, values: &[(&str, f64)]) -> Scene {
    match model {
        Model::Classic => with_numbers(values),
        Model::Combustion => combustion(values),
    }
}

const MODELS: [Model; 2] = [Model::Classic, Model::Combustion];

fn burnt(model: Model, values: &[(&str, f64)]) -> Vec<Particle> {
    burn(of(model, values), 0.8).particles()
}

#[test]
fn turbulence_depends_on_the_seed() {
    for model in MODELS {
        let stirred = |seed: f64| burnt(model, &[("turbulence", 5.0), ("seed", seed)]);
        assert_eq!(stirred(1.0), stirred(1.0));
        assert_ne!(stirred(1.0), stirred(2.0));
    }
}

#[test]
fn without_turbulence_no_bit_changes() {
    for model in MODELS {
        let plain = burnt(model, &[]);
        let sizes = [0.03, 0.6];
        for size in sizes {
            let none = [("turbulence", 0.0), ("turbulence_scale", size)];
            assert_eq!(burnt(model, &none), plain);
        }
        assert_ne!(burnt(model, &[("turbulence", 0.01)]), plain);
    }
}

#[test]
fn stronger_turbulence_accelerates_still_air_more() {
    let energy = |turbulence: f64| {
        let mut air = burn(
            combustion(&[("fuel_power", 0.0), ("turbulence", turbulence)]),
            0.5,
        );
        let (mut sum, mut n) = (0.0, 0.0);
        watch(&mut air, 0.5, |air| {
            let velocities = air.velocities();
            sum += velocities.iter().map(|v| v.length_squared()).sum::<f32>() / 2.0;
            n += velocities.len() as f32;
        });
        sum / n
    };
    let energies = [0.0, 1.0, 3.0, 10.0].map(energy);
    assert!(energies[0] < 1e-3, "{energies:?}");
    assert!(
        energies.windows(2).all(|pair| pair[1] > 2.0 * pair[0]),
        "{energies:?}"
    );
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn stronger_turbulence_sways_the_classic_fire_more() {
    let sway = |turbulence: f64| {
        let (mut sum, mut n) = (0.0, 0.0);
        for seed in [1.0, 2.0, 3.0] {
            let mut fire = burn(
                with_numbers(&[("turbulence", turbulence), ("seed", seed)]),
                1.0,
            );
            watch(&mut fire, 1.5, |fire| {
                let velocities = fire.velocities();
                sum += velocities.iter().map(|v| v.x * v.x).sum::<f32>();
                n += velocities.len() as f32;
            });
        }
        sum / n
    };
    let sways = [0.0, 4.0, 10.0].map(sway);
    assert!(
        sways.windows(2).all(|pair| pair[1] > 1.1 * pair[0]),
        "{sways:?}"
    );
}

/// Power that burns, on average over some seconds [kW/m].
fn power(values: &[(&str, f64)]) -> f64 {
    let mut fire = Simulation::new(combustion(values));
    burn_on(&mut fire, 1.5);
    let (mut burnt, from) = (0.0, fire.time());
    watch(&mut fire, 4.0, |fire| {
        let report = fire.report();
        burnt += f64::from(report.power.unwrap_or_default()) * f64::from(report.length);
    });
    burnt / (fire.time() - from)
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn emission_noise_moves_the_flames_and_keeps_the_power() {
    let powers = [0.0, 0.2, 1.0].map(|noise| power(&[("emission_noise", noise)]));
    for power in powers {
        assert!((power / powers[0] - 1.0).abs() < 0.02, "{powers:?}");
    }
    assert!(powers[2] != powers[0], "the noise does nothing");
}
