//! `docs/evaluation.md`: measured tables between marks, `<!-- name: begin -->` and
//! `<!-- name: end -->`.

use std::fs;

use anyhow::{Context, Result};
use xtask::paths;

const PAGE: &str = "docs/evaluation.md";

/// Fails unless the page has the marks of that name: known before hours are measured.
pub(crate) fn check(name: &str) -> Result<()> {
    read(name).map(drop)
}

/// The section of that name.
pub(crate) fn read(name: &str) -> Result<String> {
    let [_, section, _] = divided(&page()?, name).with_context(|| lacks(name))?;
    Ok(section.trim().to_owned())
}

/// Replaces the section of that name.
pub(crate) fn write(name: &str, section: &str) -> Result<()> {
    let page = replaced(&page()?, name, section).with_context(|| lacks(name))?;
    fs::write(paths::root().join(PAGE), page)?;
    println!("wrote {PAGE}");
    Ok(())
}

fn page() -> Result<String> {
    fs::read_to_string(paths::root().join(PAGE)).context(PAGE)
}

fn lacks(name: &str) -> String {
    format!("{PAGE} lacks the marks `{name}`")
}

/// What is before, between and after the marks of that name, the marks themselves outside.
fn divided(page: &str, name: &str) -> Option<[String; 3]> {
    let [begin, end] = ["begin", "end"].map(|side| format!("<!-- {name}: {side} -->"));
    let (before, rest) = page.split_once(&begin)?;
    let (section, after) = rest.split_once(&end)?;
    Some([before.to_owned() + &begin, section.to_owned(), end + after])
}

/// `page` with another section between the marks of that name.
pub(crate) fn replaced(page: &str, name: &str, section: &str) -> Option<String> {
    let [before, _, after] = divided(page, name)?;
    Some(format!("{before}\n\n{section}\n{after}"))
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
        assert_eq!(replaced(&once, "b", "new\n"), Some(once));
        assert_eq!(replaced(page, "d", "new"), None);
        assert_eq!(replaced("no marks", "b", "new"), None);
    }
}
