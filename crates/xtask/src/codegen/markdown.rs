//! `docs/parameters.md`: the reference of all parameters, by group.

use std::fmt::Write as _;

use hearth_core::params::{Domain, Input, Kind, PARAMETERS, Param, Scale, Value};
use hearth_core::preset::PRESETS;

use super::{MODELS, attribute, domains, model_name};

const INTRODUCTION: &str = "\
<!-- Generated from the parameter table of hearth-core by `cargo xtask codegen`;
     edit crates/hearth-core/src/params.rs instead. -->

# Parameters

The **id** names a parameter in JavaScript (`fire.set('id', value)`) and in the
panel; the **attribute** names it in HTML (`<hearth-fire attribute=\"value\">`). A
value outside its range is refused aloud and the last good one stays. Sliders of
a range marked *log* spread it by ratios.
";

/// The whole page.
pub(super) fn reference() -> String {
    let mut text = String::from(INTRODUCTION);
    let mut group = "";
    for param in PARAMETERS {
        if param.group != group {
            group = param.group;
            let _ = write!(
                text,
                "\n## {group}\n\n\
                 | id | attribute | unit | default | range | models | |\n\
                 |---|---|---|---|---|---|---|\n"
            );
        }
        let _ = writeln!(text, "{}", row(param));
    }
    text.push_str("\n## Presets\n\n| name | | changes |\n|---|---|---|\n");
    for preset in PRESETS {
        let values: Vec<_> = preset
            .values
            .iter()
            .map(|(id, input)| match input {
                Input::Text(name) => format!("`{id}` = {name}"),
                input => format!("`{id}` = {input}"),
            })
            .collect();
        let changes = if values.is_empty() {
            "nothing".to_owned()
        } else {
            values.join(", ")
        };
        let _ = writeln!(
            text,
            "| `{}` | {} | {} |",
            preset.name,
            cell(preset.label),
            cell(&changes)
        );
    }
    text
}

fn row(param: &Param) -> String {
    let all: Vec<_> = domains(param).collect();
    let models: Vec<_> = all.iter().map(|&(model, _)| model_name(model)).collect();
    let models = if all.len() == MODELS.len() {
        "all".to_owned()
    } else {
        models.join(", ")
    };
    let description = param.description();
    format!(
        "| `{}` | `{}` | {} | {} | {} | {models} | **{}.** {} |",
        param.id,
        attribute(param.id),
        cell(param.unit),
        per_model(param, |domain| default_text(domain.default)),
        per_model(param, |domain| range_text(param.kind, domain)),
        cell(description.label),
        cell(description.doc),
    )
}

/// One text where the models agree, else one for each.
fn per_model(param: &Param, text: impl Fn(&Domain) -> String) -> String {
    let texts: Vec<_> = domains(param)
        .map(|(model, domain)| (model_name(model), text(domain)))
        .collect();
    match texts.as_slice() {
        [(_, first), rest @ ..] if rest.iter().all(|(_, text)| text == first) => first.clone(),
        texts => {
            let texts: Vec<_> = texts
                .iter()
                .map(|(model, text)| format!("{model}: {text}"))
                .collect();
            texts.join("; ")
        }
    }
}

fn default_text(default: Value) -> String {
    match (default, default.as_number()) {
        (_, Some(x)) => number(x),
        (Value::Flag(on), None) => if on { "on" } else { "off" }.to_owned(),
        (value, None) => format!("`{value}`"),
    }
}

fn range_text(kind: Kind, domain: &Domain) -> String {
    let (min, max) = (number(domain.range.0), number(domain.range.1));
    match kind {
        Kind::Number(Scale::Linear) => format!("{min} – {max}"),
        Kind::Number(Scale::Log) => format!("{min} – {max}, log"),
        Kind::Integer(Scale::Linear) => format!("{min} – {max}, whole"),
        Kind::Integer(Scale::Log) => format!("{min} – {max}, whole, log"),
        Kind::Seed => format!("{min} – {max}, whole"),
        Kind::Flag => "on, off".to_owned(),
        Kind::Colour => "`transparent`, `#rgb`, `#rrggbb`, `#rrggbbaa`".to_owned(),
        Kind::Choice(names) => {
            let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
            names.join(", ")
        }
    }
}

/// A number to be read: one that is not a short decimal, as 1/240, is rounded
/// to four digits.
fn number(x: f64) -> String {
    let exact = x.to_string();
    let digits = exact.trim_start_matches(['0', '.', '-']).len();
    if x == 0.0 || x.fract() == 0.0 || digits <= 6 {
        return exact;
    }
    let before = x.abs().log10().floor() as i32;
    let places = usize::try_from(3 - before).unwrap_or(0);
    format!("{x:.places$}")
}

/// A text that does not end its cell.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_readable() {
        assert_eq!(number(0.035), "0.035");
        assert_eq!(number(100_000.0), "100000");
        assert_eq!(number(1.0 / 480.0), "0.002083");
        assert_eq!(number(0.0), "0");
    }

    #[test]
    fn every_parameter_has_its_row() {
        let page = reference();
        for param in PARAMETERS {
            assert!(page.contains(&format!("\n| `{}` |", param.id)));
        }
    }

    #[test]
    fn a_cell_stays_one_cell() {
        assert_eq!(cell("a|b\nc"), "a\\|b c");
    }
}
