//! `cargo xtask validate`: runs the physics against theory, and writes the
//! table and its plots into `docs/evaluation.md` and `docs/validation`.

use std::fs;

use anyhow::{Context, Result, bail};

use crate::{marks, paths, process, site};

/// Runs the cases whose names begin with one of `names`, or all of them. Only
/// a run of all is written down.
///
/// # Errors
/// A row outside its tolerance that is not known to be; no case of a name.
pub fn run(names: &[String]) -> Result<()> {
    let mut validate = process::cargo();
    validate.args([
        "run",
        "--quiet",
        "--release",
        "--package",
        "hearth-tests",
        "--example",
        "validate",
        "--",
    ]);
    if !names.is_empty() {
        return process::run(validate.args(names));
    }
    let folder = site::target_folder()?.join("hearth-validation");
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    let held = process::run(validate.arg("--write").arg(&folder));

    // What was measured is written down whether or not it holds.
    let Ok(table) = fs::read_to_string(folder.join("table.md")) else {
        held?;
        bail!("the validation left no table");
    };
    let docs = paths::root().join("docs");
    let plots = docs.join("validation");
    if plots.exists() {
        fs::remove_dir_all(&plots)?;
    }
    fs::create_dir_all(&plots)?;
    for file in fs::read_dir(&folder)? {
        let file = file?.path();
        if let Some(name) = file
            .file_name()
            .filter(|_| file.extension() == Some("svg".as_ref()))
        {
            fs::copy(&file, plots.join(name))?;
        }
    }
    let page = docs.join("evaluation.md");
    let present = fs::read_to_string(&page)
        .with_context(|| format!("cannot read {}", paths::shown(&page)))?;
    let updated = marks::with(&present, "validated", &table)
        .with_context(|| format!("{} lacks its marks", paths::shown(&page)))?;
    fs::write(&page, updated)?;
    println!("wrote {} and {}", paths::shown(&page), paths::shown(&plots));
    held
}
