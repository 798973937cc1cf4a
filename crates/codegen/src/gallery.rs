//! `docs/scenes.md`: every scene with its picture, and how to make one; and the picture in
//! the documentation of the crate `hearth-fire`.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::Result;
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde_json::Value;

use super::markdown::cell;
use super::models;
use super::scene::Scene;

/// The whole page.
pub(super) fn page(scenes: &[Scene]) -> String {
    let mut tables = String::new();
    for model in models() {
        let _ = write!(
            tables,
            "\n## In the {} model\n\n| | | over a page | differs in |\n|---|---|---|---|\n",
            model.name()
        );
        for scene in scenes.iter().filter(|scene| scene.model == model) {
            let _ = writeln!(tables, "{}", row(scene));
        }
    }
    include_str!("templates/scenes.md").replace("{{scenes}}", &tables)
}

/// The picture as a part of the text: documentation on the web has no file beside it.
pub(super) fn picture(checkout: &Path) -> Result<String> {
    let picture = fs::read(checkout.join("crates/hearth-fire/fire.jpg"))?;
    let picture = BASE64_STANDARD.encode(picture);
    Ok(format!("\n![A fire](data:image/jpeg;base64,{picture})\n\n"))
}

fn row(scene: &Scene) -> String {
    let name = &scene.name;
    let values = scene
        .all_values()
        .into_iter()
        .filter(|(id, _)| *id != "model");
    let values: Vec<_> = values
        .map(|(id, value)| match value {
            Value::Bool(on) => format!("`{id}` {}", if on { "on" } else { "off" }),
            Value::String(text) => format!("`{id}` {text}"),
            number => format!("`{id}` {number}"),
        })
        .collect();
    let differs = match values.is_empty() {
        true => "nothing".to_owned(),
        false => values.join(", "),
    };
    let has_wall = scene
        .all_values()
        .into_iter()
        .any(|(id, value)| id == "backdrop" && value != "none");
    let over = if has_wall { "its wall" } else { "transparent" };
    format!(
        "| ![{label}](../web/scenes/{name}.jpg) | **{label}** `{name}`<br>{} | {over} | {} |",
        cell(&scene.description),
        cell(&differs),
        label = cell(&scene.label),
    )
}
