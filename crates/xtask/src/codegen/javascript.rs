//! `web/parameters.js`: the table as data for the element, the panel's native
//! mirror and any tool. `observedAttributes` is read before wasm is loaded, so
//! the element cannot ask the engine for it.

use std::fmt::Write as _;

use hearth_core::params::{Input, Kind, PARAMETERS, Param, Scale};
use hearth_core::preset::{PRESETS, Preset};

use super::{attribute, domains, json_string, json_value, model_name, property};

/// The whole module.
pub(super) fn module() -> String {
    let mut text = String::from(
        "// Generated from the parameter table of hearth-core by `cargo xtask codegen`;\n\
         // edit crates/hearth-core/src/params.rs instead.\n\n\
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
    for preset in PRESETS {
        let _ = writeln!(text, "  {},", preset_entry(preset));
    }
    text.push_str("];\n");
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
        Kind::Choice(names) => {
            let names: Vec<_> = names.iter().map(|name| json_string(name)).collect();
            fields.push(("choices", format!("[{}]", names.join(", "))));
        }
        Kind::Flag | Kind::Colour | Kind::Seed => {}
    }
    let mut models = Vec::new();
    let mut by_model = Vec::new();
    for (model, domain) in domains(param) {
        let domain = domain_fields(param, domain);
        if models.is_empty() {
            fields.extend(domain.clone());
        }
        models.push(json_string(model_name(model)));
        by_model.push((model_name(model), object(&domain)));
    }
    fields.push(("models", format!("[{}]", models.join(", "))));
    fields.push(("domains", object(&by_model)));
    object(&fields)
}

fn domain_fields(
    param: &Param,
    domain: &hearth_core::params::Domain,
) -> Vec<(&'static str, String)> {
    let mut fields = vec![("default", json_value(domain.default))];
    if matches!(param.kind, Kind::Number(_) | Kind::Integer(_) | Kind::Seed) {
        let (min, max) = domain.range;
        fields.push(("min", min.to_string()));
        fields.push(("max", max.to_string()));
    }
    fields
}

fn preset_entry(preset: &Preset) -> String {
    let values: Vec<_> = preset
        .values
        .iter()
        .map(|&(id, input)| (id, json_input(input)))
        .collect();
    object(&[
        ("name", json_string(preset.name)),
        ("label", json_string(preset.label)),
        ("values", object(&values)),
    ])
}

fn json_input(input: Input<'_>) -> String {
    match input {
        Input::Number(x) => x.to_string(),
        Input::Flag(on) => on.to_string(),
        Input::Text(text) => json_string(text),
    }
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
