//! Laws of solids that conduct heat: what gas loses, they gain and radiate.

use hearth_core::params::Input;
use hearth_core::{Scene, Simulation};
use hearth_tests::fires;

const AIR: f64 = 293.0;
const DIAMETER: f64 = 0.3;
/// Heat capacity by volume [kJ/(m³·K)].
const CAPACITY: f64 = 20.0;

/// A closed box of gas around a disc that conducts heat.
fn scene(values: &[(&str, f64)], temperature: f64) -> Scene {
    let mut scene = fires::closed_box(values);
    let added = scene.add(&[
        ("kind", Input::Text("solid")),
        ("y", Input::Number(0.4)),
        ("width", Input::Number(DIAMETER)),
        ("thermal", Input::Text("conducting")),
        ("temperature", Input::Number(temperature)),
        ("heat_capacity", Input::Number(CAPACITY)),
    ]);
    assert_eq!(added, Ok(2));
    scene
}

fn temperature(fire: &Simulation) -> f64 {
    let mut all = fire.solid_temperatures();
    let solid = all.next();
    assert!(all.next().is_none(), "an image is no solid of its own");
    solid.map_or(f64::NAN, |(_, temperature)| f64::from(temperature))
}

#[test]
fn a_solid_gains_what_the_gas_loses_but_for_its_radiation() {
    let start = 600.0;
    let fire = Simulation::new(scene(&[("diffusion", 5e-3)], AIR));
    let mut gas = fire.particles();
    for particle in &mut gas {
        particle.temperature = start as f32;
    }
    let mut fire = fire;
    assert_eq!(fire.set_particles(&gas), Ok(()));
    let heat = |fire: &Simulation| -> f64 { fire.temperatures().into_iter().map(f64::from).sum() };
    // Gas of 0.8 m × 0.8 m less the disc, with 1 kJ/(kg·K).
    let area = std::f64::consts::PI * 0.25 * DIAMETER * DIAMETER;
    let density = f64::from(fire.parameters().ambient_density);
    let mass = density * (0.64 - area) / fire.count() as f64;
    let (before, mut radiated) = (heat(&fire), 0.0);
    while fire.time() < 1.0 {
        let hot = temperature(&fire);
        fire.step();
        // ε σ (T⁴ − T_air⁴) [kW/m²].
        let flux = 0.9 * 5.670_374e-11 * (hot.powi(4) - AIR.powi(4));
        radiated += flux * std::f64::consts::PI * DIAMETER * fire.step_length();
    }
    let lost = mass * (before - heat(&fire));
    let gained = CAPACITY * area * (temperature(&fire) - AIR);
    assert!(
        gained > 20.0 * radiated,
        "{gained} kJ/m, {radiated} radiated"
    );
    // The gas beside the disc is denser or thinner than the mean by some percent.
    let rest = (lost - gained - radiated) / gained;
    assert!(rest.abs() < 0.05, "{lost} kJ/m lost, {gained} gained");
}

#[test]
fn a_solid_warms_in_a_flame_and_cools_after_it() {
    let mut scene = fires::combustion(&[]);
    for (id, name) in [("edges", "open"), ("floor", "solid")] {
        assert_eq!(scene.set(id, name), Ok(()));
    }
    let mut fire = Simulation::new(scene.clone());
    let base = f64::from(fires::source(&scene).y);
    let fields = [
        ("kind", Input::Text("solid")),
        ("y", Input::Number(base + 0.2)),
        ("width", Input::Number(0.06)),
        ("thermal", Input::Text("conducting")),
        ("heat_capacity", Input::Number(CAPACITY)),
    ];
    assert_eq!(scene.add(&fields), Ok(2));
    fire.set_scene(scene);
    assert_eq!(temperature(&fire), AIR);
    fires::burn_on(&mut fire, 4.0);
    let hot = temperature(&fire);
    assert!(hot > 400.0, "{hot} K");
    let flame = fire.temperatures().into_iter().fold(0.0, f32::max);
    assert!(hot < f64::from(flame), "{hot} K in a flame of {flame} K");
    assert_eq!(fire.set("fuel_power", 0.0), Ok(()));
    fires::burn_on(&mut fire, 4.0);
    assert!(temperature(&fire) < hot - 20.0, "{} K", temperature(&fire));
}

#[test]
fn a_moved_solid_keeps_its_temperature_and_a_new_value_replaces_it() {
    let mut fire = Simulation::new(scene(&[], 900.0));
    fires::burn_on(&mut fire, 0.2);
    let cooled = temperature(&fire);
    assert!((AIR..899.0).contains(&cooled), "{cooled} K");
    let change = |fire: &mut Simulation, name: &str, x: f64| {
        let mut scene = fire.scene().clone();
        assert_eq!(scene.change(2, &[(name, Input::Number(x))]), Ok(()));
        fire.set_scene(scene);
    };
    change(&mut fire, "x", 0.05);
    assert_eq!(temperature(&fire), cooled);
    change(&mut fire, "temperature", 700.0);
    assert_eq!(temperature(&fire), 700.0);
}

#[test]
fn a_solid_at_an_edge_has_one_temperature() {
    let mut scene = scene(&[], 900.0);
    assert_eq!(scene.change(2, &[("x", Input::Number(0.4))]), Ok(()));
    let mut fire = Simulation::new(scene);
    fires::burn_on(&mut fire, 0.2);
    assert!((AIR..899.0).contains(&temperature(&fire)));
}

#[test]
fn a_restored_solid_has_the_temperature_that_it_had() {
    let mut hot = scene(&[], 900.0);
    // One at an edge, with an image, and one that conducts no heat.
    assert_eq!(hot.change(2, &[("x", Input::Number(0.4))]), Ok(()));
    for (thermal, y) in [("fixed", 0.1), ("conducting", 0.7)] {
        let added = hot.add(&[
            ("kind", Input::Text("solid")),
            ("width", Input::Number(0.1)),
            ("y", Input::Number(y)),
            ("thermal", Input::Text(thermal)),
            ("temperature", Input::Number(500.0)),
        ]);
        assert!(added.is_ok(), "{added:?}");
    }
    let mut fire = Simulation::new(hot.clone());
    fires::burn_on(&mut fire, 0.3);
    let saved = fire.burning().unwrap_or_default();
    let all = |fire: &Simulation| fire.solid_temperatures().collect::<Vec<_>>();
    let cooled = all(&fire);
    assert_eq!(cooled.len(), 2);
    assert!(
        cooled
            .iter()
            .all(|solid| solid.1 < 899.0 && solid.1 != 500.0)
    );
    let mut restored = Simulation::new(hot.clone());
    assert_eq!(restored.restore_burning(&saved), Ok(()));
    assert_eq!(all(&restored), cooled);

    // Damaged ones change nothing.
    let mut restored = Simulation::new(hot.clone());
    let mut damaged = Vec::from([saved[..saved.len() - 4].to_vec(), saved.clone()]);
    damaged[1].truncate(saved.len() - 4);
    damaged[1].extend(f32::NAN.to_le_bytes());
    for bytes in damaged {
        assert!(restored.restore_burning(&bytes).is_err());
        assert_eq!(all(&restored)[0].1, 900.0);
    }
}
