//! The warm-up of fires.

use hearth_core::burning::BurningError;
use hearth_core::params::{IN_DOMAIN, Input, Model, Parameters};
use hearth_core::resolution::Level;
use hearth_core::resolution::SizeLimit;
use hearth_core::resolution::{CountInputs, ParticleCount, Resolution};
use hearth_core::warm_up::WarmUp;
use hearth_core::{Burner, Simulation};

fn with(values: &[(&str, f64)]) -> Parameters {
    let mut parameters = Parameters::new(Model::Combustion);
    let named = |id: &str| values.iter().any(|&(name, _)| name == id);
    for &(id, value) in values {
        assert_eq!(parameters.set(id, Input::Number(value)), Ok(()));
    }
    parameters.complete(&named, IN_DOMAIN);
    parameters
}

/// The settings at the present part of a warm-up.
fn at(warm: &WarmUp, values: &Parameters) -> Parameters {
    let number = values.domain_particles();
    let settings = match values.model() {
        Model::Classic => Resolution::Classic(number),
        Model::Combustion => Resolution::Page(number),
    };
    let count = ParticleCount::of(&CountInputs {
        settings,
        level: Level::Medium,
        is_level_requested: false,
        size: SizeLimit::default(),
        machine: u32::MAX,
        is_coarse: warm.is_coarse(),
    });
    let mut values = values.clone();
    if count.number != number {
        values.set_domain_particles(count.number);
    }
    values
}

/// Warms a fire up. Returns it with the number of particles of each step.
fn warmed(warm: &mut WarmUp, values: &Parameters) -> (Simulation, Vec<usize>) {
    let mut fire = Simulation::new(values.clone());
    assert_eq!(warm.begin(&mut fire, values.clone().into()), None);
    if warm.is_on() {
        fire.adapt(at(warm, values).into());
    }
    let mut counts = Vec::new();
    while warm.is_on() {
        let before = fire.time();
        fire.step();
        counts.push(fire.count());
        if warm.advance(fire.time() - before) {
            fire.set_scene(at(warm, values).into());
        }
    }
    (fire, counts)
}

/// Height of bright gas above the burner \[m\].
fn flame(fire: &Simulation) -> f32 {
    let places = fire.positions().into_iter().zip(fire.temperatures());
    let bright = places.filter(|&(_, kelvin)| kelvin > 1000.0);
    let top = bright.map(|(at, _)| at.y).fold(0.0, f32::max);
    top - fire
        .scene()
        .read_first_source(|source| Burner::of(source).bottom)
}

#[test]
fn a_warm_fire_has_a_tall_flame() {
    for seed in 1..=5 {
        let values = with(&[("seed", f64::from(seed)), ("particles", 1200.0)]);
        let (fire, _) = warmed(&mut WarmUp::new(3.0, Vec::new()), &values);
        assert!(fire.time() >= 3.0);
        assert!(flame(&fire) > 0.3, "seed {seed}: {} m", flame(&fire));
    }
}

#[test]
fn the_warm_up_uses_few_particles_until_its_last_part() {
    let values = with(&[("particles", 3000.0)]);
    let (fire, counts) = warmed(&mut WarmUp::new(2.0, Vec::new()), &values);
    assert!(
        4 * counts[0] < fire.count(),
        "{} of {}",
        counts[0],
        fire.count()
    );
    // Small fires and short warm-ups use all particles.
    for (seconds, particles) in [(2.0, 500.0), (0.5, 1200.0)] {
        let values = with(&[("particles", particles)]);
        let (_, counts) = warmed(&mut WarmUp::new(seconds, Vec::new()), &values);
        let grows = |pair: &[usize]| pair[1] as f64 > 1.2 * pair[0] as f64;
        assert!(!counts.windows(2).any(grows), "{particles}: {counts:?}");
    }
    let (_, counts) = warmed(
        &mut WarmUp::new(0.2, Vec::new()),
        &Parameters::new(Model::Classic),
    );
    assert!(!counts.is_empty());
}

#[test]
fn the_warm_up_is_deterministic() {
    let values = with(&[("particles", 1200.0)]);
    let [(first, _), (second, _)] =
        [(); 2].map(|()| warmed(&mut WarmUp::new(1.5, Vec::new()), &values));
    assert_eq!(first.particles(), second.particles());
}

#[test]
fn a_saved_fire_with_the_same_settings_replaces_the_warm_up() {
    let values = with(&[("particles", 1000.0)]);
    let (fire, _) = warmed(&mut WarmUp::new(1.0, Vec::new()), &values);
    let saved = fire.burning().unwrap_or_default();
    let mut warm = WarmUp::new(3.0, saved.clone());
    for particles in [1000.0, 500.0] {
        let values = with(&[("particles", particles), ("exposure", 1.0)]);
        let (taken_up, counts) = warmed(&mut warm, &values);
        // It burns on with all particles, so that its second slice has a past.
        let burnt = taken_up.time() - fire.time();
        assert!((0.5..0.55).contains(&burnt), "{burnt}");
        assert!(counts.iter().all(|&count| count > taken_up.count() / 2));
    }
    // With other settings the fire warms up, and the saved one remains for later.
    let (_, counts) = warmed(&mut warm, &with(&[("particles", 500.0), ("wind", 0.5)]));
    assert!(!counts.is_empty());
    assert!(warmed(&mut warm, &values).0.time() > fire.time());
}

#[test]
fn a_damaged_saved_fire_is_reported_once_and_the_fire_warms_up() {
    let values = with(&[("particles", 500.0)]);
    let mut warm = WarmUp::new(0.1, vec![1, 2, 3]);
    let mut fire = Simulation::new(values.clone());
    let error = warm.begin(&mut fire, values.clone().into());
    assert!(matches!(error, Some(BurningError::Damaged(_))));
    assert!(warm.is_on());
    assert_eq!(warm.begin(&mut fire, values.clone().into()), None);
}

#[test]
fn without_a_duration_there_is_no_warm_up() {
    let values = with(&[("particles", 1000.0)]);
    let mut warm = WarmUp::default();
    assert!(!warm.is_enabled());
    let (fire, counts) = warmed(&mut warm, &values);
    assert_eq!((fire.time(), counts.len()), (0.0, 0));
    warm.set(0.1);
    assert!(!warmed(&mut warm, &values).1.is_empty());
}

#[test]
fn open_air_warms_up_with_a_coarse_spacing() {
    let mut values = with(&[]);
    assert_eq!(values.set("edges", Input::Text("open")), Ok(()));
    values.set_domain_particles(3000);
    let (fire, counts) = warmed(&mut WarmUp::new(2.0, Vec::new()), &values);
    let most = |counts: &[usize]| counts.iter().copied().max();
    assert!(most(&counts[..20]) < Some(1000), "{counts:?}");
    assert!((2000..=6000).contains(&fire.count()), "{}", fire.count());
    assert_eq!(fire.parameters().spacing(), values.spacing());
    assert!(flame(&fire) > 0.3, "{} m", flame(&fire));
    // Its saved fire starts another one at any spacing.
    let bytes = fire.burning().unwrap_or_default();
    for particles in [1200, 3000, 6700] {
        let mut other = values.clone();
        other.set_domain_particles(particles);
        let mut warm = WarmUp::new(2.0, bytes.clone());
        let mut resumed = Simulation::new(other.clone());
        assert_eq!(warm.begin(&mut resumed, other.clone().into()), None);
        assert!(warm.is_on() && resumed.time() >= 2.0);
        assert_eq!(resumed.parameters().spacing(), other.spacing());
    }
}
