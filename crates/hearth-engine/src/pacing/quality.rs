//! Adaptive quality: how many particles a fire has and how fine its picture is.
//!
//! Without a requested level, a fire starts with a guess for the device, tries the guess for
//! half a second, and then compares the cost of its frames with the time that the display
//! gives them. It lowers the level soon after frames cost too much. It raises the level only
//! after several frames had room, waits four times as long after each retreat, and rises at
//! most four times: a fire that changes all the time is worse than a coarse one. Where drawing is
//! what takes long at the lowest level, the picture gets fewer pixels.

mod detail;
mod load;
mod reason;
mod window;

use detail::Detail;
use hearth_core::resolution::Level;
use load::{Load, USUAL_INTERVAL_MS};
pub use window::FrameCost;
use window::Window;

use super::thread_budget::STEPS_BUDGET_MS;

/// Time between two decisions, and before the first \[ms\].
const DECISION_INTERVAL_MS: f64 = 1000.0;
const TRIAL_MS: f64 = 500.0;
/// Interval of frames above which the surplus does not count \[ms\]: the page was busy.
const MAX_COUNTED_INTERVAL_MS: f64 = 250.0;
/// Interval below which two frames are the same one \[ms\].
const SAME_FRAME_MS: f64 = 1.0;
/// Interval of the fastest display for which a fire lowers its level \[ms\].
const MIN_DISPLAY_INTERVAL_MS: f64 = 4.0;
/// Share of the budget above which a fire exceeds it.
const EXCEEDED_SHARE: f64 = 0.9;
/// The same of drawing alone, for fires whose number of particles is fixed.
const EXCEEDED_SHARE_OF_DRAWING: f64 = 0.5;
/// Share of the budget for steps above which a slowed fire is slow because of its steps.
const EXCEEDED_SHARE_OF_STEPS: f64 = 0.9;
/// Mean interval in intervals of the display above which frames are late.
const LATE_INTERVALS: f64 = 1.3;
/// Consecutive windows that exceed the budget, or are late, before the level falls.
const EXCEEDED_WINDOWS: u32 = 2;
const LATE_WINDOWS: u32 = 3;
/// Consecutive windows with room before the level rises, and the factor on that number after
/// each fall.
const CALM_WINDOWS: u32 = 3;
const PATIENCE_FACTOR: u32 = 4;
/// Maximum number of rises.
const MAX_RISES: u32 = 4;
/// Share of a longer interval that the assumed interval of the display takes over per window.
const SLOWER_DISPLAY_SHARE: f64 = 0.05;

/// The level of a fire, and its reason.
#[derive(Clone, Debug)]
pub struct Quality {
    requested: Option<Level>,
    detail: Detail,
    reason: String,
    /// Time of the last frame \[ms\].
    last: Option<f64>,
    /// Assumed interval of the display's frames \[ms\].
    display: f64,
    window: Window,
    /// Whether the trial is over.
    tried: bool,
    /// Consecutive windows that exceed the budget, are late, or have room.
    exceeded: u32,
    late: u32,
    calm: u32,
    /// Windows with room before the next rise.
    patience: u32,
    rises: u32,
}

impl Quality {
    /// The requested level or, without one, a guess to start from.
    pub fn new(requested: Option<Level>, guess: Level) -> Quality {
        let mut quality = Quality {
            requested: None,
            detail: Detail::of(guess),
            reason: "a guess for this device".into(),
            last: None,
            display: USUAL_INTERVAL_MS,
            window: Window::default(),
            tried: false,
            exceeded: 0,
            late: 0,
            calm: 0,
            patience: CALM_WINDOWS,
            rises: 0,
        };
        if requested.is_some() {
            quality.request(requested);
        }
        quality
    }

    /// Fixes the level, or makes it adaptive.
    pub fn request(&mut self, level: Option<Level>) {
        self.requested = level;
        self.reason = match level {
            Some(level) => {
                self.detail = Detail::of(level);
                "as requested"
            }
            None => "as before it became adaptive",
        }
        .into();
        self.restart_window();
        (self.patience, self.rises) = (CALM_WINDOWS, 0);
    }

    /// The requested level; `None` if it is adaptive.
    pub fn requested(&self) -> Option<Level> {
        self.requested
    }

    /// The current level.
    pub fn level(&self) -> Level {
        self.detail.level()
    }

    /// Default maximum of pixels in a picture.
    pub fn pixels(&self) -> f64 {
        self.detail.share() * self.level().pixels()
    }

    /// The reason of the current level, as text.
    pub fn reason(&self) -> &str {
        &self.reason
    }

    /// The speed of the machine allows `now` particles of the `requested` ones, because a step takes
    /// that time of at most `max` \[ms\].
    pub fn explain(&mut self, step: f64, max: f64, now: u32, requested: u32) {
        self.reason = reason::of_capacity(step, max, now, requested);
    }

    /// Starts after a pause: the interval before the next frame does not count.
    pub fn skip(&mut self) {
        self.last = None;
        self.restart_window();
    }

    fn restart_window(&mut self) {
        self.window = Window::default();
        self.restart_counts();
    }

    fn restart_counts(&mut self) {
        (self.exceeded, self.late, self.calm) = (0, 0, 0);
    }

    /// Adds a frame. Returns whether the level changed.
    pub fn frame(&mut self, frame: &FrameCost) -> bool {
        let interval = self.last.map(|last| frame.now - last);
        if interval.is_some_and(|interval| interval < SAME_FRAME_MS) {
            return false;
        }
        self.last = Some(frame.now);
        let Some(interval) = interval else {
            return false;
        };
        let age = self.window.age(frame.now);
        let counted = if interval < MAX_COUNTED_INTERVAL_MS {
            interval
        } else {
            MAX_COUNTED_INTERVAL_MS
        };
        self.window.add(frame, counted);
        let length = if self.tried {
            DECISION_INTERVAL_MS
        } else {
            TRIAL_MS
        };
        if age < length {
            return false;
        }
        let window = std::mem::take(&mut self.window);
        self.measure_display(window.lower_quartile());
        // A fire with a limited frame rate is not late.
        if self.display < frame.min_interval {
            self.display = frame.min_interval;
        }
        if self.requested.is_some() || window.simulated == 0.0 {
            return false;
        }
        let trial = !std::mem::replace(&mut self.tried, true);
        let load = self.load(&window, frame, trial);
        let detail = if trial {
            self.after_trial(&load)
        } else {
            self.after_window(&load)
        };
        let before = self.level();
        if let Some(detail) = detail {
            self.restart_counts();
            self.detail = detail;
        }
        self.level() != before
    }

    /// Updates the assumed interval of the display. Intervals longer than usual mean another
    /// display or a saver of power, but only if the lowest level does not shorten them; the
    /// assumption follows them slowly.
    fn measure_display(&mut self, interval: f64) {
        let known = if self.display > USUAL_INTERVAL_MS {
            self.display
        } else {
            USUAL_INTERVAL_MS
        };
        self.display = if interval <= known {
            if interval > MIN_DISPLAY_INTERVAL_MS {
                interval
            } else {
                MIN_DISPLAY_INTERVAL_MS
            }
        } else if self.level() == Level::Low {
            known + SLOWER_DISPLAY_SHARE * (interval - known)
        } else {
            known
        };
    }

    /// The load of a window. During the trial the browser still compiles: the best frames predict
    /// better than the mean, and the time of drawing has no meaning.
    fn load(&self, window: &Window, frame: &FrameCost, trial: bool) -> Load {
        let rate = window.steps_ms / window.simulated;
        let (rate, draw) = if trial {
            (window.best_rate.unwrap_or(rate), 0.0)
        } else {
            (rate, window.draw_ms / window.frames)
        };
        let mut load = Load {
            detail: self.detail,
            particles: frame.particles,
            steps: rate * frame.time_scale * self.display * 1e-3,
            draw,
            shrinks: frame
                .pixels
                .is_some_and(|pixels| pixels > 0.5 * self.pixels()),
            budget: self.display / frame.fires.max(1) as f64,
            share: frame.share,
            interval: window.intervals / window.frames,
            exceeds: false,
            late: false,
        };
        load.exceeds = if frame.particles.is_some() {
            // Rare frames slow a fire, too, independent of its steps.
            let time = STEPS_BUDGET_MS.min(frame.share * self.display);
            let budget = EXCEEDED_SHARE_OF_STEPS * time / frame.fires.max(1) as f64;
            let slowed = frame.slowed && !trial && load.steps > budget;
            load.expected(self.detail) > EXCEEDED_SHARE * load.budget || slowed
        } else {
            draw > EXCEEDED_SHARE_OF_DRAWING * load.budget
        };
        // Frames within the budget come late because of the graphics card or the page. A fixed
        // number of particles leaves nothing to change if the steps cause it.
        let rare = load.interval > LATE_INTERVALS * self.display;
        let busy = (window.steps_ms / frame.share + window.draw_ms) / window.frames;
        let helps = frame.particles.is_some() || busy + self.display < load.interval;
        load.late = rare && helps && !load.exceeds;
        load
    }

    /// The detail that should fit, after a trial of the guess.
    fn after_trial(&mut self, load: &Load) -> Option<Detail> {
        let detail = if load.exceeds {
            load.lower()
        } else {
            let finer = load.finest(Detail::FINEST, self.detail.finer());
            finer.filter(|_| !load.late)
        };
        let detail = detail.filter(|_| load.particles.is_some())?;
        self.reason = reason::of_change("steps should take ", load.expected(detail), load, detail);
        Some(detail)
    }

    /// Less detail after several windows that exceeded the budget or were late, or more after
    /// several with room.
    fn after_window(&mut self, load: &Load) -> Option<Detail> {
        count(&mut self.exceeded, load.exceeds);
        count(&mut self.late, load.late);
        let finer = self.detail.finer();
        let calm = !load.exceeds && !load.late && self.detail < Detail::FINEST && load.fits(finer);
        count(&mut self.calm, calm);
        let (what, ms, detail) = if self.exceeded >= EXCEEDED_WINDOWS {
            let took = load.expected(self.detail);
            ("steps and drawing took ", took, load.lower()?)
        } else if self.late >= LATE_WINDOWS {
            if self.detail <= Detail::LOW {
                return None;
            }
            ("pictures come every ", load.interval, self.detail.coarser())
        } else {
            if self.calm < self.patience || self.rises >= MAX_RISES {
                return None;
            }
            let takes = load.expected(finer);
            ("steps and drawing should take ", takes, finer)
        };
        if detail > self.detail {
            self.rises += 1;
        } else if detail.level() < self.level() {
            self.patience *= PATIENCE_FACTOR;
        }
        self.reason = reason::of_change(what, ms, load, detail);
        Some(detail)
    }
}

/// Counts consecutive occurrences.
fn count(times: &mut u32, occurs: bool) {
    *times = if occurs { *times + 1 } else { 0 };
}
