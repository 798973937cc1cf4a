//! The pages of text of the site: each document of `docs/` in one frame with contents and a
//! search, a page that lists them, and the page for addresses that lead nowhere.

mod card;
mod highlight;
mod markdown;

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use serde_json::json;

use crate::links::Base;
use crate::shell::Shell;
use highlight::escaped;
pub use markdown::anchor;
use markdown::{Document, Targets};

/// The documents that are pages, in the order of the contents.
const DOCUMENTS: [(&str, &[&str]); 4] = [
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
    ("Make", &["films", "sound", "simulation"]),
    ("Learn", &["learn", "lesson-sheet"]),
    (
        "Understand",
        &["physics", "look", "evaluation", "glossary", "about"],
    ),
];

const FRAME: &str = include_str!("pages/page.html");

/// What the site says about where it is.
#[derive(Default)]
pub(crate) struct Places<'a> {
    /// Its own address.
    pub url: Option<&'a Base>,
    /// The address of its sources.
    pub repository: Option<&'a Base>,
}

/// Writes the pages into the built site, with the files that they show.
pub(crate) fn write(root: &Path, site: &Path, places: &Places) -> Result<()> {
    let names = || DOCUMENTS.iter().flat_map(|(_, names)| *names);
    let texts = names()
        .map(|name| fs::read_to_string(root.join(format!("docs/{name}.md"))))
        .collect::<Result<Vec<_>, _>>()?;
    let documents = names()
        .zip(&texts)
        .map(|(name, text)| Document::read(name, text))
        .collect::<Result<Vec<_>>>()?;
    let targets = Targets {
        root,
        documents: &documents,
        repository: places.repository.map(Base::address),
    };
    let landing = fs::read_to_string(root.join("index.html"))?;
    let frame = Frame::new(&landing, &documents, places)?;

    let sh = Shell::new()?;
    let folder = sh.create_dir(site.join("docs"))?;
    let mut files = BTreeSet::new();
    for document in &documents {
        let page = document.render(&targets)?;
        let html = frame.page(
            "../",
            document.title(),
            document.description(),
            Some(document),
            &page.html,
        );
        sh.write_file(folder.join(format!("{}.html", document.name)), html)?;
        files.extend(page.files);
    }
    for file in files {
        let to = folder.join(&file);
        sh.create_dir(to.parent().unwrap_or(&folder))?;
        sh.copy_file(root.join("docs").join(&file), to)?;
    }
    let about = "What Hearth can do, how to put it on a page, and how it works.";
    let html = frame.page("../", "Documentation", about, None, &list(&documents));
    sh.write_file(folder.join("index.html"), html)?;
    sh.write_file(folder.join("search.json"), index(&documents))?;

    // A host shows it at every address, so its own are whole ones if the site's is known.
    let base = places.url.map_or("./", Base::address);
    let lost = format!(
        "<h1>Nothing burns here</h1>\n<p>This address leads to no page. \
         <a href=\"{base}index.html\">Hearth</a> and its \
         <a href=\"{base}docs/index.html\">documentation</a> are where they were.</p>\n"
    );
    let html = frame.page(
        base,
        "No such page",
        "This address leads to no page.",
        None,
        &lost,
    );
    sh.write_file(site.join("404.html"), html)?;
    if let Some(url) = places.url {
        sh.write_file(site.join("sitemap.xml"), map(url.address(), &documents))?;
    }
    Ok(())
}

/// What all pages have in common.
struct Frame<'a> {
    policy: &'a str,
    icon: &'a str,
    documents: &'a [Document<'a>],
    url: Option<&'a str>,
    source: String,
}

impl<'a> Frame<'a> {
    /// The policy and the icon are those of the landing page.
    fn new(
        landing: &'a str,
        documents: &'a [Document<'a>],
        places: &'a Places,
    ) -> Result<Frame<'a>> {
        let after = |start: &str| {
            let (_, rest) = landing.split_once(start)?;
            Some(rest.split_once('"')?.0)
        };
        let source = places.repository.map(|it| {
            let address = escaped(it.address());
            format!(". <a href=\"{address}\">Source</a>")
        });
        Ok(Frame {
            policy: after("\"Content-Security-Policy\" content=\"")
                .context("index.html has no policy")?,
            icon: after("<link rel=\"icon\" href=\"").context("index.html has no icon")?,
            documents,
            url: places.url.map(Base::address),
            source: source.unwrap_or_default(),
        })
    }

    /// A page whose files are found from `root`.
    fn page(
        &self,
        root: &str,
        title: &str,
        description: &str,
        open: Option<&Document>,
        content: &str,
    ) -> String {
        let cards = match content.contains("class=\"card\"") {
            true => format!("\n    <link rel=\"stylesheet\" href=\"{root}web/docs/cards.css\">"),
            false => String::new(),
        };
        let values = [
            ("title", escaped(title)),
            ("description", escaped(description)),
            ("policy", self.policy.to_owned()),
            ("icon", self.icon.to_owned()),
            ("root", root.to_owned()),
            ("cards", cards),
            ("base", self.url.unwrap_or(root).to_owned()),
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            ("source", self.source.clone()),
            ("contents", contents(root, self.documents, open)),
            ("content", content.to_owned()),
        ];
        // Every second part is a name; no text is taken for one.
        let parts = FRAME.split(['{', '}']).enumerate().map(|(at, part)| {
            let value = values.iter().find(|(name, _)| at % 2 == 1 && *name == part);
            value.map_or(part, |(_, value)| value)
        });
        parts.collect()
    }
}

/// The contents: all pages, and the headings of the one that is open.
fn contents(root: &str, documents: &[Document], open: Option<&Document>) -> String {
    let mut html = String::new();
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
    html
}

/// The list of all pages, each with its first sentence.
fn list(documents: &[Document]) -> String {
    let mut html = String::from("<h1>Documentation</h1>\n");
    for (group, names) in DOCUMENTS {
        let _ = writeln!(html, "<h2>{group}</h2>\n<dl>");
        for it in documents.iter().filter(|it| names.contains(&it.name)) {
            let (title, about) = (escaped(it.title()), escaped(it.description()));
            let _ = writeln!(
                html,
                "<dt><a href=\"{}.html\">{title}</a></dt>\n<dd>{about}</dd>",
                it.name
            );
        }
        html.push_str("</dl>\n");
    }
    html
}

/// What the search of `web/docs/` reads: each section with its page.
fn index(documents: &[Document]) -> String {
    let pages = documents.iter().map(|document| {
        let sections = document.sections.iter();
        let sections = sections.map(|it| json!([it.anchor, it.heading, it.text]));
        json!({
            "name": document.name,
            "title": document.title(),
            "sections": sections.collect::<Vec<_>>(),
        })
    });
    json!(pages.collect::<Vec<_>>()).to_string()
}

/// The addresses of all pages, for programs that search the web.
fn map(url: &str, documents: &[Document]) -> String {
    let docs = documents.iter().map(|it| it.name).chain(["index"]);
    let docs = docs.map(|name| format!("docs/{name}.html"));
    let pages = ["", "bench.html", "figures.html", "printed.html"].map(str::to_owned);
    let entries: String = pages
        .into_iter()
        .chain(docs)
        .map(|page| {
            format!(
                "<url><loc>{}</loc></url>\n",
                escaped(&format!("{url}{page}"))
            )
        })
        .collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <urlset xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n{entries}</urlset>\n"
    )
}

#[cfg(test)]
mod tests;
