//! What a new fire's start and each command change.

use hearth_settings::untrusted::ValidationError;
use hearth_settings::{Change, OBJECTS, Settings};

use crate::commands::{Command, Start};

/// The settings of a new fire, and the errors in its start. A new fire takes the valid
/// values beside an invalid one, because it has no earlier values to keep.
pub fn at_first(start: &Start<'_>) -> (Settings, Vec<ValidationError>) {
    let mut errors = Vec::new();
    let mut settings = Settings::default();
    let preset = start.preset.map(Settings::of_preset);
    let config = (!start.config.is_missing()).then(|| Settings::of_file(start.config));
    for replaced in [preset, config].into_iter().flatten() {
        match replaced {
            Ok(replaced) => settings = replaced,
            Err(invalid) => errors.extend(invalid),
        }
    }
    let settings = settings.after_valid(start.values, &mut errors);
    (settings, errors)
}

/// The source of the changes of children in events.
const CHILD: &str = "child";

/// Whether a command lays children over objects.
pub fn lays_children(settings: &Settings, command: &Command<'_>) -> bool {
    let replaces = match *command {
        Command::Children { .. } => return true,
        Command::Preset { .. } | Command::Import { .. } => true,
        Command::Set { values, source } => {
            source == "attribute" && values.iter().any(|(id, _)| id == OBJECTS)
        }
        _ => false,
    };
    replaces && settings.has_children()
}

/// The settings after a command and the source of their change; `None` if it changes none. Appends the errors of the
/// children. Other settings keep the objects of the children, unless a call replaces objects.
pub fn by_command<'a>(
    settings: &Settings,
    command: &Command<'a>,
    errors: &mut Vec<ValidationError>,
) -> Option<(Result<Settings, Vec<ValidationError>>, &'a str)> {
    let keeps = lays_children(settings, command);
    let keep = |after: Result<Settings, _>| {
        after.map(|after| match keeps {
            true => after.keeping_children(settings),
            false => after,
        })
    };
    let (change, source) = match *command {
        Command::Import { config, source } => {
            return Some((keep(Settings::of_file(config)), source));
        }
        Command::Restore {
            settings: whole,
            source,
        } => return Some((Settings::of_file(whole), source)),
        Command::Children { children } => {
            return Some((Ok(settings.with_children(children.list(), errors)), CHILD));
        }
        Command::Set { values, source } => (Change::Set(values), source),
        Command::AddObject { object, source } => (Change::AddObject(object), source),
        Command::ChangeObject { id, values, source } => {
            (Change::ChangeObject(id.0, values), source)
        }
        Command::RemoveObject { id, source } => (Change::RemoveObject(id.0), source),
        Command::Preset { name, source } => (Change::Preset(name), source),
        _ => return None,
    };
    Some((keep(settings.after(&change)), source))
}
