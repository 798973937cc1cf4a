//! How much of a frame the simulation may take.
//!
//! A fire that asks for more than the machine can give must slow down, not the
//! page. Each frame has a budget of wall time; the fires that share the frame
//! share the budget; steps that do not fit are dropped, and the statistics say
//! so.

use hearth_core::clock::LONGEST_FRAME;

/// Wall time that the steps of all fires may take in one frame, in ms. A display
/// of 60 Hz has 16.7; the rest is for drawing and for the page.
pub const STEPS_BUDGET_MS: f64 = 12.0;

/// Makes steps for as long as `step` has one to make and there is time; returns
/// how many it made. It looks at the time after each one, so the first is always
/// made: however slow the machine, the fire moves.
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

/// The time until which one of `fires` that are still to come may go on, so
/// that each has an equal part of what is left.
pub fn share(now: f64, end: f64, fires: usize) -> f64 {
    now + (end - now).max(0.0) / fires.max(1) as f64
}

/// Seconds of the clock over which the real-time factor is averaged.
const LATELY: f64 = 1.0;

/// Longest frame that is held against a fire \[s\]. Whatever keeps a page from
/// drawing for longer is rarely the fire, and it is not slow for seconds after.
const LONGEST_SLOW_FRAME: f64 = 0.25;

/// The real-time factor of a fire, and whether it should be higher: sums over frames, of
/// which the older ones fade away.
#[derive(Clone, Debug, Default)]
pub struct RealTime {
    /// Seconds of the clock.
    clock: f64,
    /// Seconds of fire that were made in them.
    made: f64,
    /// Seconds of fire that should have been made in them.
    wanted: f64,
    /// Seconds of fire that were given up.
    missed: f64,
}

impl RealTime {
    /// Counts a frame of `passed` seconds of the clock, each of them `time_scale`
    /// seconds of fire. It made so many seconds of fire and dropped others.
    pub fn frame(&mut self, passed: f64, time_scale: f64, made: f64, dropped: f64) {
        let kept = 1.0 / (1.0 + passed / LATELY);
        let counted = passed.min(LONGEST_SLOW_FRAME);
        let forgone = (counted - LONGEST_FRAME).max(0.0) * time_scale;
        self.clock = self.clock * kept + passed;
        self.made = self.made * kept + made;
        self.wanted = self.wanted * kept + counted * time_scale;
        self.missed = self.missed * kept + forgone + dropped;
    }

    /// Seconds of fire for each second of the clock; zero before there was one.
    pub fn factor(&self) -> f64 {
        if self.clock > 0.0 {
            self.made / self.clock
        } else {
            0.0
        }
    }

    /// Holds nothing against it that was given up so far: what it burns with is
    /// other work from now on.
    pub fn forgive(&mut self) {
        (self.wanted, self.missed) = (0.0, 0.0);
    }

    /// Whether more than a twentieth of what it should have burnt was given up: a
    /// single late frame is no slow fire.
    pub fn slowed(&self) -> bool {
        self.missed > 0.05 * self.wanted
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    /// Makes `owed` steps of 5 ms within a budget; returns what was made.
    fn made(owed: u32, budget_ms: f64) -> u32 {
        let (mut left, time) = (owed, Cell::new(0.0));
        let step = || {
            let due = left > 0;
            left -= u32::from(due);
            time.set(time.get() + 5.0);
            due
        };
        make_steps(|| time.get() < budget_ms, step)
    }

    #[test]
    fn all_steps_are_made_in_time() {
        assert_eq!(made(7, 1000.0), 7);
    }

    #[test]
    fn no_step_is_made_where_none_is_owed() {
        assert_eq!(made(0, 1000.0), 0);
    }

    #[test]
    fn a_slow_machine_still_makes_one_step() {
        assert_eq!(made(24, 0.0), 1);
    }

    #[test]
    fn steps_end_with_the_budget() {
        assert_eq!(made(24, STEPS_BUDGET_MS), 3);
    }

    #[test]
    fn fires_share_what_is_left() {
        assert_eq!(share(0.0, 12.0, 3), 4.0);
        // The first was quick: the two others have more.
        assert_eq!(share(2.0, 12.0, 2), 7.0);
        // The budget is spent: nothing is left, and nothing is negative.
        assert_eq!(share(14.0, 12.0, 1), 14.0);
    }

    /// A second of frames at 60 Hz that each make `part` of what they should.
    fn second(real_time: &mut RealTime, scale: f64, part: f64) {
        for _ in 0..60 {
            let wanted = scale / 60.0;
            real_time.frame(1.0 / 60.0, scale, part * wanted, (1.0 - part) * wanted);
        }
    }

    #[test]
    fn the_real_time_factor_is_fire_by_clock() {
        let mut real_time = RealTime::default();
        assert_eq!(real_time.factor(), 0.0);
        for scale in [1.0, 0.1, 2.0] {
            for _ in 0..10 {
                second(&mut real_time, scale, 1.0);
                // Also while an older scale fades: nothing is behind.
                assert!(!real_time.slowed());
            }
            assert!((real_time.factor() - scale).abs() < 1e-3);
        }
    }

    #[test]
    fn a_fire_that_drops_steps_says_so_until_it_drops_none() {
        let mut real_time = RealTime::default();
        for _ in 0..10 {
            second(&mut real_time, 1.0, 0.3);
            assert!(real_time.slowed());
        }
        assert!((real_time.factor() - 0.3).abs() < 1e-3);
        for _ in 0..5 {
            second(&mut real_time, 1.0, 1.0);
        }
        assert!(!real_time.slowed());
    }

    #[test]
    fn a_fire_that_is_forgiven_is_not_slow_and_keeps_its_real_time_factor() {
        let mut real_time = RealTime::default();
        for _ in 0..10 {
            second(&mut real_time, 1.0, 0.3);
        }
        let before = real_time.factor();
        real_time.forgive();
        assert!(!real_time.slowed());
        assert_eq!(real_time.factor(), before);
        // Only what comes counts, and that at once.
        real_time.frame(1.0 / 60.0, 1.0, 1.0 / 60.0, 0.0);
        assert!(!real_time.slowed());
        second(&mut real_time, 1.0, 0.3);
        assert!(real_time.slowed());
    }

    #[test]
    fn one_late_frame_is_not_slow_but_many_are() {
        let mut real_time = RealTime::default();
        second(&mut real_time, 1.0, 1.0);
        real_time.frame(1.0 / 60.0, 1.0, 0.5 / 60.0, 0.5 / 60.0);
        assert!(!real_time.slowed());
        second(&mut real_time, 1.0, 0.8);
        assert!(real_time.slowed());
    }

    #[test]
    fn steps_that_are_longer_than_frames_are_not_slow() {
        let mut real_time = RealTime::default();
        // Slow motion with long steps: one in ten frames makes one.
        for frame in 0..100 {
            let made = if frame % 10 == 9 { 1.0 / 60.0 } else { 0.0 };
            real_time.frame(1.0 / 60.0, 0.1, made, 0.0);
            assert!(!real_time.slowed());
        }
    }

    #[test]
    fn frames_too_rare_to_be_made_up_for_are_slow() {
        let mut real_time = RealTime::default();
        for _ in 0..10 {
            real_time.frame(0.2, 1.0, LONGEST_FRAME, 0.0);
        }
        assert!(real_time.slowed());
        assert!((real_time.factor() - 0.5).abs() < 1e-6);
    }

    #[test]
    fn a_page_that_hung_for_once_has_no_slow_fire_for_long() {
        let mut real_time = RealTime::default();
        second(&mut real_time, 1.0, 1.0);
        real_time.frame(10.0, 1.0, LONGEST_FRAME, 0.0);
        for _ in 0..2 {
            second(&mut real_time, 1.0, 1.0);
        }
        assert!(!real_time.slowed());
    }
}
