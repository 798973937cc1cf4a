//! Named sets of values: the scenes.
//!
//! Each is a file of `scenes/` in Hearth's repository. `cargo xtask codegen` generates the table
//! of all of them, so this crate reads no file.

mod definition;
mod resolution;
// Generated code.
#[rustfmt::skip]
mod scenes;

pub use definition::{Caption, Preset};
pub use scenes::{CAPTIONS, PRESETS};

impl Preset {
    /// The preset with this name.
    pub fn find(name: &str) -> Option<&'static Preset> {
        PRESETS.iter().find(|preset| preset.name == name)
    }

    /// Its label and description.
    pub fn caption(&self) -> &'static Caption {
        let at = PRESETS.iter().position(|preset| preset.name == self.name);
        at.and_then(|at| CAPTIONS.get(at)).unwrap_or(&Caption {
            label: "",
            description: "",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{Input, Parameters};

    #[test]
    fn every_value_of_every_preset_is_accepted_and_read_back() {
        for preset in PRESETS {
            let mut parameters = Parameters::default();
            let set = parameters.set_all(preset.values());
            assert_eq!(set, Ok(()), "preset {}", preset.name);
            let model = parameters.model();
            for (id, input) in preset.values() {
                let param = crate::params::PARAMETERS
                    .iter()
                    .find(|param| param.id == id);
                let value = param.map(|param| param.get(&parameters).to_string());
                let asked = match input {
                    Input::Text(text) => text.to_owned(),
                    input => input.to_string(),
                };
                assert_eq!(value, Some(asked), "{id} of {}", preset.name);
                let used = param.is_some_and(|param| param.domain(model).is_some());
                assert!(used, "{} has no use for {id}", preset.name);
            }
        }
    }

    #[test]
    fn names_labels_and_descriptions_are_unique_and_the_default_is_first() {
        assert_eq!(PRESETS[0].name, "default");
        assert_eq!(PRESETS[0].parameters(), Parameters::default());
        assert_eq!(PRESETS.len(), CAPTIONS.len());
        for (at, preset) in PRESETS.iter().enumerate() {
            let caption = preset.caption();
            assert!(!caption.label.is_empty() && caption.description.ends_with('.'));
            for other in &PRESETS[..at] {
                assert_ne!(other.name, preset.name);
                assert_ne!(other.caption().label, caption.label);
                assert_ne!(other.caption().description, caption.description);
                assert_ne!(other.parameters(), preset.parameters());
            }
        }
    }
}
