//! `web/react.d.ts`: the element in JSX. React 19 passes what has a hyphen to a custom
//! element as an attribute and `on…` as a listener, so attributes and events are typed by
//! their names in HTML.

use std::fmt::Write as _;

use hearth_core::params::{Kind, PARAMETERS};

use super::manifest::{Element, parts};
use super::{attribute, typescript};

/// The whole file of declarations.
pub(super) fn declarations(element: &Element) -> String {
    let mut attributes = String::new();
    for own in element.list("attributes") {
        let (name, kind, doc) = parts(own);
        entry(&mut attributes, doc, name, kind);
    }
    for param in PARAMETERS {
        let doc = typescript::comment(param);
        entry(
            &mut attributes,
            &doc,
            &attribute(param.id),
            &kind(param.kind),
        );
    }
    let mut listeners = String::new();
    for event in element.list("events") {
        let (name, kind, doc) = parts(event);
        let listener = format!("((event: {kind}) => void)");
        entry(&mut listeners, doc, &format!("on{name}"), &listener);
    }
    include_str!("templates/react.d.ts")
        .replace("{{attributes}}", &attributes)
        .replace("{{listeners}}", &listeners)
}

fn entry(text: &mut String, doc: &str, name: &str, kind: &str) {
    let quote = if name.contains('-') { "\"" } else { "" };
    let _ = writeln!(
        text,
        "  /** {doc} */\n  {quote}{name}{quote}?: {kind} | undefined;"
    );
}

/// A number may be written as text, as in HTML.
fn kind(kind: Kind) -> String {
    match kind {
        Kind::Number(_) | Kind::Integer(_) => "number | `${number}`".to_owned(),
        Kind::Seed => "number | `${number}` | 'auto'".to_owned(),
        other => typescript::value_type(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_with_a_hyphen_are_quoted() -> anyhow::Result<()> {
        let text = declarations(&Element::read()?);
        assert!(text.contains("\n  \"source-width\"?: number | `${number}` | undefined;\n"));
        assert!(text.contains("\n  viscosity?: number | `${number}` | undefined;\n"));
        assert!(text.contains("\n  onready?: ((event: CustomEvent<null>) => void) | undefined;\n"));
        Ok(())
    }
}
