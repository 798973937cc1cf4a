//! Which fire a command draws: a preset or a settings file, with values of the command line.

use std::fs::File;
use std::io;
use std::path::Path;

use hearth_core::preset::Preset;
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings};

use crate::error::Error;
use crate::json;

/// A value of the command line: the id of a parameter, and its text.
pub type Setting = (String, String);

/// The settings of a scene: the name of a preset, a settings file, or `-` for one on standard input.
///
/// # Errors
/// There is no such scene, or a value is refused; all refusals, with the messages of the element.
pub fn settings(scene: &str, values: &[Setting]) -> Result<Settings, Error> {
    let base = match scene {
        "-" => of_json(io::stdin().lock(), "standard input")?,
        name if is_file(name) => {
            let file = File::open(name).map_err(|error| Error::at(name, error))?;
            if file.metadata().is_ok_and(|metadata| metadata.is_dir()) {
                return Err(Error::at(name, "is a folder"));
            }
            of_json(file, name)?
        }
        name => Settings::of_preset(name).map_err(|errors| {
            let hint = "a scene is the name of a preset, or a file whose name ends with .json";
            let refused = Error::refused(hint, &errors);
            Error::Use(refused.to_string())
        })?,
    };
    let values: Vec<_> = values
        .iter()
        .map(|(id, text)| (id.clone(), Untrusted::Text(text.clone())))
        .collect();
    let changed = base.after(&Change::Set(&values));
    changed.map_err(|errors| Error::refused("--set", &errors))
}

/// A name that a sheet shows for a scene.
pub fn label(scene: &str) -> String {
    let stem = Path::new(scene).file_stem();
    let stem = stem
        .filter(|_| is_file(scene))
        .and_then(|stem| stem.to_str());
    stem.unwrap_or(scene).to_owned()
}

/// Whether a scene is a file: its name ends so, or it has a folder.
fn is_file(scene: &str) -> bool {
    let known = Preset::find(scene).is_ok();
    !known && (scene.ends_with(".json") || scene.contains('/') || Path::new(scene).is_file())
}

fn of_json(source: impl io::Read, place: &str) -> Result<Settings, Error> {
    let config = json::read(source).map_err(|error| Error::Use(format!("{place}: {error}")))?;
    Settings::of_file(&config).map_err(|errors| Error::refused(place, &errors))
}
