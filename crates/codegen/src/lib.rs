//! Files generated from the table of parameters, the class of the element and the scenes.
//!
//! A parameter is stated once, in `hearth-core`. What needs it before any wasm is loaded
//! (the element's attributes), what a compiler reads (types) and what a person reads (the
//! reference) is generated and committed. A test writes a file that is out of date and
//! fails, so a stale one cannot be merged.
//!
//! A scene is a file of `scenes/`. What follows from one is generated from the file, and
//! not from the table in `hearth-core` that this program was compiled with.

mod gallery;
mod javascript;
mod markdown;
pub mod prewarmed;
mod rust;
mod scene;
pub mod sections;
mod stats;
mod typescript;

use std::path::Path;
use std::{fs, io};

use anyhow::{Context, Result};
use hearth_core::params::{Choice, Domain, Model, Param, Value};
pub use scene::Scene;
use serde_json::Value as Json;

/// The scenes that a page may open with, which are also stored prewarmed.
const PREWARMED: [&str; 1] = ["fireside"];

/// A generated file: its path in the checkout, and its text.
type Generated = (&'static str, String);

/// Every generated file.
fn generate(checkout: &Path) -> Result<Vec<Generated>> {
    let scenes = scenes(checkout)?;
    Ok(vec![
        (
            "crates/hearth-core/src/preset/scenes.txt",
            rust::table(&scenes),
        ),
        (
            "crates/hearth-core/src/preset/texts.txt",
            rust::texts(&scenes),
        ),
        (
            "crates/hearth-fire/src/picture.md",
            gallery::picture(checkout)?,
        ),
        ("web/generated/defaults.js", javascript::defaults()),
        ("web/parameters.js", javascript::module()),
        ("web/generated/table.js", javascript::table(&scenes)),
        ("web/generated/quantities.js", javascript::quantities()),
        ("web/generated/prewarmed.js", javascript::prewarmed()),
        (
            "web/generated/interpolation.js",
            javascript::interpolation(),
        ),
        ("web/generated/properties.js", javascript::properties()),
        (
            "web/generated/scene-objects.js",
            javascript::scene_objects(&scenes),
        ),
        ("web/generated/version.js", javascript::version()),
        ("web/parameters.d.ts", typescript::declarations(&scenes)),
        ("docs/element.md", stats::page(checkout)?),
        ("docs/parameters.md", markdown::reference()),
        ("docs/scenes.md", gallery::page(&scenes)),
    ])
}

/// The scene of that name, from its file.
fn scene_of_file(checkout: &Path, name: &str) -> Result<hearth_core::Scene> {
    let scenes = scenes(checkout)?;
    let scene = scenes.iter().find(|scene| scene.name == name);
    scene
        .with_context(|| format!("scenes/{name}.json is missing"))?
        .scene()
}

/// The scenes of `scenes/`, in the order of the presets.
///
/// # Errors
/// A file is wrong, or cannot be read.
pub fn scenes(checkout: &Path) -> Result<Vec<Scene>> {
    scene::read_all(&checkout.join("scenes"))
}

/// The scenes of `scenes/community/`.
///
/// # Errors
/// A file is wrong, or cannot be read.
pub fn community(checkout: &Path) -> Result<Vec<Scene>> {
    scene::read_community(&checkout.join("scenes"))
}

/// Writes each generated file of the checkout that is missing or differs; returns those.
///
/// # Errors
/// A file of `scenes/` with a wrong value, or a file that cannot be read or written.
pub fn refresh(checkout: &Path) -> Result<Vec<String>> {
    refresh_into(checkout, checkout)
}

fn refresh_into(folder: &Path, checkout: &Path) -> Result<Vec<String>> {
    let mut written = Vec::new();
    for (file, text) in generate(checkout)? {
        if ensure_contents(&folder.join(file), &text).context(file)? {
            written.push(file.to_owned());
        }
    }
    Ok(written)
}

/// Writes `text` to `path` if that differs; returns whether it did.
fn ensure_contents(path: &Path, text: &str) -> io::Result<bool> {
    match fs::read_to_string(path) {
        // A checkout on Windows may have other line ends.
        Ok(present) if present.replace("\r\n", "\n") == text => return Ok(false),
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => return Err(error),
        _ => {}
    }
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, text)?;
    Ok(true)
}

/// Every model, the default one first.
fn models() -> Vec<Model> {
    let names = Model::NAMES.iter();
    let mut models: Vec<_> = names.filter_map(|name| Model::from_name(name)).collect();
    models.sort_by_key(|&model| model != Model::DEFAULT);
    models
}

/// The models that use `param`, each with its default and range.
fn domains(param: &Param) -> Vec<(Model, &'static Domain)> {
    let domain = |model| Some((model, param.domain(model)?));
    models().into_iter().filter_map(domain).collect()
}

/// `viscosity_limit` → `viscosity-limit`.
fn attribute(id: &str) -> String {
    id.replace('_', "-")
}

/// `viscosity_limit`, or `viscosity-limit` → `viscosityLimit`.
fn property(id: &str) -> String {
    let mut words = id.split(['_', '-']);
    let mut name = words.next().unwrap_or_default().to_owned();
    for word in words {
        let (first, rest) = word.split_at(word.len().min(1));
        name.push_str(&first.to_ascii_uppercase());
        name.push_str(rest);
    }
    name
}

/// `value` as JSON, which is JavaScript and TypeScript as well.
fn json(value: Value) -> Json {
    match (value, value.as_number()) {
        (Value::Flag(on), _) => on.into(),
        (_, Some(x)) => number(x),
        (text, None) => text.to_string().into(),
    }
}

/// A number without `.0`.
fn number(x: f64) -> Json {
    match x as i64 {
        whole if whole as f64 == x => whole.into(),
        _ => x.into(),
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use xshell::Shell;

    use super::*;

    fn checkout() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
    }

    #[test]
    fn generated_files_are_up_to_date() {
        let written = refresh(&checkout());
        assert!(
            written.as_ref().is_ok_and(Vec::is_empty),
            "generated files were out of date and have been written; commit them: {written:?}"
        );
    }

    #[test]
    fn a_stale_file_is_written_once() -> Result<()> {
        let folder = Shell::new()?.create_temp_dir()?;
        let checkout = checkout();
        let refresh = || refresh_into(folder.path(), &checkout);
        let generated = generate(&checkout)?.into_iter();
        let all: Vec<_> = generated.map(|(path, _)| path).collect();
        assert_eq!(refresh()?, all);
        assert!(refresh()?.is_empty());
        fs::write(folder.path().join(all[0]), "stale")?;
        assert_eq!(refresh()?, all[..1]);
        assert!(refresh()?.is_empty());
        Ok(())
    }

    #[test]
    fn names_follow_the_platform() {
        assert_eq!(attribute("max_particles"), "max-particles");
        assert_eq!(property("max_particles"), "maxParticles");
        assert_eq!(property("reduced-motion"), "reducedMotion");
        assert_eq!(property("seed"), "seed");
    }

    #[test]
    fn numbers_are_the_shortest_decimals() {
        for (value, shown) in [
            (Value::Number(0.05), "0.05"),
            (Value::Number(6e-4), "0.0006"),
            (Value::Number(-3.0), "-3"),
            (Value::Integer(100_000), "100000"),
        ] {
            assert_eq!(json(value).to_string(), shown);
        }
    }
}
