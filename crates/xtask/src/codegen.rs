//! Files generated from the table of parameters and from the scenes.
//!
//! A parameter is stated once, in `hearth-core`. What needs it before any wasm
//! is loaded (the element's attributes), what a compiler reads (types) and what
//! a person reads (the reference) is written from there and committed. A test
//! rewrites a file that is behind the table and fails, so a stale one cannot be
//! merged and needs no work to correct.
//!
//! A scene is a file of `scenes/`, and what comes from one is written from there,
//! not from the table in `hearth-core`, which this program was compiled with.

mod gallery;
mod javascript;
mod json;
mod markdown;
mod rust;
mod scene;
mod stats;
mod typescript;

use std::path::Path;
use std::{fs, io};

use anyhow::{Context, Result};
use hearth_core::Parameters;
use hearth_core::params::{Choice, Domain, Model, Param, Value};

/// A generated file: where it lies in the checkout, and what it must hold.
#[derive(Debug)]
pub struct Generated {
    /// Path relative to the checkout.
    pub path: &'static str,
    /// The text that the table gives.
    pub text: String,
}

/// Every generated file, fresh from the table and the scenes.
///
/// # Errors
/// A scene that is none, with what is wrong in its file.
pub fn generate() -> Result<Vec<Generated>> {
    let scenes = scene::read_all(&crate::paths::root().join("scenes"))?;
    let files = [
        (
            "crates/hearth-core/src/preset/scenes.rs",
            rust::table(&scenes),
        ),
        ("web/generated/defaults.js", javascript::defaults()),
        ("web/parameters.js", javascript::module(&scenes)),
        ("web/generated/quantities.js", javascript::quantities()),
        ("web/generated/burning.js", javascript::burning()),
        ("web/generated/between.js", javascript::between()),
        ("web/generated/objects.js", javascript::objects()),
        ("web/parameters.d.ts", typescript::declarations(&scenes)),
        ("docs/element.md", stats::page()?),
        ("docs/parameters.md", markdown::reference()),
        ("docs/scenes.md", gallery::page(&scenes)),
    ];
    let generated = |(path, text)| Generated { path, text };
    Ok(files.into_iter().map(generated).collect())
}

/// The values of the scene of that name, as its file has them.
///
/// # Errors
/// There is no such scene, or a file that is none.
pub(crate) fn values_of_scene(name: &str) -> Result<Parameters> {
    let scenes = scene::read_all(&crate::paths::root().join("scenes"))?;
    let scene = scenes.iter().find(|scene| scene.name == name);
    scene
        .with_context(|| format!("scenes/{name}.json is missing"))?
        .parameters()
}

/// Writes each generated file under `root` that is missing or differs, and
/// names those.
///
/// # Errors
/// A wrong scene, or a file that can be neither read nor written.
pub fn refresh(root: &Path) -> Result<Vec<&'static str>> {
    let mut written = Vec::new();
    for file in generate()? {
        let path = root.join(file.path);
        if ensure_contents(&path, &file.text).with_context(|| path.display().to_string())? {
            written.push(file.path);
        }
    }
    Ok(written)
}

/// Writes every generated file of the checkout that is missing or differs, and names those:
/// first the files of the table, then those of the element's class, which name parameters.
///
/// # Errors
/// As [`refresh`]; no Node; a class whose JSDoc lacks something.
pub fn refresh_checkout() -> Result<Vec<String>> {
    let mut written: Vec<_> = refresh(&crate::paths::root())?
        .into_iter()
        .map(str::to_owned)
        .collect();
    written.extend(crate::script::element_files()?.lines().map(str::to_owned));
    Ok(written)
}

/// Makes `path` hold `text`; whether it had to be written.
fn ensure_contents(path: &Path, text: &str) -> io::Result<bool> {
    match fs::read_to_string(path) {
        // A checkout on Windows may have turned line ends.
        Ok(present) if present.replace("\r\n", "\n") == text => return Ok(false),
        Ok(_) => {}
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        Err(error) if error.kind() == io::ErrorKind::InvalidData => {}
        Err(error) => return Err(error),
    }
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, text)?;
    Ok(true)
}

/// Every model, the default one first.
fn models() -> Vec<Model> {
    let mut models: Vec<_> = Model::NAMES
        .iter()
        .filter_map(|name| Model::from_name(name))
        .collect();
    models.sort_by_key(|&model| model != Model::DEFAULT);
    models
}

/// The models that use `param`, each with its default and range.
fn domains(param: &Param) -> impl Iterator<Item = (Model, &'static Domain)> {
    models()
        .into_iter()
        .filter_map(|model| Some((model, param.domain(model)?)))
}

/// `viscosity_limit` → `viscosity-limit`.
fn attribute(id: &str) -> String {
    id.replace('_', "-")
}

/// `viscosity_limit` → `viscosityLimit`.
fn property(id: &str) -> String {
    let mut words = id.split('_');
    let mut name = words.next().unwrap_or_default().to_owned();
    for word in words {
        let (first, rest) = word.split_at(word.len().min(1));
        name.push_str(&first.to_ascii_uppercase());
        name.push_str(rest);
    }
    name
}

/// `text` as a string of JSON, which is one of JavaScript as well.
fn json_string(text: &str) -> String {
    let mut json = String::with_capacity(text.len() + 2);
    json.push('"');
    for c in text.chars() {
        match c {
            '"' => json.push_str("\\\""),
            '\\' => json.push_str("\\\\"),
            '\n' => json.push_str("\\n"),
            '\r' => json.push_str("\\r"),
            '\t' => json.push_str("\\t"),
            // The two line separators end a line in older JavaScript.
            c if c.is_control() || matches!(c, '\u{2028}' | '\u{2029}') => {
                json.push_str(&format!("\\u{:04x}", u32::from(c)));
            }
            c => json.push(c),
        }
    }
    json.push('"');
    json
}

/// `value` as JSON.
fn json_value(value: Value) -> String {
    match value {
        Value::Flag(on) => on.to_string(),
        Value::Number(_) | Value::Integer(_) | Value::Seed(_) => value
            .as_number()
            .map_or_else(|| value.to_string(), |x| x.to_string()),
        Value::Choice(_) | Value::Colour(_) => json_string(&value.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generated_files_are_up_to_date() {
        let written = refresh(&crate::paths::root());
        assert!(
            written.as_ref().is_ok_and(Vec::is_empty),
            "files that are generated from the parameter table and the scenes were behind them and \
             have been written anew; commit them: {written:?}"
        );
    }

    #[test]
    fn a_stale_file_is_noticed_and_written_once() -> Result<()> {
        let root = std::env::temp_dir().join(format!("hearth-codegen-{}", std::process::id()));
        let all: Vec<_> = generate()?.iter().map(|file| file.path).collect();
        assert_eq!(refresh(&root)?, all);
        assert!(refresh(&root)?.is_empty());
        fs::write(root.join(all[0]), "stale")?;
        assert_eq!(refresh(&root)?, all[..1]);
        assert!(refresh(&root)?.is_empty());
        Ok(fs::remove_dir_all(root)?)
    }

    #[test]
    fn names_follow_the_platform() {
        assert_eq!(attribute("max_particles"), "max-particles");
        assert_eq!(property("max_particles"), "maxParticles");
        assert_eq!(property("seed"), "seed");
    }

    #[test]
    fn strings_survive_hostile_characters() {
        assert_eq!(
            json_string("a\"b\\c\nd\u{1}e\u{2028}f²"),
            r#""a\"b\\c\nd\u0001e\u2028f²""#
        );
    }

    #[test]
    fn numbers_are_the_shortest_decimals() {
        assert_eq!(json_value(Value::Number(0.05)), "0.05");
        assert_eq!(json_value(Value::Number(6e-4)), "0.0006");
        assert_eq!(json_value(Value::Integer(100_000)), "100000");
    }
}
