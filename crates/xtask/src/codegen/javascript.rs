//! `web/defaults.js`: the little of the table that the element needs.
//! `observedAttributes` is read before wasm is loaded, so the element cannot ask
//! the engine for it. `web/parameters.js`: all of the table, for the panel's
//! native mirror and any tool; `web/quantities.js`: a part of it.

use std::fmt::Write as _;

use hearth_core::params::{Choice, DisplayMode, Domain, Kind, Model, PARAMETERS, Param, Scale};

use super::json::Json;
use super::scene::Scene;
use super::{attribute, domains, json_string, json_value, property};

const HEADER: &str = "\
// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params.rs instead.
";

/// The module of ids and defaults.
pub(super) fn defaults() -> String {
    let mut text = format!(
        "{HEADER}\n\
         /** What a new fire burns with: every parameter, the model first. */\n\
         export const DEFAULTS = {{\n"
    );
    for param in PARAMETERS {
        let default = param.any_domain(Model::DEFAULT).default;
        let _ = writeln!(text, "  {}: {},", param.id, json_value(default));
    }
    text.push_str("};\n");
    text
}

/// The module of the whole table.
pub(super) fn module(scenes: &[Scene]) -> String {
    let mut text = format!(
        "{HEADER}\n\
         /** Every parameter, in the order in which a panel shows them. */\n\
         export const PARAMETERS = [\n",
    );
    for param in PARAMETERS {
        let _ = writeln!(text, "  {},", entry(param));
    }
    text.push_str(
        "];\n\n\
         /** Named sets of values: the defaults, with these changed. */\n\
         export const PRESETS = [\n",
    );
    for scene in scenes {
        let _ = writeln!(text, "  {},", preset_entry(scene));
    }
    text.push_str("];\n\nexport { QUANTITIES } from './quantities.js';\n");
    text
}

/// The module of what displays measure: apart, since the element's bar of colours
/// needs no more of the table.
pub(super) fn quantities() -> String {
    let mut text = format!(
        "{HEADER}\n\
         /** What the colours of a display mode measure; not there are those that show a fire. */\n\
         export const QUANTITIES = {{\n",
    );
    for name in DisplayMode::NAMES {
        let mode = DisplayMode::from_name(name);
        if let Some(quantity) = mode.and_then(DisplayMode::quantity) {
            let fields = object(&[
                ("unit", json_string(quantity.unit)),
                ("signed", quantity.signed.to_string()),
                ("whole", quantity.whole.to_string()),
            ]);
            let _ = writeln!(text, "  {name}: {fields},");
        }
    }
    text.push_str("};\n");
    text
}

fn entry(param: &Param) -> String {
    let description = param.description();
    let mut fields = vec![
        ("id", json_string(param.id)),
        ("attribute", json_string(&attribute(param.id))),
        ("property", json_string(&property(param.id))),
        ("label", json_string(description.label)),
        ("group", json_string(param.group)),
        ("unit", json_string(param.unit)),
        ("doc", json_string(description.doc)),
        ("kind", json_string(kind_name(param.kind))),
    ];
    match param.kind {
        Kind::Number(scale) | Kind::Integer(scale) => {
            fields.push(("scale", json_string(scale_name(scale))));
        }
        Kind::Choice(names) => fields.push(("choices", list(names))),
        Kind::Flag | Kind::Colour | Kind::Seed => {}
    }
    let mut models = Vec::new();
    let mut by_model = Vec::new();
    for (model, domain) in domains(param) {
        let domain = domain_fields(param, domain);
        if models.is_empty() {
            fields.extend(domain.clone());
        }
        models.push(json_string(model.name()));
        by_model.push((model.name(), object(&domain)));
    }
    fields.push(("models", format!("[{}]", models.join(", "))));
    fields.push(("domains", object(&by_model)));
    for (name, chosen) in [("when", description.when), ("unless", description.unless)] {
        if !chosen.is_empty() {
            let chosen = chosen.iter().map(|&(id, names)| (id, list(names)));
            fields.push((name, object(&chosen.collect::<Vec<_>>())));
        }
    }
    object(&fields)
}

fn domain_fields(param: &Param, domain: &Domain) -> Vec<(&'static str, String)> {
    let mut fields = vec![("default", json_value(domain.default))];
    if matches!(param.kind, Kind::Number(_) | Kind::Integer(_) | Kind::Seed) {
        let (min, max) = domain.range;
        fields.push(("min", min.to_string()));
        fields.push(("max", max.to_string()));
    }
    fields
}

fn preset_entry(scene: &Scene) -> String {
    let values: Vec<_> = scene
        .values
        .iter()
        .map(|(id, value)| (id.as_str(), json(value)))
        .collect();
    object(&[
        ("name", json_string(&scene.name)),
        ("label", json_string(&scene.label)),
        ("description", json_string(&scene.description)),
        ("values", object(&values)),
    ])
}

/// A value of a scene.
fn json(value: &Json) -> String {
    match value {
        Json::Number(x) => x.to_string(),
        Json::Flag(on) => on.to_string(),
        Json::Text(text) => json_string(text),
        // Which no parameter takes, so no scene has one.
        Json::Object(_) => "{}".to_owned(),
    }
}

/// A list of texts on one line.
fn list(texts: &[&str]) -> String {
    let texts: Vec<_> = texts.iter().map(|text| json_string(text)).collect();
    format!("[{}]", texts.join(", "))
}

/// An object on one line; ids and field names are identifiers, so they need no quotes.
fn object(fields: &[(&str, String)]) -> String {
    let fields: Vec<_> = fields
        .iter()
        .map(|(name, value)| format!("{name}: {value}"))
        .collect();
    if fields.is_empty() {
        "{}".to_owned()
    } else {
        format!("{{ {} }}", fields.join(", "))
    }
}

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Number(_) => "number",
        Kind::Integer(_) => "integer",
        Kind::Choice(_) => "choice",
        Kind::Flag => "flag",
        Kind::Colour => "colour",
        Kind::Seed => "seed",
    }
}

fn scale_name(scale: Scale) -> &'static str {
    match scale {
        Scale::Linear => "linear",
        Scale::Log => "log",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_fire_has_every_parameter_and_the_model_first() {
        let text = defaults();
        let lines: Vec<_> = text.lines().filter(|line| line.starts_with("  ")).collect();
        assert_eq!(lines.len(), PARAMETERS.len());
        assert_eq!(lines[0], format!("  model: \"{}\",", Model::DEFAULT.name()));
    }
}
