//! `crates/hearth-core/src/preset/scenes.rs`: the scenes as a part of the physics, which is
//! published by itself and reads no file.

use std::fmt::Write as _;
use std::iter;

use serde_json::Value;

use super::scene::Scene;

const HEADER: &str = "\
// Generated from the files of scenes/ by `cargo xtask codegen`; edit those instead.

use super::definition::{Caption, Preset};

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
        let mut lines = vec![fields(scene.values.iter())];
        lines.extend(own_fields(&scene.objects).map(|own| fields(own.into_iter())));
        // Long literals stay legible: a line of text is a line of the file.
        let lines = lines.join("\n\n").escape_debug().to_string();
        let lines = lines.replace("\\n", "\\n\\\n            ");
        let _ = writeln!(text, "        text: \"{lines}\",\n    }},");
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

/// The fields of each object. One that has every property of the one before it has only its own.
pub(super) fn own_fields(
    objects: &[Vec<(String, Value)>],
) -> impl Iterator<Item = Vec<&(String, Value)>> {
    let before = iter::once(&[][..]).chain(objects.iter().map(Vec::as_slice));
    before.zip(objects).map(|(before, object)| {
        let named = |id: &str| object.iter().any(|(known, _)| known == id);
        let continues = before.iter().all(|(id, _)| named(id)) && before != object;
        let all = object.iter();
        all.filter(|field| !continues || !before.contains(field))
            .collect()
    })
}

/// A line for each field: its id and its value.
fn fields<'a>(fields: impl Iterator<Item = &'a (String, Value)>) -> String {
    let lines = fields.map(|(id, value)| match value {
        Value::String(text) => format!("{id} {text}"),
        Value::Bool(on) => format!("{id} {on}"),
        number => format!("{id} {}", number.as_f64().unwrap_or_default()),
    });
    lines.collect::<Vec<_>>().join("\n")
}
