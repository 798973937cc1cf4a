//! Fixed simulation steps from the frames of a wall clock.
//!
//! A display draws at 30, 60, 120 or 144 Hz, or at no steady rate at all; the
//! fire must burn at the same speed on each. The clock turns the passing of
//! time into whole steps of a fixed length and keeps the remainder for the
//! next frame. It never asks the time: the caller tells it.

/// Longest time that one frame may make up for, in seconds of the wall clock.
/// A page that was hidden or blocked must not come back with a burst of work.
pub const LONGEST_FRAME: f64 = 0.1;

/// Turns the times of frames into whole steps.
#[derive(Clone, Debug, Default)]
pub struct Clock {
    last: Option<f64>,
    owed: f64,
}

impl Clock {
    /// A clock that has seen no frame.
    pub fn new() -> Clock {
        Clock::default()
    }

    /// The number of steps of `step` seconds to make for a frame at the time
    /// `now` (seconds of any steady clock), where a second of the clock is
    /// `time_scale` seconds of fire. The first frame makes none. A clock that
    /// runs backwards counts as one that stands still.
    pub fn advance(&mut self, now: f64, step: f64, time_scale: f64) -> u32 {
        let passed = self.last.map_or(0.0, |last| now - last);
        self.last = Some(now);
        self.owed += passed.clamp(0.0, LONGEST_FRAME) * time_scale;
        // A display's frames are not exactly a whole number of steps long; the
        // tiny slack keeps 1/60 s at four steps of 1/240 s instead of 3, 5, 3 ….
        let steps = (self.owed / step + 1e-6).floor().max(0.0);
        self.owed = (self.owed - steps * step).max(0.0);
        steps as u32
    }

    /// Forgets the last frame and what is owed: after a pause, the time that
    /// has passed is not made up for.
    pub fn restart(&mut self) {
        *self = Clock::new();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steps_in(seconds: f64, frames_per_second: f64, scale: f64) -> u32 {
        let mut clock = Clock::new();
        let frames = (seconds * frames_per_second).round() as u32;
        (0..=frames)
            .map(|frame| clock.advance(f64::from(frame) / frames_per_second, 1.0 / 240.0, scale))
            .sum()
    }

    #[test]
    fn a_fire_burns_at_the_same_speed_on_every_display() {
        for rate in [30.0, 50.0, 60.0, 75.0, 120.0, 144.0, 240.0] {
            let steps = steps_in(10.0, rate, 1.0);
            assert!(steps.abs_diff(2400) <= 1, "{steps} steps at {rate} Hz");
        }
    }

    #[test]
    fn the_time_scale_scales() {
        assert!(steps_in(10.0, 60.0, 0.5).abs_diff(1200) <= 1);
        assert!(steps_in(10.0, 60.0, 2.0).abs_diff(4800) <= 1);
    }

    #[test]
    fn catching_up_is_clamped() {
        let mut clock = Clock::new();
        clock.advance(0.0, 1.0 / 240.0, 1.0);
        assert_eq!(clock.advance(3600.0, 1.0 / 240.0, 1.0), 24);
    }

    #[test]
    fn time_that_runs_backwards_makes_no_step() {
        let mut clock = Clock::new();
        clock.advance(10.0, 1.0 / 240.0, 1.0);
        assert_eq!(clock.advance(5.0, 1.0 / 240.0, 1.0), 0);
    }

    #[test]
    fn a_pause_is_not_made_up_for() {
        let mut clock = Clock::new();
        clock.advance(0.0, 1.0 / 240.0, 1.0);
        clock.restart();
        assert_eq!(clock.advance(0.05, 1.0 / 240.0, 1.0), 0);
    }
}
