//! The time that an engine takes of its thread.

use std::cell::Cell;

use hearth_engine::pacing::thread_budget::{
    SHARE_OF_PAGE, STEPS_BUDGET_MS, ThreadBudget, deadline, make_steps,
};

/// Number of steps of 5 ms that are made of `due` ones within a budget.
fn made(due: u32, budget_ms: f64) -> u32 {
    let (mut left, time) = (due, Cell::new(0.0));
    let step = || {
        let due = left > 0;
        left -= u32::from(due);
        time.set(time.get() + 5.0);
        due
    };
    make_steps(|| time.get() < budget_ms, step)
}

#[test]
fn all_due_steps_are_made_within_the_budget() {
    assert_eq!(made(7, 1000.0), 7);
}

#[test]
fn no_step_is_made_if_none_is_due() {
    assert_eq!(made(0, 1000.0), 0);
}

#[test]
fn a_slow_machine_makes_one_step() {
    assert_eq!(made(24, 0.0), 1);
}

#[test]
fn steps_end_with_the_budget() {
    assert_eq!(made(24, STEPS_BUDGET_MS), 3);
}

#[test]
fn fires_share_the_remaining_time() {
    assert_eq!(deadline(0.0, 12.0, 3), 4.0);
    // The first fire took less than its share: the other two get more.
    assert_eq!(deadline(2.0, 12.0, 2), 7.0);
    // After the end there is no time left, and no negative time.
    assert_eq!(deadline(14.0, 12.0, 1), 14.0);
}

/// Tasks of an engine that always has steps to make, each `step` long: start and end \[ms\].
fn tasks(step: impl Fn(u32) -> f64, frame: f64, seconds: f64) -> Vec<(f64, f64)> {
    let mut account = ThreadBudget::new(SHARE_OF_PAGE);
    let (mut now, mut tasks, mut number) = (1000.0, Vec::new(), 0);
    while now < 1000.0 * (1.0 + seconds) {
        let (start, budget) = (now, account.refill(now));
        if budget > 0.0 {
            let end = start + budget;
            let time = Cell::new(now);
            make_steps(
                || time.get() < end,
                || {
                    number += 1;
                    time.set(time.get() + step(number));
                    true
                },
            );
            now = time.get();
            account.spend(now - start);
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
    let mut budget = ThreadBudget::new(SHARE_OF_PAGE);
    budget.refill(0.0);
    assert!(budget.refill(60_000.0) <= 12.0);
}

#[test]
fn a_machine_that_was_suspended_during_a_step_goes_on_within_seconds() {
    let mut budget = ThreadBudget::new(SHARE_OF_PAGE);
    budget.refill(0.0);
    budget.spend(8.0 * 3600.0 * 1000.0);
    assert!(budget.refill(5000.0) > 0.0);
}
