//! How many instructions a step takes, natively and in wasm, and what a first visit downloads. Unlike a time, these
//! numbers do not depend on what else the machine does, so growth is distinguishable from noise. When a visit shows its
//! first picture is recorded beside them, and not compared.
//!
//! `cargo xtask test cost` compares the counts with recorded ones; `cargo xtask cost` records them.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use serde::{Deserialize, Serialize};
use xshell::cmd;

use crate::shell::Shell;
use crate::site::{self, Module};
use crate::stages::browser;
use crate::{paths, tools};

/// The scenes as a wasm module, compiled as the page's engine is.
const SCENES: Module = Module::new("hearth-benches", "engine");

/// Native cases of `scenes::counted` in `benches`. What wasm is counted of, `benches/examples/fuel.rs` prints.
const CASES: [&str; 4] = ["classic block", "classic plume", "combustion", "bodies"];

/// Growth that fails and decrease that should be recorded: with the recorded compiler, and another.
const TOLERANCE: f64 = 0.03;
const OTHER_COMPILER: f64 = 0.10;

/// The target of the recorded counts.
const TARGET: &str = "x86_64-unknown-linux-gnu";

/// Instructions a particle and step, by case, or bytes, by entry.
type Counts = BTreeMap<String, u64>;

/// The recorded counts.
const FILE: &str = "benches/instructions.json";

/// The counts and the compiler that they depend on.
#[derive(Deserialize, Serialize)]
struct Counted {
    compiler: String,
    instructions: Counts,
    /// By entry.
    visits: BTreeMap<String, Visit>,
}

/// A first visit, as `benches/browser/visits.mjs` measures it.
#[derive(Deserialize, Serialize)]
struct Visit {
    /// Of all files, compressed.
    bytes: u64,
    /// Milliseconds from the start of the page, on the machine that recorded them.
    first_picture_ms: u64,
}

impl Counted {
    fn all(&self) -> Counts {
        let visits = self.visits.iter();
        let bytes = visits.map(|(entry, visit)| (format!("{entry}, bytes"), visit.bytes));
        self.instructions.clone().into_iter().chain(bytes).collect()
    }
}

/// Records the counts.
pub(crate) fn record() -> Result<()> {
    site::build()?;
    let Some(recorded) = counted()? else {
        return Ok(());
    };
    let text = serde_json::to_string_pretty(&recorded)? + "\n";
    Shell::new()?.write_file(FILE, text)?;
    println!("wrote {FILE}");
    Ok(())
}

/// Fails where a step takes far more instructions than recorded.
pub(crate) fn check() -> Result<()> {
    let Some(now) = counted()? else {
        return Ok(());
    };
    let recorded = Shell::new()?.read_file(FILE)?;
    let recorded: Counted = serde_json::from_str(&recorded).context(FILE)?;
    let mut tolerance = TOLERANCE;
    if recorded.compiler != now.compiler {
        println!("recorded with {}, now {}", recorded.compiler, now.compiler);
        tolerance = OTHER_COMPILER;
    }
    let comparison = compare(&recorded.all(), &now.all(), tolerance);
    print!("{}", comparison.table);
    if comparison.fallen {
        println!("some have fallen; run `cargo xtask cost`");
    }
    ensure!(
        comparison.grown.is_empty(),
        "over {:.0} % more than recorded: {}",
        100.0 * tolerance,
        comparison.grown.join(", ")
    );
    Ok(())
}

/// The counts of this checkout; `None` on another target than the recorded one.
fn counted() -> Result<Option<Counted>> {
    if !cfg!(all(
        target_arch = "x86_64",
        target_os = "linux",
        target_env = "gnu"
    )) {
        println!("skipped: the counts were recorded on {TARGET}");
        return Ok(None);
    }
    tools::VALGRIND.get()?;
    let sh = Shell::new()?;
    Ok(Some(Counted {
        instructions: count(&sh)?,
        visits: visits()?,
        compiler: cmd!(sh, "rustc --version").read()?,
    }))
}

/// What first visits of the built site download.
fn visits() -> Result<BTreeMap<String, Visit>> {
    let sh = Shell::new()?;
    let printed =
        browser::script(&sh, "../../benches/browser/visits.mjs", &paths::site())?.read()?;
    serde_json::from_str(&printed).context("visits.mjs")
}

/// Compiles the cases and counts each under callgrind.
fn count(sh: &Shell) -> Result<Counts> {
    // For the least processor: the code must not depend on the machine that compiles it.
    cmd!(
        sh,
        "cargo build --quiet --profile engine --target {TARGET} --package hearth-benches
         --bin counted"
    )
    .env_remove("CARGO_ENCODED_RUSTFLAGS")
    .env("RUSTFLAGS", "-C target-cpu=x86-64")
    .run()?;
    let folder = tools::target()?.join(TARGET).join("engine");
    let program = folder.join("counted");
    let notes = folder.join("callgrind.out");
    let mut counts = count_in_wasm(sh)?;
    for case in CASES {
        counts.insert(case.to_owned(), count_case(sh, &program, case, &notes)?);
    }
    Ok(counts)
}

/// Instructions of an interpreter of wasm, by case.
fn count_in_wasm(sh: &Shell) -> Result<Counts> {
    site::compile(&SCENES, &[])?;
    let wasm = tools::target()?
        .join(tools::WASM)
        .join("engine/hearth_benches.wasm");
    let fuel = "run --quiet --release --package hearth-benches --example fuel";
    let printed = sh.cargo(fuel).arg(wasm).read()?;
    let counts = printed.lines().map(|line| {
        let (case, count) = line.split_once(": ").context("no count")?;
        Ok((format!("{case}, wasm"), count.parse()?))
    });
    counts.collect()
}

fn count_case(sh: &Shell, program: &Path, case: &str, notes: &Path) -> Result<u64> {
    let options = ["--quiet", "--tool=callgrind", "--toggle-collect=*measured*"];
    let particles = cmd!(
        sh,
        "valgrind {options...} --callgrind-out-file={notes} {program} {case}"
    )
    .read()?;
    let particles: u64 = particles.parse().context("the case prints no number")?;
    let total = total(&sh.read_file(notes)?).context("callgrind gave no total")?;
    ensure!(total > 0 && particles > 0, "nothing was counted of {case}");
    Ok(total.div_ceil(particles))
}

/// The sum of all instructions in callgrind's notes.
fn total(notes: &str) -> Option<u64> {
    let mut lines = notes.lines().rev();
    let total = lines.find_map(|line| line.strip_prefix("totals:"))?;
    total.trim().parse().ok()
}

struct Comparison {
    table: String,
    grown: Vec<String>,
    fallen: bool,
}

fn compare(before: &Counts, now: &Counts, tolerance: f64) -> Comparison {
    let mut table = format!(
        "{:<30}{:>12}{:>12}{:>10}\n",
        "case", "recorded", "now", "change"
    );
    let (mut grown, mut fallen) = (Vec::new(), false);
    for (case, &count) in now {
        let Some(&before) = before.get(case) else {
            table += &format!("{case:<30}{:>12}{count:>12}\n", "");
            grown.push(format!("{case} (not recorded)"));
            continue;
        };
        let change = count as f64 / before as f64 - 1.0;
        let percent = format!("{:+.1} %", 100.0 * change);
        table += &format!("{case:<30}{before:>12}{count:>12}{percent:>10}\n");
        if change > tolerance {
            grown.push(format!("{case} {percent}"));
        }
        fallen |= change < -tolerance;
    }
    Comparison {
        table,
        grown,
        fallen,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(cases: &[(&str, u64)]) -> Counts {
        let named = cases.iter().map(|&(case, count)| (case.to_owned(), count));
        named.collect()
    }

    #[test]
    fn growth_beyond_the_tolerance_fails() {
        let before = counts(&[("a", 1000), ("b", 1000), ("c", 1000)]);
        let now = counts(&[("a", 1031), ("b", 1029), ("c", 971)]);
        let comparison = compare(&before, &now, TOLERANCE);
        assert_eq!(comparison.grown, ["a +3.1 %"]);
        assert!(!comparison.fallen);
        assert!(compare(&before, &counts(&[("c", 969)]), TOLERANCE).fallen);
        assert!(comparison.table.contains("971    -2.9 %"));
        assert!(compare(&before, &now, OTHER_COMPILER).grown.is_empty());
    }

    #[test]
    fn a_case_without_a_recorded_count_fails() {
        let comparison = compare(&Counts::new(), &counts(&[("new", 5)]), TOLERANCE);
        assert_eq!(comparison.grown, ["new (not recorded)"]);
    }

    #[test]
    fn the_total_is_read_from_the_last_line_of_that_name() {
        assert_eq!(total("events: Ir\nsummary: 7\n\ntotals: 12\n"), Some(12));
        assert_eq!(total("events: Ir\n"), None);
    }

    #[test]
    fn every_case_has_a_recorded_count() -> Result<()> {
        let recorded: Counted = serde_json::from_str(&Shell::new()?.read_file(FILE)?)?;
        for case in CASES {
            assert!(recorded.instructions.contains_key(case), "{case}");
        }
        Ok(())
    }
}
