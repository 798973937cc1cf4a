//! The time that an engine takes of its thread: a token bucket.
//!
//! The budget grows with the clock, by the engine's share of the thread, and shrinks by the time of
//! its work. After a long step or call it is negative, and no step is made until it is positive
//! again. So the work in any second is at most the share, one budget of a frame and the last task.

/// Maximum wall time of the steps of all fires in one frame \[ms\]. A frame at 60 Hz lasts
/// 16.7 ms; drawing and the page need the rest.
pub const STEPS_BUDGET_MS: f64 = 12.0;

/// Share of a page's own thread: under half in any second, whose last task may take 38 ms.
pub const SHARE_OF_PAGE: f64 = 0.45;
/// Share of a worker: the budget for steps in a frame of 60 Hz.
pub const SHARE_OF_WORKER: f64 = 0.72;

/// Largest debt \[ms\]: a laptop that was suspended during a step goes on within seconds.
const MAX_DEBT_MS: f64 = 2000.0;

/// The time that an engine may take of its thread.
#[derive(Clone, Debug)]
pub struct ThreadBudget {
    share: f64,
    /// Available time \[ms\]; negative: debt.
    available: f64,
    /// Time of the last refill \[ms\].
    refilled_at: f64,
}

impl ThreadBudget {
    /// The budget of an engine with that share of its thread.
    pub fn new(share: f64) -> ThreadBudget {
        ThreadBudget {
            share,
            available: 0.0,
            refilled_at: 0.0,
        }
    }

    /// The share of the thread.
    pub fn share(&self) -> f64 {
        self.share
    }

    /// Refills the budget. Returns the time for steps at `now`, at most [`STEPS_BUDGET_MS`] \[ms\];
    /// without a positive time, the engine makes no steps.
    pub fn refill(&mut self, now: f64) -> f64 {
        let refill = self.share * (now - self.refilled_at).max(0.0);
        self.refilled_at = now;
        self.available = (self.available + refill).min(STEPS_BUDGET_MS);
        self.available
    }

    /// Subtracts the time of work \[ms\].
    pub fn spend(&mut self, work: f64) {
        self.available = (self.available - work).max(-MAX_DEBT_MS);
    }
}

/// The deadline of the next of `fires` that share the time until `end`: each gets an equal part.
pub fn deadline(now: f64, end: f64, fires: usize) -> f64 {
    now + (end - now).max(0.0) / fires.max(1) as f64
}

/// Calls `step` until it has no step to make or `in_time` is false. Returns the number of
/// steps. The time is read after each step, so even the slowest machine makes one.
pub fn make_steps(mut in_time: impl FnMut() -> bool, mut step: impl FnMut() -> bool) -> u32 {
    let mut made = 0;
    while step() {
        made += 1;
        if !in_time() {
            break;
        }
    }
    made
}
