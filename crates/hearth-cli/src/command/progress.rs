//! The progress bar, on standard error where that is a terminal.

use indicatif::{ProgressBar, ProgressFinish, ProgressStyle};

/// Steps of the bar per second of fire.
const STEPS_PER_SECOND: f64 = 100.0;

/// Shows how long fires have burnt.
#[derive(Clone)]
pub struct Progress(ProgressBar);

impl Progress {
    /// The bar of that many seconds of fire.
    pub fn new(seconds: f64) -> Progress {
        // indicatif draws nothing where standard error is no terminal.
        let bar = ProgressBar::new((seconds * STEPS_PER_SECOND) as u64);
        let bar = bar.with_finish(ProgressFinish::AndClear);
        if let Ok(style) = ProgressStyle::with_template("{wide_bar} {percent:>3} % {msg}") {
            bar.set_style(style);
        }
        Progress(bar)
    }

    /// Counts seconds of fire.
    pub fn add(&self, seconds: f64) {
        self.0.inc((seconds * STEPS_PER_SECOND).round() as u64);
    }

    /// Names the fire that burns.
    pub fn name(&self, scene: &str) {
        self.0.set_message(scene.to_owned());
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.0.finish_and_clear();
    }
}

/// Counts the steps of a fire in a [`Progress`], in whole hundredths of a second.
pub struct Counter<'a> {
    progress: &'a Progress,
    counted: f64,
}

impl Counter<'_> {
    /// Counts from an age of zero.
    pub fn new(progress: &Progress) -> Counter<'_> {
        Counter {
            progress,
            counted: 0.0,
        }
    }

    /// The fire has this age \[s\].
    pub fn at(&mut self, age: f64) {
        let new = ((age - self.counted) * STEPS_PER_SECOND).floor() / STEPS_PER_SECOND;
        if new > 0.0 {
            self.progress.add(new);
            self.counted += new;
        }
    }
}
