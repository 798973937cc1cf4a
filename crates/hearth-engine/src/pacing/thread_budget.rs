//! The share of its thread that an engine takes.
//!
//! The engine earns time while the clock runs and spends it with its work, a token bucket. An
//! engine in debt, after a long step or call, idles until it has paid. So its work in any
//! second is at most its share, one budget of a frame and the last task.

use crate::budget::STEPS_BUDGET_MS;

/// Share of a page's own thread: under half in any second, whose last task may take 38 ms.
pub const SHARE_OF_PAGE: f64 = 0.45;
/// Share of a worker: the budget for steps in a frame of 60 Hz.
pub const SHARE_OF_WORKER: f64 = 0.72;

/// Largest debt \[ms\]. A laptop that slept during a step does not pay for the night.
const MAX_DEBT: f64 = 2000.0;

/// The account of an engine.
#[derive(Clone, Debug)]
pub struct Duty {
    share: f64,
    /// Earned time \[ms\]; negative: debt.
    credit: f64,
    /// Time of the last income \[ms\].
    last: f64,
}

impl Duty {
    /// The account of an engine with that share of its thread.
    pub fn new(share: f64) -> Duty {
        Duty {
            share,
            credit: 0.0,
            last: 0.0,
        }
    }

    /// The share of the thread.
    pub fn share(&self) -> f64 {
        self.share
    }

    /// Time for steps at `now`, at most [`STEPS_BUDGET_MS`] \[ms\]. Without a positive time, the
    /// engine idles.
    pub fn budget(&mut self, now: f64) -> f64 {
        let income = self.share * (now - self.last).max(0.0);
        self.last = now;
        self.credit = (self.credit + income).min(STEPS_BUDGET_MS);
        self.credit
    }

    /// Pays for work \[ms\].
    pub fn spend(&mut self, work: f64) {
        self.credit = (self.credit - work).max(-MAX_DEBT);
    }
}
