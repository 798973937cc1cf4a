// Generated from the files of scenes/ by `cargo xtask codegen`; edit those instead.

use super::{Caption, Preset};
use crate::params::Input;

/// Every preset: the default one, then those of each model by their names.
pub static PRESETS: &[Preset] = &[
    Preset {
        name: "default",
        values: &[
        ],
    },
    Preset {
        name: "classic",
        values: &[
            ("model", Input::Text("classic")),
        ],
    },
    Preset {
        name: "seed",
        values: &[
            ("model", Input::Text("classic")),
            ("domain_width", Input::Number(1.5)),
            ("domain_height", Input::Number(1.5)),
            ("walls", Input::Text("solid")),
            ("smoothing_radius", Input::Number(0.0075)),
            ("particle_mass", Input::Number(0.0001)),
            ("gas_constant", Input::Number(2.0)),
            ("viscosity", Input::Number(0.0002)),
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

/// What a person reads about each preset, in the order of [`PRESETS`].
pub static CAPTIONS: &[Caption] = &[
    Caption {
        label: "Default",
        description: "A broad fire in still air, at every parameter's default.",
    },
    Caption {
        label: "Classic",
        description: "The student paper's model, with its mistakes put right.",
    },
    Caption {
        label: "Seed",
        description: "The program that Hearth grew from: a narrow column of sparse dots.",
    },
];
