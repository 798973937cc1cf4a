//! Frames per second, smoothed.
//!
//! The rate of single frames varies too much to read, so the counter shows the
//! exponential moving average, `fps ← fps + α (1/Δt − fps)` with α = 0.1.

/// Weight of the newest frame.
pub const ALPHA: f64 = 0.1;

/// Shortest time between two frames of a display, in seconds. Callbacks closer together, as at
/// the start of a page, belong to one frame; a single rate of a thousand would take seconds to
/// fade from the average.
const SHORTEST_FRAME: f64 = 1.0 / 500.0;

/// The exponential moving average of the frame rate.
#[derive(Clone, Debug, Default)]
pub struct FpsCounter {
    last: Option<f64>,
    average: Option<f64>,
}

impl FpsCounter {
    /// A counter before its first frame.
    pub fn new() -> FpsCounter {
        FpsCounter::default()
    }

    /// Counts a frame at the time `now`, in seconds of any steady clock.
    pub fn frame(&mut self, now: f64) {
        if let Some(last) = self.last
            && now > last
        {
            if now - last < SHORTEST_FRAME {
                return;
            }
            let rate = 1.0 / (now - last);
            self.average = Some(match self.average {
                Some(average) => average + ALPHA * (rate - average),
                None => rate,
            });
        }
        self.last = Some(now);
    }

    /// The average so far [1/s]; zero before the second frame.
    pub fn fps(&self) -> f64 {
        self.average.unwrap_or(0.0)
    }

    /// Forgets the last frame but not the average: a pause is not a slow frame.
    pub fn skip(&mut self) {
        self.last = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_steady_display_shows_its_rate() {
        let mut counter = FpsCounter::new();
        for frame in 0..100 {
            counter.frame(f64::from(frame) / 60.0);
        }
        assert!((counter.fps() - 60.0).abs() < 1e-6);
    }

    #[test]
    fn one_frame_moves_it_by_a_tenth() {
        let mut counter = FpsCounter::new();
        counter.frame(0.0);
        counter.frame(1.0 / 60.0);
        counter.frame(1.0 / 60.0 + 1.0 / 30.0);
        assert!((counter.fps() - (60.0 + 0.1 * (30.0 - 60.0))).abs() < 1e-6);
    }

    #[test]
    fn callbacks_closer_than_any_frame_are_one_frame() {
        let mut counter = FpsCounter::new();
        for frame in 0..10 {
            counter.frame(f64::from(frame) / 60.0);
            counter.frame(f64::from(frame) / 60.0 + 0.0005);
        }
        assert!((counter.fps() - 60.0).abs() < 1e-6);
    }

    #[test]
    fn a_pause_does_not_count() {
        let mut counter = FpsCounter::new();
        counter.frame(0.0);
        counter.frame(1.0 / 60.0);
        counter.skip();
        counter.frame(100.0);
        counter.frame(100.0 + 1.0 / 60.0);
        assert!((counter.fps() - 60.0).abs() < 1e-6);
    }
}
