//! Untrusted values and scenes for tests.

use hearth_core::Scene;
use hearth_core::resolution::Level;
use hearth_core::resolution::SizeLimit;
use hearth_core::resolution::{CountInputs, ParticleCount};
use hearth_settings::Requested;
use hearth_settings::file::Config;
use hearth_settings::untrusted::Untrusted;

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
pub fn at_level(requested: &Requested, level: Level) -> Scene {
    let count = ParticleCount::of(&CountInputs {
        settings: requested.resolution(),
        level,
        is_level_requested: false,
        size: SizeLimit::default(),
        machine: u32::MAX,
        is_coarse: false,
    });
    requested.at(count.number)
}

/// The settings of a valid file.
pub fn imported(config: &Untrusted) -> Requested {
    match Config::requested_by(config) {
        Ok(requested) => requested,
        other => panic!("{config:?} gives {other:?}"),
    }
}
