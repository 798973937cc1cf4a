//! The report of `cargo xtask test`: a headline and the time of each stage, and at the end
//! a table and a line of totals.

use std::fmt::Write as _;
use std::time::{Duration, Instant};

use anyhow::{Result, anyhow};

/// How a stage ended.
#[derive(Debug, PartialEq)]
enum Outcome {
    Passed,
    Failed(String),
    Skipped,
}

/// The stages so far.
#[derive(Debug, Default)]
pub(crate) struct Report {
    stages: Vec<(&'static str, Outcome, Duration)>,
}

impl Report {
    /// Runs a stage and records how it ended. The stage fails without running where the
    /// one that it `needs` failed.
    pub(crate) fn stage(
        &mut self,
        name: &'static str,
        about: &str,
        needs: Option<&str>,
        work: impl FnOnce() -> Result<()>,
    ) {
        println!("\n=== {name}: {about}");
        let start = Instant::now();
        let result = match needs {
            Some(need) if self.failed().any(|failed| failed == need) => {
                Err(anyhow!("not run, because \"{need}\" failed"))
            }
            _ => work(),
        };
        let time = start.elapsed();
        let outcome = match result {
            Ok(()) => Outcome::Passed,
            Err(error) => Outcome::Failed(format!("{error:#}")),
        };
        match &outcome {
            Outcome::Failed(why) => println!("=== {name} FAILED after {}: {why}", shown(time)),
            _ => println!("=== {name} passed in {}", shown(time)),
        }
        self.stages.push((name, outcome, time));
    }

    /// Records a stage that is skipped on request.
    pub(crate) fn skip(&mut self, name: &'static str) {
        println!("\n=== {name}: skipped on request");
        self.stages.push((name, Outcome::Skipped, Duration::ZERO));
    }

    fn failed(&self) -> impl Iterator<Item = &str> {
        let failed = |outcome: &Outcome| matches!(outcome, Outcome::Failed(_));
        let stages = self.stages.iter();
        stages.filter_map(move |(name, outcome, _)| failed(outcome).then_some(*name))
    }

    /// Whether everything that ran passed.
    pub(crate) fn passed(&self) -> bool {
        self.failed().next().is_none()
    }

    /// The table of all stages; its last line is `N passed, M failed`.
    pub(crate) fn summary(&self) -> String {
        let mut text = String::new();
        for (name, outcome, time) in &self.stages {
            let word = match outcome {
                Outcome::Passed => "passed",
                Outcome::Failed(_) => "FAILED",
                Outcome::Skipped => "skipped",
            };
            let _ = writeln!(text, "{name:<12}{word:<10}{:>10}", shown(*time));
            if let Outcome::Failed(why) = outcome {
                let indented = why.replace('\n', "\n            ");
                let _ = writeln!(text, "            {indented}");
            }
        }
        let total = self.stages.iter().map(|(_, _, time)| *time).sum();
        let passed = self
            .stages
            .iter()
            .filter(|stage| stage.1 == Outcome::Passed);
        let (passed, failed) = (passed.count(), self.failed().count());
        let _ = writeln!(text, "{:<22}{:>10}", "", shown(total));
        let _ = writeln!(text, "{passed} passed, {failed} failed");
        text
    }
}

fn shown(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds < 60.0 {
        return format!("{seconds:.1} s");
    }
    let whole = seconds.round() as u64;
    format!("{} min {:02} s", whole / 60, whole % 60)
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::bail;

    #[test]
    fn the_last_line_counts() {
        let mut report = Report::default();
        report.stage("good", "", None, || Ok(()));
        report.stage("next", "", Some("good"), || Ok(()));
        report.skip("browser");
        assert!(report.passed());
        assert_eq!(report.summary().lines().last(), Some("2 passed, 0 failed"));
    }

    #[test]
    fn a_failure_stops_what_needs_it_and_nothing_else() {
        let mut report = Report::default();
        let mut ran = Vec::new();
        report.stage("site", "", None, || bail!("no disk"));
        report.stage("e2e", "", Some("site"), || {
            ran.push("e2e");
            Ok(())
        });
        report.stage("lint", "", None, || {
            ran.push("lint");
            Ok(())
        });
        assert_eq!(ran, ["lint"]);
        assert!(!report.passed());
        let summary = report.summary();
        assert!(summary.contains("no disk"));
        assert_eq!(summary.lines().last(), Some("1 passed, 2 failed"));
    }

    #[test]
    fn times_are_readable() {
        assert_eq!(shown(Duration::from_millis(1250)), "1.2 s");
        assert_eq!(shown(Duration::from_secs(125)), "2 min 05 s");
    }
}
