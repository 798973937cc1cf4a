//! What `benches/browser/run.mjs` measured.

use anyhow::{Context, Result};
use serde::Deserialize;
use serde_json::Value;

/// The place of the headline: a browser, one thread.
pub(super) const BROWSER: &str = "chromium";

/// Floating-point operations of a pair of particles in a step of the classic model,
/// roughly.
const OPERATIONS_A_PAIR: f64 = 55.0;

/// Everything that was measured.
pub(super) struct Figures {
    pub all: Value,
    pub rows: Vec<Row>,
}

/// One case in one place.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Row {
    /// The program.
    pub name: String,
    pub scene: String,
    #[serde(rename = "where")]
    pub place: String,
    /// The requested number of particles.
    pub count: u64,
    pub particles: f64,
    #[serde(default)]
    pub neighbours: f64,
    #[serde(default = "one_substep")]
    pub substeps: u64,
    #[serde(flatten)]
    pub step: Time,
    pub steps_per_frame: Option<f64>,
    #[serde(default)]
    pub yardstick: bool,
}

fn one_substep() -> u64 {
    1
}

/// A time in milliseconds.
#[derive(Clone, Copy, Debug, Deserialize)]
pub(super) struct Time {
    /// The median of all rounds.
    #[serde(rename = "stepMs", alias = "median")]
    pub median: f64,
    /// The best round's.
    #[serde(rename = "bestStepMs", alias = "best")]
    pub best: f64,
}

impl Time {
    /// The same in every round.
    pub fn always(time: f64) -> Time {
        let (median, best) = (time, time);
        Time { median, best }
    }

    /// Applies a function to both.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Time {
        Time {
            median: f(self.median),
            best: f(self.best),
        }
    }

    /// The ratio to `other`.
    pub fn over(self, other: Time) -> Time {
        Time {
            median: self.median / other.median,
            best: self.best / other.best,
        }
    }
}

impl Row {
    /// Its name in a table.
    pub fn label(&self) -> &str {
        match self.scene.as_str() {
            "typed" => "JavaScript, typed arrays, list of pairs",
            "scan" => "JavaScript, typed arrays, 3 × 3 cells",
            "paper" => "JavaScript, the paper's loop",
            _ => &self.name,
        }
    }

    /// Nanoseconds a particle and step.
    pub fn nanoseconds(&self) -> Time {
        self.step.map(|ms| 1e6 * ms / self.particles)
    }

    /// Milliseconds of the steps of a 60 Hz frame.
    pub fn frame(&self) -> Option<Time> {
        let steps = self.steps_per_frame?;
        Some(self.step.map(|ms| ms * steps))
    }
}

impl Figures {
    pub fn read(text: &str) -> Result<Figures> {
        let all: Value = serde_json::from_str(text).context("the figures cannot be read")?;
        let results = all["results"].as_array().context("there are no results")?;
        // A case that a program could not measure lacks figures.
        let rows = results.iter().filter_map(|row| Row::deserialize(row).ok());
        let rows = rows.collect();
        Ok(Figures { all, rows })
    }

    /// Hearth, or a baseline of its own, in a place.
    pub fn own(&self, scene: &str, place: &str, count: u64) -> Option<&Row> {
        self.row("Hearth", scene, place, count)
    }

    pub fn row(&self, name: &str, scene: &str, place: &str, count: u64) -> Option<&Row> {
        self.rows.iter().find(|row| {
            row.name.starts_with(name)
                && (&*row.scene, &*row.place, row.count) == (scene, place, count)
        })
    }

    /// The share of the place's peak that Hearth's steps reach; `None` for other programs
    /// and models, whose pairs need other operations.
    pub fn share_of_peak(&self, row: &Row) -> Option<Time> {
        let peak = self.all["peaks"][&row.place].as_f64()?;
        let counted = row.name == "Hearth" && row.scene == "block";
        let operations = OPERATIONS_A_PAIR * 0.5 * row.neighbours;
        counted.then(|| row.nanoseconds().map(|ns| operations / ns / peak))
    }

    /// The time of a step on a slowed-down page, and the steps of a frame.
    pub fn throttled(&self) -> Option<(Time, f64)> {
        let throttled = &self.all["throttled"];
        let steps = throttled["stepsPerFrame"].as_f64()?;
        Some((Time::deserialize(throttled).ok()?, steps))
    }

    /// When a page shows its first picture.
    pub fn first_picture(&self) -> Option<Time> {
        Time::deserialize(&self.all["page"]["firstPicture"]).ok()
    }

    /// The longest task of a page's own thread.
    pub fn longest_task(&self) -> Option<Time> {
        self.all["page"]["longestTask"].as_f64().map(Time::always)
    }

    /// Bytes a particle of the block that took most.
    pub fn memory(&self) -> Option<Time> {
        let blocks = self.all["memory"].as_array()?.iter();
        let bytes_each = blocks
            .filter_map(|block| Some(block["bytes"].as_f64()? / block["particles"].as_f64()?));
        bytes_each.max_by(f64::total_cmp).map(Time::always)
    }
}
