//! `cargo measure fuzz`: sends random values to every decoder, natively, in Node, and with inputs that coverage guides, whose
//! figures it writes into `docs/evaluation.md`.

use anyhow::Result;
use xshell::cmd;
use xtask::fuzz::Tried;
use xtask::shell::Shell;
use xtask::tools;

use crate::evaluation;
use crate::flags::Fuzz;

const HEAD: &str = "| decoder | inputs | a second | slowest | commit |\n|---|--:|--:|--:|---|\n";

/// Tries every law of the decoders for so many minutes each; or one of the decoders that coverage guides, alone.
pub(crate) fn run(fuzz: &Fuzz) -> Result<()> {
    if fuzz.decoder.is_none() {
        laws(fuzz)?;
    }
    let commit = evaluation::commit()?;
    let seconds = 60 * fuzz.minutes.unwrap_or(1);
    xtask::fuzz::run(
        seconds,
        fuzz.seed.unwrap_or(1),
        fuzz.decoder.as_deref(),
        &mut |tried| {
            let before = evaluation::read("fuzzed")?;
            evaluation::write("fuzzed", &recorded(&before, &tried, &commit))
        },
    )
}

/// The laws of random values.
fn laws(fuzz: &Fuzz) -> Result<()> {
    tools::node()?;
    let sh = Shell::new()?;
    let given = [
        ("HEARTH_FUZZ_MINUTES", fuzz.minutes),
        ("HEARTH_FUZZ_SEED", fuzz.seed),
    ];
    for (name, value) in given {
        if let Some(value) = value {
            sh.set_var(name, value.to_string());
        }
    }
    let limit = 600_000 + 4 * 60_000 * u64::from(fuzz.minutes.unwrap_or(0));
    let option = format!("--test-timeout={limit}");
    cmd!(sh, "node --test {option} tests/web/fuzz.test.mjs").run()?;
    Ok(cmd!(sh, "cargo test --package hearth-tests --test laws fuzz::").run()?)
}

/// The table with the row of a decoder, in the order of their names.
fn recorded(before: &str, tried: &Tried, commit: &str) -> String {
    let figure = |name| tried.figures.get(name).copied().unwrap_or_default();
    let [inputs, rate, slowest] = [
        "number_of_executed_units",
        "average_exec_per_sec",
        "slowest_unit_time_sec",
    ]
    .map(figure);
    let slowest = match slowest {
        0 => "below 1 s".to_owned(),
        time => format!("{time} s"),
    };
    let start = format!("| {} |", tried.decoder);
    let row = format!("{start} {inputs} | {rate} | {slowest} | {commit} |");
    let others = before
        .lines()
        .skip(2)
        .filter(|line| line.starts_with('|') && !line.starts_with(&start));
    let mut rows: Vec<_> = others.chain([row.as_str()]).collect();
    rows.sort_unstable();
    format!("{HEAD}{}\n", rows.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_replaces_that_of_its_decoder_alone() {
        let tried = Tried {
            decoder: "link".to_owned(),
            figures: [("number_of_executed_units".to_owned(), 7)].into(),
        };
        let old = format!("{HEAD}| link | 1 | 1 | 1 s | a |\n| scene | 2 | 2 | 2 s | a |\n");
        let rows = "| link | 7 | 0 | below 1 s | b |\n| scene | 2 | 2 | 2 s | a |\n";
        assert_eq!(recorded(&old, &tried, "b"), format!("{HEAD}{rows}"));
    }
}
