//! `crates/hearth-core/src/preset/scenes.txt`: the scenes as a part of the physics, which is
//! published by itself and reads no JSON.

use std::fmt::Write as _;

use serde_json::Value;

use super::scene::Scene;

const HEADER: &str = "\
# Every preset: the default one, then those of each model by their names. `cargo xtask codegen`
# writes this file from the files of scenes/; edit those instead.
#
# A line is a name, a blank and a value, which extends to the end of the line. `preset` begins a
# preset; its label, its description and the values that differ from the defaults follow. `kind`
# begins an object besides the first source; the fields that differ from the defaults follow.
";

/// The whole file.
pub(super) fn table(scenes: &[Scene]) -> String {
    let mut text = HEADER.to_owned();
    for scene in scenes {
        let Scene {
            name,
            label,
            description,
            ..
        } = scene;
        let _ = write!(
            text,
            "\npreset {name}\nlabel {label}\ndescription {description}\n"
        );
        write_fields(&mut text, &scene.values);
        for object in &scene.objects {
            text.push('\n');
            write_fields(&mut text, object);
        }
    }
    text
}

/// A line for each field: its name and its value.
fn write_fields(text: &mut String, fields: &[(String, Value)]) {
    for (name, value) in fields {
        let _ = match value {
            Value::String(word) => writeln!(text, "{name} {word}"),
            Value::Bool(on) => writeln!(text, "{name} {on}"),
            number => writeln!(text, "{name} {}", number.as_f64().unwrap_or_default()),
        };
    }
}
