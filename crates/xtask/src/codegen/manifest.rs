//! `web/custom-elements.json`: the element for editors, catalogues and generators of
//! wrappers, in the format that these share, the [Custom Elements
//! Manifest](https://github.com/webcomponents/custom-elements-manifest).
//!
//! What the element has beyond its parameters is stated in `element.json`, a manifest
//! without them. Tests compare it with the element's class and its types.

use anyhow::{Context, Result};
use hearth_core::params::{Kind, Model, PARAMETERS};
use serde_json::{Value, json};

use super::{attribute, property, typescript};

/// The manifest without the parameters.
pub(super) struct Element(Value);

impl Element {
    pub(super) fn read() -> Result<Element> {
        let manifest = serde_json::from_str(include_str!("element.json"));
        Ok(Element(manifest.context("element.json")?))
    }

    /// The entries of one list of the element, as `events`.
    pub(super) fn list(&self, name: &str) -> &[Value] {
        let list = self.0["modules"][0]["declarations"][0][name].as_array();
        list.map(Vec::as_slice).unwrap_or_default()
    }
}

/// Name, type and description of an entry.
pub(super) fn parts(entry: &Value) -> (&str, &str, &str) {
    let texts = [
        &entry["name"],
        &entry["type"]["text"],
        &entry["description"],
    ];
    let [name, kind, description] = texts.map(|text| text.as_str().unwrap_or_default());
    (name, kind, description)
}

/// The whole manifest, with an entry on each line.
pub(super) fn manifest(element: &Element) -> String {
    let mut attributes = Vec::new();
    let mut members = Vec::new();
    for own in element.list("attributes") {
        let (name, kind, description) = parts(own);
        let field = property(name);
        let mut entry = json!({ "name": name, "fieldName": field, "type": { "text": kind } });
        let mut member = json!({
            "kind": "field", "name": field, "attribute": name, "reflects": true,
            "type": { "text": kind },
        });
        for entry in [&mut entry, &mut member] {
            if let Some(default) = own.get("default") {
                entry["default"] = default.clone();
            }
            entry["description"] = description.into();
        }
        attributes.push(entry);
        members.push(member);
    }
    members.extend_from_slice(element.list("members"));
    for param in PARAMETERS {
        let (name, field) = (attribute(param.id), property(param.id));
        // The manifest holds defaults as texts.
        let default = super::json(param.any_domain(Model::DEFAULT).default);
        let default = default
            .as_str()
            .map_or_else(|| default.to_string(), str::to_owned);
        let kind = json!({ "text": value_type(param.kind) });
        attributes.push(json!({
            "name": name, "fieldName": field, "type": kind, "default": default,
            "description": typescript::comment(param),
        }));
        members.push(json!({
            "kind": "field", "name": field, "attribute": name, "type": kind,
            "default": default, "description": param.description().doc,
        }));
    }
    let mut whole = element.0.clone();
    let declaration = &mut whole["modules"][0]["declarations"][0];
    declaration["attributes"] = attributes.into();
    declaration["members"] = members.into();
    let text = whole.to_string();
    text.replace("},{", "},\n{").replace(":[{", ":[\n{") + "\n"
}

/// The type in the quotes that people write in TypeScript.
fn value_type(kind: Kind) -> String {
    typescript::value_type(kind).replace('"', "'")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(list: &str) -> Result<Vec<String>> {
        let whole = Element(serde_json::from_str(&manifest(&Element::read()?))?);
        let names = whole
            .list(list)
            .iter()
            .map(|entry| parts(entry).0.to_owned());
        Ok(names.collect())
    }

    #[test]
    fn every_parameter_is_an_attribute_and_a_property() -> Result<()> {
        let (attributes, members) = (names("attributes")?, names("members")?);
        for param in PARAMETERS {
            assert!(attributes.contains(&attribute(param.id)));
            assert!(members.contains(&property(param.id)));
        }
        Ok(())
    }

    #[test]
    fn every_list_has_entries_and_no_name_twice() -> Result<()> {
        let declarations = [
            "attributes",
            "members",
            "events",
            "slots",
            "cssParts",
            "cssProperties",
            "cssStates",
        ];
        for list in declarations {
            let mut names = names(list)?;
            assert!(!names.is_empty(), "{list}");
            let all = names.len();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), all, "{list}");
        }
        Ok(())
    }
}
