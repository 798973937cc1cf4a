//! The laws that the paper states of its fire (§4.1.1), and what its emitter
//! and lifetimes promise.

use hearth_core::params::Model;
use hearth_core::{Parameters, Particle, Simulation};
use hearth_tests::fires::{burn, source, with_numbers as with};

/// The mean of a figure of the burning fire over some seconds and seeds.
fn mean_of(values: &[(&str, f64)], figure: impl Fn(&[Particle]) -> f32) -> f32 {
    let (mut sum, mut n) = (0.0, 0);
    for seed in [1.0, 2.0, 3.0] {
        let mut fire = burn(with(&[values, &[("seed", seed)]].concat()), 1.5);
        for step in 0..720 {
            fire.step();
            if step % 12 == 0 {
                sum += figure(&fire.particles());
                n += 1;
            }
        }
    }
    sum / n as f32
}

fn width(particles: &[Particle]) -> f32 {
    let square: f32 = particles.iter().map(|p| p.position.x * p.position.x).sum();
    (square / particles.len() as f32).sqrt()
}

fn height(particles: &[Particle]) -> f32 {
    let sum: f32 = particles.iter().map(|p| p.position.y).sum();
    sum / particles.len() as f32
}

/// Mean distance from a particle to the nearest other one.
fn nearest(particles: &[Particle]) -> f32 {
    let sum: f32 = particles
        .iter()
        .map(|a| {
            particles
                .iter()
                .filter(|b| !std::ptr::eq(a, *b))
                .map(|b| a.position.distance_squared(b.position))
                .fold(f32::INFINITY, f32::min)
                .sqrt()
        })
        .sum();
    sum / particles.len() as f32
}

fn falls(figures: &[f32]) -> bool {
    figures.windows(2).all(|pair| pair[1] < pair[0])
}

#[test]
fn the_fire_narrows_as_buoyancy_rises() {
    let widths = [0.0, 0.3, 1.0].map(|beta| mean_of(&[("buoyancy", beta)], width));
    assert!(falls(&widths), "{widths:?}");
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn the_fire_widens_as_the_gas_constant_grows() {
    let widths = [6.0, 2.0, 0.6, 0.1].map(|k| mean_of(&[("gas_constant", k)], width));
    assert!(falls(&widths), "{widths:?}");
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn a_larger_smoothing_radius_clusters_the_fire() {
    let radii = [0.02, 0.04, 0.08];
    let widths = radii.map(|h| mean_of(&[("smoothing_radius", h)], width));
    let distances = radii.map(|h| mean_of(&[("smoothing_radius", h)], nearest));
    assert!(falls(&widths), "{widths:?}");
    assert!(falls(&distances), "{distances:?}");
}

#[test]
fn heat_raises_the_fire_and_extra_weight_lowers_it() {
    let plain = mean_of(&[], height);
    assert!(mean_of(&[("thermal_buoyancy", 0.6)], height) > plain);
    assert!(mean_of(&[("extra_weight", 3.0)], height) < plain);
}

#[test]
fn every_particle_reddens_before_it_dies() {
    let fire = burn(Parameters::new(Model::Classic), 3.0);
    let (p, source) = (fire.parameters(), source(fire.scene()));
    for particle in fire.particles() {
        let cooled = source.birth_temperature - p.cooling_rate * particle.age;
        let expected = cooled.max(p.ambient_temperature);
        // The age and the temperature are summed step by step; a particle is
        // born within a step and cools from its end on.
        let slack = p.cooling_rate * p.time_step + 1.0;
        assert!(
            (particle.temperature - expected).abs() < slack,
            "{particle:?}"
        );
    }
}

#[test]
fn births_come_at_the_emission_rate() {
    // Long lives and a source with room: all particles are alive.
    let quiet = [
        ("emission_rate", 400.0),
        ("emission_noise", 0.0),
        ("lifetime_min", 3.0),
        ("lifetime_max", 3.0),
        ("max_particles", 100_000.0),
        ("domain_height", 6.0),
        ("domain_width", 6.0),
    ];
    let fire = burn(with(&quiet), 2.0);
    assert!(
        (fire.count() as f32 - 800.0).abs() <= 3.0,
        "{}",
        fire.count()
    );

    // Noise moves births about; it does not add or take away any.
    let mut noisy = quiet.to_vec();
    noisy[1].1 = 1.0;
    let mean = (0..8)
        .map(|seed| {
            burn(
                with(&[&noisy[..], &[("seed", f64::from(seed))]].concat()),
                2.5,
            )
            .count()
        })
        .sum::<usize>() as f32
        / 8.0;
    assert!((mean / 1000.0 - 1.0).abs() < 0.1, "{mean}");
}

#[test]
fn births_come_at_the_emission_rate_at_any_time_step() {
    // At 50/s and 17 ms, a step brings less than one birth, and more than half of one.
    for (rate, time_step) in [(50.0, 0.002), (50.0, 0.017), (90.0, 0.017), (400.0, 0.017)] {
        let fire = burn(
            with(&[
                ("emission_rate", rate),
                ("time_step", time_step),
                ("emission_noise", 0.0),
                ("lifetime_min", 3.0),
                ("lifetime_max", 3.0),
                ("domain_height", 6.0),
                ("domain_width", 6.0),
            ]),
            2.0,
        );
        let count = fire.count() as f64;
        assert!(
            (count / (2.0 * rate) - 1.0).abs() < 0.03,
            "{count} at {rate}/s, {time_step} s"
        );
    }
}

#[test]
fn a_crowded_source_emits_only_what_can_leave_it() {
    let crowded = burn(with(&[("emission_rate", 1e5), ("max_particles", 1e5)]), 2.0);
    let max = crowded.report().max_neighbours;
    assert!(max < 80, "{max} neighbours: the source is too dense");
}

#[test]
fn lifetimes_are_in_their_range() {
    let (shortest, longest) = (0.5, 0.9);
    let fire = burn(
        with(&[("lifetime_min", shortest), ("lifetime_max", longest)]),
        2.0,
    );
    let lives: Vec<f64> = fire
        .particles()
        .iter()
        .map(|p| f64::from(p.lifetime))
        .collect();
    assert!(
        lives
            .iter()
            .all(|life| (shortest - 1e-6..=longest + 1e-6).contains(life))
    );
    assert!(lives.iter().any(|&life| life < shortest + 0.1));
    assert!(lives.iter().any(|&life| life > longest - 0.1));
    assert!(fire.particles().iter().all(|p| p.age < p.lifetime));

    // The wrong way round, the shortest counts for both.
    let fire = burn(with(&[("lifetime_min", 0.9), ("lifetime_max", 0.5)]), 2.0);
    assert!(
        fire.particles()
            .iter()
            .all(|p| (p.lifetime - 0.9).abs() < 1e-6)
    );
}

#[test]
fn without_taper_lifetimes_are_uniform_over_the_source() {
    let fire = burn(with(&[("taper", 0.0), ("emission_noise", 0.0)]), 3.0);
    let newborn: Vec<Particle> = fire
        .particles()
        .into_iter()
        .filter(|p| p.age < 0.25)
        .collect();
    let mean = newborn.iter().map(|p| p.lifetime).sum::<f32>() / newborn.len() as f32;
    let source = source(fire.scene());
    let (low, high) = (source.life_min, source.life_max);
    // Five standard errors of the mean of a uniform distribution.
    let allowed = 5.0 * (high - low) / 12_f32.sqrt() / (newborn.len() as f32).sqrt();
    assert!(
        (mean - 0.5 * (low + high)).abs() < allowed,
        "{mean} of {}",
        newborn.len()
    );
}

#[test]
fn particles_are_born_at_the_source() {
    let fire = burn(with(&[("source_width", 0.3), ("source_height", 0.4)]), 1.0);
    let dt = fire.parameters().time_step;
    let newborn: Vec<Particle> = fire
        .particles()
        .into_iter()
        .filter(|p| p.age < 2.0 * dt)
        .collect();
    assert!(!newborn.is_empty());
    for particle in newborn {
        assert!(particle.position.x.abs() <= 0.15 + 0.02, "{particle:?}");
        assert!((particle.position.y - 0.4).abs() < 0.03, "{particle:?}");
    }
}

#[test]
fn the_number_of_particles_is_limited() {
    let mut fire = Simulation::new(with(&[("max_particles", 150.0)]));
    let mut max = 0;
    for _ in 0..960 {
        fire.step();
        max = max.max(fire.count());
    }
    assert!((140..=150).contains(&max), "{max}");
}

#[test]
fn the_default_has_700_to_1000_particles_and_15_to_30_neighbours() {
    let mut fire = burn(Parameters::new(Model::Classic), 2.0);
    let (mut count, mut neighbours, steps) = (0.0, 0.0, 720);
    for _ in 0..steps {
        fire.step();
        count += fire.count() as f32 / steps as f32;
        neighbours += fire.report().mean_neighbours / steps as f32;
    }
    assert!((700.0..=1000.0).contains(&count), "{count}");
    assert!((15.0..=30.0).contains(&neighbours), "{neighbours}");
}
