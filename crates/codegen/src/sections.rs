//! Generated sections of documents, between marks: `<!-- name: begin -->` and `<!-- name: end -->`.

/// What is before, between and after the marks of that name, the marks themselves outside.
fn divided(page: &str, name: &str) -> Option<[String; 3]> {
    let [begin, end] = ["begin", "end"].map(|side| format!("<!-- {name}: {side} -->"));
    let (before, rest) = page.split_once(&begin)?;
    let (section, after) = rest.split_once(&end)?;
    Some([before.to_owned() + &begin, section.to_owned(), end + after])
}

/// The section of that name; `None` without its marks.
pub fn read(page: &str, name: &str) -> Option<String> {
    let [_, section, _] = divided(page, name)?;
    Some(section.trim().to_owned())
}

/// `page` with another section between the marks of that name; `None` without them.
pub fn replaced(page: &str, name: &str, section: &str) -> Option<String> {
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
        assert_eq!(read(&once, "b"), Some("new".to_owned()));
        assert_eq!(replaced(&once, "b", "new\n"), Some(once));
        assert_eq!(replaced(page, "d", "new"), None);
        assert_eq!(replaced("no marks", "b", "new"), None);
    }
}
