//! The real-time factor: how much of the due fire time is simulated.
//!
//! A fire that needs more time than the machine has slows down instead of the page. Steps that do
//! not fit into the budget of a frame are dropped, and the statistics report it.

use hearth_core::clock::LONGEST_FRAME;

/// Seconds of the clock over which the real-time factor is averaged.
const AVERAGING_SECONDS: f64 = 1.0;

/// Longest frame that counts as slow \[s\]. A longer one is rarely the fire's fault.
const MAX_COUNTED_FRAME: f64 = 0.25;

/// Share of the due fire time that a fire drops before it counts as slowed: one late frame
/// stays below it.
const TOLERATED_LOSS_SHARE: f64 = 0.05;

/// The real-time factor of a fire: sums over frames, in which older frames fade out.
#[derive(Clone, Debug, Default)]
pub struct RealTime {
    /// Seconds of the clock.
    clock: f64,
    /// Seconds of fire that were simulated.
    simulated: f64,
    /// Seconds of fire that were due.
    due: f64,
    /// Seconds of fire that were dropped.
    dropped: f64,
}

impl RealTime {
    /// Adds a frame of `passed` seconds of the clock at a requested `time_scale`, with its
    /// simulated and dropped seconds of fire.
    pub fn frame(&mut self, passed: f64, time_scale: f64, simulated: f64, dropped: f64) {
        let kept = 1.0 / (1.0 + passed / AVERAGING_SECONDS);
        let counted = passed.min(MAX_COUNTED_FRAME);
        let beyond = (counted - LONGEST_FRAME).max(0.0) * time_scale;
        self.clock = self.clock * kept + passed;
        self.simulated = self.simulated * kept + simulated;
        self.due = self.due * kept + counted * time_scale;
        self.dropped = self.dropped * kept + beyond + dropped;
    }

    /// Seconds of fire per second of the clock; 0 before the first frame.
    pub fn factor(&self) -> f64 {
        if self.clock > 0.0 {
            self.simulated / self.clock
        } else {
            0.0
        }
    }

    /// Forgets dropped time, because the work of a step changes.
    pub fn forget_losses(&mut self) {
        (self.due, self.dropped) = (0.0, 0.0);
    }

    /// Whether the fire dropped more than a twentieth of the time that was due.
    pub fn slowed(&self) -> bool {
        self.dropped > TOLERATED_LOSS_SHARE * self.due
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A second of frames at 60 Hz, each of which simulates that part of the due time.
    fn second(real_time: &mut RealTime, scale: f64, part: f64) {
        for _ in 0..60 {
            let due = scale / 60.0;
            real_time.frame(1.0 / 60.0, scale, part * due, (1.0 - part) * due);
        }
    }

    #[test]
    fn the_real_time_factor_is_fire_time_by_clock_time() {
        let mut real_time = RealTime::default();
        assert_eq!(real_time.factor(), 0.0);
        for scale in [1.0, 0.1, 2.0] {
            for _ in 0..10 {
                second(&mut real_time, scale, 1.0);
                // A change of the time scale is no loss.
                assert!(!real_time.slowed());
            }
            assert!((real_time.factor() - scale).abs() < 1e-3);
        }
    }

    #[test]
    fn a_fire_is_slowed_as_long_as_it_drops_steps() {
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
    fn forgotten_losses_leave_the_real_time_factor() {
        let mut real_time = RealTime::default();
        for _ in 0..10 {
            second(&mut real_time, 1.0, 0.3);
        }
        let before = real_time.factor();
        real_time.forget_losses();
        assert!(!real_time.slowed());
        assert_eq!(real_time.factor(), before);
        // Later losses count at once.
        real_time.frame(1.0 / 60.0, 1.0, 1.0 / 60.0, 0.0);
        assert!(!real_time.slowed());
        second(&mut real_time, 1.0, 0.3);
        assert!(real_time.slowed());
    }

    #[test]
    fn one_late_frame_does_not_slow_a_fire_but_many_do() {
        let mut real_time = RealTime::default();
        second(&mut real_time, 1.0, 1.0);
        real_time.frame(1.0 / 60.0, 1.0, 0.5 / 60.0, 0.5 / 60.0);
        assert!(!real_time.slowed());
        second(&mut real_time, 1.0, 0.8);
        assert!(real_time.slowed());
    }

    #[test]
    fn steps_longer_than_frames_do_not_slow_a_fire() {
        let mut real_time = RealTime::default();
        // Slow motion with long steps: one frame in ten makes one.
        for frame in 0..100 {
            let made = if frame % 10 == 9 { 1.0 / 60.0 } else { 0.0 };
            real_time.frame(1.0 / 60.0, 0.1, made, 0.0);
            assert!(!real_time.slowed());
        }
    }

    #[test]
    fn frames_longer_than_the_clock_makes_up_for_slow_a_fire() {
        let mut real_time = RealTime::default();
        for _ in 0..10 {
            real_time.frame(0.2, 1.0, LONGEST_FRAME, 0.0);
        }
        assert!(real_time.slowed());
        assert!((real_time.factor() - 0.5).abs() < 1e-6);
    }

    #[test]
    fn a_page_that_hung_once_does_not_slow_a_fire_for_seconds() {
        let mut real_time = RealTime::default();
        second(&mut real_time, 1.0, 1.0);
        real_time.frame(10.0, 1.0, LONGEST_FRAME, 0.0);
        for _ in 0..2 {
            second(&mut real_time, 1.0, 1.0);
        }
        assert!(!real_time.slowed());
    }
}
