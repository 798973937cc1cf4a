//! The table for JavaScript. `web/generated/defaults.js`: the ids and defaults, which the element
//! needs before wasm is loaded, as the browser reads `observedAttributes` by then.
//! `web/parameters.js`: all of the table, for the panel's accessible controls and any
//! tool; `web/generated/quantities.js`, `web/generated/interpolation.js`: parts of it that are loaded alone.

use hearth_core::params::{Choice, DisplayMode, Domain, Kind, Model, PARAMETERS, Param, Scale};
use hearth_core::scene::{self, KINDS, MAX_OBJECTS};
use serde_json::{Map, Value, json};

use super::scene::Scene;
use super::{attribute, domains, number, property};

const HEADER: &str = "\
// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.
";

/// The declaration of a constant: an object or a list, with an entry in each line.
fn constant(
    doc: &str,
    name: &str,
    [open, close]: [char; 2],
    entries: impl IntoIterator<Item = String>,
) -> String {
    let lines = entries.into_iter().map(|entry| format!("  {entry},\n"));
    let lines: String = lines.collect();
    format!("\n/** {doc} */\nexport const {name} = {open}\n{lines}{close};\n")
}

const OBJECT: [char; 2] = ['{', '}'];
const LIST: [char; 2] = ['[', ']'];

/// The module of ids and defaults, and of the other attributes.
pub(super) fn defaults() -> String {
    let doc = "What a new fire burns with: every parameter, the model first.";
    let entries = PARAMETERS.iter().map(|param| {
        let default = super::json(param.any_domain(Model::DEFAULT).default);
        format!("{}: {default}", param.id)
    });
    let defaults = constant(doc, "DEFAULTS", OBJECT, entries);
    let doc = "The parameters that a model lacks. @type {{[model: string]: string[]}}";
    let lacking = Model::VALUES.iter().map(|model| {
        let all = PARAMETERS.iter();
        let ids = all.filter(|param| param.only_in(*model).is_some());
        let ids: Vec<_> = ids.map(|param| param.id).collect();
        format!("{}: {}", model.name(), json!(ids))
    });
    let lacking = constant(doc, "LACKING", OBJECT, lacking);
    format!("{HEADER}{defaults}{lacking}\nexport {{ OWN_ATTRIBUTES }} from './attributes.js';\n")
}

/// The module of all tables for pages and packages.
pub(super) fn module() -> String {
    HEADER.to_owned()
        + "\n\
           export { QUANTITIES } from './generated/quantities.js';\n\
           export { PARAMETERS, PRESETS } from './generated/table.js';\n"
}

/// The module of the parameters and the presets.
pub(super) fn table(scenes: &[Scene]) -> String {
    let all = PARAMETERS.iter().map(|param| derived(entry(param)));
    let all = all.map(|entry| entry.to_string());
    let entries = constant("The entries.", "ENTRIES", LIST, all).replace("export ", "");
    let doc = "Named sets of values: the defaults, with these changed. \
               @type {import('../parameters.js').Preset[]}";
    let presets = scenes.iter().map(|scene| {
        let values = scene.all_values().into_iter();
        let values: Map<_, _> = values.map(|(id, value)| (id.to_owned(), value)).collect();
        let (name, label, description) = (&scene.name, &scene.label, &scene.description);
        json!({ "name": name, "label": label, "description": description, "values": values })
            .to_string()
    });
    let presets = constant(doc, "PRESETS", LIST, presets);
    [HEADER, &entries, DERIVE, &presets].concat()
}

/// Fills in what [`derived`] leaves out.
const DERIVE: &str = "
/** Every parameter, in the order in which a panel shows them. @type {import('../parameters.js').Parameter[]} */
export const PARAMETERS = /** @type {any} */ (ENTRIES.map(({ domains, ...entry }) => ({
  ...entry,
  attribute: entry.id.replaceAll('_', '-'),
  property: entry.id.replace(/_(.)/g, (_, letter) => letter.toUpperCase()),
  domains: domains ?? Object.fromEntries(entry.models.map((model) => [
    model,
    'min' in entry ? { default: entry.default, min: entry.min, max: entry.max } : { default: entry.default },
  ])),
})));
";

/// An entry without what follows from the rest: a kilobyte of two downloads.
fn derived(mut entry: Value) -> Value {
    let domain = ["default", "min", "max"].map(|field| entry[field].clone());
    if let Some(fields) = entry.as_object_mut() {
        fields.remove("attribute");
        fields.remove("property");
        let is_same =
            |other: &Value| ["default", "min", "max"].map(|field| other[field].clone()) == domain;
        let domains = fields.get("domains").and_then(Value::as_object);
        if domains.is_some_and(|domains| domains.values().all(is_same)) {
            fields.remove("domains");
        }
    }
    entry
}

/// The module of what displays measure: apart, since the element's bar of colours needs
/// no more of the table.
pub(super) fn quantities() -> String {
    let doc = "What the colours of a display mode measure; modes that show a fire are absent.";
    let entries = DisplayMode::NAMES.iter().filter_map(|name| {
        let quantity = DisplayMode::from_name(name)?.quantity()?;
        let (unit, signed, whole) = (quantity.unit, quantity.signed, quantity.whole);
        let fields = json!({ "unit": unit, "signed": signed, "whole": whole });
        Some(format!("{name}: {fields}"))
    });
    HEADER.to_owned() + &constant(doc, "QUANTITIES", OBJECT, entries)
}

/// The module of the prewarmed fires.
pub(super) fn prewarmed() -> String {
    let doc = "The addresses of prewarmed fires, by the names of their scenes. \
               @type {{[scene: string]: () => URL}}";
    let entries = super::PREWARMED.iter().map(|name| {
        format!("'{name}': () => new URL('../prewarmed/{name}.fire', import.meta.url)")
    });
    "// Generated by `cargo xtask codegen`; edit crates/codegen/src/lib.rs instead.\n".to_owned()
        + &constant(doc, "PREWARMED", OBJECT, entries)
}

/// The module of the properties of objects: apart, since only children of the element need it.
pub(super) fn properties() -> String {
    let doc = "@type {{[kind: string]: {[name: string]: Property}}}";
    let entries = KINDS.iter().map(|kind| {
        let entries = kind.properties().filter_map(|property| {
            let fields = of_object(property.entry()?);
            Some(format!("    {}: {fields},\n", property.name))
        });
        format!("{}: {{\n{}  }}", kind.name, entries.collect::<String>())
    });
    format!(
        "{HEADER}\n\
         /**\n * Each property of each kind of object: its domain, which is its default and, of a number, its range, in\n \
         * every model or in those that use it; of a source, the parameter that it is of the first one.\n *\n \
         * @typedef {{[standard: any, min?: number, max?: number]}} Domain\n \
         * @typedef {{{{parameter?: string, every?: Domain, combustion?: Domain, classic?: Domain}}}} Property\n */\n\
         {}",
        constant(doc, "PROPERTIES", OBJECT, entries)
    )
}

/// The data of a property that children of the element need.
fn of_object(param: &Param) -> Value {
    let mut entry = Map::new();
    if PARAMETERS.iter().any(|known| known.id == param.id) {
        entry.insert("parameter".to_owned(), param.id.into());
    }
    let domains = domains(param);
    let all = |domain| Value::from_iter(domain_fields(param, domain).into_iter().map(|(_, x)| x));
    match domains.as_slice() {
        [(_, domain), (_, other)] if domain == other => {
            entry.insert("every".to_owned(), all(domain));
        }
        domains => entry.extend(
            domains
                .iter()
                .map(|(model, domain)| (model.name().to_owned(), all(domain))),
        ),
    }
    Value::Object(entry)
}

/// The data of a property that is no parameter.
fn own_entry(param: &Param) -> Value {
    let mut entry = entry(param);
    if let Some(fields) = entry.as_object_mut() {
        let of_parameters = ["attribute", "property", "group", "models", "domains"];
        fields.retain(|field, _| !of_parameters.contains(&field.as_str()));
    }
    entry
}

/// The module of the panel's data of objects, which nothing else needs.
pub(super) fn scene_objects(scenes: &[Scene]) -> String {
    let doc = "The properties of each kind that are no parameters, in the order of a panel.\n \
               * @type {{[kind: string]: ({id: string, label: string, unit: string, doc: string, kind: string} \
               & {[field: string]: any})[]}}";
    let kinds = KINDS.iter().map(|kind| {
        let own = kind
            .properties()
            .filter(|property| !kind.is_of_parameters() || property.is_common());
        let entries = own
            .filter_map(|property| property.entry())
            .map(|param| format!("    {},\n", own_entry(param)));
        format!("{}: [\n{}  ]", kind.name, entries.collect::<String>())
    });
    let kinds = constant(doc, "KINDS", OBJECT, kinds);
    let properties = scene::Kind::SOURCE.properties();
    let properties = properties.filter(|property| !property.is_common());
    let doc = "Each property of a source, and the parameter that it is of the first one.";
    let entries = properties.map(|property| format!("{}: '{}'", property.name, property.id()));
    let source = constant(doc, "SOURCE", OBJECT, entries);
    let bodies = KINDS.iter().filter(|kind| kind.is_body);
    let bodies: Vec<_> = bodies.map(|kind| kind.name).collect();
    let doc = "The fields of the objects of each preset.\n \
               * @type {{[preset: string]: {[name: string]: string | number | boolean}[]}}";
    let entries = scenes.iter().map(|scene| {
        let objects = scene.objects.iter();
        let objects = objects.map(|fields| fields.iter().cloned().collect::<Map<_, _>>());
        format!("'{}': {}", scene.name, json!(objects.collect::<Vec<_>>()))
    });
    let objects = constant(doc, "OBJECTS", OBJECT, entries);
    format!(
        "// Generated from the table of objects of hearth-core and the files of scenes/ by\n\
         // `cargo xtask codegen`; edit those instead.\n\n\
         /** Most objects of a kind in a scene. */\n\
         export const MAX_OBJECTS = {MAX_OBJECTS};\n\n\
         /** The kinds of bodies, which gas flows around. */\n\
         export const BODIES = {};\n\
         {source}{kinds}{objects}",
        json!(bodies)
    )
}

/// The module of the package's version.
pub(super) fn version() -> String {
    let version = env!("CARGO_PKG_VERSION");
    format!(
        "// Generated by `cargo xtask codegen`; edit the version in Cargo.toml instead.\n\n\
         /** The version of the package. */\n\
         export const VERSION = '{version}';\n"
    )
}

/// The module of how values move: apart, since only transitions need it.
pub(super) fn interpolation() -> String {
    let ids = |wanted: fn(Kind) -> bool| -> Value {
        let params = PARAMETERS.iter().filter(|param| wanted(param.kind));
        params.map(|param| param.id).collect()
    };
    format!(
        "{HEADER}\n\
         /** The parameters whose equal steps are equal ratios. */\n\
         export const LOGARITHMIC = {};\n\n\
         /** The parameters whose values are whole numbers. */\n\
         export const WHOLE = {};\n",
        ids(|kind| matches!(kind, Kind::Number(Scale::Log))),
        ids(|kind| matches!(kind, Kind::Integer(_) | Kind::Seed)),
    )
}

/// What is known of a parameter: the `Parameter` of `parameters.d.ts`.
fn entry(param: &Param) -> Value {
    let description = param.description();
    let (kind, scale) = match param.kind {
        Kind::Number(scale) => ("number", Some(scale)),
        Kind::Integer(scale) => ("integer", Some(scale)),
        Kind::Choice(_) => ("choice", None),
        Kind::Flag => ("flag", None),
        Kind::Colour => ("colour", None),
        Kind::Seed => ("seed", None),
        Kind::Text(_) => ("text", None),
    };
    let mut entry = json!({
        "id": param.id, "attribute": attribute(param.id), "property": property(param.id),
        "label": description.label, "group": description.group, "unit": param.unit,
        "doc": description.doc, "kind": kind,
    });
    match (scale, param.kind) {
        (Some(Scale::Linear), _) => entry["scale"] = "linear".into(),
        (Some(Scale::Log), _) => entry["scale"] = "log".into(),
        (None, Kind::Choice(names)) => entry["choices"] = names.into(),
        (None, _) => {}
    }
    let domains = domains(param);
    if let (Some(entry), Some((_, first))) = (entry.as_object_mut(), domains.first()) {
        entry.extend(domain_fields(param, first));
    }
    entry["models"] = domains.iter().map(|(model, _)| model.name()).collect();
    let by_model = domains.iter().map(|(model, domain)| {
        let fields = domain_fields(param, domain);
        (model.name(), Value::Object(fields))
    });
    entry["domains"] = by_model.collect();
    for (name, chosen) in [("when", description.when), ("unless", description.unless)] {
        if !chosen.is_empty() {
            entry[name] = chosen.iter().map(|&(id, names)| (id, names)).collect();
        }
    }
    entry
}

fn domain_fields(param: &Param, domain: &Domain) -> Map<String, Value> {
    let mut fields = Map::new();
    fields.insert("default".to_owned(), super::json(domain.default));
    if matches!(param.kind, Kind::Number(_) | Kind::Integer(_) | Kind::Seed) {
        fields.insert("min".to_owned(), number(domain.range.0));
        fields.insert("max".to_owned(), number(domain.range.1));
    }
    fields
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_fire_has_every_parameter_and_the_model_first() {
        let text = defaults();
        let (text, _) = text.split_once("LACKING").unwrap_or_default();
        let lines: Vec<_> = text.lines().filter(|line| line.starts_with("  ")).collect();
        assert_eq!(lines.len(), PARAMETERS.len());
        assert_eq!(lines[0], format!("  model: \"{}\",", Model::DEFAULT.name()));
    }
}
