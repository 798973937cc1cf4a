//! `crates/hearth-core/src/preset/scenes.rs`: the scenes as a part of the physics, which is
//! published by itself and reads no file.

use std::fmt::Write as _;

use serde_json::Value;

use super::scene::Scene;

const HEADER: &str = "\
// Generated from the files of scenes/ by `cargo xtask codegen`; edit those instead.

use super::definition::{Caption, Preset};
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
        fields(&mut text, &scene.values);
        text.push_str("        ],\n        objects: &[");
        for object in &scene.objects {
            text.push_str("&[\n");
            fields(&mut text, object);
            text.push_str("        ], ");
        }
        text.push_str("],\n    },\n");
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

/// The fields of an object, a line each.
fn fields(text: &mut String, fields: &[(String, Value)]) {
    for (id, value) in fields {
        let input = match value {
            Value::String(text) => format!("Text({text:?})"),
            Value::Bool(on) => format!("Flag({on})"),
            number => format!("Number({:?})", number.as_f64().unwrap_or_default()),
        };
        let _ = writeln!(text, "            ({id:?}, Input::{input}),");
    }
}
