//! Fires that burn before they are shown.

use hearth_core::params::{Input, Model, Parameters};
use hearth_core::{Burner, Simulation};
use hearth_engine::warm::Warm;

fn with(values: &[(&str, f64)]) -> Parameters {
    let mut parameters = Parameters::new(Model::Combustion);
    for &(id, value) in values {
        assert_eq!(parameters.set(id, Input::Number(value)), Ok(()));
    }
    parameters
}

/// Warms a fire; returns it, with the particles of each step.
fn warmed(warm: &mut Warm, values: &Parameters) -> (Simulation, Vec<usize>) {
    let mut fire = Simulation::new(values.clone());
    assert_eq!(warm.begin(&mut fire, &values.clone().into()), None);
    let mut counts = Vec::new();
    while warm.is_on() {
        let before = fire.time();
        fire.step();
        counts.push(fire.count());
        let done = warm.burnt(fire.time() - before, &mut fire, &values.clone().into());
        assert_eq!(done, !warm.is_on());
    }
    (fire, counts)
}

/// How far above the burner gas is bright \[m\].
fn flame(fire: &Simulation) -> f32 {
    let places = fire.positions().into_iter().zip(fire.temperatures());
    let bright = places.filter(|&(_, kelvin)| kelvin > 1000.0);
    let top = bright.map(|(at, _)| at.y).fold(0.0, f32::max);
    top - Burner::of(fire.parameters()).bottom
}

#[test]
fn the_first_picture_of_a_warm_fire_has_a_tall_flame() {
    for seed in 1..=5 {
        let values = with(&[("seed", f64::from(seed)), ("max_particles", 1200.0)]);
        let (fire, _) = warmed(&mut Warm::new(3.0, Vec::new()), &values);
        assert!(fire.time() >= 3.0);
        assert!(flame(&fire) > 0.3, "seed {seed}: {} m", flame(&fire));
    }
}

#[test]
fn most_of_the_time_few_particles_burn_and_at_the_end_all() {
    let values = with(&[("max_particles", 3000.0)]);
    let (fire, counts) = warmed(&mut Warm::new(2.0, Vec::new()), &values);
    assert!((700..=760).contains(&counts[0]), "{}", counts[0]);
    assert!((2800..=3000).contains(&fire.count()), "{}", fire.count());
    // What nobody sees is left out where a fire is small anyway, and short.
    for (seconds, particles) in [(2.0, 500.0), (0.5, 1200.0)] {
        let values = with(&[("max_particles", particles)]);
        let (fire, counts) = warmed(&mut Warm::new(seconds, Vec::new()), &values);
        assert!(counts.iter().all(|count| *count == fire.count()));
    }
    let (_, counts) = warmed(
        &mut Warm::new(0.2, Vec::new()),
        &Parameters::new(Model::Classic),
    );
    assert!(!counts.is_empty());
}

#[test]
fn it_is_always_the_same_fire() {
    let values = with(&[("max_particles", 1200.0)]);
    let [(one, _), (other, _)] = [(); 2].map(|()| warmed(&mut Warm::new(1.5, Vec::new()), &values));
    assert_eq!(one.particles(), other.particles());
}

#[test]
fn a_kept_fire_of_the_same_values_needs_no_warming() {
    let values = with(&[("max_particles", 1000.0)]);
    let (fire, _) = warmed(&mut Warm::new(1.0, Vec::new()), &values);
    let kept = fire.burning().unwrap_or_default();
    let mut warm = Warm::new(3.0, kept.clone());
    for particles in [1000.0, 500.0] {
        let values = with(&[("max_particles", particles), ("exposure", 1.0)]);
        let (taken_up, counts) = warmed(&mut warm, &values);
        assert_eq!((taken_up.time(), counts.len()), (fire.time(), 0));
    }
    // Of other values it burns first, and the kept one is there for later.
    let (_, counts) = warmed(&mut warm, &with(&[("max_particles", 500.0), ("wind", 0.5)]));
    assert!(!counts.is_empty());
    assert_eq!(warmed(&mut warm, &values).1.len(), 0);
}

#[test]
fn a_damaged_fire_is_told_once_and_the_fire_burns_all_the_same() {
    let values = with(&[("max_particles", 500.0)]);
    let mut warm = Warm::new(0.1, vec![1, 2, 3]);
    let mut fire = Simulation::new(values.clone());
    let words = warm.begin(&mut fire, &values.clone().into());
    assert!(words.is_some_and(|words| !words.is_empty()));
    assert!(warm.is_on());
    assert_eq!(warm.begin(&mut fire, &values.clone().into()), None);
}

#[test]
fn without_a_time_nothing_is_warmed() {
    let values = with(&[("max_particles", 1000.0)]);
    let mut warm = Warm::default();
    assert!(!warm.is_wanted());
    let (fire, counts) = warmed(&mut warm, &values);
    assert_eq!((fire.time(), counts.len()), (0.0, 0));
    warm.set(0.1);
    assert!(!warmed(&mut warm, &values).1.is_empty());
}
