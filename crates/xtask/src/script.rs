//! Scripts without what only their readers need: a visitor downloads code, and
//! a third of these files, compressed, would be comments.

/// `script` without the lines that hold nothing but a comment, without blank ones,
/// without the blanks that lines begin with, and without the types of casts. What else
/// stands behind code, and all of a template, is left alone.
pub fn without_comments(script: &str) -> String {
    let mut kept = String::with_capacity(script.len());
    let (mut in_comment, mut in_template) = (false, false);
    for line in script.lines() {
        let words = line.trim();
        if in_comment {
            in_comment = !words.ends_with("*/");
        } else if in_template || !is_comment(words) {
            let was_in_template = in_template;
            in_template ^= backticks(words) % 2 == 1;
            if was_in_template || in_template {
                // Blanks at its ends may be the template's.
                kept.push_str(if was_in_template {
                    line
                } else {
                    line.trim_start()
                });
            } else {
                kept.push_str(&without_casts(words));
            }
            kept.push('\n');
        } else {
            in_comment = words.starts_with("/*") && !words.ends_with("*/");
        }
    }
    kept
}

/// A line of code without `/** @type {…} */`, which no text of ours holds.
fn without_casts(line: &str) -> String {
    let mut kept = String::with_capacity(line.len());
    let mut rest = line;
    while let Some((before, cast)) = rest.split_once("/** @type") {
        let Some((_, after)) = cast.split_once("*/") else {
            break;
        };
        kept.push_str(before);
        rest = after.strip_prefix(' ').unwrap_or(after);
    }
    kept.push_str(rest);
    kept
}

/// Whether a line, without the blanks around it, is blank, is a comment, or
/// begins one that goes on below it.
fn is_comment(words: &str) -> bool {
    let alone = words.find("*/").is_none_or(|end| end + 2 == words.len());
    words.is_empty() || words.starts_with("//") || words.starts_with("/*") && alone
}

/// How many backticks begin or end a template.
fn backticks(words: &str) -> usize {
    words.matches('`').count() - words.matches("\\`").count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_blank_lines_go() {
        let script =
            "/** A\n * `b\n */\n\n// c\nlet d = 1; // e\n  /* f */\n  /* g\n  h */\n  d();\n";
        assert_eq!(without_comments(script), "let d = 1; // e\nd();\n");
    }

    #[test]
    fn types_of_casts_go() {
        let script = "const a = /** @type {A} */ (b);\nc(/** @type {any} */(d), /** @type x";
        assert_eq!(
            without_comments(script),
            "const a = (b);\nc((d), /** @type x\n"
        );
    }

    #[test]
    fn code_behind_a_comment_stays() {
        let script = "/* a */ b();\n/* @__PURE__ */ c(/* d */);\n";
        assert_eq!(without_comments(script), script);
    }

    #[test]
    fn templates_stay_as_they_are() {
        let script = "const a = `\n// b\n\n/* c */ \\`\n`;\nd(`e`);\n";
        assert_eq!(without_comments(script), script);
        assert_eq!(
            without_comments("a(`b`);\n// `\nc(`\n// d\n`);\n// e"),
            "a(`b`);\nc(`\n// d\n`);\n"
        );
    }

    #[test]
    fn a_comment_that_never_ends_is_no_trouble() {
        assert_eq!(without_comments("a();\n/* b\nc"), "a();\n");
        assert_eq!(without_comments(""), "");
    }
}
