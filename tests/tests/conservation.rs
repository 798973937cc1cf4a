//! What the combustion model keeps: particles, mass, momentum, heat and matter.

use hearth_core::params::Model;
use hearth_core::random::Random;
use hearth_core::{Parameters, Particle, Simulation, Vec2};
use hearth_tests::fires::{burn_on, closed_box, combustion, filled, watch};

const SIDE: u32 = 32;

/// Two sums in double precision: of the numbers, and of their magnitudes.
fn sums(numbers: impl IntoIterator<Item = f32>) -> (f64, f64) {
    let mut sums = (0.0, 0.0);
    for number in numbers.into_iter().map(f64::from) {
        sums.0 += number;
        sums.1 += number.abs();
    }
    sums
}

/// A number for a place, as if drawn at random from −1 to 1.
fn chance(at: Vec2, salt: u32) -> f32 {
    let bits = at.x.to_bits() ^ at.y.to_bits().rotate_left(16);
    Random::new(bits.wrapping_add(salt)).between(-1.0, 1.0)
}

/// Gas of which each particle flies its own way, as hot as it happens to be,
/// and colder than what could burn.
fn randomise(particle: &mut Particle) {
    let at = particle.position;
    particle.velocity = Vec2::new(chance(at, 1), chance(at, 2));
    particle.temperature = 550.0 + 250.0 * chance(at, 3);
    particle.fuel = 0.5 + 0.5 * chance(at, 4);
    particle.oxygen = 0.5 + 0.5 * chance(at, 5);
    particle.soot = 1.0 + chance(at, 6);
}

#[test]
fn a_closed_box_conserves_momentum() {
    for expansion in [0.0, 0.5, 1.0] {
        let mut gas = filled(
            closed_box(&[
                ("gas_expansion", expansion),
                ("kinematic_viscosity", 0.005),
                ("artificial_viscosity", 0.5),
                ("eddy_viscosity", 0.4),
                ("diffusion", 0.002),
                ("shifting", 1.0),
                // It burns as well.
                ("ignition_temperature", 500.0),
            ]),
            SIDE,
            randomise,
        );
        let momentum = |gas: &Simulation| {
            let velocities = gas.velocities();
            let (x, all_x) = sums(velocities.iter().map(|v| v.x));
            let (y, all_y) = sums(velocities.iter().map(|v| v.y));
            (x, y, all_x + all_y)
        };
        let (x, y, all) = momentum(&gas);
        (0..400).for_each(|_| gas.step());
        let (x_then, y_then, all_then) = momentum(&gas);
        assert!(
            gas.report().power.unwrap_or_default() > 0.0,
            "nothing burns"
        );
        assert!(all_then < 0.9 * all, "nothing slowed down");
        let drift = f64::hypot(x_then - x, y_then - y);
        assert!(drift < 2e-6 * all, "{drift} of {all}");
    }
}

/// Mass of one particle, from the volumes that the renderer gets and the densities.
fn mass(fire: &Simulation) -> f64 {
    let mut instances = Vec::new();
    fire.write_instances(&mut instances);
    let seen = instances.len() as f64;
    let volumes: f64 = instances.iter().map(|i| f64::from(i[5])).sum();
    // A particle of the picture and one of the readers are the same where their
    // places are.
    let (places, densities) = (fire.positions(), fire.densities());
    let inverse: f64 = instances
        .iter()
        .filter_map(|i| {
            let same = |at: &Vec2| at.x == i[0] && at.y == i[1];
            Some(f64::from(densities[places.iter().position(same)?]).recip())
        })
        .sum();
    assert!(seen > 20.0, "too little to weigh");
    volumes / inverse
}

#[test]
fn any_fire_conserves_particles_and_mass() {
    for values in [
        &[][..],
        &[("gas_expansion", 1.0), ("wind", 2.0), ("turbulence", 8.0)],
        &[("seam", 0.2), ("fuel_power", 600.0), ("shifting", 1.0)],
        &[("seam", 0.0), ("ember_rate", 1000.0)],
    ] {
        let mut fire = Simulation::new(combustion(values));
        let parameters = fire.parameters();
        let air = f64::from(parameters.ambient_density);
        let area = f64::from(parameters.domain_width) * f64::from(parameters.domain_height);
        let count = fire.count();
        for _ in 0..4 {
            burn_on(&mut fire, 0.4);
            assert_eq!(fire.count(), count);
            let total = mass(&fire) * count as f64;
            assert!((total / (air * area) - 1.0).abs() < 1e-5, "{total}");
        }
    }
}

#[test]
fn diffusion_conserves_heat_and_matter_and_creates_no_extremes() {
    let mut gas = filled(
        closed_box(&[
            ("diffusion", 0.005),
            ("eddy_viscosity", 0.4),
            ("ignition_temperature", 900.0),
            ("smoke_life", 10.0),
        ]),
        SIDE,
        randomise,
    );
    let fields = |gas: &Simulation| {
        [
            gas.temperatures(),
            gas.fuels().unwrap_or_default(),
            gas.oxygens().unwrap_or_default(),
            gas.soots().unwrap_or_default(),
        ]
    };
    let extremes = |field: &[f32]| {
        let min = field.iter().copied().fold(f32::INFINITY, f32::min);
        (min, field.iter().copied().fold(0.0, f32::max))
    };
    let before = fields(&gas);
    // Cold soot fades by an amount that follows from the lengths of the steps.
    let mut left = 1.0;
    for _ in 0..400 {
        gas.step();
        let report = gas.report();
        for _ in 0..report.substeps {
            left /= 1.0 + f64::from(report.length) / f64::from(report.substeps) / 10.0;
        }
    }
    assert_eq!(gas.report().power, Some(0.0), "it burns");
    for (name, (before, after)) in ["T", "F", "O", "S"]
        .iter()
        .zip(before.into_iter().zip(fields(&gas)))
    {
        let lasting = if *name == "S" { left } else { 1.0 };
        let (sum, _) = sums(before.iter().copied());
        let (sum_then, _) = sums(after.iter().copied());
        let kept = sum_then / (sum * lasting);
        assert!((kept - 1.0).abs() < 1e-5, "{name}: {kept}");

        let ((low, high), (low_then, high_then)) = (extremes(&before), extremes(&after));
        let lasting = lasting as f32;
        assert!(low_then >= low * lasting, "{name}: {low} → {low_then}");
        assert!(high_then <= high, "{name}: {high} → {high_then}");
        let (range, range_then) = (high - low, high_then - low_then);
        assert!(range_then < 0.5 * range, "{name}: {range} → {range_then}");
    }
}

#[test]
fn a_closed_adiabatic_box_gains_the_heat_of_combustion() {
    let scene = closed_box(&[("gas_expansion", 1.0), ("burn_time", 0.05)]);
    let parameters = scene.world();
    let (rise, demand) = (
        f64::from(parameters.flame_rise),
        f64::from(parameters.air_demand),
    );
    let area = f64::from(parameters.domain_width * parameters.domain_height);
    let mass = f64::from(parameters.ambient_density) * area / f64::from(SIDE * SIDE);
    let mut gas = filled(scene, SIDE, |particle| {
        let at = particle.position;
        particle.temperature = 750.0 + 100.0 * chance(at, 1);
        particle.fuel = 0.15 + 0.1 * chance(at, 2);
    });
    let heat = |gas: &Simulation| mass * sums(gas.temperatures()).0;
    let fuel = |gas: &Simulation| mass * sums(gas.fuels().unwrap_or_default()).0;
    let oxygen = |gas: &Simulation| mass * sums(gas.oxygens().unwrap_or_default()).0;
    let (heat_before, fuel_before, oxygen_before) = (heat(&gas), fuel(&gas), oxygen(&gas));
    let mut burnt = 0.0;
    watch(&mut gas, 0.25, |gas| {
        let report = gas.report();
        burnt += f64::from(report.power.unwrap_or_default()) * f64::from(report.length);
    });
    // The heat capacity is 1 kJ/(kg K).
    let gained = heat(&gas) - heat_before;
    let eaten = fuel_before - fuel(&gas);
    assert!(eaten > 0.9 * fuel_before, "{eaten} of {fuel_before}");
    assert!((gained / burnt - 1.0).abs() < 1e-3, "{gained} of {burnt}");
    let worth = eaten * rise * (1.0 + demand);
    assert!((worth / burnt - 1.0).abs() < 1e-3, "{worth} for {burnt}");
    let breathed = oxygen_before - oxygen(&gas);
    let needed = eaten * demand;
    assert!((breathed / needed - 1.0).abs() < 1e-3, "{breathed}");
}

#[test]
fn all_fuel_burns() {
    let mut fire = Simulation::new(Parameters::new(Model::Combustion));
    burn_on(&mut fire, 1.0);
    let nominal = f64::from(fire.scene().power());
    let (mut burnt, from) = (0.0, fire.time());
    watch(&mut fire, 4.0, |fire| {
        let report = fire.report();
        burnt += f64::from(report.power.unwrap_or_default()) * f64::from(report.length);
    });
    let power = burnt / (fire.time() - from);
    assert!(
        (power / nominal - 1.0).abs() < 0.02,
        "{power} of {nominal} kW/m"
    );
}
