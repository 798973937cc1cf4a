//! How many instructions a step takes: unlike its time, that does not depend on
//! what else a machine does, so growth can be told from noise.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use serde_json::{Value, json};

use crate::{paths, process, site, tools};

/// The cases of `benches/examples/counted.rs`.
const CASES: [&str; 3] = ["classic block", "classic plume", "combustion"];

/// Growth that fails, and fall that is to be written down, as shares.
const TOLERANCE: f64 = 0.10;

/// The machine that the counts hold for, and the least processor of its kind:
/// what is compiled must not depend on whose processor compiles it.
const TARGET: &str = "x86_64-unknown-linux-gnu";
const PROCESSOR: &str = "x86-64";

/// Instructions a particle and step, by case.
type Counts = BTreeMap<String, u64>;

/// Counts, and holds the counts to those written down, or writes them down.
///
/// # Errors
/// A case that takes far more than it did; no way to count.
pub(super) fn run(write: bool) -> Result<()> {
    if !cfg!(all(
        target_arch = "x86_64",
        target_os = "linux",
        target_env = "gnu"
    )) {
        println!("left out: the counts that are written down hold for {TARGET} alone");
        return Ok(());
    }
    tools::valgrind()?;
    let counts = count()?;
    let compiler = process::output(process::command("rustc").arg("--version"))?;
    let compiler = compiler.trim();
    if write {
        let noted = json!({ "compiler": compiler, "instructions": counts });
        fs::write(file(), serde_json::to_string_pretty(&noted)? + "\n")?;
        println!("wrote {}", paths::shown(&file()));
        return Ok(());
    }
    let text = fs::read_to_string(file())
        .with_context(|| format!("cannot read {}", paths::shown(&file())))?;
    let noted: Value = serde_json::from_str(&text)?;
    let before: Counts = serde_json::from_value(noted["instructions"].clone())
        .with_context(|| format!("{} holds no counts", paths::shown(&file())))?;
    let verdict = compare(&before, &counts);
    print!("{}", verdict.table);
    if noted["compiler"] != compiler {
        println!(
            "they were written down with {}, this is {compiler}",
            noted["compiler"]
        );
    }
    if verdict.fallen {
        println!("some have fallen; run `cargo xtask bench --instructions --write`");
    }
    if !verdict.grown.is_empty() {
        bail!(
            "a step takes over {:.0} % more instructions than written down: {}",
            100.0 * TOLERANCE,
            verdict.grown.join(", ")
        );
    }
    Ok(())
}

fn file() -> PathBuf {
    paths::root().join("benches").join("instructions.json")
}

/// Compiles the cases and counts each under callgrind.
fn count() -> Result<Counts> {
    process::run(
        process::cargo()
            .args([
                "build",
                "--quiet",
                "--profile",
                "engine",
                "--target",
                TARGET,
            ])
            .args(["--package", "hearth-benches", "--example", "counted"])
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env("RUSTFLAGS", format!("-C target-cpu={PROCESSOR}")),
    )?;
    let folder = site::target_folder()?.join(TARGET).join("engine");
    let program = folder.join("examples").join("counted");
    let noted = folder.join("callgrind.out");
    let mut counts = Counts::new();
    for case in CASES {
        counts.insert(case.to_owned(), count_case(&program, case, &noted)?);
    }
    Ok(counts)
}

fn count_case(program: &Path, case: &str, noted: &Path) -> Result<u64> {
    let particles = process::output(
        process::command("valgrind")
            .args(["--quiet", "--tool=callgrind", "--toggle-collect=*measured*"])
            .arg(format!("--callgrind-out-file={}", noted.display()))
            .arg(program)
            .arg(case),
    )?;
    let particles: u64 = particles.trim().parse().context("no number of particles")?;
    let total = total(&fs::read_to_string(noted)?).context("callgrind gave no total")?;
    if total == 0 || particles == 0 {
        bail!("nothing was counted of {case}");
    }
    Ok(total.div_ceil(particles))
}

/// The sum of all instructions in callgrind's notes.
fn total(notes: &str) -> Option<u64> {
    let line = notes
        .lines()
        .rev()
        .find_map(|line| line.strip_prefix("totals:"))?;
    line.trim().parse().ok()
}

/// How the counts compare with those before.
struct Verdict {
    table: String,
    grown: Vec<String>,
    fallen: bool,
}

fn compare(before: &Counts, now: &Counts) -> Verdict {
    let mut table = format!(
        "{:<16}{:>14}{:>14}{:>10}\n",
        "instructions", "written down", "now", "change"
    );
    let (mut grown, mut fallen) = (Vec::new(), false);
    for (case, &count) in now {
        let Some(&before) = before.get(case) else {
            table += &format!("{case:<16}{:>14}{count:>14}\n", "");
            grown.push(format!("{case} (not written down at all)"));
            continue;
        };
        let change = count as f64 / before as f64 - 1.0;
        let percent = format!("{:+.1} %", 100.0 * change);
        table += &format!("{case:<16}{before:>14}{count:>14}{percent:>10}\n");
        if change > TOLERANCE {
            grown.push(format!("{case} {percent}"));
        }
        fallen |= change < -TOLERANCE;
    }
    Verdict {
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
    fn growth_beyond_a_tenth_is_blamed_and_the_like_fall_told() {
        let before = counts(&[("a", 1000), ("b", 1000), ("c", 1000)]);
        let verdict = compare(&before, &counts(&[("a", 1101), ("b", 1099), ("c", 901)]));
        assert_eq!(verdict.grown, ["a +10.1 %"]);
        assert!(!verdict.fallen);
        assert!(compare(&before, &counts(&[("c", 899)])).fallen);
        assert!(verdict.table.contains("901    -9.9 %"));
    }

    #[test]
    fn a_case_without_a_count_is_blamed() {
        let verdict = compare(&Counts::new(), &counts(&[("new", 5)]));
        assert_eq!(verdict.grown, ["new (not written down at all)"]);
    }

    #[test]
    fn the_total_is_the_last_line_of_that_name() {
        assert_eq!(total("events: Ir\nsummary: 7\n\ntotals: 12\n"), Some(12));
        assert_eq!(total("events: Ir\n"), None);
    }

    #[test]
    fn every_case_is_written_down() -> Result<()> {
        let noted: Value = serde_json::from_str(&fs::read_to_string(file())?)?;
        for case in CASES {
            assert!(noted["instructions"][case].is_u64(), "{case}");
        }
        Ok(())
    }
}
