//! What `benches/browser/run.mjs` measured.

use anyhow::{Context, Result};
use serde_json::Value;

/// The headline's place: a browser, one thread.
pub(super) const BROWSER: &str = "chromium";

/// Floating-point operations of a pair of particles in a step of the classic
/// model, roughly.
const OPERATIONS_A_PAIR: f64 = 55.0;

/// Everything that was measured.
pub(super) struct Figures {
    pub all: Value,
    pub rows: Vec<Row>,
}

/// One case in one place.
#[derive(Clone, Debug)]
pub(super) struct Row {
    /// The program.
    pub name: String,
    pub scene: String,
    pub place: String,
    /// Particles that were asked for.
    pub count: u64,
    pub particles: f64,
    pub neighbours: f64,
    pub substeps: u64,
    pub step: Time,
    pub steps_a_frame: Option<f64>,
    pub is_yardstick: bool,
}

/// A time in milliseconds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Time {
    /// The median of all rounds.
    pub median: f64,
    /// The best round's.
    pub best: f64,
}

impl Time {
    /// What a function makes of both.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Time {
        Time {
            median: f(self.median),
            best: f(self.best),
        }
    }

    /// How many times as long as `other`.
    pub fn over(self, other: Time) -> Time {
        Time {
            median: self.median / other.median,
            best: self.best / other.best,
        }
    }

    fn read(value: &Value) -> Option<Time> {
        Some(Time {
            median: value["stepMs"].as_f64()?,
            best: value["bestStepMs"].as_f64()?,
        })
    }
}

impl Row {
    fn read(value: &Value) -> Option<Row> {
        let text = |key: &str| value[key].as_str().map(str::to_owned);
        Some(Row {
            name: text("name")?,
            scene: text("scene")?,
            place: text("where")?,
            count: value["count"].as_u64()?,
            particles: value["particles"].as_f64()?,
            neighbours: value["neighbours"].as_f64().unwrap_or_default(),
            substeps: value["substeps"].as_u64().unwrap_or(1),
            step: Time::read(value)?,
            steps_a_frame: value["stepsPerFrame"].as_f64(),
            is_yardstick: value["yardstick"] == true,
        })
    }

    /// What it is called in a table.
    pub fn label(&self) -> String {
        match self.scene.as_str() {
            "typed" => "JavaScript, typed arrays, list of pairs".to_owned(),
            "scan" => "JavaScript, typed arrays, 3 × 3 cells".to_owned(),
            "paper" => "JavaScript, the paper's loop".to_owned(),
            _ => self.name.clone(),
        }
    }

    /// Nanoseconds a particle and step.
    pub fn nanoseconds(&self) -> Time {
        self.step.map(|ms| 1e6 * ms / self.particles)
    }

    /// Milliseconds that the steps of a 60 Hz frame take.
    pub fn frame(&self) -> Option<Time> {
        let steps = self.steps_a_frame?;
        Some(self.step.map(|ms| ms * steps))
    }
}

impl Figures {
    /// # Errors
    /// No JSON, or one without results.
    pub fn read(text: &str) -> Result<Figures> {
        let all: Value = serde_json::from_str(text).context("the figures cannot be read")?;
        let listed = all["results"].as_array().context("there are no figures")?;
        let rows = listed.iter().filter_map(Row::read).collect();
        Ok(Figures { all, rows })
    }

    /// Hearth, or a baseline of its own, in a place.
    pub fn own(&self, scene: &str, place: &str, count: u64) -> Option<&Row> {
        self.row("Hearth", scene, place, count)
    }

    pub fn row(&self, name: &str, scene: &str, place: &str, count: u64) -> Option<&Row> {
        self.rows.iter().find(|row| {
            row.name.starts_with(name)
                && row.scene == scene
                && row.place == place
                && row.count == count
        })
    }

    /// The share of the place's peak that Hearth's steps reach; nothing for other
    /// programs and other models, whose pairs take other operations.
    pub fn share_of_peak(&self, row: &Row) -> Option<Time> {
        let peak = self.all["peaks"][&row.place].as_f64()?;
        let counted = row.name == "Hearth" && row.scene == "block";
        let operations = OPERATIONS_A_PAIR * 0.5 * row.neighbours;
        counted.then(|| row.nanoseconds().map(|ns| operations / ns / peak))
    }

    /// Times of a step on a slowed-down page.
    pub fn throttled(&self) -> Option<(Time, f64)> {
        let throttled = &self.all["throttled"];
        Some((Time::read(throttled)?, throttled["stepsPerFrame"].as_f64()?))
    }

    /// When a page shows its first picture.
    pub fn first_picture(&self) -> Option<Time> {
        let first = &self.all["page"]["firstPicture"];
        let time = |name: &str| first[name].as_f64();
        Some(Time {
            median: time("median")?,
            best: time("best")?,
        })
    }

    /// The longest task of a page's own thread.
    pub fn longest_task(&self) -> Option<Time> {
        let longest = self.all["page"]["longestTask"].as_f64()?;
        Some(Time {
            median: longest,
            best: longest,
        })
    }

    /// Bytes a particle of the block that took most.
    pub fn memory(&self) -> Option<f64> {
        let listed = self.all["memory"].as_array()?;
        let each = listed
            .iter()
            .filter_map(|one| Some(one["bytes"].as_f64()? / one["particles"].as_f64()?));
        each.max_by(f64::total_cmp)
    }
}
