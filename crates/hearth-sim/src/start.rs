//! The values that a simulation starts with.

use hearth_core::Parameters;
use hearth_core::params::Input;
use hearth_core::preset::{PRESETS, Preset};

/// The values of the preset of that name; without a name, the defaults.
///
/// # Errors
/// There is no preset of that name; in words that name those that there are.
pub fn of_preset(name: Option<&str>) -> Result<Parameters, String> {
    let Some(name) = name else {
        return Ok(Parameters::default());
    };
    Preset::find(name).map(Preset::parameters).ok_or_else(|| {
        let names: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
        format!(
            "preset = {} is refused: it must be one of {}",
            Input::Text(name),
            names.join(", ")
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_preset_gives_its_values_and_no_preset_the_defaults() {
        assert_eq!(of_preset(None), Ok(Parameters::default()));
        for preset in PRESETS {
            assert_eq!(of_preset(Some(preset.name)), Ok(preset.parameters()));
        }
    }

    #[test]
    fn an_unknown_preset_is_refused_with_every_known_one() {
        for name in ["Seed", "", "__proto__", &"x".repeat(1000)] {
            let said = of_preset(Some(name)).err();
            let said = said.as_deref().unwrap_or_default();
            assert!(PRESETS.iter().all(|preset| said.contains(preset.name)));
            assert!(said.len() < 600, "{said}");
        }
    }
}
