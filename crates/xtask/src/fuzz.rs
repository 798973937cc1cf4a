//! Inputs that coverage guides, for the decoders of `tests/fuzz`: libFuzzer on stable Rust.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use hearth_core::params::PARAMETERS;
use hearth_core::scene::KINDS;
use xshell::cmd;

use crate::shell::Shell;
use crate::tools;

/// Flags of LLVM's instrumentation for libFuzzer. The compiler's own option is unstable, its parts are not.
const INSTRUMENTED: &str = "--cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
    -Cllvm-args=-sanitizer-coverage-trace-compares";

/// Build scripts are not instrumented where a target is named.
const TARGET: &str = "x86_64-unknown-linux-gnu";

/// Inputs of each decoder by its name: each byte is a letter of Latin-1.
const CORPUS: &str = "tests/fuzz/corpus.json";

/// Most inputs of a decoder, and the longest \[bytes\].
const MOST: u32 = 1_000_000;
const LONGEST: u32 = 4096;

/// Longest time of an input \[s\].
const SLOWEST: u32 = 10;

/// Tries each decoder for a few seconds.
pub(crate) fn shortly() -> Result<()> {
    const SECONDS: u32 = 8;
    run(SECONDS, 1, None, &mut |_| Ok(()))
}

/// What a decoder was tried with.
pub struct Tried {
    /// Its name.
    pub decoder: String,
    /// libFuzzer's figures, by their names.
    pub figures: BTreeMap<String, u64>,
}

/// Tries each decoder, or the named one, for that long, or a million inputs, and reports it. What it finds more than the
/// corpus stays beside it in the target folder, and is where the next run begins.
///
/// # Errors
/// An input breaks the law of its decoder: the error names its file. No decoder has that name.
pub fn run(
    seconds: u32,
    seed: u32,
    only: Option<&str>,
    report: &mut dyn FnMut(Tried) -> Result<()>,
) -> Result<()> {
    if !cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        println!("skipped: the decoders are instrumented on {TARGET}");
        return Ok(());
    }
    tools::COMPILER.get()?;
    let (sh, folder) = (Shell::new()?, tools::target()?.join("fuzz"));
    // The dependencies have the versions of the workspace.
    sh.copy_file("Cargo.lock", "tests/fuzz")?;
    cmd!(sh, "cargo build --quiet --release --manifest-path tests/fuzz/Cargo.toml --target {TARGET} --target-dir {folder}")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .env("RUSTFLAGS", INSTRUMENTED)
        .run()?;
    let words = folder.join("words");
    sh.write_file(&words, dictionary())?;
    let program = folder.join(TARGET).join("release/hearth-fuzz");
    let corpus: BTreeMap<String, Vec<String>> =
        serde_json::from_str(&sh.read_file(CORPUS)?).context(CORPUS)?;
    let names = corpus.keys().map(String::as_str).collect::<Vec<_>>();
    ensure!(
        only.is_none_or(|name| names.contains(&name)),
        "a decoder is one of {}, not \"{}\"",
        names.join(", "),
        only.unwrap_or_default()
    );
    for (decoder, inputs) in &corpus {
        if only.is_some_and(|name| name != decoder) {
            continue;
        }
        let found = folder.join("found").join(decoder);
        for (number, input) in inputs.iter().enumerate() {
            sh.write_file(found.join(format!("corpus-{number}")), latin(input))?;
        }
        let mut folders = vec![found];
        if decoder == "scene" {
            folders.extend(["scenes", "scenes/community"].map(Into::into));
        }
        let limits = [seconds, seed];
        report(try_decoder(
            &sh, &program, decoder, &folders, &words, limits,
        )?)?;
    }
    Ok(())
}

fn try_decoder(
    sh: &Shell,
    program: &Path,
    decoder: &str,
    folders: &[PathBuf],
    words: &Path,
    [seconds, seed]: [u32; 2],
) -> Result<Tried> {
    let broken = words.with_file_name("broken").join(decoder);
    sh.create_dir(&broken)?;
    let options = [
        format!("-runs={MOST}"),
        format!("-max_total_time={seconds}"),
        format!("-seed={seed}"),
        format!("-max_len={LONGEST}"),
        format!("-timeout={SLOWEST}"),
        format!("-dict={}", words.display()),
        format!("-artifact_prefix={}/", broken.display()),
        "-print_final_stats=1".to_owned(),
        "-verbosity=0".to_owned(),
    ];
    let done = cmd!(sh, "{program} {options...} {folders...}")
        .env("HEARTH_DECODER", decoder)
        .quiet()
        .ignore_status()
        .output()?;
    let log = String::from_utf8_lossy(&done.stderr);
    let figures: BTreeMap<_, _> = log
        .lines()
        .filter_map(|line| line.strip_prefix("stat::")?.split_once(':'))
        .filter_map(|(name, value)| Some((name.to_owned(), value.trim().parse().ok()?)))
        .collect();
    let inputs = figures.get("number_of_executed_units").unwrap_or(&0);
    println!("{decoder}: {inputs} inputs");
    ensure!(
        done.status.success(),
        "an input breaks the law of \"{decoder}\"; it is in {}:\n{log}",
        broken.display()
    );
    Ok(Tried {
        decoder: decoder.to_owned(),
        figures,
    })
}

/// The names that decoders know, as words that an input may have.
fn dictionary() -> String {
    let kinds = KINDS
        .iter()
        .flat_map(|kind| kind.names.iter().copied().chain([kind.name]));
    let ids = PARAMETERS.iter().map(|param| param.id);
    let fields = [
        "values", "objects", "hearth", "preset", "kind", "id", "fire=",
    ];
    let all = fields.into_iter().chain(ids).chain(kinds);
    all.map(|word| format!("\"{word}\"\n")).collect()
}

fn latin(text: &str) -> Vec<u8> {
    text.chars().map(|letter| letter as u8).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corpus_has_inputs_of_every_decoder_in_latin() -> Result<()> {
        let sh = Shell::new()?;
        let corpus: BTreeMap<String, Vec<String>> = serde_json::from_str(&sh.read_file(CORPUS)?)?;
        let program = sh.read_file("tests/fuzz/src/main.rs")?;
        for (decoder, inputs) in &corpus {
            assert!(program.contains(&format!("(\"{decoder}\", ")), "{decoder}");
            assert!(!inputs.is_empty());
            assert!(
                inputs
                    .iter()
                    .all(|it| it.chars().all(|letter| u32::from(letter) < 256))
            );
        }
        let decoders = program
            .split("const DECODERS")
            .nth(1)
            .and_then(|it| it.split("];").next());
        assert_eq!(
            decoders.map(|it| it.matches("(\"").count()),
            Some(corpus.len())
        );
        Ok(())
    }
}
