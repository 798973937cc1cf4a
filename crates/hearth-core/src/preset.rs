//! Named sets of values: the scenes.
//!
//! Each is a file of `scenes/` in Hearth's repository. `cargo xtask codegen` writes a table of all
//! of them, `preset/scenes.txt` and `preset/texts.txt`, which this crate contains.

mod definition;
mod resolution;

pub use definition::{Preset, UnknownPreset};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{Input, Parameters};
    use crate::scene::Scene;

    #[test]
    fn every_value_of_every_preset_is_accepted_and_read_back() {
        for preset in Preset::all() {
            let mut world = Parameters::default();
            let set = world.set_all(preset.values());
            assert_eq!(set, Ok(()), "preset {}", preset.name);
            let model = world.model();
            for (id, input) in preset.values() {
                let param = crate::params::Param::find(id);
                let value = world.get(id).map(|value| value.to_string());
                let expected = match input {
                    Input::Text(text) => text.to_owned(),
                    input => input.to_string(),
                };
                assert_eq!(value, Some(expected), "{id} of {}", preset.name);
                let used = param.is_some_and(|param| param.domain(model).is_some());
                assert!(used, "{} has no use for {id}", preset.name);
            }
        }
    }

    #[test]
    fn names_labels_and_descriptions_are_unique_and_the_default_is_first() {
        assert_eq!(Preset::all()[0].name, "default");
        assert_eq!(Preset::all()[0].scene(), Scene::default());
        for (at, preset) in Preset::all().iter().enumerate() {
            assert!(!preset.label().is_empty() && preset.description().ends_with('.'));
            for other in &Preset::all()[..at] {
                assert_ne!(other.name, preset.name);
                assert_ne!(other.label(), preset.label());
                assert_ne!(other.description(), preset.description());
                assert_ne!(other.scene(), preset.scene());
            }
        }
    }
}
