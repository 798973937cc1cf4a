//! What the frames between two decisions took.

use super::load::USUAL_INTERVAL_MS;

/// Frames whose step times a trial sums before it compares them: the clocks of browsers are
/// too coarse for a single frame.
const FRAMES_OF_A_GROUP: f64 = 8.0;
/// Intervals between frames that a window stores.
const STORED_INTERVALS: usize = 32;

/// One frame and its cost. All costs count from the previous frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameCost {
    /// Time of the frame \[ms\].
    pub now: f64,
    /// Minimum interval that a page requested \[ms\]; 0 without a request.
    pub min_interval: f64,
    /// Time of the steps \[ms\].
    pub steps_ms: f64,
    /// Seconds of fire that the steps simulated.
    pub simulated: f64,
    /// Time of drawing, on the processor or on the graphics card \[ms\].
    pub draw_ms: f64,
    /// Pixels of the element; none if the page limits those of the picture.
    pub pixels: Option<f64>,
    /// Requested seconds of fire per second of the clock.
    pub time_scale: f64,
    /// Whether the fire fell behind the clock in the last second.
    pub slowed: bool,
    /// Number of particles at each level, if the level decides it.
    pub particles: Option<[u32; 3]>,
    /// Number of fires that share the frame.
    pub fires: usize,
    /// Share of the thread that the engine takes.
    pub share: f64,
}

/// Sums over frames.
#[derive(Clone, Copy, Debug, Default)]
pub struct Window {
    start: Option<f64>,
    /// Number of frames.
    pub frames: f64,
    /// Sum of the intervals between them \[ms\].
    pub intervals: f64,
    /// Time of their steps \[ms\].
    pub steps_ms: f64,
    /// Seconds of fire that the steps simulated.
    pub simulated: f64,
    /// Time of drawing \[ms\].
    pub draw_ms: f64,
    /// Minimum over groups of frames of the time per second of fire \[ms\].
    pub best_rate: Option<f64>,
    /// `steps_ms` and `simulated` before the current group.
    before: [f64; 2],
    /// The last intervals, in a ring \[ms\].
    last: [f64; STORED_INTERVALS],
}

impl Window {
    /// Time from the first frame until `now` \[ms\].
    pub fn age(&mut self, now: f64) -> f64 {
        now - *self.start.get_or_insert(now)
    }

    /// Adds a frame, an interval after the previous one \[ms\].
    pub fn add(&mut self, frame: &FrameCost, interval: f64) {
        self.last[self.frames as usize % STORED_INTERVALS] = interval;
        self.frames += 1.0;
        self.intervals += interval;
        self.steps_ms += frame.steps_ms;
        self.simulated += frame.simulated;
        self.draw_ms += frame.draw_ms;
        if self.frames % FRAMES_OF_A_GROUP == 0.0 {
            let [steps_ms, simulated] = [
                self.steps_ms - self.before[0],
                self.simulated - self.before[1],
            ];
            self.before = [self.steps_ms, self.simulated];
            let best = self.best_rate.unwrap_or(f64::INFINITY);
            if simulated > 0.0 && steps_ms > 0.0 && steps_ms / simulated < best {
                self.best_rate = Some(steps_ms / simulated);
            }
        }
    }

    /// Lower quartile of the last intervals \[ms\]: neither late frames nor a few early ones
    /// change it.
    pub fn lower_quartile(&self) -> f64 {
        let intervals = &self.last[..STORED_INTERVALS.min(self.frames as usize)];
        let quarter = intervals.len() / 4;
        let is_quartile = |interval: &f64| {
            let shorter = intervals.iter().filter(|other| *other < interval).count();
            let not_longer = intervals.iter().filter(|other| *other <= interval).count();
            shorter <= quarter && quarter < not_longer
        };
        let found = intervals.iter().copied().find(is_quartile);
        found.unwrap_or(USUAL_INTERVAL_MS)
    }
}
