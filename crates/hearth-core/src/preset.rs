//! Named sets of values.

use crate::params::{Input, Parameters};

/// A named set of values: the defaults, with these changed.
#[derive(Debug)]
pub struct Preset {
    /// Its name in attributes and URLs.
    pub name: &'static str,
    /// What a person reads.
    pub label: &'static str,
    /// What differs from the defaults.
    pub values: &'static [(&'static str, Input<'static>)],
}

/// Every preset, the default one first.
pub static PRESETS: &[Preset] = &[
    Preset {
        name: "default",
        label: "Default",
        values: &[],
    },
    Preset {
        name: "seed",
        label: "Seed",
        values: &[],
    },
];

impl Preset {
    /// The preset of that name.
    pub fn find(name: &str) -> Option<&'static Preset> {
        PRESETS.iter().find(|preset| preset.name == name)
    }

    /// Its values.
    pub fn parameters(&self) -> Parameters {
        let mut parameters = Parameters::default();
        for &(id, input) in self.values {
            let set = parameters.set(id, input);
            debug_assert!(set.is_ok(), "preset {}: {set:?}", self.name);
        }
        parameters
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_of_every_preset_is_accepted() {
        for preset in PRESETS {
            let mut parameters = Parameters::default();
            for &(id, input) in preset.values {
                assert_eq!(parameters.set(id, input), Ok(()), "preset {}", preset.name);
            }
        }
    }
}
