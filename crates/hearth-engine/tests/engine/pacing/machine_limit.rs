//! The number of particles that a machine steps in time.

use hearth_engine::pacing::machine_limit::{
    MAX_STEP_MS_OF_PAGE, MIN_PARTICLES, MachineLimit, START_PARTICLES,
};

/// The limit and the longest step of a fire that requests `requested` particles on a machine that
/// needs `cost` for the step of a particle \[ms\], after many frames.
fn settled(requested: u32, cost: f64) -> (u32, f64) {
    let mut limit = MachineLimit::new(true);
    let mut longest = 0.0_f64;
    for _ in 0..200 {
        let particles = limit.particles().min(requested);
        let step = cost * f64::from(particles);
        longest = longest.max(step);
        limit.measure(step, particles as usize, requested);
    }
    (limit.particles().min(requested), longest)
}

#[test]
fn a_page_has_as_many_particles_as_it_steps_in_time() {
    // A fast machine, a phone, and one that is slower than any.
    assert_eq!(settled(100_000, 1e-4), (100_000, 10.0));
    let (particles, longest) = settled(100_000, 1e-3);
    assert!(
        (START_PARTICLES..30_000).contains(&particles),
        "{particles}"
    );
    assert!(longest < MAX_STEP_MS_OF_PAGE, "{longest} ms");
    let (particles, _) = settled(100_000, 0.01);
    assert!((1000..1600).contains(&particles), "{particles}");
    assert_eq!(settled(100_000, 10.0).0, MIN_PARTICLES);
    // A usual fire is never limited on a usual machine.
    assert_eq!(settled(4000, 1e-3).0, 4000);
}

#[test]
fn one_step_that_another_process_slows_changes_nothing() {
    let mut limit = MachineLimit::new(true);
    for frame in 0..300 {
        let step = if frame % 3 == 0 { 400.0 } else { 8.0 };
        assert_eq!(limit.measure(step, 10_000, 10_000), None);
    }
}

#[test]
fn a_number_that_fell_rises_only_for_other_settings() {
    let mut limit = MachineLimit::new(true);
    let frames = |limit: &mut MachineLimit, step| {
        (0..30)
            .filter_map(|_| limit.measure(step, 10_000, 50_000))
            .count()
    };
    assert!(frames(&mut limit, 100.0) > 0);
    let fallen = limit.particles();
    assert!(fallen < START_PARTICLES);
    assert_eq!(frames(&mut limit, 1.0), 0);
    limit.restart();
    assert!(frames(&mut limit, 1.0) > 0);
    assert!(limit.particles() > fallen);
}

#[test]
fn a_worker_has_the_requested_number_until_a_step_takes_long() {
    let mut limit = MachineLimit::new(false);
    for _ in 0..10 {
        assert_eq!(limit.measure(150.0, 100_000, 100_000), None);
    }
    assert!((0..6).any(|_| limit.measure(650.0, 100_000, 100_000).is_some()));
    assert!(limit.particles() < 40_000);
}
