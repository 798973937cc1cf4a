//! Known vulnerabilities of the crates, by a copy of the RustSec database on this machine.

mod locks;

use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

use locks::{LOCKS, locked};
use semver::{Version, VersionReq};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Where a copy of the RustSec database is.
fn advisory_database() -> Option<PathBuf> {
    let cargo = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = || Some(PathBuf::from(env::var_os("HOME")?).join(".cargo"));
    let default = cargo.or_else(home)?.join("advisory-db");
    let folder = env::var_os("HEARTH_ADVISORY_DB").map_or(default, PathBuf::from);
    folder.join("crates").is_dir().then_some(folder)
}

/// The quoted texts of a field of an advisory, which is a text or a list.
fn quoted(advisory: &str, field: &str) -> Vec<String> {
    let Some((_, rest)) = advisory.split_once(&format!("\n{field} = ")) else {
        return Vec::new();
    };
    let end = if rest.starts_with('[') { ']' } else { '\n' };
    let value = rest.split(end).next().unwrap_or_default();
    value
        .split('"')
        .skip(1)
        .step_by(2)
        .map(str::to_owned)
        .collect()
}

/// The advisories of a database that apply to a crate. One that was withdrawn or reports no
/// vulnerability, but an unmaintained crate for instance, does not count.
fn advisories(database: &Path, name: &str, version: &str) -> Result<Vec<String>> {
    let folder = database.join("crates").join(name);
    // Without its feature `std`, an error of semver is no `Error`.
    let version = Version::parse(version).map_err(|error| error.to_string())?;
    let mut found = Vec::new();
    for file in fs::read_dir(folder).into_iter().flatten() {
        let advisory = fs::read_to_string(file?.path())?.replace("\r\n", "\n");
        let counts = ["withdrawn", "informational"]
            .iter()
            .all(|field| quoted(&advisory, field).is_empty());
        let mut safe = [
            quoted(&advisory, "patched"),
            quoted(&advisory, "unaffected"),
        ]
        .concat()
        .into_iter();
        if counts
            && !safe
                .any(|range| VersionReq::parse(&range).is_ok_and(|range| range.matches(&version)))
        {
            found.extend(quoted(&advisory, "id"));
        }
    }
    Ok(found)
}

#[test]
fn no_crate_has_a_known_vulnerability() -> Result<()> {
    // Not `eprintln!`, whose words `cargo test` hides where a test passes.
    let mut words = io::stderr();
    let Some(database) = advisory_database() else {
        writeln!(
            words,
            "advisories: not checked, because this machine has no copy of the RustSec database"
        )?;
        return Ok(());
    };
    let mut checked = 0;
    for file in LOCKS {
        for [name, version, ..] in locked(file)? {
            let found = advisories(&database, &name, &version)?;
            assert!(
                found.is_empty(),
                "{file}: {name} {version}: {}",
                found.join(", ")
            );
            checked += 1;
        }
    }
    writeln!(
        words,
        "advisories: {checked} crates checked against {}",
        database.display()
    )?;
    Ok(())
}

#[test]
fn an_advisory_applies_to_the_versions_that_it_does_not_except() -> Result<()> {
    let database = env::temp_dir().join(format!("hearth-advisories-{}", std::process::id()));
    let folder = database.join("crates/soot");
    fs::create_dir_all(&folder)?;
    for (number, extra) in [
        ("1", ""),
        ("2", "withdrawn = \"2026-01-01\"\n"),
        ("3", "informational = \"unmaintained\"\n"),
    ] {
        let advisory = format!(
            "```toml\n[advisory]\nid = \"RUSTSEC-2026-{number}\"\n{extra}\n[versions]\n\
             patched = [\">= 1.2.3\", \"^1.0.9\"]\nunaffected = [\n  \"< 0.5.0\",\n]\n```\n# Soot\n"
        );
        fs::write(folder.join(format!("{number}.md")), advisory)?;
    }
    for (version, vulnerable) in [
        ("0.4.9", false),
        ("0.5.0", true),
        ("1.0.8", true),
        ("1.0.9", false),
        ("2.0.0", false),
    ] {
        let found = advisories(&database, "soot", version)?;
        let expected: &[&str] = if vulnerable { &["RUSTSEC-2026-1"] } else { &[] };
        assert_eq!(found, expected, "{version}");
    }
    assert!(advisories(&database, "ash", "1.0.0")?.is_empty());
    Ok(fs::remove_dir_all(database)?)
}
