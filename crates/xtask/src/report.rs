//! The report of `cargo xtask test`: a headline and the time of each stage, and at the end
//! a table and a line of totals. Threads share it.

use std::fmt::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use anyhow::{Result, anyhow};

/// How a stage ended: a word, or why it failed.
type Outcome = Result<&'static str, String>;

/// The stages so far, in the order of their ends.
type Stages = Vec<(&'static str, Outcome, Duration)>;

/// The stages so far.
pub(crate) struct Report {
    start: Instant,
    stages: Mutex<Stages>,
    /// Wakes the threads that wait for a stage.
    ended: Condvar,
}

impl Report {
    pub(crate) fn new() -> Report {
        Report {
            start: Instant::now(),
            stages: Mutex::default(),
            ended: Condvar::new(),
        }
    }

    /// Runs a stage and records how it ended, once the one that it `needs` has ended. The stage
    /// fails without running where that one failed.
    pub(crate) fn stage(
        &self,
        name: &'static str,
        about: &str,
        needs: Option<&str>,
        work: impl FnOnce() -> Result<()>,
    ) {
        let failed = |stages: &Stages, need: &str| {
            let stage = stages.iter().find(|stage| stage.0 == need);
            stage.map(|(_, outcome, _)| outcome.is_err())
        };
        let needs = needs.filter(|need| {
            let waits = |stages: &mut Stages| failed(stages, need).is_none();
            let stages = self.ended.wait_while(self.stages(), waits);
            failed(&stages.unwrap_or_else(PoisonError::into_inner), need) == Some(true)
        });
        println!("\n=== {name}: {about}");
        let start = Instant::now();
        let result = match needs {
            Some(need) => Err(anyhow!("not run, because \"{need}\" failed")),
            // No thread waits for ever for a stage that panics.
            None => {
                catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Err(anyhow!("panicked")))
            }
        };
        let time = start.elapsed();
        let outcome = result.map_err(|error| format!("{error:#}"));
        match &outcome {
            Err(why) => println!("=== {name} FAILED after {}: {why}", shown(time)),
            Ok(()) => println!("=== {name} passed in {}", shown(time)),
        }
        self.push((name, outcome.map(|()| "passed"), time));
    }

    /// Records a stage that is skipped on request.
    pub(crate) fn skip(&self, name: &'static str) {
        println!("\n=== {name}: skipped on request");
        self.push((name, Ok("skipped"), Duration::ZERO));
    }

    fn push(&self, stage: (&'static str, Outcome, Duration)) {
        self.stages().push(stage);
        self.ended.notify_all();
    }

    fn stages(&self) -> MutexGuard<'_, Stages> {
        self.stages.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether everything that ran passed.
    pub(crate) fn passed(&self) -> bool {
        self.stages().iter().all(|(_, outcome, _)| outcome.is_ok())
    }

    /// The table of all stages; its last line is `N passed, M failed`.
    pub(crate) fn summary(&self) -> String {
        let mut text = String::new();
        let stages = self.stages();
        for (name, outcome, time) in &*stages {
            let word = outcome.as_ref().unwrap_or(&"FAILED");
            let _ = writeln!(text, "{name:<12}{word:<10}{:>10}", shown(*time));
            if let Err(why) = outcome {
                let indented = why.replace('\n', "\n            ");
                let _ = writeln!(text, "            {indented}");
            }
        }
        let count = |is: fn(&Outcome) -> bool| stages.iter().filter(|stage| is(&stage.1)).count();
        let (passed, failed) = (count(|it| *it == Ok("passed")), count(Result::is_err));
        let _ = writeln!(text, "{:<22}{:>10}", "", shown(self.start.elapsed()));
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
        let report = Report::new();
        report.stage("good", "", None, || Ok(()));
        report.stage("next", "", Some("good"), || Ok(()));
        report.skip("browser");
        assert!(report.passed());
        assert_eq!(report.summary().lines().last(), Some("2 passed, 0 failed"));
    }

    #[test]
    fn a_failure_stops_what_needs_it_and_nothing_else() {
        let report = Report::new();
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
    fn a_stage_waits_for_the_one_that_it_needs_even_if_that_panics() {
        let report = Report::new();
        std::thread::scope(|scope| {
            scope.spawn(|| report.stage("e2e", "", Some("site"), || Ok(())));
            report.stage("site", "", None, || panic!("as this test wants it"));
        });
        let summary = report.summary();
        assert!(summary.starts_with("site"), "{summary}");
        assert!(summary.ends_with("0 passed, 2 failed\n"), "{summary}");
    }

    #[test]
    fn times_are_readable() {
        assert_eq!(shown(Duration::from_millis(1250)), "1.2 s");
        assert_eq!(shown(Duration::from_secs(125)), "2 min 05 s");
    }
}
