//! `web/parameters.d.ts`: the types that depend on the parameters. The element's own types
//! are written by hand in `web/hearth-fire.d.ts` and build on these.

use std::fmt::Write as _;

use hearth_core::params::{Choice, Domain, Kind, Model, PARAMETERS, Param};

use super::scene::Scene;
use super::{domains, json, property};

/// The whole file of declarations.
pub(super) fn declarations(scenes: &[Scene]) -> String {
    let presets: Vec<_> = scenes.iter().map(|scene| scene.name.as_str()).collect();
    include_str!("templates/parameters.d.ts")
        .replace("{{models}}", &union(Model::NAMES))
        .replace("{{presets}}", &union(&presets))
        .replace("{{parameters}}", &fields(|param| param.id.to_owned()))
        .replace("{{properties}}", &fields(|param| property(param.id)))
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
        Kind::Colour => "string".to_owned(),
        Kind::Choice(names) => union(names),
    }
}

fn union(names: &[&str]) -> String {
    let names: Vec<_> = names.iter().map(|name| format!("\"{name}\"")).collect();
    names.join(" | ")
}
