//! The documents that are pages, and the list of them beside each.

use std::fmt::Write as _;

use super::highlight::escaped;
use super::markdown::Document;

/// The documents that are pages, in the order of the contents.
pub(super) const DOCUMENTS: [(&str, &[&str]); 4] = [
    (
        "Use",
        &[
            "embedding",
            "recipes",
            "hosts",
            "costs",
            "element",
            "parameters",
            "scenes",
            "package",
            "iframe",
        ],
    ),
    (
        "Make",
        &["films", "worlds", "sound", "simulation", "community"],
    ),
    ("Learn", &["learn", "lesson-sheet"]),
    (
        "Understand",
        &[
            "physics",
            "look",
            "evaluation",
            "compare",
            "glossary",
            "about",
        ],
    ),
];

/// The contents: all pages, and the headings of the one that is open.
pub(super) fn contents(root: &str, documents: &[Document], open: Option<&Document>) -> String {
    let mut html = String::from(
        "<nav id=\"contents\" aria-label=\"Documentation\">\n<details>\n<summary>Contents</summary>\n",
    );
    for (group, names) in DOCUMENTS {
        let _ = writeln!(html, "<p>{group}</p>\n<ul>");
        for document in documents.iter().filter(|it| names.contains(&it.name)) {
            let (name, title) = (document.name, escaped(document.title()));
            let here = open.filter(|open| open.name == name);
            let current = here.map_or("", |_| " aria-current=\"page\"");
            let link = format!("<a href=\"{root}docs/{name}.html\"{current}>{title}</a>");
            let _ = write!(html, "<li>{link}");
            let sections = here.map_or(&[][..], |here| &here.sections).iter();
            let headings: String = sections
                .filter(|it| it.level == 2)
                .map(|it| (&it.anchor, escaped(&it.heading)))
                .map(|(anchor, heading)| format!("<li><a href=\"#{anchor}\">{heading}</a></li>\n"))
                .collect();
            if !headings.is_empty() {
                let _ = write!(html, "\n<ul>\n{headings}</ul>\n");
            }
            html.push_str("</li>\n");
        }
        html.push_str("</ul>\n");
    }
    html.push_str("</details>\n</nav>\n");
    html
}
