//! `crates/hearth-core/src/preset/scenes.rs`: the scenes as the physics carries them,
//! which is published by itself and reads no file.

use std::fmt::Write as _;

use super::json::Json;
use super::scene::Scene;

const HEADER: &str = "\
// Generated from the files of scenes/ by `cargo xtask codegen`; edit those instead.

use super::{Caption, Preset};
use crate::params::Input;

";

/// The whole file.
pub(super) fn table(scenes: &[Scene]) -> String {
    let mut text = format!(
        "{HEADER}\
         /// Every preset: the default one, then those of each model by their names.\n\
         pub static PRESETS: &[Preset] = &[\n"
    );
    for scene in scenes {
        let _ = writeln!(text, "    Preset {{\n        name: {:?},", scene.name);
        text.push_str("        values: &[\n");
        for (id, value) in &scene.values {
            let input = match value {
                Json::Number(x) => format!("Number({x:?})"),
                Json::Text(text) => format!("Text({text:?})"),
                Json::Flag(on) => format!("Flag({on})"),
                // Which no parameter takes, so no scene has one.
                Json::Object(_) => continue,
            };
            let _ = writeln!(text, "            ({id:?}, Input::{input}),");
        }
        text.push_str("        ],\n    },\n");
    }
    text.push_str(
        "];\n\n\
         /// What a person reads about each preset, in the order of [`PRESETS`].\n\
         pub static CAPTIONS: &[Caption] = &[\n",
    );
    for scene in scenes {
        let _ = writeln!(
            text,
            "    Caption {{\n        label: {:?},\n        description: {:?},\n    }},",
            scene.label, scene.description
        );
    }
    text.push_str("];\n");
    text
}
