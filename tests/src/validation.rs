//! Physical validation of the fire, as executable cases.
//!
//! A [`Case`] runs the simulation through its public interface, measures, and
//! gives [`Row`]s: what theory expects, how far off it may be, and what came
//! out. The cases alone state expected values and tolerances. The
//! quick cases run in `tests/tests/validation.rs`, all of them in
//! `cargo measure validate`, which writes `docs/evaluation.md`.
//!
//! A tolerance is never loosened. A row that cannot be reached is in
//! [`not_reached`], with what was measured and why.

mod boxes;
pub mod detached;
pub mod diffusion;
pub mod disc;
pub mod flame;
pub mod kernel;
pub mod measure;
pub mod not_reached;
pub mod open_air;
pub mod plot;
pub mod plume;
mod record;
pub mod row;
pub mod settings;
pub mod solids;
pub mod soot;
pub mod stability;
pub mod table;
pub mod viscous;
pub mod waves;

pub use boxes::mass;
pub use plot::Plot;
pub use row::{Expected, Row, Verdict};

/// How long a case takes, roughly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// Seconds even in a test build: runs in `cargo xtask test` too.
    Quick,
    /// So many seconds on one core in a release build.
    Long(u32),
}

/// One run, or a few that belong together, and what is measured in it.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// What it is called on the command line.
    pub name: &'static str,
    /// How long it takes.
    pub pace: Pace,
    /// Runs it.
    pub run: fn() -> Outcome,
}

/// What a case measured.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// The lines of the table.
    pub rows: Vec<Row>,
    /// Pictures of the measurement.
    pub plots: Vec<Plot>,
}

impl Outcome {
    /// Rows without a picture.
    pub fn rows(rows: impl IntoIterator<Item = Row>) -> Outcome {
        Outcome {
            rows: rows.into_iter().collect(),
            plots: Vec::new(),
        }
    }

    /// The same with a picture.
    #[must_use]
    pub fn with(mut self, plot: Plot) -> Outcome {
        self.plots.push(plot);
        self
    }
}

/// Every case, in the order of the table.
pub fn cases() -> impl Iterator<Item = &'static Case> {
    [
        kernel::CASES,
        waves::CASES,
        diffusion::CASES,
        viscous::CASES,
        stability::CASES,
        solids::CASES,
        disc::CASES,
        flame::CASES,
        detached::CASES,
        plume::CASES,
        open_air::CASES,
        soot::CASES,
        settings::CASES,
    ]
    .into_iter()
    .flatten()
}

/// The case of that name.
pub fn case(name: &str) -> Option<&'static Case> {
    cases().find(|case| case.name == name)
}
