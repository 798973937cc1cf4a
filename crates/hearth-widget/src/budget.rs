//! How much of a frame the simulation may take.
//!
//! A fire that asks for more than the machine can give must slow down, not the
//! page. Each frame has a budget of wall time; the fires that share the frame
//! share the budget; steps that do not fit are dropped, and the statistics say
//! so.

/// Wall time that the steps of all fires may take in one frame, in ms. A display
/// of 60 Hz has 16.7; the rest is for drawing and for the page.
pub const STEPS_BUDGET_MS: f64 = 12.0;

/// Makes up to `owed` steps and returns how many it made. It looks at the time
/// after each one, so the first is always made: however slow the machine, the
/// fire moves.
pub fn make_steps(owed: u32, mut in_time: impl FnMut() -> bool, mut step: impl FnMut()) -> u32 {
    for made in 1..=owed {
        step();
        if !in_time() {
            return made;
        }
    }
    owed
}

/// The time until which one of `fires` that are still to come may go on, so
/// that each has an equal part of what is left.
pub fn share(now: f64, end: f64, fires: usize) -> f64 {
    now + (end - now).max(0.0) / fires.max(1) as f64
}

/// Tells whether a fire lately had to drop steps.
#[derive(Clone, Debug, Default)]
pub struct Pace {
    owed: u32,
    made: u32,
}

impl Pace {
    /// Counts a frame that owed so many steps and made so many.
    pub fn frame(&mut self, owed: u32, made: u32) {
        self.owed += owed;
        self.made += made;
    }

    /// Whether more than one step in twenty was dropped since the last call: a
    /// single late frame is no slow fire.
    pub fn take_slowed(&mut self) -> bool {
        let Pace { owed, made } = std::mem::take(self);
        u64::from(owed - made.min(owed)) * 20 > u64::from(owed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_steps_are_made_in_time() {
        let mut count = 0;
        assert_eq!(make_steps(7, || true, || count += 1), 7);
        assert_eq!(count, 7);
    }

    #[test]
    fn no_step_is_made_where_none_is_owed() {
        assert_eq!(make_steps(0, || true, || panic!("a step")), 0);
    }

    #[test]
    fn a_slow_machine_still_makes_one_step() {
        let mut count = 0;
        assert_eq!(make_steps(24, || false, || count += 1), 1);
        assert_eq!(count, 1);
    }

    #[test]
    fn steps_end_with_the_budget() {
        let time = std::cell::Cell::new(0.0);
        let made = make_steps(
            24,
            || time.get() < STEPS_BUDGET_MS,
            || time.set(time.get() + 5.0),
        );
        assert_eq!(made, 3);
    }

    #[test]
    fn fires_share_what_is_left() {
        assert_eq!(share(0.0, 12.0, 3), 4.0);
        // The first was quick: the two others have more.
        assert_eq!(share(2.0, 12.0, 2), 7.0);
        // The budget is spent: nothing is left, and nothing is negative.
        assert_eq!(share(14.0, 12.0, 1), 14.0);
    }

    #[test]
    fn one_late_frame_is_not_slow_but_many_are() {
        let mut pace = Pace::default();
        for _ in 0..59 {
            pace.frame(4, 4);
        }
        pace.frame(4, 2);
        assert!(!pace.take_slowed());
        for _ in 0..15 {
            pace.frame(4, 3);
        }
        assert!(pace.take_slowed());
        assert!(!pace.take_slowed());
    }
}
