//! `web/react.d.ts`: the element in JSX. React 19 gives a custom element what has
//! a hyphen as an attribute and `on…` as a listener, so attributes and events are
//! typed by the names that HTML has for them.

use std::fmt::Write as _;

use hearth_core::params::{Kind, PARAMETERS};

use super::element;
use super::{attribute, json_string, typescript};

const INTRODUCTION: &str = "\
// Generated from the parameter table of hearth-core and the table of the element
// by `cargo xtask codegen`; edit crates/hearth-core/src/params.rs or
// crates/xtask/src/codegen/element.rs instead.

/**
 * `<hearth-fire>` in JSX, for React 19 and newer: `import 'hearth-fire/react'`
 * instead of `'hearth-fire'`, and attributes and events have their types.
 */

import type { DetailedHTMLProps, HTMLAttributes } from 'react';
import type {
  HearthChangeDetail,
  HearthErrorDetail,
  HearthFire,
  HearthQuality,
  HearthQualityDetail,
  HearthStats,
  PresetName,
} from './hearth-fire.js';

export * from './hearth-fire.js';

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'hearth-fire': DetailedHTMLProps<HearthFireProps, HearthFire>;
    }
  }
}

/** Everything that `<hearth-fire>` takes in JSX. */
export type HearthFireProps = HearthFireAttributes &
  HearthFireListeners &
  Omit<HTMLAttributes<HearthFire>, keyof HearthFireAttributes | keyof HearthFireListeners>;
";

/// The whole file of declarations.
pub(super) fn declarations() -> String {
    let mut text = String::from(INTRODUCTION);
    text.push_str(
        "\n/** The attributes of `<hearth-fire>`; one that is taken away is back at its default. */\n\
         export interface HearthFireAttributes {\n",
    );
    for own in element::ATTRIBUTES {
        entry(&mut text, own.doc, own.name, own.kind);
    }
    for param in PARAMETERS {
        let doc = typescript::comment(param);
        entry(&mut text, &doc, &attribute(param.id), &kind(param.kind));
    }
    text.push_str(
        "}\n\n/** The events of `<hearth-fire>`. */\nexport interface HearthFireListeners {\n",
    );
    for event in element::EVENTS {
        let listener = format!("((event: CustomEvent<{}>) => void)", event.kind);
        entry(
            &mut text,
            event.doc,
            &format!("on{}", event.name),
            &listener,
        );
    }
    text.push_str("}\n");
    text
}

fn entry(text: &mut String, doc: &str, name: &str, kind: &str) {
    let name = if name.contains('-') {
        json_string(name)
    } else {
        name.to_owned()
    };
    let _ = writeln!(text, "  /** {doc} */\n  {name}?: {kind} | undefined;");
}

/// A number may be written as text, as HTML does.
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
    fn names_that_are_no_identifiers_are_quoted() {
        let text = declarations();
        assert!(text.contains("\n  \"source-width\"?: number | `${number}` | undefined;\n"));
        assert!(text.contains("\n  viscosity?: number | `${number}` | undefined;\n"));
        assert!(text.contains("\n  onready?: ((event: CustomEvent<null>) => void) | undefined;\n"));
    }
}
