//! `cargo measure coverage`: which lines of core, settings and engine their own tests reach, and which of the scripts those in
//! Node, written into `docs/evaluation.md`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde_json::Value;
use xshell::cmd;
use xtask::shell::Shell;
use xtask::{paths, tools};

use crate::evaluation;

/// What is measured: the name of a row, and the folder of its files.
const ROWS: [(&str, &str); 4] = [
    ("core", "crates/hearth-core/src/"),
    ("settings", "crates/hearth-settings/src/"),
    ("engine", "crates/hearth-engine/src/"),
    ("scripts that these tests load", "web/"),
];

/// The packages whose tests run, instrumented.
const PACKAGES: &str = "-p hearth-fire-core -p hearth-fire-settings -p hearth-engine";

/// So many of the longest unreached pieces are printed.
const SHOWN: usize = 24;

/// How often each line of a file is reached.
type Lines = BTreeMap<usize, u64>;

/// Measures and records; prints the longest pieces that are not reached.
pub(crate) fn run() -> Result<()> {
    evaluation::check("covered")?;
    let (sh, folder) = (Shell::new()?, tools::target()?.join("coverage"));
    let mut files = BTreeMap::new();
    for report in [of_rust(&sh, &folder)?, of_scripts(&sh, &folder)?] {
        add(&mut files, &report);
    }
    for (file, lines) in &mut files {
        let own = length(&sh.read_file(file)?);
        lines.retain(|number, _| *number <= own);
    }
    let mut rows = String::from("| | lines | reached |\n|---|--:|--:|\n");
    for (name, under) in ROWS {
        let lines = files
            .iter()
            .filter(|(file, _)| file.starts_with(under))
            .flat_map(|(_, lines)| lines.values());
        let (all, reached) = lines.fold((0_u32, 0_u32), |(all, reached), times| {
            (all + 1, reached + u32::from(*times > 0))
        });
        let share = 100.0 * f64::from(reached) / f64::from(all.max(1));
        rows += &format!("| {name} | {all} | {share:.1} % |\n");
    }
    let mut gaps: Vec<_> = files
        .iter()
        .flat_map(|(file, lines)| gaps(lines).map(move |[first, last]| (last - first, file, first)))
        .collect();
    gaps.sort_unstable_by(|a, b| b.cmp(a));
    for (more, file, first) in gaps.iter().take(SHOWN) {
        println!("{file}:{first}: {} lines are not reached", more + 1);
    }
    let measured = format!("Measured at {}.\n\n", evaluation::commit()?);
    evaluation::write("covered", &(measured + &rows))
}

/// Runs the tests of the crates; returns what they reach.
fn of_rust(sh: &Shell, folder: &Path) -> Result<String> {
    let profiles = folder.join("profiles");
    sh.remove_path(&profiles)?;
    let test = |more: &str| {
        sh.cargo(&format!("test {PACKAGES} --lib --tests {more}"))
            .env("RUSTFLAGS", "-C instrument-coverage")
            .env("CARGO_TARGET_DIR", folder)
            .env("LLVM_PROFILE_FILE", profiles.join("%m-%p.profraw"))
    };
    let described = test("--no-run --message-format=json").read()?;
    let programs: Vec<PathBuf> = described
        .lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
        .filter_map(|message| message["executable"].as_str().map(PathBuf::from))
        .collect();
    // A law that fails under instrumentation fails in `cargo xtask test` too, which judges it.
    test("--no-fail-fast").ignore_status().run()?;
    let tools = llvm(sh)?;
    let (merged, found) = (folder.join("merged.profdata"), sh.read_dir(&profiles)?);
    cmd!(
        sh,
        "{tools}/llvm-profdata merge --sparse --output {merged} {found...}"
    )
    .quiet()
    .run()?;
    let objects = programs
        .iter()
        .map(|program| format!("--object={}", program.display()));
    Ok(cmd!(
        sh,
        "{tools}/llvm-cov export --format=lcov --instr-profile={merged} {objects...}"
    )
    .quiet()
    .read()?)
}

/// Runs the tests of the scripts in Node; returns what they reach.
fn of_scripts(sh: &Shell, folder: &Path) -> Result<String> {
    tools::node()?;
    let report = folder.join("scripts.lcov");
    let mut tests = sh.read_dir("tests/web")?;
    tests.retain(|file| file.to_string_lossy().ends_with(".test.mjs"));
    let options =
        "--test --experimental-test-coverage --test-concurrency=2 --test-reporter=lcov".split(' ');
    cmd!(
        sh,
        "node {options...} --test-reporter-destination={report} {tests...}"
    )
    .ignore_status()
    .run()?;
    Ok(sh.read_file(report)?)
}

/// The folder of LLVM's tools, of the version of this compiler.
fn llvm(sh: &Shell) -> Result<PathBuf> {
    let libraries = PathBuf::from(cmd!(sh, "rustc --print target-libdir").read()?);
    let tools = libraries
        .parent()
        .context("the compiler has no folder")?
        .join("bin");
    if !tools.join("llvm-cov").is_file() {
        cmd!(sh, "rustup component add llvm-tools").run()?;
    }
    Ok(tools)
}

/// Adds the lines of a report in the format of lcov to those of the checkout's files, without tests.
fn add(files: &mut BTreeMap<String, Lines>, report: &str) {
    let root = format!("{}/", paths::root().display());
    let mut file = String::new();
    for line in report.lines() {
        if let Some(path) = line.strip_prefix("SF:") {
            file = path.strip_prefix(&root).unwrap_or(path).to_owned();
        } else if let Some((number, times)) =
            line.strip_prefix("DA:").and_then(|it| it.split_once(','))
            && let (Ok(number), Ok(times)) = (number.parse(), times.parse::<u64>())
            && ROWS.iter().any(|(_, under)| file.starts_with(under))
            && !file.contains("/tests")
        {
            *files
                .entry(file.clone())
                .or_default()
                .entry(number)
                .or_default() += times;
        }
    }
}

/// The number of lines before the tests of a file.
fn length(text: &str) -> usize {
    let tests = text.find("#[cfg(test)]\nmod tests {");
    text[..tests.unwrap_or(text.len())].lines().count()
}

/// The first and last lines of the pieces that are not reached.
fn gaps(lines: &Lines) -> impl Iterator<Item = [usize; 2]> {
    let all: Vec<_> = lines
        .iter()
        .map(|(number, times)| (*number, *times > 0))
        .collect();
    let pieces: Vec<_> = all
        .chunk_by(|one, next| one.1 == next.1)
        .filter(|piece| !piece[0].1)
        .map(|piece| [piece[0].0, piece[piece.len() - 1].0])
        .collect();
    pieces.into_iter()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_reports_add_up_and_those_without_a_hit_are_a_gap() {
        let mut files = BTreeMap::new();
        let report = "SF:web/a.js\nDA:1,1\nDA:2,0\nDA:4,0\nDA:5,3\nDA:6,0\nend_of_record\nSF:web/tests/b.js\nDA:1,0\n";
        add(&mut files, report);
        add(&mut files, "SF:web/a.js\nDA:6,1\n");
        assert_eq!(files.len(), 1);
        let found: Vec<_> = gaps(&files["web/a.js"]).collect();
        assert_eq!(found, [[2, 4]]);
        assert_eq!(length("a\nb\n#[cfg(test)]\nmod tests {\n"), 2);
    }
}
