//! `docs/evaluation.md`: measured tables between marks, `<!-- name: begin -->` and
//! `<!-- name: end -->`.

use std::fs;

use anyhow::{Context, Result};

use crate::paths;

const PAGE: &str = "docs/evaluation.md";

/// Fails unless the page has the marks of that name: known before hours are measured.
pub(crate) fn check(name: &str) -> Result<()> {
    with_section(name, "").map(drop)
}

/// The section of that name.
pub(crate) fn read(name: &str) -> Result<String> {
    let page = fs::read_to_string(paths::root().join(PAGE)).context(PAGE)?;
    let section = section(&page, name).with_context(|| lacks(name))?;
    Ok(section.trim().to_owned())
}

/// Replaces the section of that name.
pub(crate) fn write(name: &str, section: &str) -> Result<()> {
    fs::write(paths::root().join(PAGE), with_section(name, section)?)?;
    println!("wrote {PAGE}");
    Ok(())
}

fn with_section(name: &str, section: &str) -> Result<String> {
    let page = fs::read_to_string(paths::root().join(PAGE)).context(PAGE)?;
    replaced(&page, name, section).with_context(|| lacks(name))
}

fn lacks(name: &str) -> String {
    format!("{PAGE} lacks the marks `{name}`")
}

/// What is between the marks of that name.
fn section<'a>(page: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = page.split_once(&format!("<!-- {name}: begin -->"))?;
    Some(rest.split_once(&format!("<!-- {name}: end -->"))?.0)
}

/// `page` with another section between the marks of that name.
pub(crate) fn replaced(page: &str, name: &str, section: &str) -> Option<String> {
    let (begin, end) = (
        format!("<!-- {name}: begin -->"),
        format!("<!-- {name}: end -->"),
    );
    let (before, rest) = page.split_once(&begin)?;
    let (_, after) = rest.split_once(&end)?;
    Some(format!("{before}{begin}\n\n{section}\n{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_text_between_the_marks_is_replaced() {
        let page = "a\n<!-- b: begin -->\nold\n<!-- b: end -->\nc <!-- d: begin --> d";
        let once = replaced(page, "b", "new\n").unwrap_or_default();
        assert_eq!(
            once,
            "a\n<!-- b: begin -->\n\nnew\n\n<!-- b: end -->\nc <!-- d: begin --> d"
        );
        assert_eq!(section(&once, "b"), Some("\n\nnew\n\n"));
        assert_eq!(replaced(&once, "b", "new\n"), Some(once));
        assert_eq!(replaced(page, "d", "new"), None);
        assert_eq!(replaced("no marks", "b", "new"), None);
    }
}
