//! `web/parameters.d.ts`: the types that depend on the parameters. The types of the
//! element's class, which `element.mjs` makes, build on these.

use std::fmt::Write as _;

use hearth_core::params::{Choice, Domain, Kind, Model, PARAMETERS, Param};

use hearth_core::scene::KINDS;

use super::scene::Scene;
use super::{domains, json, property, stats};

/// The whole file of declarations.
pub(super) fn declarations(scenes: &[Scene]) -> String {
    let presets: Vec<_> = scenes.iter().map(|scene| scene.name.as_str()).collect();
    include_str!("templates/parameters.d.ts")
        .replace("{{models}}", &union(Model::NAMES))
        .replace("{{presets}}", &union(&presets))
        .replace("{{parameters}}", &fields(|param| param.id.to_owned()))
        .replace("{{properties}}", &fields(|param| property(param.id)))
        .replace("{{objects}}\n", &objects())
        .replace("{{stats}}", &stats::interface())
}

/// The types of objects: each kind with its properties.
fn objects() -> String {
    let mut text = String::new();
    let mut names = Vec::new();
    for kind in KINDS {
        let (first, rest) = kind.name.split_at(1);
        let name = format!("Hearth{}{rest}", first.to_ascii_uppercase());
        let _ = write!(
            text,
            "/** {} */\nexport interface {name} {{\n  kind: \"{}\";\n  \
             /** A whole number from 1, unique in its scene; without one it gets the next. */\n  \
             id?: number;\n",
            kind.doc, kind.name,
        );
        for property in kind.properties() {
            if let Some(param) = property.entry() {
                let kind = match property.name {
                    // The element and the simulation make a text of a list.
                    "points" => "string | readonly (readonly [number, number])[]".to_owned(),
                    _ => value_type(param.kind),
                };
                let (doc, name) = (comment(param), property.name);
                let _ = writeln!(text, "  /** {doc} */\n  {name}?: {kind};");
            }
        }
        text.push_str("}\n\n");
        names.push(name);
    }
    let names = names.join(" | ");
    let _ = writeln!(
        text,
        "/** An object of a scene. */\nexport type HearthObject = {names};\n"
    );
    text
}

fn fields(name: impl Fn(&Param) -> String) -> String {
    let mut text = String::new();
    for param in PARAMETERS {
        let (name, kind) = (name(param), value_type(param.kind));
        let _ = writeln!(text, "  /** {} */\n  {name}: {kind};", comment(param));
    }
    text
}

/// The doc, the unit, and default and range, for each model where they differ.
pub(super) fn comment(param: &Param) -> String {
    let mut comment = param.description().doc.to_owned();
    if !param.unit.is_empty() {
        let _ = write!(comment, " [{}]", param.unit);
    }
    match domains(param).as_slice() {
        [(_, domain), (_, other)] if domain == other => {
            let _ = write!(comment, " Default {}.", values(param, domain));
        }
        all => {
            for (model, domain) in all {
                let values = values(param, domain);
                let _ = write!(comment, " Default in {}: {values}.", model.name());
            }
        }
    }
    comment.replace("*/", "*\\/")
}

/// The default and, of a number, the range.
fn values(param: &Param, domain: &Domain) -> String {
    let mut text = json(domain.default).to_string();
    if matches!(param.kind, Kind::Number(_) | Kind::Integer(_)) {
        let _ = write!(text, ", from {} to {}", domain.range.0, domain.range.1);
    }
    text
}

pub(super) fn value_type(kind: Kind) -> String {
    match kind {
        Kind::Number(_) | Kind::Integer(_) | Kind::Seed => "number".to_owned(),
        Kind::Flag => "boolean".to_owned(),
        Kind::Colour | Kind::Text(_) => "string".to_owned(),
        Kind::Choice(names) => union(names),
    }
}

fn union(names: &[&str]) -> String {
    let names: Vec<_> = names.iter().map(|name| format!("\"{name}\"")).collect();
    names.join(" | ")
}
