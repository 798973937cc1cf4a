//! What a new fire's start and each command request.

use hearth_bindings::{Untrusted, ValidationError, settings};
use hearth_core::params::Model;

use super::{COUNT, Requested};
use crate::commands::{Command, Start};
use crate::config::Config;

impl Requested {
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
        for values in [start.kept, start.values] {
            settings::set_valid(&mut requested.scene, values, &mut errors);
        }
        (requested, errors)
    }

    /// The settings after a command; `None` if the command does not change settings.
    ///
    /// # Errors
    /// The validation errors of the command.
    pub fn after(&self, command: &Command<'_>) -> Option<Result<Requested, Vec<ValidationError>>> {
        let object = match command {
            Command::AddObject { object, .. } => Some((None, Some(*object))),
            Command::ChangeObject { id, values, .. } => Some((Some(id.0), Some(*values))),
            Command::RemoveObject { id, .. } => Some((Some(id.0), None)),
            _ => None,
        };
        let (scene, overridden) = match command {
            _ if let Some((id, sent)) = object => {
                (settings::with_object(&self.scene, id, sent), None)
            }
            Command::Set { values, .. } => {
                let named = values.iter().any(|(id, _)| id == COUNT);
                let set = settings::with_values(&self.scene, values);
                (set, named.then_some(true))
            }
            Command::Restore { ids, .. } => {
                let named = ids.iter().any(|id| id.text() == COUNT);
                let ids: Vec<_> = ids
                    .iter()
                    .map(|id| (id.text().to_owned(), Untrusted::Missing))
                    .collect();
                let restored = settings::with_defaults(&self.scene, &ids);
                (restored, named.then_some(false))
            }
            Command::Preset { name, .. } => return Some(Requested::of_preset(name)),
            Command::Import { config, .. } => return Some(Config::requested_by(config)),
            _ => return None,
        };
        Some(scene.map(|scene| {
            // The classic model's number never follows the quality.
            let combustion = scene.settings().model() == Model::Combustion;
            let overridden = overridden.filter(|_| combustion);
            Requested {
                scene,
                count_overridden: overridden.unwrap_or(self.count_overridden),
                preset: self.preset,
            }
        }))
    }
}
