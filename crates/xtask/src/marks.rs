//! Places in a document that a command writes.

/// `page` with what stands between the marks of that name replaced; `None`
/// without marks. Marks are comments: `<!-- name: begin -->` and
/// `<!-- name: end -->`.
pub fn with(page: &str, name: &str, written: &str) -> Option<String> {
    let (begin, end) = (
        format!("<!-- {name}: begin -->"),
        format!("<!-- {name}: end -->"),
    );
    let (before, rest) = page.split_once(&begin)?;
    let (_, after) = rest.split_once(&end)?;
    Some(format!("{before}{begin}\n\n{written}\n{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_stands_between_the_marks_is_replaced() {
        let page = "a\n<!-- b: begin -->\nold\n<!-- b: end -->\nc <!-- d: begin --> d";
        let once = with(page, "b", "new\n").unwrap_or_default();
        assert_eq!(
            once,
            "a\n<!-- b: begin -->\n\nnew\n\n<!-- b: end -->\nc <!-- d: begin --> d"
        );
        assert_eq!(with(&once, "b", "new\n"), Some(once));
        assert_eq!(with(page, "d", "new"), None);
        assert_eq!(with("no marks", "b", "new"), None);
    }
}
