//! What a new fire's start and each command change.

use hearth_settings::untrusted::ValidationError;
use hearth_settings::{Change, Settings};

use crate::commands::{Command, Start};

/// The settings of a new fire, and the errors in its start. A new fire takes the valid
/// values beside an invalid one, because it has no earlier values to keep.
pub fn at_first(start: &Start<'_>) -> (Settings, Vec<ValidationError>) {
    let mut errors = Vec::new();
    let mut settings = Settings::default();
    let preset = start.preset.map(Change::Preset);
    let config = (!start.config.is_missing()).then_some(Change::Import(start.config));
    for change in [preset, config].into_iter().flatten() {
        match settings.after(&change) {
            Ok(after) => settings = after,
            Err(invalid) => errors.extend(invalid),
        }
    }
    let settings = settings.after_valid(start.values, &mut errors);
    (settings, errors)
}

/// The change of settings that a command makes, and its source; `None` if it makes none.
pub fn of_command<'a>(command: &Command<'a>) -> Option<(Change<'a>, &'a str)> {
    Some(match *command {
        Command::Set { values, source } => (Change::Set(values), source),
        Command::Restore { ids, source } => (Change::Restore(ids), source),
        Command::AddObject { object, source } => (Change::AddObject(object), source),
        Command::ChangeObject { id, values, source } => {
            (Change::ChangeObject(id.0, values), source)
        }
        Command::RemoveObject { id, source } => (Change::RemoveObject(id.0), source),
        Command::Preset { name, source } => (Change::Preset(name), source),
        Command::Import { config, source } => (Change::Import(config), source),
        _ => return None,
    })
}
