//! `crates/hearth-core/src/preset/scenes.txt` and `texts.txt`: the scenes as a part of the physics, which is
//! published by itself and reads no JSON.

use std::fmt::Write as _;

use serde_json::Value;

use super::scene::Scene;

/// Values and objects of every scene. All but the first one are a part of the engine's wasm.
pub(super) fn table(scenes: &[Scene]) -> String {
    let mut text = String::new();
    for (at, scene) in scenes.iter().enumerate() {
        if at == 1 {
            text += "//part scenes\n";
        }
        let _ = writeln!(text, "preset {}", scene.name);
        write_fields(&mut text, &scene.values);
        for object in &scene.objects {
            write_fields(&mut text, object);
        }
    }
    text + "//end\n"
}

/// Name, label and description of every scene.
pub(super) fn texts(scenes: &[Scene]) -> String {
    let line = |scene: &Scene| format!("{}\t{}\t{}\n", scene.name, scene.label, scene.description);
    scenes.iter().map(line).collect()
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
