//! `web/custom-elements.json`: the element for editors, catalogues and the
//! generators of wrappers, in the format that these share, the Custom Elements
//! Manifest.

use std::fmt::Write as _;

use hearth_core::params::{Kind, Model, PARAMETERS, Param};

use super::element::{self, Attribute, Field, Method, Named};
use super::{attribute, json_string, json_value, property, typescript};

/// The version of the format.
const SCHEMA: &str = "2.1.0";
/// The module that defines the element, and its class.
const MODULE: &str = "hearth-fire.js";
const CLASS: &str = "HearthFire";

/// The whole manifest.
pub(super) fn manifest() -> String {
    let attributes = element::ATTRIBUTES.iter().map(own_attribute);
    let attributes = attributes.chain(PARAMETERS.iter().map(parameter_attribute));
    let members = element::ATTRIBUTES.iter().map(own_property);
    let members = members.chain(element::FIELDS.iter().map(field));
    let members = members.chain(element::METHODS.iter().map(method));
    let members = members.chain(PARAMETERS.iter().map(parameter_property));
    let declaration = [
        ("attributes", list(attributes)),
        ("members", list(members)),
        ("events", list(element::EVENTS.iter().map(event))),
        ("slots", list(element::SLOTS.iter().map(named))),
        ("cssParts", list(element::PARTS.iter().map(named))),
        (
            "cssProperties",
            list(element::CSS_PROPERTIES.iter().map(named)),
        ),
        ("cssStates", list(element::CSS_STATES.iter().map(named))),
    ];
    let mut text = format!(
        "{{\n  \"schemaVersion\": \"{SCHEMA}\",\n  \"readme\": \"README.md\",\n  \"modules\": [{{\n    \
         \"kind\": \"javascript-module\",\n    \"path\": \"{MODULE}\",\n    \
         \"declarations\": [{{\n      \
         \"kind\": \"class\",\n      \"customElement\": true,\n      \"tagName\": \"hearth-fire\",\n      \
         \"name\": \"{CLASS}\",\n      \"superclass\": {{ \"name\": \"HTMLElement\" }},\n      \
         \"description\": \"A fire, simulated by smoothed particle hydrodynamics.\""
    );
    for (name, list) in declaration {
        let _ = write!(text, ",\n      \"{name}\": {list}");
    }
    let declared = format!("{{ \"name\": \"{CLASS}\", \"module\": \"{MODULE}\" }}");
    let _ = write!(
        text,
        "\n    }}],\n    \"exports\": [\n      \
         {{ \"kind\": \"js\", \"name\": \"{CLASS}\", \"declaration\": {declared} }},\n      \
         {{ \"kind\": \"custom-element-definition\", \"name\": \"hearth-fire\", \"declaration\": {declared} }}\n    \
         ]\n  }}]\n}}\n"
    );
    text
}

fn own_attribute(own: &Attribute) -> String {
    object(&[
        ("name", json_string(own.name)),
        ("fieldName", json_string(&camel_case(own.name))),
        ("type", kind(own.kind)),
        ("default", optional(own.default)),
        ("description", json_string(own.doc)),
    ])
}

fn own_property(own: &Attribute) -> String {
    object(&[
        ("kind", json_string("field")),
        ("name", json_string(&camel_case(own.name))),
        ("attribute", json_string(own.name)),
        ("reflects", optional_flag(own.reflects)),
        ("type", kind(own.kind)),
        ("default", optional(own.default)),
        ("description", json_string(own.doc)),
    ])
}

fn parameter_attribute(param: &Param) -> String {
    object(&[
        ("name", json_string(&attribute(param.id))),
        ("fieldName", json_string(&property(param.id))),
        ("type", kind(&value_type(param.kind))),
        ("default", default(param)),
        ("description", json_string(&typescript::comment(param))),
    ])
}

fn parameter_property(param: &Param) -> String {
    object(&[
        ("kind", json_string("field")),
        ("name", json_string(&property(param.id))),
        ("attribute", json_string(&attribute(param.id))),
        ("type", kind(&value_type(param.kind))),
        ("default", default(param)),
        ("description", json_string(param.description().doc)),
    ])
}

/// The type in the quotes that people write in TypeScript, which need no escape in JSON.
fn value_type(kind: Kind) -> String {
    typescript::value_type(kind).replace('"', "'")
}

/// The default as the attribute would have it; the manifest holds it as a text.
fn default(param: &Param) -> String {
    let value = json_value(param.any_domain(Model::DEFAULT).default);
    json_string(value.trim_matches('"'))
}

fn field(field: &Field) -> String {
    object(&[
        ("kind", json_string("field")),
        ("name", json_string(field.name)),
        ("static", optional_flag(field.of_class)),
        ("readonly", optional_flag(!field.of_class)),
        ("type", kind(field.kind)),
        ("description", json_string(field.doc)),
    ])
}

fn method(method: &Method) -> String {
    let parameters = method.parameters.iter().map(|&(name, ty)| {
        let plain = name.trim_start_matches("...").trim_end_matches('?');
        object(&[
            ("name", json_string(plain)),
            ("optional", optional_flag(name.ends_with('?'))),
            ("rest", optional_flag(name.starts_with("..."))),
            ("type", kind(ty)),
        ])
    });
    let parameters: Vec<_> = parameters.collect();
    object(&[
        ("kind", json_string("method")),
        ("name", json_string(method.name)),
        ("parameters", format!("[{}]", parameters.join(", "))),
        (
            "return",
            format!("{{ \"type\": {} }}", kind(method.returns)),
        ),
        ("description", json_string(method.doc)),
    ])
}

fn event(event: &Named) -> String {
    object(&[
        ("name", json_string(event.name)),
        ("type", kind(&format!("CustomEvent<{}>", event.kind))),
        ("description", json_string(event.doc)),
    ])
}

fn named(named: &Named) -> String {
    object(&[
        ("name", json_string(named.name)),
        ("description", json_string(named.doc)),
    ])
}

fn kind(text: &str) -> String {
    format!("{{ \"text\": {} }}", json_string(text))
}

/// `text`, or nothing where it is empty.
fn optional(text: &str) -> String {
    if text.is_empty() {
        String::new()
    } else {
        json_string(text)
    }
}

/// What is not so is not said.
fn optional_flag(on: bool) -> String {
    if on { "true".to_owned() } else { String::new() }
}

/// `reduced-motion` → `reducedMotion`.
pub(super) fn camel_case(name: &str) -> String {
    property(&name.replace('-', "_"))
}

/// An object on one line, without the fields that have no value.
fn object(fields: &[(&str, String)]) -> String {
    let fields: Vec<_> = fields
        .iter()
        .filter(|(_, value)| !value.is_empty())
        .map(|(name, value)| format!("\"{name}\": {value}"))
        .collect();
    format!("{{ {} }}", fields.join(", "))
}

/// One entry a line.
fn list(entries: impl Iterator<Item = String>) -> String {
    let lines: Vec<_> = entries.map(|entry| format!("\n        {entry}")).collect();
    format!("[{}\n      ]", lines.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    fn read() -> Result<Value, serde_json::Error> {
        serde_json::from_str(&manifest())
    }

    fn names<'a>(of: &'a Value, list: &str) -> Vec<&'a str> {
        let entries = of["modules"][0]["declarations"][0][list].as_array();
        entries
            .into_iter()
            .flatten()
            .filter_map(|entry| entry["name"].as_str())
            .collect()
    }

    #[test]
    fn every_parameter_is_an_attribute_and_a_property() -> Result<(), serde_json::Error> {
        let manifest = read()?;
        let (attributes, members) = (names(&manifest, "attributes"), names(&manifest, "members"));
        for param in PARAMETERS {
            assert!(attributes.contains(&attribute(param.id).as_str()));
            assert!(members.contains(&property(param.id).as_str()));
        }
        Ok(())
    }

    #[test]
    fn nothing_is_said_twice() -> Result<(), serde_json::Error> {
        let manifest = read()?;
        for list in [
            "attributes",
            "members",
            "events",
            "slots",
            "cssParts",
            "cssProperties",
            "cssStates",
        ] {
            let mut names = names(&manifest, list);
            assert!(!names.is_empty(), "{list}");
            names.sort_unstable();
            let all = names.len();
            names.dedup();
            assert_eq!(names.len(), all, "{list}");
        }
        Ok(())
    }
}
