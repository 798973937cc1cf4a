//! Untrusted values and scenes for tests.

use hearth_core::Scene;
use hearth_core::resolution::{CountInputs, Level, ParticleCount, SizeLimit};
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings};

/// Named values, as a script sends them.
pub type Sent = Vec<(String, Untrusted)>;

/// A number.
pub fn number(number: f64) -> Untrusted {
    Untrusted::Number(number)
}

/// A text.
pub fn text(text: &str) -> Untrusted {
    Untrusted::Text(text.to_owned())
}

/// An object.
pub fn object<const N: usize>(fields: [(&str, Untrusted); N]) -> Untrusted {
    Untrusted::Object(sent(fields))
}

/// Named values.
pub fn sent<const N: usize>(values: [(&str, Untrusted); N]) -> Sent {
    values.map(|(id, value)| (id.to_owned(), value)).into()
}

/// The scene of a large element on a fast machine at a level.
pub fn at_level(settings: &Settings, level: Level) -> Scene {
    let count = ParticleCount::of(&CountInputs {
        settings: settings.resolution(),
        level,
        is_level_requested: false,
        size: SizeLimit::default(),
        machine: u32::MAX,
        is_coarse: false,
    });
    settings.at(count.number)
}

/// The settings of a valid file.
pub fn imported(config: &Untrusted) -> Settings {
    match Settings::of_file(config) {
        Ok(settings) => settings,
        other => panic!("{config:?} gives {other:?}"),
    }
}

/// A scene whose objects have ids in their order, as files number those of a scene.
pub fn in_order(scene: &Scene) -> Scene {
    let ids: Vec<u32> = scene.objects().map(|object| object.id).collect();
    let mut scene = scene.clone();
    scene.renumber(&|id| ids.iter().take_while(|known| **known != id).count() as u32 + 1);
    scene
}

/// The settings after a valid change.
pub fn after(settings: &Settings, change: Change<'_>) -> Settings {
    match settings.after(&change) {
        Ok(after) => after,
        Err(errors) => panic!("{change:?} is refused: {errors:?}"),
    }
}

/// The settings with this value.
pub fn set(settings: &Settings, id: &str, value: Untrusted) -> Settings {
    after(settings, Change::Set(&[(id.to_owned(), value)]))
}
