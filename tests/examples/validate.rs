//! Runs validation cases on all cores and prints what came out.
//!
//! `validate [--write FOLDER] [CASE...]`: all cases, or those whose names begin
//! as given; the table and the plots go into FOLDER. Fails where a row fails.
//! `cargo measure validate` calls it.

use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::thread;
use std::time::Instant;

use hearth_tests::validation::table::{self, Finished};
use hearth_tests::validation::{self, Case, Pace};

fn main() -> ExitCode {
    match options().and_then(|(folder, cases)| validate(folder.as_deref(), &cases)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The folder to write into, and the cases to run.
fn options() -> io::Result<(Option<PathBuf>, Vec<&'static Case>)> {
    let (mut folder, mut names) = (None, Vec::new());
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        if argument == "--write" {
            folder = arguments.next().map(PathBuf::from);
        } else {
            names.push(argument);
        }
    }
    let fits = |case: &Case, name: &String| case.name.starts_with(name.as_str());
    if let Some(name) = names
        .iter()
        .find(|name| !validation::cases().any(|case| fits(case, name)))
    {
        let known: Vec<_> = validation::cases().map(|case| case.name).collect();
        let known = known.join(", ");
        return Err(io::Error::other(format!(
            "no case begins with \"{name}\"; there are: {known}"
        )));
    }
    let cases = validation::cases()
        .filter(|case| names.is_empty() || names.iter().any(|name| fits(case, name)))
        .collect();
    Ok((folder, cases))
}

/// Runs the cases and reports; whether all rows hold or are known not to.
fn validate(folder: Option<&Path>, cases: &[&'static Case]) -> io::Result<bool> {
    let start = Instant::now();
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let finished = run(cases, cores);
    let passed = table::passed(&finished);
    println!(
        "\n{} in {:.1} min on {cores} cores",
        if passed {
            "Every row holds, or is known not to"
        } else {
            "Some rows fail"
        },
        start.elapsed().as_secs_f64() / 60.0
    );
    if let Some(folder) = folder {
        fs::create_dir_all(folder)?;
        let mut text = table::markdown(&finished);
        let plots = finished.iter().flat_map(|case| &case.outcome.plots);
        for (i, plot) in plots.enumerate() {
            let file = format!("{}.svg", plot.name);
            fs::write(folder.join(&file), plot.svg())?;
            text.push_str(if i % 2 == 0 { "\n" } else { "" });
            text.push_str(&format!("![{}](validation/{file})\n", plot.title));
        }
        fs::write(folder.join("table.md"), text)?;
    }
    Ok(passed)
}

/// Runs the cases on so many threads, the longest first, so that all cores are
/// busy to the end; gives them back in the order of the table.
fn run(cases: &[&'static Case], cores: usize) -> Vec<Finished> {
    let mut waiting = cases.to_vec();
    waiting.sort_by_key(|case| match case.pace {
        Pace::Quick => 0,
        Pace::Long(seconds) => seconds,
    });
    let waiting = Mutex::new(waiting);
    let mut finished: Vec<Finished> = thread::scope(|scope| {
        let workers: Vec<_> = (0..cores.min(cases.len()))
            .map(|_| scope.spawn(|| work(&waiting)))
            .collect();
        let done = workers.into_iter().map(|worker| match worker.join() {
            Ok(done) => done,
            Err(panic) => std::panic::resume_unwind(panic),
        });
        done.flatten().collect()
    });
    let place = |name: &str| cases.iter().position(|case| case.name == name);
    finished.sort_by_key(|finished| place(finished.case.name));
    finished
}

/// Runs what waits, one case after another.
fn work(waiting: &Mutex<Vec<&'static Case>>) -> Vec<Finished> {
    let next = || waiting.lock().ok()?.pop();
    let mut finished = Vec::new();
    while let Some(case) = next() {
        let start = Instant::now();
        let outcome = (case.run)();
        let took = start.elapsed();
        let mut text = format!("{} ({:.1} s)\n", case.name, took.as_secs_f64());
        for row in &outcome.rows {
            text.push_str(&table::line(row));
            text.push('\n');
        }
        // One write, so that lines of two cases do not mix.
        let _ = io::stdout().lock().write_all(text.as_bytes());
        finished.push(Finished {
            case,
            outcome,
            took,
        });
    }
    finished
}
