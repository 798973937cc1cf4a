//! What `cargo xtask test` says: a headline and the time of each stage, and at
//! the end one table and one plain line.

use std::time::{Duration, Instant};

use anyhow::{Result, anyhow};

/// How a stage ended.
#[derive(Debug)]
enum Outcome {
    Passed,
    Failed(String),
    Skipped,
}

/// The stages so far.
#[derive(Debug, Default)]
pub struct Report {
    stages: Vec<(&'static str, Outcome, Duration)>,
}

impl Report {
    /// A report of nothing yet.
    pub fn new() -> Report {
        Report::default()
    }

    /// Runs a stage and notes how it ended. It is not run, and counts as
    /// failed, where one of the stages that it `needs` failed.
    pub fn stage(
        &mut self,
        name: &'static str,
        about: &str,
        needs: &[&str],
        work: impl FnOnce() -> Result<()>,
    ) {
        println!("\n=== {name}: {about}");
        let start = Instant::now();
        let worked = match needs.iter().find(|need| self.failed(need)) {
            Some(need) => Err(anyhow!("not run, because \"{need}\" failed")),
            None => work(),
        };
        let took = start.elapsed();
        let outcome = match worked {
            Ok(()) => Outcome::Passed,
            Err(error) => Outcome::Failed(format!("{error:#}")),
        };
        match &outcome {
            Outcome::Failed(why) => println!("=== {name} FAILED after {}: {why}", shown(took)),
            _ => println!("=== {name} passed in {}", shown(took)),
        }
        self.stages.push((name, outcome, took));
    }

    /// Notes a stage that a person asked to leave out.
    pub fn skip(&mut self, name: &'static str) {
        println!("\n=== {name}: left out, as asked");
        self.stages.push((name, Outcome::Skipped, Duration::ZERO));
    }

    fn failed(&self, name: &str) -> bool {
        self.stages
            .iter()
            .any(|(stage, outcome, _)| *stage == name && matches!(outcome, Outcome::Failed(_)))
    }

    /// Whether everything that ran passed.
    pub fn passed(&self) -> bool {
        !self
            .stages
            .iter()
            .any(|(_, outcome, _)| matches!(outcome, Outcome::Failed(_)))
    }

    /// The table of all stages; its last line is `N passed, M failed`.
    pub fn summary(&self) -> String {
        let mut text = String::new();
        let (mut passed, mut failed) = (0, 0);
        let total: Duration = self.stages.iter().map(|(_, _, took)| *took).sum();
        for (name, outcome, took) in &self.stages {
            let word = match outcome {
                Outcome::Passed => {
                    passed += 1;
                    "passed"
                }
                Outcome::Failed(_) => {
                    failed += 1;
                    "FAILED"
                }
                Outcome::Skipped => "left out",
            };
            text.push_str(&format!("{name:<12}{word:<10}{:>10}\n", shown(*took)));
            if let Outcome::Failed(why) = outcome {
                text.push_str(&format!(
                    "            {}\n",
                    why.replace('\n', "\n            ")
                ));
            }
        }
        text.push_str(&format!("{:<22}{:>10}\n", "", shown(total)));
        text.push_str(&format!("{passed} passed, {failed} failed\n"));
        text
    }
}

fn shown(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds < 60.0 {
        format!("{seconds:.1} s")
    } else {
        let whole = seconds.round() as u64;
        format!("{} min {:02} s", whole / 60, whole % 60)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::bail;

    #[test]
    fn the_last_line_counts() {
        let mut report = Report::new();
        report.stage("good", "", &[], || Ok(()));
        report.stage("next", "", &["good"], || Ok(()));
        report.skip("browser");
        assert!(report.passed());
        assert_eq!(report.summary().lines().last(), Some("2 passed, 0 failed"));
    }

    #[test]
    fn a_failure_stops_what_needs_it_and_nothing_else() {
        let mut report = Report::new();
        let mut ran = Vec::new();
        report.stage("site", "", &[], || bail!("no disk"));
        report.stage("e2e", "", &["site"], || {
            ran.push("e2e");
            Ok(())
        });
        report.stage("lint", "", &[], || {
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
