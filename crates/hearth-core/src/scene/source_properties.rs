//! The properties of sources, which are parameters of the settings with a value for each source.

use crate::params::{Input, Parameters};

/// The properties that are parameters: the names of all, and the ids of their entries.
macro_rules! of_parameters {
    ($($name:literal = $id:literal),+) => {
        (&["name", $($name),+], &["name", $($id),+])
    };
}

/// The names of a source's properties, and the ids of their parameters.
pub(super) const OF_PARAMETERS: (&[&str], &[&str]) = of_parameters!(
    "enabled" = "source_enabled",
    "shape" = "source_shape",
    "solid" = "source_solid",
    "x" = "source_x",
    "y" = "source_height",
    "angle" = "source_angle",
    "width" = "source_width",
    "power" = "fuel_power",
    "rate" = "emission_rate",
    "speed" = "emission_speed",
    "spread" = "emission_spread",
    "noise" = "emission_noise",
    "temperature" = "source_temperature",
    "oxygen" = "source_oxygen",
    "birth_temperature" = "maximum_temperature",
    "life_min" = "lifetime_min",
    "life_max" = "lifetime_max",
    "taper" = "taper"
);

/// `settings` with the source properties of `source`, which is not the first, and a seed that
/// depends on its `index`, so that sources flicker independently.
pub(super) fn values_of_source(
    settings: &Parameters,
    source: &Parameters,
    index: usize,
) -> Parameters {
    let mut merged = with_properties_of(settings, source);
    let seed = settings.seed ^ (index as u32).wrapping_mul(0x9E37_79B9);
    let set = merged.set("seed", Input::Number(seed.into()));
    debug_assert_eq!(set, Ok(()));
    merged
}

/// `settings` with the source properties of `source`.
pub(super) fn with_properties_of(settings: &Parameters, source: &Parameters) -> Parameters {
    let mut merged = settings.clone();
    for id in OF_PARAMETERS.1 {
        merged.copy_both_models(id, source);
    }
    merged
}
