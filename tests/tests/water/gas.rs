//! What droplets and gas exchange.

use hearth_core::random::Random;
use hearth_core::{Simulation, SprayError, Vec2};
use hearth_tests::fires::{burn_on, closed_box, combustion, everything, filled, in_the_open, mean};
use hearth_tests::fires::{watch, with};

use super::{assert_balanced, open, spray, sprayed, with_solid};

/// Specific heat [kJ/(kg·K)], boiling point [K] and heat of vaporisation [kJ/kg] of water.
const CAPACITY: f64 = 4.18;
const BOILING: f64 = 373.15;
const VAPORISATION: f64 = 2257.0;

/// A closed box of gas of a temperature, without weight.
fn hot_box(kelvin: f32) -> Simulation {
    filled(closed_box(&[("diffusion", 0.0)]), 30, |particle| {
        particle.temperature = kelvin;
    })
}

/// Heat of the gas of a closed box relative to 0 K [kJ/m].
fn heat(fire: &Simulation) -> f64 {
    let density = f64::from(fire.parameters().ambient_density);
    density * 0.64 * mean(fire.temperatures())
}

#[test]
fn the_gas_loses_what_the_water_takes() {
    for (kelvin, mass) in [(500.0, 0.002), (1000.0, 0.02), (1800.0, 0.05)] {
        let mut fire = hot_box(kelvin);
        let before = heat(&fire);
        let middle = Vec2::new(0.0, 0.4);
        assert_eq!(fire.spray(middle, Vec2::new(0.5, 0.0), mass), Ok(()));
        watch(&mut fire, 0.5, assert_balanced);
        let all = sprayed(&fire);
        let lost = before - heat(&fire);
        assert!(
            (lost - all.heat).abs() < 0.01 * lost,
            "{lost} kJ/m of gas, {all:?}"
        );
        // None has struck anything, so all of the heat is in the water.
        assert_eq!(all.run_off, 0.0, "{all:?}");
        let air = f64::from(fire.parameters().ambient_temperature);
        let flying = fire.droplets().iter().map(|droplet| {
            f64::from(droplet.mass) * CAPACITY * (f64::from(droplet.temperature) - air)
        });
        let vapour = all.evaporated * (CAPACITY * (BOILING - air) + VAPORISATION);
        let taken = flying.sum::<f64>() + vapour;
        assert!(all.evaporated > 0.0, "{all:?}");
        assert!((taken - lost).abs() < 0.01 * lost, "{taken} of {lost} kJ/m");
        assert!(
            fire.droplets()
                .iter()
                .all(|droplet| f64::from(droplet.temperature) <= BOILING + 0.01)
        );
    }
}

#[test]
fn cold_air_evaporates_no_water_and_the_hotter_gas_the_more() {
    let evaporated = |kelvin: f32| {
        let mut fire = hot_box(kelvin);
        assert_eq!(fire.spray(Vec2::new(0.0, 0.4), Vec2::ZERO, 0.01), Ok(()));
        burn_on(&mut fire, 0.5);
        sprayed(&fire).evaporated
    };
    let all = [293.0, 600.0, 1000.0, 1600.0].map(evaporated);
    assert_eq!(all[0], 0.0);
    assert!(all.is_sorted() && all[1] < all[2], "{all:?}");
}

#[test]
fn the_squared_diameter_falls_evenly_in_hot_gas() {
    // So little water that the gas stays hot.
    let mut fire = hot_box(1600.0);
    assert_eq!(fire.spray(Vec2::new(0.0, 0.4), Vec2::ZERO, 1e-6), Ok(()));
    let mut all = Vec::new();
    watch(&mut fire, 3.0, |fire| {
        // They all shrink alike, so it is always the same one.
        let largest = fire.droplets().iter();
        let largest = largest.max_by(|a, b| a.diameter.total_cmp(&b.diameter));
        let boils = largest.filter(|droplet| f64::from(droplet.temperature) > BOILING - 0.01);
        if let Some(droplet) = boils {
            all.push((fire.time(), f64::from(droplet.diameter * droplet.diameter)));
        }
    });
    let (first, last) = (all[0], all[all.len() * 3 / 4]);
    let middle = all[all.len() * 3 / 8];
    let slope = |(t, first): (f64, f64), (u, second): (f64, f64)| (first - second) / (u - t);
    let (early, late) = (slope(first, middle), slope(middle, last));
    assert!(last.1 < 0.8 * first.1, "{} of {}", last.1, first.1);
    assert!((early / late - 1.0).abs() < 0.05, "{early}, then {late}");
    // K = 8 λ ln(1 + B)/(ρ c), with λ of air of 1600 K by its three quarters' power.
    let transfer = (1600.0 - BOILING) / VAPORISATION;
    let conductivity = 2.57e-5 * (1600.0_f64 / 293.0).powf(0.75);
    let expected = 8.0 * conductivity * (1.0 + transfer).ln() / transfer / 1000.0
        * (1600.0 - BOILING)
        / VAPORISATION;
    assert!(
        (early / expected - 1.0).abs() < 0.1,
        "{early} of {expected} m²/s"
    );
}

#[test]
fn gas_and_droplets_keep_their_momentum() {
    let mut fire = hot_box(293.0);
    let density = f64::from(fire.parameters().ambient_density);
    let particle = density * 0.64 / fire.count() as f64;
    let momentum = |fire: &Simulation| {
        let gas: f64 = fire.velocities().iter().map(|v| f64::from(v.x)).sum();
        let drops = fire.droplets().iter();
        let drops = drops.map(|droplet| f64::from(droplet.mass) * f64::from(droplet.velocity.x));
        (particle * gas, drops.sum::<f64>())
    };
    let still = momentum(&fire).0;
    assert_eq!(
        fire.spray(Vec2::new(-0.2, 0.4), Vec2::new(3.0, 0.0), 0.01),
        Ok(())
    );
    let (_, thrown) = momentum(&fire);
    burn_on(&mut fire, 0.15);
    let (gas, drops) = momentum(&fire);
    assert!(gas - still > 0.3 * thrown, "{gas} of {thrown}");
    assert!(
        (gas - still + drops - thrown).abs() < 0.02 * thrown,
        "{gas} and {drops} of {thrown}"
    );
}

#[test]
fn water_falls_faster_than_the_small_droplets_and_lands_on_the_floor() {
    let mut fire = Simulation::new(open(&[]));
    assert_eq!(fire.spray(Vec2::new(0.0, 1.0), Vec2::ZERO, 0.01), Ok(()));
    burn_on(&mut fire, 0.3);
    let mut drops = fire.droplets().to_vec();
    drops.sort_by(|a, b| a.diameter.total_cmp(&b.diameter));
    let (small, large) = (drops[0], drops[drops.len() - 1]);
    assert!(large.velocity.y < small.velocity.y, "{small:?}, {large:?}");
    burn_on(&mut fire, 3.0);
    let all = sprayed(&fire);
    assert!((all.run_off / all.sprayed - 1.0).abs() < 1e-4, "{all:?}");
    assert_balanced(&fire);
}

#[test]
fn a_hot_plume_cools_by_what_evaporates_in_it() {
    let mut dry = Simulation::new(in_the_open(combustion(&[("ember_rate", 0.0)]), 3000));
    burn_on(&mut dry, 2.0);
    let mut wet = dry.clone();
    // In the plume above the flame, beyond the reach of what it lands on.
    let jet = [Vec2::new(0.0, 1.2), Vec2::new(0.0, 1.0)];
    spray(&mut wet, jet, (0.02, 0.4), |_| ());
    burn_on(&mut dry, 0.4);
    let hotness = |fire: &Simulation| {
        let all = fire.temperatures();
        let air = fire.parameters().ambient_temperature;
        all.iter()
            .map(|kelvin| f64::from(kelvin - air))
            .sum::<f64>()
    };
    assert!(sprayed(&wet).evaporated > 0.0);
    assert!(hotness(&wet) < hotness(&dry));
}

#[test]
fn no_droplet_is_inside_of_a_solid_or_goes_through_a_plate() {
    // Of the first place, after the numbers of the fire.
    const GAP: usize = 6 + 7;
    for (motion, amplitude) in [("still", 0.0), ("sway", 0.1)] {
        let numbers = [
            ("y", 0.5),
            ("width", 0.6),
            ("height", 0.01),
            ("angle", 20.0),
            ("sway", amplitude),
        ];
        let texts = [("shape", "line"), ("motion", motion)];
        let mut fire = Simulation::new(with_solid(open(&[]), &texts, &numbers));
        let jet = [Vec2::new(0.0, 1.0), Vec2::new(0.0, -15.0)];
        let (mut steps, mut checked) = (0, 0);
        spray(&mut fire, jet, (0.2, 1.0), |fire| {
            steps += 1;
            let in_air = fire
                .droplets()
                .iter()
                .filter(|droplet| droplet.waits <= 0.0);
            let near = in_air.filter(|droplet| droplet.position.y < 0.8).take(10);
            for droplet in near.filter(|_| steps % 12 == 0) {
                checked += 1;
                let gap = fire.measure(droplet.position)[GAP];
                assert!(gap > -1e-4, "{gap} m at {:?}", droplet.position);
                let is_behind = droplet.position.y < 0.3 && droplet.position.x.abs() < 0.1;
                assert!(!is_behind, "{:?} is through the plate", droplet.position);
            }
        });
        assert!(checked > 20, "{checked}");
        assert!(sprayed(&fire).run_off > 0.0);
        assert_balanced(&fire);
    }
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn random_sprays_keep_everything_finite() {
    let mut random = Random::new(5);
    for edges in ["open", "periodic"] {
        let mut settings = everything();
        if edges == "open" {
            settings = in_the_open(settings, 1500);
        }
        let texts = [("shape", "circle"), ("thermal", "conducting")];
        let numbers = [("y", 0.7), ("x", 0.2), ("temperature", 900.0)];
        let mut fire = Simulation::new(with_solid(settings, &texts, &numbers));
        for _ in 0..300 {
            let place = Vec2::new(random.between(-1.0, 1.0), random.between(-0.5, 2.0));
            let far = 10.0_f32.powf(random.between(-2.0, 3.0));
            let velocity = Vec2::new(random.between(-far, far), random.between(-far, far));
            let mass = 10.0_f32.powf(random.between(-9.0, 2.0));
            assert_eq!(fire.spray(place, velocity, mass), Ok(()));
            for _ in 0..3 {
                fire.step();
            }
        }
        for (place, velocity, mass) in [
            (Vec2::NAN, Vec2::ZERO, 0.1),
            (Vec2::new(0.0, 0.5), Vec2::NAN, 0.1),
            (Vec2::new(0.0, 0.5), Vec2::ZERO, f32::NAN),
            (Vec2::new(0.0, 0.5), Vec2::ZERO, -1.0),
            (Vec2::new(f32::INFINITY, 0.5), Vec2::ZERO, 1.0),
        ] {
            assert_eq!(fire.spray(place, velocity, mass), Ok(()));
        }
        assert_balanced(&fire);
        assert!(
            fire.temperatures().iter().all(|kelvin| *kelvin > 250.0),
            "{edges}"
        );
        assert!(fire.positions().iter().all(|at| at.is_finite()), "{edges}");
        assert!(
            fire.velocities().iter().all(|v| v.length() < 1000.0),
            "{edges}"
        );
        let mut drops = fire.droplets().iter();
        assert!(drops.all(|droplet| droplet.position.is_finite() && droplet.velocity.is_finite()));
    }
}

#[test]
fn the_classic_model_refuses_water() {
    let mut fire = Simulation::new(with([]));
    let refused = fire.spray(Vec2::new(0.0, 0.5), Vec2::ZERO, 0.01);
    assert_eq!(refused, Err(SprayError));
    let words = "model must be combustion: the classic model has no water";
    assert_eq!(
        refused.map_err(|error| error.to_string()),
        Err(words.into())
    );
    assert_eq!((fire.sprayed(), fire.droplets().len()), (None, 0));
}

#[test]
fn a_spray_of_no_water_changes_no_bits() {
    let mut sprayed = Simulation::new(in_the_open(combustion(&[]), 900));
    let mut other = sprayed.clone();
    assert_eq!(sprayed.spray(Vec2::new(0.0, 0.5), Vec2::ZERO, 0.0), Ok(()));
    burn_on(&mut sprayed, 0.5);
    burn_on(&mut other, 0.5);
    assert_eq!(sprayed.particles(), other.particles());
}
