//! `docs/parameters.md`: the reference of all parameters, by group.

use std::fmt::Write as _;

use hearth_core::params::{
    Description, Domain, Kind, Model, PARAMETERS, Param, Scale, Value, conditions_text,
};

use hearth_core::scene::{self, KINDS};

use super::{attribute, models};

/// The whole page.
pub(super) fn reference() -> String {
    let mut tables = String::new();
    let mut group = "";
    for param in PARAMETERS {
        if param.group() != group {
            group = param.group();
            let models: Vec<_> = models().into_iter().map(Model::name).collect();
            let _ = write!(
                tables,
                "\n## {group}\n\n\
                 | id | attribute | unit | {} | |\n\
                 |---|---|---|---|---|---|\n",
                models.join(" | ")
            );
        }
        let _ = writeln!(tables, "{}", row(param));
    }
    let mut objects = String::new();
    for property in scene::Kind::SOURCE
        .properties()
        .filter(|property| !property.is_common())
    {
        let label = property
            .entry()
            .map_or("", |param| param.description().label);
        let _ = writeln!(
            objects,
            "| `{}` | `{}` | {label} |",
            property.name,
            property.id()
        );
    }
    let kinds = KINDS.iter().filter(|kind| !kind.is_of_parameters());
    let kinds: String = kinds.map(|kind| properties(kind)).collect();
    include_str!("templates/parameters.md")
        .replace("{{parameters}}", &tables)
        .replace("{{objects}}", &objects)
        .replace("{{kinds}}\n", &kinds)
}

/// The properties of a kind that are no parameters.
fn properties(kind: &scene::Kind) -> String {
    let name = kind.name;
    let mut text = format!(
        "A {name} (`kind` `{name}`) has these properties, which are the same in both models.\n\n\
         | property | unit | default | |\n|---|---|---|---|\n"
    );
    let own = kind.properties().filter(|property| !property.is_common());
    for param in own.filter_map(|property| property.entry()) {
        let domain = &param.domains[0];
        let description = param.description();
        let _ = writeln!(
            text,
            "| `{}` | {} | {} ({}) | **{}.** {} |",
            param.id,
            param.unit,
            default_text(domain.default),
            range_text(param.kind, domain),
            description.label,
            cell(&(description.doc.to_owned() + &condition(description))),
        );
    }
    text + "\n"
}

fn row(param: &Param) -> String {
    let by_model: Vec<_> = models()
        .into_iter()
        .map(|model| match param.domain(model) {
            Some(domain) => cell(&format!(
                "{} ({})",
                default_text(domain.default),
                range_text(param.kind, domain)
            )),
            None => "–".to_owned(),
        })
        .collect();
    let description = param.description();
    format!(
        "| `{}` | `{}` | {} | {} | **{}.** {} |",
        param.id,
        attribute(param.id),
        cell(param.unit),
        by_model.join(" | "),
        cell(description.label),
        cell(&(description.doc.to_owned() + &condition(description))),
    )
}

/// The choices with which the value has an effect, unless it always has.
fn condition(description: &Description) -> String {
    let quoted = |word: &str| format!("`{word}`");
    let each = [("Only", description.when), ("Not", description.unless)];
    let each = each.map(
        |(how, chosen)| match conditions_text(chosen, quoted, quoted) {
            words if words.is_empty() => words,
            words => format!(" {how} with {words}."),
        },
    );
    each.concat()
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
        Kind::Text(form) => form.to_owned(),
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
pub(super) fn cell(text: &str) -> String {
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
    fn each_model_has_its_column() {
        for param in PARAMETERS {
            let row = row(param);
            let cells: Vec<_> = row.split(" | ").skip(3).collect();
            for (model, cell) in models().into_iter().zip(cells) {
                let expected = match param.domain(model) {
                    Some(domain) => default_text(domain.default),
                    None => "–".to_owned(),
                };
                assert!(cell.starts_with(&expected), "{} of {model:?}", param.id);
            }
        }
    }

    #[test]
    fn a_condition_reads_as_in_the_panel() {
        let when: &[(_, &[_])] = &[("a", &["x", "y", "z"]), ("b", &["x", "y"]), ("c", &["x"])];
        let description = Description {
            when,
            unless: &[("d", &["x"])],
            ..*PARAMETERS[0].description()
        };
        assert_eq!(
            condition(&description),
            " Only with `a` `x`, `y` or `z` and `b` `x` or `y` and `c` `x`. Not with `d` `x`."
        );
    }

    #[test]
    fn a_cell_stays_one_cell() {
        assert_eq!(cell("a|b\nc"), "a\\|b c");
    }
}
