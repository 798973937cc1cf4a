//! Hot gas, fire and smoke in the combustion model.

use hearth_core::{Particle, Simulation, Vec2};
use hearth_tests::fingerprint;
use hearth_tests::fires::{burn, burn_on, closed_box, combustion, filled, mean, watch};

const SIDE: u32 = 32;

/// Where the round spot is in the middle of the box.
fn in_the_spot(at: Vec2) -> bool {
    at.distance(Vec2::new(0.0, 0.4)) < 0.2
}

/// A box with a round spot of gas that is `hot` \[K\].
fn with_a_spot(values: &[(&str, f64)], hot: f32) -> Simulation {
    filled(closed_box(values), SIDE, |particle: &mut Particle| {
        if in_the_spot(particle.position) {
            particle.temperature = hot;
        }
    })
}

/// The means of a figure over the particles that began in the spot, and over
/// the others.
fn in_and_out(gas: &Simulation, began: &[Vec2], figure: &[f32]) -> (f64, f64) {
    assert_eq!(gas.count(), began.len());
    let of = |inside: bool| {
        let chosen = figure.iter().zip(began);
        let chosen = chosen.filter(|(_, at)| in_the_spot(**at) == inside);
        mean(chosen.map(|(number, _)| *number))
    };
    (of(true), of(false))
}

/// The root mean square of the speed of all gas.
fn agitation(gas: &Simulation) -> f64 {
    mean(gas.velocities().iter().map(|v| v.length_squared())).sqrt()
}

#[test]
fn noise_in_gas_at_rest_decays_whether_it_is_cold_or_the_hottest() {
    // The fastest sound is that of the hottest gas, with the longest step where nothing moves. Steps beyond
    // the stable ones agitate it to 1 m/s within a second.
    for kelvin in [293.0, 1500.0, 3700.0] {
        for side in [SIDE - 3, SIDE, SIDE + 2] {
            let still = closed_box(&[("gas_expansion", 1.0)]);
            let mut gas = filled(still, side, |particle| particle.temperature = kelvin);
            let [early, late] = [0.3, 1.2].map(|time| {
                while gas.time() < time {
                    gas.step();
                }
                agitation(&gas)
            });
            assert!(
                late < 0.8 * early && late < 0.1,
                "{early} and {late} m/s at {kelvin} K"
            );
        }
    }
}

#[test]
fn hot_gas_is_thinner_by_its_expansion() {
    for (expansion, hot) in [(1.0, 1172.0), (1.0, 586.0), (0.5, 1172.0), (0.0, 1172.0)] {
        // No heat passes over, and the sound of the expansion dies down.
        let still = [
            ("gas_expansion", expansion),
            ("diffusion", 0.0),
            ("eddy_viscosity", 0.0),
            ("kinematic_viscosity", 0.01),
            ("artificial_viscosity", 0.5),
        ];
        let mut gas = with_a_spot(&still, hot);
        let began = gas.positions();
        burn_on(&mut gas, 1.0);
        let (mut thin, mut dense) = (0.0, 0.0);
        watch(&mut gas, 0.5, |gas| {
            let (inside, outside) = in_and_out(gas, &began, &gas.densities());
            (thin, dense) = (thin + inside, dense + outside);
        });
        let expected = f64::from(293.0 / hot).powf(expansion);
        let ratio = thin / dense;
        assert!(
            (ratio / expected - 1.0).abs() < 0.03,
            "expansion {expansion}, {hot} K: {ratio} instead of {expected}"
        );
    }
}

/// How far a spot of that temperature rises in a moment \[m\].
fn risen(hot: f32, buoyancy: f64) -> f64 {
    // A closed box has no floor to rise from.
    let lifted = [("gravity", 9.81), ("buoyancy", buoyancy), ("seam", 0.05)];
    let mut gas = with_a_spot(&lifted, hot);
    let began = gas.positions();
    burn_on(&mut gas, 0.2);
    let risen: Vec<f32> = gas
        .positions()
        .iter()
        .zip(&began)
        .map(|(now, then)| now.y - then.y)
        .collect();
    in_and_out(&gas, &began, &risen).0
}

#[test]
fn hot_gas_rises_in_proportion_to_its_buoyancy_and_cold_gas_sinks() {
    let hot = [0.0, 0.5, 1.0, 2.0].map(|buoyancy| risen(900.0, buoyancy));
    assert!(hot[0].abs() < 0.005, "{hot:?}");
    assert!(hot[2] > 0.03, "{hot:?}");
    let ratio = hot[3] / hot[1];
    assert!((2.5..5.0).contains(&ratio), "{hot:?}");
    assert!(hot.windows(2).all(|pair| pair[1] > pair[0]), "{hot:?}");
    assert!(risen(150.0, 1.0) < -0.02);
}

#[test]
fn heat_spreads_into_the_cold() {
    let mut gas = with_a_spot(&[("diffusion", 0.01)], 900.0);
    let began = gas.positions();
    let (mut hot, mut cold) = in_and_out(&gas, &began, &gas.temperatures());
    assert_eq!((hot as f32, cold as f32), (900.0, 293.0));
    for _ in 0..3 {
        burn_on(&mut gas, 0.1);
        let temperatures = gas.temperatures();
        let (hot_then, cold_then) = in_and_out(&gas, &began, &temperatures);
        assert!(hot_then < hot - 10.0, "{hot} → {hot_then}");
        assert!(cold_then > cold + 1.0, "{cold} → {cold_then}");
        (hot, cold) = (hot_then, cold_then);
        // Nothing becomes hotter than the hot or colder than the cold.
        let possible = 292.9..=900.1;
        assert!(temperatures.iter().all(|t| possible.contains(t)));
    }
}

#[test]
fn hotter_gas_radiates_faster() {
    let cooled = |hot: f32| {
        let values = [
            ("radiative_cooling", 500.0),
            ("diffusion", 0.0),
            ("eddy_viscosity", 0.0),
        ];
        let mut gas = filled(closed_box(&values), SIDE, |particle| {
            particle.temperature = hot
        });
        burn_on(&mut gas, 0.01);
        let time = gas.time();
        (f64::from(hot) - mean(gas.temperatures())) / time
    };
    // K [(T/1500)⁴ − (Tₐ/1500)⁴]
    let air = (293.0_f64 / 1500.0).powi(4);
    for hot in [500.0_f32, 1000.0, 1500.0, 2000.0] {
        let expected = 500.0 * ((f64::from(hot) / 1500.0).powi(4) - air);
        let rate = cooled(hot);
        assert!((rate / expected - 1.0).abs() < 0.05, "{hot} K: {rate} K/s");
    }
}

#[test]
fn fuel_burns_only_where_it_is_hot_and_has_oxygen() {
    let burnt = |temperature: f32, oxygen: f32| {
        let mut gas = filled(closed_box(&[]), SIDE, |particle| {
            particle.temperature = temperature;
            particle.fuel = 0.2;
            particle.oxygen = oxygen;
        });
        burn_on(&mut gas, 0.3);
        0.2 - mean(gas.fuels().unwrap_or_default())
    };
    let ignition = closed_box(&[]).world().ignition_temperature;
    assert!(burnt(ignition - 10.0, 1.0).abs() < 1e-6);
    assert!(burnt(800.0, 0.0).abs() < 1e-6);
    assert!(burnt(ignition + 10.0, 1.0) > 0.15);
    // One part of fuel needs 1.5 parts of air: oxygen for 0.06 of it burns 0.04.
    let starved = burnt(800.0, 0.06);
    assert!((0.03..0.0401).contains(&starved), "{starved}");
}

#[test]
fn a_burner_without_power_does_not_change_the_air() {
    let mut instances = Vec::new();
    let fire = burn(combustion(&[("fuel_power", 0.0)]), 1.0);
    assert!(fire.temperatures().iter().all(|t| (t - 293.0).abs() < 1e-3));
    let each = |x: f32| Some(vec![x; fire.count()]);
    assert_eq!((fire.fuels(), fire.soots()), (each(0.0), each(0.0)));
    assert_eq!(fire.oxygens(), each(1.0));
    fire.write_instances(&mut instances);
    assert_eq!((instances.len(), fire.report().power), (0, Some(0.0)));
    assert!(fire.report().max_speed < 0.3, "{}", fire.report().max_speed);
}

#[test]
fn the_renderer_receives_all_visible_gas() {
    let fire = burn(combustion(&[]), 1.5);
    let mut instances = Vec::new();
    fire.write_instances(&mut instances);
    let seen = fire
        .temperatures()
        .into_iter()
        .zip(fire.soots().unwrap_or_default());
    let seen = seen.filter(|&(t, soot)| t > 400.0 || soot > 0.002).count();
    assert_eq!(instances.len(), seen);
    assert!(
        (50..fire.count()).contains(&seen),
        "{seen} of {}",
        fire.count()
    );
    let burning = instances.iter().filter(|i| i[7] > 0.0).count();
    let rates = fire.burn_rates().unwrap_or_default();
    assert_eq!(burning, rates.iter().filter(|&&rate| rate > 0.0).count());
    assert!(burning > 10, "{burning}");
}

/// A small flame, so that there is room for its smoke above it.
fn smoking(smoke_life: f64) -> Simulation {
    let small = [
        ("fuel_power", 60.0),
        ("source_width", 0.2),
        ("smoke_life", smoke_life),
    ];
    burn(combustion(&small), 3.0)
}

/// The mean soot between two heights, and the soot of cold gas and the speed at
/// which it rises, over some seconds.
struct Smoke {
    soot: Vec<f64>,
    rise: f64,
    cold: f64,
}

fn smoke(fire: &mut Simulation, layers: &[(f32, f32)]) -> Smoke {
    let mut soot = vec![0.0; layers.len()];
    let (mut n, mut carried, mut cold) = (0.0, 0.0, 0.0);
    watch(fire, 3.0, |fire| {
        n += 1.0;
        let particles = fire.particles();
        for (sum, &(low, high)) in soot.iter_mut().zip(layers) {
            let in_layer = |p: &&Particle| (low..high).contains(&p.position.y);
            *sum += mean(particles.iter().filter(in_layer).map(|p| p.soot));
        }
        for p in particles.iter().filter(|p| p.temperature < 800.0) {
            if p.position.y > layers[0].0 {
                carried += f64::from(p.soot * p.velocity.y);
                cold += f64::from(p.soot);
            }
        }
    });
    Smoke {
        soot: soot.iter().map(|sum| sum / n).collect(),
        rise: carried / cold,
        cold: cold / n,
    }
}

#[test]
fn smoke_outlives_the_flame_rises_and_decays() {
    let Smoke { soot, rise, cold } = smoke(&mut smoking(0.5), &[(0.9, 1.1), (1.2, 1.4)]);
    assert!(cold > 0.5, "{cold}");
    assert!(rise > 0.5, "{rise} m/s");
    assert!(soot[1] < 0.9 * soot[0], "{soot:?}");
    assert!(soot[1] > 0.001, "{soot:?}");
}

#[test]
fn a_longer_smoke_life_gives_more_smoke() {
    let high = [(1.2, 1.4)];
    let soots = [0.1, 0.4, 1.5, 10.0].map(|life| smoke(&mut smoking(life), &high).soot[0]);
    assert!(
        soots.windows(2).all(|pair| pair[1] > 1.1 * pair[0]),
        "{soots:?}"
    );
}

#[test]
fn the_seam_lets_no_smoke_in_from_below() {
    let mut fire = smoking(10.0);
    // Below the burner, which stands at 0.25 m, there is air and nothing else.
    let mut sootiest: f32 = 0.0;
    watch(&mut fire, 2.0, |fire| {
        for p in fire.particles() {
            if (0.05..0.15).contains(&p.position.y) {
                sootiest = sootiest.max(p.soot);
            }
        }
    });
    assert!(sootiest < 0.02, "{sootiest}");
}

#[test]
fn rolls_of_the_size_of_a_kernel_change_no_bit() {
    // C D* is 0.034 m with 0.1, and 2.5 C_s h is 0.035 m.
    let print = |mixing| fingerprint(combustion(&[("roll_mixing", mixing)]));
    let off = print(0.0);
    assert_eq!(print(0.1), off);
    assert_ne!(print(0.2), off);
}
