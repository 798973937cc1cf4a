//! The cards of the gallery: one for each scene, those of `scenes/community/` first, with the groups that its settings
//! put it into. A community's file is fetched when its card burns or is opened.

use std::path::Path;

use anyhow::Result;
use hearth_core::Scene;
use hearth_core::params::{AnyValue, Model};

use super::highlight::escaped;
use crate::shell::Shell;

/// Most height of the domain of a small fire \[m\].
const SMALL: f32 = 0.8;

/// The cards, whose files of the community are copied into the site.
pub(super) fn cards(root: &Path, site: &Path) -> Result<String> {
    let sh = Shell::new()?;
    let folder = sh.create_dir(site.join("community"))?;
    let mut html = String::new();
    for given in codegen::community(root)? {
        for end in ["json", "jpg"] {
            let file = format!("scenes/community/{}.{end}", given.name);
            sh.copy_file(root.join(file), &folder)?;
        }
        html.push_str(&card(&given, "community", "fit=contain&amp;")?);
    }
    for preset in codegen::scenes(root)? {
        let scene = format!("scene={}&amp;", preset.name);
        html.push_str(&card(&preset, "web/scenes", &scene)?);
    }
    Ok(html)
}

/// The groups of a scene, which are classes of its card.
fn groups(scene: &Scene) -> Vec<&'static str> {
    if scene.model() != Model::DEFAULT {
        return vec!["paper"];
    }
    let world = scene.world();
    let value = |id: &str| world.get(id).map(|value| value.to_string());
    let has = |id: &str, wanted: &str| {
        let mut values = scene.objects().flat_map(|object| object.properties());
        values.any(|(name, _, value)| {
            name == id && matches!(value, AnyValue::Choice(choice) if choice == wanted)
        })
    };
    let all = [
        ("small", world.domain_height <= SMALL),
        ("words", has("shape", "mask")),
        ("falling", has("motion", "free")),
        (
            "colours",
            value("palette").is_some_and(|name| name != "blackbody"),
        ),
    ];
    let mut found: Vec<_> = all
        .into_iter()
        .filter(|(_, is_in)| *is_in)
        .map(|(name, _)| name)
        .collect();
    if found.is_empty() {
        found.push("hearths");
    }
    found
}

/// A card. Its links lead to the landing page; those of a scene that is no preset get the fragment of its file by the
/// script.
fn card(scene: &codegen::Scene, folder: &str, query: &str) -> Result<String> {
    let name = &scene.name;
    let (label, about) = (escaped(&scene.label), escaped(&scene.description));
    let groups = groups(&scene.scene()?).join(" ");
    let credit = scene
        .credit
        .as_ref()
        .map_or_else(String::new, |[author, licence]| {
            format!(
                "<p class=\"credit\">By {}. Licence: {}</p>\n",
                escaped(author),
                escaped(licence)
            )
        });
    let kind = if scene.credit.is_some() {
        "community"
    } else {
        "scene"
    };
    let link = |query: &str, text: &str| {
        let query = query.trim_end_matches("&amp;");
        format!("<a href=\"./index.html?{query}\">{text}<span class=\"unseen\"> {label}</span></a>")
    };
    Ok(format!(
        "<li class=\"card {groups}\" data-{kind}=\"{name}\">\n\
         <button type=\"button\" class=\"still\" aria-pressed=\"false\" aria-label=\"Burn {label}\">\
         <img src=\"./{folder}/{name}.jpg\" alt=\"\" width=\"120\" height=\"160\" loading=\"lazy\" decoding=\"async\"></button>\n\
         <h2>{label}</h2>\n<p>{about}</p>\n{credit}\
         <p class=\"acts\">{} {} \
         <button type=\"button\" data-act=\"copy\">Copy<span class=\"unseen\"> the HTML of {label}</span></button> {}</p>\n</li>\n",
        link(query, "Open"),
        link(&format!("{query}open=panel"), "Fork"),
        link(&format!("{query}open=save"), "Film"),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paths;

    #[test]
    fn every_group_has_scenes_and_every_scene_a_group() -> Result<()> {
        let root = paths::root();
        let mut all = codegen::scenes(&root)?;
        all.extend(codegen::community(&root)?);
        let mut counts = std::collections::BTreeMap::new();
        for scene in &all {
            for group in groups(&scene.scene()?) {
                *counts.entry(group).or_insert(0) += 1;
            }
        }
        let page = std::fs::read_to_string(root.join("web/pages/gallery.html"))?;
        for (group, count) in &counts {
            assert!(*count >= 3, "{group} has {count}");
            assert!(
                page.contains(&format!("value=\"{group}\"")),
                "{group} has no filter"
            );
        }
        assert_eq!(page.matches("type=\"radio\"").count(), counts.len() + 1);
        Ok(())
    }
}
