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
        name: "classic",
        label: "Classic",
        values: &[("model", Input::Text("classic"))],
    },
    Preset {
        name: "seed",
        label: "Seed",
        // The program that Hearth grew from: 600 pixels, here 1.5 m, other
        // kernels and no physical units. Lengths are converted; strengths are
        // chosen so that its picture, a narrow column of sparse dots, and the
        // effect of each of its sliders come out alike.
        values: &[
            ("model", Input::Text("classic")),
            ("domain_width", Input::Number(1.5)),
            ("domain_height", Input::Number(1.5)),
            ("walls", Input::Text("solid")),
            ("smoothing_radius", Input::Number(0.0075)),
            ("particle_mass", Input::Number(1e-4)),
            ("gas_constant", Input::Number(2.0)),
            ("viscosity", Input::Number(2e-4)),
            ("buoyancy", Input::Number(0.02)),
            ("thermal_buoyancy", Input::Number(0.01)),
            ("max_particles", Input::Number(800.0)),
            ("emission_rate", Input::Number(400.0)),
            ("lifetime_min", Input::Number(1.1)),
            ("lifetime_max", Input::Number(2.0)),
            ("taper", Input::Number(0.0)),
            ("emission_speed", Input::Number(0.75)),
            ("emission_spread", Input::Number(0.45)),
            ("emission_noise", Input::Number(0.0)),
            ("source_width", Input::Number(0.125)),
            ("maximum_temperature", Input::Number(1273.0)),
            ("cooling_rate", Input::Number(300.0)),
            ("display_mode", Input::Text("paper")),
            ("particle_size", Input::Number(0.015)),
        ],
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
        let set = parameters.set_all(self.values.iter().copied());
        debug_assert!(set.is_ok(), "preset {}: {set:?}", self.name);
        parameters
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_of_every_preset_is_accepted() {
        for preset in PRESETS {
            let set = Parameters::default().set_all(preset.values.iter().copied());
            assert_eq!(set, Ok(()), "preset {}", preset.name);
        }
    }
}
