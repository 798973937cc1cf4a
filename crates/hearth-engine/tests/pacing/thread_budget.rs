//! The share of the thread that an engine takes, and the particles that it steps in time.

use hearth_engine::budget::make_steps;
use hearth_engine::capacity::{Capacity, MAX_STEP_OF_PAGE, MIN, START};
use hearth_engine::duty::{Duty, SHARE_OF_PAGE};

/// Tasks of an engine that always has steps to make, each `step` long: start and end \[ms\].
fn tasks(step: impl Fn(u32) -> f64, frame: f64, seconds: f64) -> Vec<(f64, f64)> {
    let mut duty = Duty::new(SHARE_OF_PAGE);
    let (mut now, mut tasks, mut number) = (1000.0, Vec::new(), 0);
    while now < 1000.0 * (1.0 + seconds) {
        let (start, budget) = (now, duty.budget(now));
        if budget > 0.0 {
            let end = start + budget;
            let time = std::cell::Cell::new(now);
            make_steps(
                || time.get() < end,
                || {
                    number += 1;
                    time.set(time.get() + step(number));
                    true
                },
            );
            now = time.get();
            duty.spend(now - start);
            tasks.push((start, now));
        }
        now = ((now / frame + 1e-6).floor() + 1.0) * frame;
    }
    tasks
}

/// The most work in any second \[ms\]. It begins with a task.
fn busiest_second(tasks: &[(f64, f64)]) -> f64 {
    let within = |from: f64| {
        let work = tasks
            .iter()
            .map(|&(start, end)| (end.min(from + 1000.0) - start.max(from)).max(0.0));
        work.sum::<f64>()
    };
    let starts = tasks.iter().map(|&(start, _)| start);
    starts.map(within).fold(0.0, f64::max)
}

#[test]
fn an_engine_works_less_than_half_of_any_second() {
    for frame in [1000.0 / 144.0, 1000.0 / 60.0, 1000.0 / 30.0] {
        for step in [0.1, 1.0, 5.0, 12.0, 25.0, 38.0] {
            let tasks = tasks(|_| step, frame, 10.0);
            let busiest = busiest_second(&tasks);
            assert!(busiest < 500.0, "{busiest} ms of steps of {step} ms");
            let longest = tasks.iter().map(|&(start, end)| end - start);
            assert!(longest.fold(0.0, f64::max) < 50.0);
        }
        // One step in a hundred is long.
        let mixed = |number: u32| {
            if number.is_multiple_of(100) {
                30.0
            } else {
                2.0
            }
        };
        assert!(busiest_second(&tasks(mixed, frame, 10.0)) < 500.0);
    }
}

#[test]
fn an_engine_with_long_steps_idles_longer_than_it_works() {
    for step in [100.0, 650.0] {
        let tasks = tasks(|_| step, 1000.0 / 60.0, 20.0);
        let work: f64 = tasks.iter().map(|&(start, end)| end - start).sum();
        assert!(
            work < 0.5 * 20_000.0 + step,
            "{work} ms of steps of {step} ms"
        );
        // The first task spends the credit of an idle engine.
        for pair in tasks.windows(2).skip(1) {
            assert!(pair[1].0 - pair[0].1 > step);
        }
    }
}

#[test]
fn an_engine_that_idled_does_not_make_up_for_it() {
    let mut duty = Duty::new(SHARE_OF_PAGE);
    duty.budget(0.0);
    assert!(duty.budget(60_000.0) <= 12.0);
}

#[test]
fn a_machine_that_slept_during_a_step_goes_on_within_seconds() {
    let mut duty = Duty::new(SHARE_OF_PAGE);
    duty.budget(0.0);
    duty.spend(8.0 * 3600.0 * 1000.0);
    assert!(duty.budget(5000.0) > 0.0);
}

/// The limit and the longest step of a fire that requests `wanted` particles on a machine that
/// needs `cost` for the step of a particle \[ms\], after many frames.
fn settled(wanted: u32, cost: f64) -> (u32, f64) {
    let mut capacity = Capacity::new(true);
    let mut longest = 0.0_f64;
    for _ in 0..200 {
        let particles = capacity.limit().min(wanted);
        let step = cost * f64::from(particles);
        longest = longest.max(step);
        capacity.measure(step, particles as usize, wanted);
    }
    (capacity.limit().min(wanted), longest)
}

#[test]
fn a_page_has_as_many_particles_as_it_steps_in_time() {
    // A fast machine, a phone, and one that is slower than any.
    assert_eq!(settled(100_000, 1e-4), (100_000, 10.0));
    let (particles, longest) = settled(100_000, 1e-3);
    assert!((START..30_000).contains(&particles), "{particles}");
    assert!(longest < MAX_STEP_OF_PAGE, "{longest} ms");
    let (particles, _) = settled(100_000, 0.01);
    assert!((1000..1600).contains(&particles), "{particles}");
    assert_eq!(settled(100_000, 10.0).0, MIN);
    // A usual fire is never limited on a usual machine.
    assert_eq!(settled(4000, 1e-3).0, 4000);
}

#[test]
fn one_step_that_another_process_slows_changes_nothing() {
    let mut capacity = Capacity::new(true);
    for frame in 0..300 {
        let step = if frame % 3 == 0 { 400.0 } else { 8.0 };
        assert_eq!(capacity.measure(step, 10_000, 10_000), None);
    }
}

#[test]
fn a_number_that_fell_rises_only_for_other_settings() {
    let mut capacity = Capacity::new(true);
    let frames = |capacity: &mut Capacity, step| {
        (0..30)
            .filter_map(|_| capacity.measure(step, 10_000, 50_000))
            .count()
    };
    assert!(frames(&mut capacity, 100.0) > 0);
    let fallen = capacity.limit();
    assert!(fallen < START);
    assert_eq!(frames(&mut capacity, 1.0), 0);
    capacity.forget();
    assert!(frames(&mut capacity, 1.0) > 0);
    assert!(capacity.limit() > fallen);
}

#[test]
fn a_worker_has_the_requested_number_until_a_step_takes_long() {
    let mut capacity = Capacity::new(false);
    for _ in 0..10 {
        assert_eq!(capacity.measure(150.0, 100_000, 100_000), None);
    }
    assert!((0..6).any(|_| capacity.measure(650.0, 100_000, 100_000).is_some()));
    assert!(capacity.limit() < 40_000);
}
