//! `web/parameters.d.ts`: the types of everything that depends on which
//! parameters there are. The element's own types, which do not, are written by
//! hand in `web/hearth-fire.d.ts` and build on these.

use std::fmt::Write as _;

use hearth_core::params::{Choice, Domain, Kind, Model, PARAMETERS, Param};

use hearth_core::scene::KINDS;

use super::scene::Scene;
use super::{domains, json_string, json_value, property, stats};

const HEADER: &str = "\
// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params.rs instead.
";

const TABLE: &str = "
/** Any id of a parameter. */
export type ParameterId = keyof HearthParameters;

/** Default and range of a parameter in one model; only numbers have a range. */
export interface ParameterDomain {
  default: number | string | boolean;
  min?: number;
  max?: number;
}

/**
 * What is known about a parameter. Default and range are those of the default
 * model, or of the one that uses it; `domains` has those of each.
 */
export interface Parameter extends ParameterDomain {
  id: ParameterId;
  /** The attribute of `<hearth-fire>`. */
  attribute: string;
  /** The property of `<hearth-fire>`. */
  property: keyof HearthProperties;
  label: string;
  group: string;
  /** Empty for a pure number. */
  unit: string;
  doc: string;
  kind: 'number' | 'integer' | 'choice' | 'flag' | 'colour' | 'seed';
  /** Numbers and integers: how a slider spreads the range. */
  scale?: 'linear' | 'log';
  /** Choices: every name. */
  choices?: string[];
  /** The models that use it. */
  models: ModelName[];
  domains: Partial<Record<ModelName, ParameterDomain>>;
  /**
   * The choices, by id, that must each have one of these names, or the value shows nowhere.
   * It can be set all the same.
   */
  when?: Partial<Record<ParameterId, string[]>>;
  /** The choices with whose names, all of them chosen together, it shows nowhere either. */
  unless?: Partial<Record<ParameterId, string[]>>;
}

/** A named set of values: the defaults, with these changed. */
export interface Preset {
  name: PresetName;
  label: string;
  /** What there is to see, in a sentence. */
  description: string;
  values: Partial<HearthParameters>;
}

/** Every parameter, in the order in which a panel shows them. */
export declare const PARAMETERS: Parameter[];

/** Every preset, the default one first. */
export declare const PRESETS: Preset[];

/** What the colours of a display mode measure, from `stats.scale[0]` to `stats.scale[1]`. */
export interface Quantity {
  /** Empty for a pure number. */
  unit: string;
  /** Whether it goes both ways from zero, which is then the middle of the colours. */
  signed: boolean;
  /** Whether it is a whole number. */
  whole: boolean;
}

/** Of each display mode that measures something, what. */
export declare const QUANTITIES: Partial<Record<HearthParameters['display_mode'], Quantity>>;
";

/// The whole file of declarations.
pub(super) fn declarations(scenes: &[Scene]) -> String {
    let mut text = String::from(HEADER);
    let models = Model::NAMES.iter().copied();
    let presets = scenes.iter().map(|scene| scene.name.as_str());
    let _ = write!(
        text,
        "\n/** Which equations move the particles. */\n\
         export type ModelName = {};\n\
         \n/** The name of a preset. */\n\
         export type PresetName = {};\n",
        union(models),
        union(presets)
    );
    text.push_str("\n/** The value of every parameter, by its id. */\n");
    interface(&mut text, "HearthParameters", |param| param.id.to_owned());
    text.push_str("\n/** The value of every parameter, as the element's properties name it. */\n");
    interface(&mut text, "HearthProperties", |param| property(param.id));
    objects(&mut text);
    text.push_str(TABLE);
    text.push_str(&stats::interface());
    text
}

/// The types of objects: each kind with its properties.
fn objects(text: &mut String) {
    for kind in KINDS {
        let name = format!("Hearth{}", capitalised(kind.name));
        let _ = write!(
            text,
            "\n/** {} */\nexport interface {name} {{\n  kind: {};\n  \
             /** A whole number from 1, unique in its scene; without one it gets the next. */\n  id?: number;\n",
            kind.doc,
            json_string(kind.name),
        );
        let params = kind.properties.iter();
        for (property, param) in params.filter_map(|one| Some((one, Param::find(one.id)?))) {
            let _ = writeln!(text, "  /** {} */", comment(param));
            let _ = writeln!(text, "  {}?: {};", property.name, value_type(param.kind));
        }
        text.push_str("}\n");
    }
    let names = KINDS
        .iter()
        .map(|kind| format!("Hearth{}", capitalised(kind.name)));
    let _ = writeln!(
        text,
        "\n/** An object of a scene. */\nexport type HearthObject = {};",
        names.collect::<Vec<_>>().join(" | ")
    );
}

fn capitalised(name: &str) -> String {
    let (first, rest) = name.split_at(name.len().min(1));
    first.to_ascii_uppercase() + rest
}

fn interface(text: &mut String, name: &str, field: impl Fn(&Param) -> String) {
    let _ = writeln!(text, "export interface {name} {{");
    for param in PARAMETERS {
        let _ = writeln!(text, "  /** {} */", comment(param));
        let _ = writeln!(text, "  {}: {};", field(param), value_type(param.kind));
    }
    text.push_str("}\n");
}

/// The doc, the unit, and default and range, for each model where they differ.
pub(super) fn comment(param: &Param) -> String {
    let mut comment = param.description().doc.to_owned();
    if !param.unit.is_empty() {
        let _ = write!(comment, " [{}]", param.unit);
    }
    let all: Vec<_> = domains(param).collect();
    match all.as_slice() {
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
    let mut text = json_value(domain.default);
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
        Kind::Choice(names) => union(names.iter().copied()),
    }
}

fn union<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<_> = names.map(json_string).collect();
    names.join(" | ")
}
