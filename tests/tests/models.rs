//! Two models, and the way from one to the other; live changes in the
//! combustion model that keep the fire burning.

use hearth_core::params::{Input, Model};
use hearth_core::{Scene, Simulation, StepReport};
use hearth_tests::fires::{burn, burn_on, combustion, mean, watch};
use hearth_tests::sweep;

fn set(fire: &mut Simulation, id: &str, value: f64) {
    assert_eq!(fire.set(id, Input::Number(value)), Ok(()));
}

fn switch(fire: &mut Simulation, model: &str) {
    assert_eq!(fire.set("model", Input::Text(model)), Ok(()));
}

/// Burns on, with all well at its end.
fn burns_well(fire: &mut Simulation) {
    assert_eq!(sweep::burn(fire, 0.5).fault(), None);
}

#[test]
fn the_model_of_a_burning_fire_can_change_and_change_back() {
    let mut fire = Simulation::new(Scene::default());
    let air = fire.count();
    burn_on(&mut fire, 0.5);
    for _ in 0..2 {
        switch(&mut fire, "classic");
        // A source that is about to be lit.
        assert_eq!((fire.count(), fire.time()), (0, 0.0));
        burns_well(&mut fire);
        assert_eq!(fire.parameters().model(), Model::Classic);
        assert!(fire.count() > 200, "{}", fire.count());
        assert!(fire.particles().iter().all(|p| p.lifetime.is_finite()));
        assert_eq!(
            (fire.power(), fire.fuels(), fire.soots()),
            (None, None, None)
        );
        assert_eq!((fire.oxygens(), fire.burn_rates()), (None, None));
        assert_eq!((fire.removed(), fire.fuel_total()), (None, None));
        let StepReport {
            power,
            preheat,
            asleep,
            ..
        } = fire.report();
        assert_eq!((power, preheat, asleep), (None, None, None));
        assert_eq!(fire.embers(), []);

        switch(&mut fire, "combustion");
        assert_eq!((fire.count(), fire.time()), (air, 0.0));
        assert!(fire.temperatures().iter().all(|&t| t == 293.0));
        burns_well(&mut fire);
        assert_eq!(fire.parameters().model(), Model::Combustion);
        assert!(fire.particles().iter().all(|p| p.lifetime.is_infinite()));
        assert!(
            fire.report().power.unwrap_or_default() > 100.0,
            "{:?}",
            fire.report()
        );
    }
}

#[test]
fn a_fire_after_a_change_of_model_and_back_is_a_new_fire() {
    let mut fire = burn(combustion(&[]), 0.3);
    switch(&mut fire, "classic");
    burn_on(&mut fire, 0.3);
    switch(&mut fire, "combustion");
    burn_on(&mut fire, 0.3);
    assert_eq!(fire.particles(), burn(Scene::default(), 0.3).particles());
}

/// Mean temperature \[K\] where the flames stand, right over the burner: of a
/// place there, not of a particle, of which hot places have fewer.
fn warmth(fire: &Simulation) -> f64 {
    let (mut warmth, mut volume) = (0.0, 0.0);
    for (p, density) in fire.particles().iter().zip(fire.densities()) {
        if p.position.x.abs() < 0.2 && (0.25..0.6).contains(&p.position.y) {
            warmth += f64::from(p.temperature / density);
            volume += f64::from(1.0 / density);
        }
    }
    warmth / volume
}

#[test]
fn another_number_of_particles_or_another_domain_keeps_the_fire_burning() {
    for changes in [
        &[("particles", 4000.0), ("particles", 1200.0)][..],
        &[("domain_width", 1.8), ("domain_width", 0.9)],
        &[("domain_height", 2.4), ("domain_height", 1.3)],
        &[("smoothing_ratio", 1.8), ("ambient_density", 0.6)],
    ] {
        let mut fire = burn(combustion(&[("particles", 2000.0)]), 1.5);
        for &(id, value) in changes {
            let (before, time) = (warmth(&fire), fire.time());
            assert!(before > 800.0, "it does not burn: {before} K");
            set(&mut fire, id, value);
            // Volumes are known after a step.
            fire.step();
            let after = warmth(&fire);
            assert!(
                (after / before - 1.0).abs() < 0.15,
                "{id}: {before} → {after} K"
            );
            assert!((time..time + 0.02).contains(&fire.time()), "{id}");

            let particles = f64::from(fire.parameters().particles);
            let share = fire.count() as f64 / particles;
            assert!((0.9..=1.0).contains(&share), "{id}: {}", fire.count());

            burns_well(&mut fire);
            assert!(warmth(&fire) > 800.0, "{id}: it went out");
        }
    }
}

/// Heat that the gas holds above that of air [kJ/m].
fn heat(fire: &Simulation) -> f64 {
    let p = fire.parameters();
    let area = f64::from(p.domain_width) * f64::from(p.domain_height);
    let air = f64::from(p.ambient_temperature);
    f64::from(p.ambient_density) * area * (mean(fire.temperatures()) - air)
}

#[test]
fn live_changes_add_no_heat() {
    let drags = [
        ("particles", 2000.0, 4000.0),
        ("domain_width", 1.2, 1.8),
        ("domain_height", 1.8, 2.4),
    ];
    for (id, from, to) in drags {
        let mut fire = burn(combustion(&[("particles", 2000.0)]), 1.5);
        let before = heat(&fire);
        // As a slider that is dragged: a change a frame, and no time to burn between.
        for i in 1..=8 {
            let share = f64::from(i) / 8.0;
            let value: f64 = from + share * (to - from);
            set(&mut fire, id, value);
            let ratio = heat(&fire) / before;
            assert!((ratio - 1.0).abs() < 0.15, "{id}, change {i}: {ratio}");
        }
        // Nor do they bang.
        let mut fastest: f32 = 0.0;
        watch(&mut fire, 0.1, |fire| {
            fastest = fastest.max(fire.report().max_speed)
        });
        assert!(fastest < 5.0, "{id}: {fastest} m/s");
    }
}

#[test]
fn other_parameters_move_no_particle() {
    let mut fire = burn(combustion(&[]), 0.5);
    let before = fire.particles();
    for (id, value) in [
        ("smoothing_ratio", 1.8),
        ("ambient_density", 0.6),
        ("wind", 1.0),
    ] {
        set(&mut fire, id, value);
        assert_eq!(fire.particles(), before, "{id}");
    }
}

#[test]
fn a_domain_that_grows_is_filled_with_air() {
    let mut fire = burn(combustion(&[]), 1.0);
    set(&mut fire, "domain_height", 3.0);
    let particles = fire.particles();
    let new: Vec<_> = particles.iter().filter(|p| p.position.y > 1.8).collect();
    assert!(new.len() > 300, "{}", new.len());
    assert!(
        new.iter()
            .all(|p| p.temperature == 293.0 && p.oxygen == 1.0)
    );
    assert!(new.iter().all(|p| p.fuel == 0.0 && p.soot == 0.0));
}

#[test]
fn a_burner_can_be_turned_off_and_on() {
    let mut fire = burn(combustion(&[("smoke_life", 0.1)]), 1.0);
    set(&mut fire, "fuel_power", 0.0);
    burn_on(&mut fire, 3.0);
    assert_eq!(fire.report().power, Some(0.0));
    assert!(fire.temperatures().iter().all(|&t| t < 600.0));
    set(&mut fire, "fuel_power", 220.0);
    burn_on(&mut fire, 1.5);
    assert!(warmth(&fire) > 800.0);
}
