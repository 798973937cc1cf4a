//! Which fire a command draws: a preset, a settings file or a page's link, with values of the command line.

pub(crate) mod link;

use std::ffi::OsStr;
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

/// The settings of a scene: the name of a preset, a settings file, a page's link, or `-` for a file on standard input.
///
/// # Errors
/// There is no such scene, or a value is refused; all refusals, with the messages of the element.
pub fn settings(scene: &OsStr, values: &[Setting]) -> Result<Settings, Error> {
    let base = if scene == "-" {
        of_json(io::stdin().lock(), OsStr::new("standard input"))?
    } else if let Some(link) = link_of(scene) {
        let config = link::settings(link).map_err(|error| Error::at_use(scene, error))?;
        Settings::of_file(&config).map_err(|errors| Error::refused(scene, &errors))?
    } else if is_file(scene) {
        let file = File::open(scene).map_err(|error| Error::at(scene, error))?;
        if file.metadata().is_ok_and(|metadata| metadata.is_dir()) {
            return Err(Error::at(scene, "is a folder"));
        }
        of_json(file, scene)?
    } else {
        Settings::of_preset(&scene.to_string_lossy()).map_err(|errors| {
            let hint = "a scene is the name of a preset, a file whose name ends with .json, or a page's link";
            Error::refused(hint, &errors)
        })?
    };
    let values: Vec<_> = values
        .iter()
        .map(|(id, text)| (id.clone(), Untrusted::Text(text.clone())))
        .collect();
    let changed = base.after(&Change::Set(&values));
    changed.map_err(|errors| Error::refused("--set", &errors))
}

/// A name that a sheet shows for a scene.
pub fn label(scene: &OsStr) -> String {
    if link_of(scene).is_some() {
        return "link".to_owned();
    }
    let stem = Path::new(scene).file_stem().filter(|_| is_file(scene));
    stem.unwrap_or(scene).to_string_lossy().into_owned()
}

/// The link that a scene is.
fn link_of(scene: &OsStr) -> Option<&str> {
    scene.to_str().filter(|text| link::is_link(text))
}

/// Whether a scene is a file: its name ends so, or it has a folder.
fn is_file(scene: &OsStr) -> bool {
    let text = scene.to_string_lossy();
    let known = Preset::find(&text).is_ok();
    !known && (text.ends_with(".json") || text.contains('/') || Path::new(scene).is_file())
}

fn of_json(source: impl io::Read, place: &OsStr) -> Result<Settings, Error> {
    let config = json::read(source).map_err(|error| Error::at_use(place, error))?;
    Settings::of_file(&config).map_err(|errors| Error::refused(place, &errors))
}
