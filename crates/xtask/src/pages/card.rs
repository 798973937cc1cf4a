//! A card of a lesson: the JSON of a fence `json card` becomes a place with a still picture of the scene,
//! which a page without scripts and a printed one show. `web/docs/cards.js` burns the fires there.

use std::path::Path;

use anyhow::{Context, Result};
use serde_json::Value;

use super::highlight::escaped;

/// The lines that pupils fill in, below the question of a printed card.
const LINES: [&str; 4] = [
    "I expect, because",
    "Fire A",
    "Fire B",
    "What differs from what I expected",
];

/// The HTML of a card.
pub(super) fn card(root: &Path, json: &str) -> Result<String> {
    let card: Value = serde_json::from_str(json)?;
    let scene = card["scene"]
        .as_str()
        .context("the card has no \"scene\"")?;
    let (width, height) = super::markdown::size(&root.join(format!("web/scenes/{scene}.jpg")))?;
    Ok(format!(
        "<div class=\"card\" data-card=\"{}\"><img src=\"../web/scenes/{scene}.jpg\" \
         alt=\"A fire of this card\" width=\"{width}\" height=\"{height}\">\
         <p><button type=\"button\" hidden>Light both fires</button></p></div>\n",
        escaped(&card.to_string())
    ))
}

/// The HTML of the lines.
pub(super) fn lines() -> String {
    let lines = LINES.map(|line| format!("<p class=\"line\">{line}</p>"));
    format!("<div class=\"lines\">{}</div>\n", lines.concat())
}
