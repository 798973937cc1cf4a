//! Whole simulation steps from the frames of a wall clock.
//!
//! Displays draw at 30, 60, 120 or 144 Hz, or at no steady rate; the fire burns at the same
//! speed on each. The clock accumulates fire time: frames add to it and steps subtract from it,
//! whatever their length. It reads no system clock: the caller passes the time.

/// Longest time that one frame adds, in seconds of the wall clock. A page that was hidden or
/// blocked must not continue with a burst of work.
pub const LONGEST_FRAME: f64 = 0.1;

/// Turns the times of frames into whole steps.
#[derive(Clone, Debug, Default)]
pub struct Clock {
    last: Option<f64>,
    accumulated: f64,
}

impl Clock {
    /// A clock before its first frame.
    pub fn new() -> Clock {
        Clock::default()
    }

    /// Adds a frame at the time `now` (seconds of any steady clock); a second of the clock is
    /// `time_scale` seconds of fire. Returns the time since the last frame \[s\]: zero at the
    /// first one, and if the clock runs backwards. [`LONGEST_FRAME`] limits the added time.
    pub fn advance(&mut self, now: f64, time_scale: f64) -> f64 {
        let passed = self.last.map_or(0.0, |last| (now - last).max(0.0));
        self.last = Some(now);
        self.accumulated += passed.min(LONGEST_FRAME) * time_scale;
        passed
    }

    /// Whether another whole step of about `length` seconds of fire is due: at least half of
    /// it has accumulated. On average the steps then equal the frames, and a display whose
    /// frames are a whole number of steps long gets that number each time, despite jitter.
    pub fn due(&self, length: f64) -> bool {
        self.accumulated > 0.5 * length
    }

    /// Subtracts a step of `length` seconds of fire. If it was longer than the accumulated
    /// time, the next frames make up for the difference.
    pub fn spend(&mut self, length: f64) {
        self.accumulated -= length;
    }

    /// Drops the accumulated time that there was no time to simulate, and returns it \[s\]. A
    /// fire on a slow machine burns slowly and does not fall further and further behind.
    pub fn drop_rest(&mut self) -> f64 {
        let rest = self.accumulated.max(0.0);
        self.accumulated -= rest;
        rest
    }

    /// Forgets the last frame and the accumulated time: after a pause, the fire does not catch
    /// up.
    pub fn restart(&mut self) {
        *self = Clock::new();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: f64 = 1.0 / 240.0;

    /// Makes all due steps, of the lengths that `length` returns. Returns their number and
    /// their total length.
    fn make_due(clock: &mut Clock, mut length: impl FnMut() -> f64) -> (u32, f64) {
        let (mut steps, mut made) = (0, 0.0);
        let mut guess = STEP;
        while clock.due(guess) {
            guess = length();
            clock.spend(guess);
            steps += 1;
            made += guess;
        }
        (steps, made)
    }

    /// Seconds of fire in `seconds` of a display, with steps of such lengths.
    fn burnt_in(seconds: f64, rate: f64, scale: f64, mut length: impl FnMut() -> f64) -> f64 {
        let mut clock = Clock::new();
        let frames = (seconds * rate).round() as u32;
        (0..=frames)
            .map(|frame| {
                clock.advance(f64::from(frame) / rate, scale);
                make_due(&mut clock, &mut length).1
            })
            .sum()
    }

    #[test]
    fn a_fire_burns_at_the_same_speed_on_every_display() {
        for rate in [30.0, 50.0, 60.0, 75.0, 120.0, 144.0, 240.0] {
            for length in [STEP, 0.0002, 0.017] {
                let burnt = burnt_in(10.0, rate, 1.0, || length);
                let off = (burnt - 10.0).abs();
                assert!(
                    off <= length,
                    "{burnt} s of steps of {length} s at {rate} Hz"
                );
            }
        }
    }

    #[test]
    fn steps_of_changing_length_keep_the_speed() {
        for rate in [30.0, 60.0, 144.0] {
            let mut count = 0_u32;
            // From 0.2 to 1.4 ms, unrelated to the frames.
            let length = || {
                count += 1;
                0.0002 * f64::from(1 + count * 5 % 7)
            };
            let burnt = burnt_in(10.0, rate, 1.0, length);
            assert!((burnt - 10.0).abs() < 0.0015, "{burnt} s at {rate} Hz");
        }
    }

    #[test]
    fn frames_that_jitter_bring_the_same_number_of_steps_each() {
        let mut clock = Clock::new();
        clock.advance(0.0, 1.0);
        for frame in 1..1000 {
            let jitter = [0.0, 0.0015, -0.0009, 0.0004, -0.0015][frame % 5];
            clock.advance(frame as f64 / 60.0 + jitter, 1.0);
            let (steps, _) = make_due(&mut clock, || STEP);
            assert_eq!(steps, 4, "in frame {frame}");
        }
    }

    #[test]
    fn the_time_scale_scales() {
        for scale in [0.1, 0.5, 2.0] {
            let burnt = burnt_in(10.0, 60.0, scale, || STEP);
            assert!((burnt - 10.0 * scale).abs() <= STEP, "{burnt} s at {scale}");
        }
    }

    #[test]
    fn the_first_frame_makes_no_step() {
        let mut clock = Clock::new();
        assert_eq!(clock.advance(1000.0, 1.0), 0.0);
        assert!(!clock.due(STEP));
    }

    #[test]
    fn catching_up_is_clamped_and_the_elapsed_time_is_returned() {
        let mut clock = Clock::new();
        clock.advance(0.0, 1.0);
        assert_eq!(clock.advance(3600.0, 1.0), 3600.0);
        assert_eq!(make_due(&mut clock, || STEP).0, 24);
    }

    #[test]
    fn dropped_time_stays_dropped() {
        let mut clock = Clock::new();
        clock.advance(0.0, 1.0);
        clock.advance(0.1, 1.0);
        clock.spend(STEP);
        assert!((clock.drop_rest() - (0.1 - STEP)).abs() < 1e-9);
        assert!(!clock.due(STEP));
        // A step longer than the accumulated time leaves a debt.
        clock.spend(STEP);
        assert_eq!(clock.drop_rest(), 0.0);
        clock.advance(0.1 + STEP, 1.0);
        assert!(!clock.due(STEP));
    }

    #[test]
    fn time_that_runs_backwards_makes_no_step() {
        let mut clock = Clock::new();
        clock.advance(10.0, 1.0);
        assert_eq!(clock.advance(5.0, 1.0), 0.0);
        assert!(!clock.due(STEP));
    }

    #[test]
    fn a_pause_adds_no_time() {
        let mut clock = Clock::new();
        clock.advance(0.0, 1.0);
        clock.restart();
        assert_eq!(clock.advance(0.05, 1.0), 0.0);
        assert!(!clock.due(STEP));
    }
}
