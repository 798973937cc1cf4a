//! `docs/scenes.md`: every scene with its picture, and how to make one.

use std::fmt::Write as _;

use super::json::Json;
use super::markdown::cell;
use super::models;
use super::scene::Scene;

const INTRODUCTION: &str = "\
<!-- Generated from the files of scenes/ by `cargo xtask codegen`; edit those, or
     crates/xtask/src/codegen/gallery.rs, instead. -->

# Scenes

A scene is a named fire: a set of values, and all else as the defaults have it. It is
chosen by its name: `preset=\"candle\"` in HTML, `fire.preset = 'candle'` in JavaScript,
`?scene=candle` in an address, `Preset::find(\"candle\")` in Rust. What each value
means stands in [parameters.md](parameters.md).

Sizes are chosen for the eye and not with a ruler. In a domain of 12 cm a step is so short
that a candle would be some ten times the work of a campfire; so small fires burn in a
larger domain, and in slower time. No scene is more than twice the work of the default one.
";

const PAPER: &str = "
## The paper's figures

The paper shows its fire in figures 3 to 6 and says of it, in §4.1.1, what three of its
parameters do. The scenes `paper-…` stand for those figures: in the paper's model, drawn as the
paper draws, `paper-fire` plainly and each of the others with one of the three changed
(`paper-buoyancy` also lives shorter, to stay in the picture). They are no copies: the values
of the figures are not known here.

| | changed | what the paper says |
|---|---|---|
| `paper-buoyancy` | buoyancy β | more of it narrows the fire |
| `paper-stiffness` | gas constant k | more of it widens the fire |
| `paper-smoothing` | smoothing radius h | more of it clusters the particles |

A test holds each against `paper-fire`. What §4.1.2 says of flames that are not premixed, that
they are hottest at their outer sheet, is a law of the combustion model with `source_oxygen` 0.
";

const ANOTHER: &str = "
## Another scene

A scene is one file. Set a fire up from the default one, in the panel or in a page, export its
settings, and save them as `scenes/NAME.json` with two fields more:

```json
{
  \"hearth\": 1,
  \"label\": \"Lantern\",
  \"description\": \"A small flame behind glass.\",
  \"values\": { \"fuel_power\": 60, \"source_width\": 0.15 }
}
```

The name is made of small letters, digits and hyphens. Then

    cargo xtask codegen       # checks it; writes the table, the types and this page
    cargo xtask thumbnails    # draws its small picture, web/scenes/NAME.jpg
    cargo xtask look NAME     # watches it for flashes and more, a minute long

and `cargo xtask test native` burns it for a while. A scene that flashes is made slower, dimmer
or smaller until it does not: flashes can bring on seizures. A value out of its range, an unknown
id, or one that the scene's model has no use for is refused with the file's name. The file
is also one of settings as it stands: `<hearth-fire src=\"lantern.json\">` burns it anywhere,
without its being one of these.
";

/// The whole page.
pub(super) fn page(scenes: &[Scene]) -> String {
    let mut text = String::from(INTRODUCTION);
    for model in models() {
        let _ = write!(
            text,
            "\n## In the {} model\n\n| | | differs in |\n|---|---|---|\n",
            model.name()
        );
        for scene in scenes.iter().filter(|scene| scene.model == model) {
            let _ = writeln!(text, "{}", row(scene));
        }
    }
    text + PAPER + ANOTHER
}

fn row(scene: &Scene) -> String {
    let name = &scene.name;
    let values: Vec<_> = scene
        .values
        .iter()
        .filter(|(id, _)| id != "model")
        .map(|(id, value)| format!("`{id}` {}", shown(value)))
        .collect();
    let differs = match values.is_empty() {
        true => "nothing".to_owned(),
        false => values.join(", "),
    };
    format!(
        "| ![{label}](../web/scenes/{name}.jpg) | **{label}** `{name}`<br>{} | {} |",
        cell(&scene.description),
        cell(&differs),
        label = cell(&scene.label),
    )
}

fn shown(value: &Json) -> String {
    match value {
        Json::Number(x) => x.to_string(),
        Json::Flag(on) => if *on { "on" } else { "off" }.to_owned(),
        Json::Text(text) => text.clone(),
        // Which no parameter takes, so no scene has one.
        Json::Object(_) => String::new(),
    }
}
