//! What a new fire's start and each command change.

use hearth_settings::untrusted::{Untrusted, ValidationError};
use hearth_settings::{Change, Settings};

use crate::commands::{Command, Start};

/// The settings of a new fire, and the errors in its start. A new fire takes the valid
/// values beside an invalid one, because it has no earlier values to keep.
pub fn at_first(start: &Start<'_>) -> (Settings, Vec<ValidationError>) {
    let mut errors = Vec::new();
    let mut settings = Settings::default();
    let preset = start.preset.map(Settings::of_preset);
    let config = (!start.config.is_missing()).then(|| match start.children {
        true => Settings::of_whole(start.config),
        false => Settings::of_file(start.config),
    });
    for replaced in [preset, config].into_iter().flatten() {
        match replaced {
            Ok(replaced) => settings = replaced,
            Err(invalid) => errors.extend(invalid),
        }
    }
    let settings = settings.after_valid(start.values, &mut errors);
    (settings, errors)
}

/// The source of the changes of an attribute.
const ATTRIBUTE: &str = "attribute";
/// The source of the changes of children in events.
const CHILD: &str = "child";

/// The settings after a command and the source of their change; `None` if it changes none. Appends the errors of the
/// children.
pub fn by_command<'a>(
    settings: &Settings,
    command: &Command<'a>,
    errors: &mut Vec<ValidationError>,
) -> Option<(Result<Settings, Vec<ValidationError>>, &'a str)> {
    let (change, source) = match *command {
        Command::Children { children } => {
            return Some((Ok(settings.with_children(children.list(), errors)), CHILD));
        }
        Command::Import {
            config,
            source,
            keeps_seed,
        } => {
            let kept = Untrusted::Number(settings.parameters().seed.into());
            let kept = [Untrusted::field_of("seed", kept)];
            let keeps =
                keeps_seed == Some(true) && config.field("values").field("seed").is_missing();
            let imported = settings.after_file(config);
            let imported = imported.and_then(|imported| match keeps {
                true => imported.after(&Change::Set(&kept)),
                false => Ok(imported),
            });
            return Some((imported, source));
        }
        Command::Restore { deltas, source } => {
            return Some((settings.after_deltas(deltas.list()), source));
        }
        Command::Set {
            values,
            source: ATTRIBUTE,
            attributes,
        } => {
            let stated = settings.after(&Change::State(values)).map(|after| {
                match after.scene().model() == settings.scene().model() {
                    true => after,
                    // An attribute that is refused has been reported.
                    false => after.after_valid(attributes.fields(), &mut Vec::new()),
                }
            });
            return Some((stated, ATTRIBUTE));
        }
        Command::Set {
            values,
            source,
            attributes,
        } => (Change::SetModel(values, attributes.fields()), source),
        Command::AddObject { object, source } => (Change::AddObject(object), source),
        Command::ChangeObject { id, values, source } => {
            (Change::ChangeObject(id.0, values), source)
        }
        Command::RemoveObject { id, source } => (Change::RemoveObject(id.0), source),
        Command::Preset { name, source } => (Change::Preset(name), source),
        _ => return None,
    };
    Some((settings.after(&change), source))
}
