//! What a new fire's start and each command request.

use hearth_settings::file::Config;
use hearth_settings::untrusted::{Untrusted, ValidationError};
use hearth_settings::{COUNT, Requested, SPACING};

use crate::commands::{Command, Start};

/// The settings of a new fire, and the errors in its start. A new fire takes the valid
/// values beside an invalid one, because it has no earlier values to keep.
pub fn at_first(start: &Start<'_>) -> (Requested, Vec<ValidationError>) {
    let mut errors = Vec::new();
    let mut requested = Requested::default();
    let preset = start.preset.map(Requested::of_preset);
    let config = (!start.config.is_missing()).then(|| Config::requested_by(start.config));
    for base in [preset, config].into_iter().flatten() {
        match base {
            Ok(base) => requested = base,
            Err(invalid) => errors.extend(invalid),
        }
    }
    requested.count_overridden |= start.count_overridden;
    requested.spacing_overridden |= start.spacing_overridden;
    for values in [start.kept, start.values] {
        hearth_settings::set_valid(&mut requested.scene, values, &mut errors);
    }
    requested.follow_domain();
    (requested, errors)
}

/// The settings after a command; `None` if the command does not change settings.
///
/// # Errors
/// The validation errors of the command.
pub fn after(
    before: &Requested,
    command: &Command<'_>,
) -> Option<Result<Requested, Vec<ValidationError>>> {
    let object = match command {
        Command::AddObject { object, .. } => Some((None, Some(*object))),
        Command::ChangeObject { id, values, .. } => Some((Some(id.0), Some(*values))),
        Command::RemoveObject { id, .. } => Some((Some(id.0), None)),
        _ => None,
    };
    let (scene, overridden) = match command {
        _ if let Some((id, sent)) = object => (
            hearth_settings::with_object(&before.scene, id, sent),
            [None; 2],
        ),
        Command::Set { values, .. } => return Some(before.with_values(values)),
        Command::Restore { ids, .. } => {
            let names = |name: &str| ids.iter().any(|id| id.text() == name);
            let named = [COUNT, SPACING].map(|id| names(id).then_some(false));
            let ids: Vec<_> = ids
                .iter()
                .map(|id| (id.text().to_owned(), Untrusted::Missing))
                .collect();
            let restored = hearth_settings::with_defaults(&before.scene, &ids);
            (restored, named)
        }
        Command::Preset { name, .. } => return Some(Requested::of_preset(name)),
        Command::Import { config, .. } => return Some(Config::requested_by(config)),
        _ => return None,
    };
    Some(scene.map(|scene| before.with_scene(scene, overridden)))
}
