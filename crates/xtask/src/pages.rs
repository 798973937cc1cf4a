//! The pages of the site beside the landing page, in one frame with a head and a search: each document of `docs/` with
//! contents, a page that lists them, those of `web/pages/`, and the page for addresses that lead nowhere.

mod card;
mod contents;
mod frame;
mod gallery;
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
use contents::DOCUMENTS;
pub(crate) use frame::Places;
use frame::{Content, Frame, Place, Source, between};
use highlight::escaped;
pub use markdown::anchor;
use markdown::{Document, Targets};

const PAGES: [Source; 4] = [
    Source {
        name: "gallery",
        script: "pages/gallery",
        styles: &["pages/gallery"],
        has_frames: false,
    },
    Source {
        name: "figures",
        script: "paper/figures/main",
        styles: &["paper/main", "paper/figures/main"],
        has_frames: false,
    },
    Source {
        name: "printed",
        script: "paper/printed/main",
        styles: &["paper/main"],
        has_frames: false,
    },
    Source {
        name: "bench",
        script: "paper/bench/main",
        styles: &["paper/main", "paper/bench/main"],
        has_frames: true,
    },
];

/// Writes the pages into the built site, with the files that they show.
pub(crate) fn write(root: &Path, site: &Path, places: &Places) -> Result<()> {
    let names = || DOCUMENTS.iter().flat_map(|(_, names)| *names);
    let texts = names()
        .map(|name| {
            with_sections(
                root,
                &fs::read_to_string(root.join(format!("docs/{name}.md")))?,
            )
        })
        .collect::<Result<Vec<_>>>()?;
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
        let html = frame.page(&Content {
            root: "../",
            file: &format!("docs/{}.html", document.name),
            title: &escaped(document.title()),
            description: &escaped(document.description()),
            place: Place::Documentation(Some(document)),
            html: &page.html,
        });
        sh.write_file(folder.join(format!("{}.html", document.name)), html)?;
        files.extend(page.files);
    }
    for file in files {
        let to = folder.join(&file);
        sh.create_dir(to.parent().unwrap_or(&folder))?;
        sh.copy_file(root.join("docs").join(&file), to)?;
    }
    let html = frame.page(&Content {
        root: "../",
        file: "docs/index.html",
        title: "Documentation",
        description: "What Hearth can do, how to put it on a page, and how it works.",
        place: Place::Documentation(None),
        html: &list(&documents),
    });
    sh.write_file(folder.join("index.html"), html)?;
    sh.write_file(folder.join("search.json"), index(&documents))?;

    for source in &PAGES {
        let (name, file) = (source.name, format!("{}.html", source.name));
        let text = fs::read_to_string(root.join("web/pages").join(&file))?;
        let text = match name {
            "gallery" => text.replace("<!-- cards -->\n", &gallery::cards(root, site)?),
            _ => text,
        };
        let part = |start, end| {
            between(&text, start, end).with_context(|| format!("{file} has no {start}"))
        };
        let html = frame.page(&Content {
            root: "./",
            file: &file,
            title: part("<h1>", "</h1>")?,
            description: part("<p>", "</p>")?,
            place: Place::Site(source),
            html: &text,
        });
        sh.write_file(site.join(&file), html)?;
        // The site has it with its frame alone.
        sh.remove_path(site.join("web/pages").join(&file))?;
    }

    // A host shows it at every address, so its own are whole ones if the site's is known.
    let base = places.url.map_or("./", Base::address);
    let lost = format!(
        "<h1>Nothing burns here</h1>\n<p>This address leads to no page. \
         <a href=\"{base}index.html\">Hearth</a> and its \
         <a href=\"{base}docs/index.html\">documentation</a> are where they were.</p>\n"
    );
    let html = frame.page(&Content {
        root: base,
        file: "404.html",
        title: "No such page",
        description: "This address leads to no page.",
        place: Place::Documentation(None),
        html: &lost,
    });
    sh.write_file(site.join("404.html"), html)?;
    if let Some(url) = places.url {
        sh.write_file(site.join("sitemap.xml"), map(url.address(), &documents))?;
    }
    Ok(())
}

/// A document with the measured sections that its comments name, as `<!-- look.md: filmed -->`: a table of a command
/// stands in one document.
fn with_sections(root: &Path, text: &str) -> Result<String> {
    let mut whole = String::with_capacity(text.len());
    for line in text.lines() {
        let named = between(line, "<!-- ", " -->").and_then(|it| it.split_once(".md: "));
        if let Some((document, section)) = named {
            let file = format!("docs/{document}.md");
            let text = fs::read_to_string(root.join(&file)).with_context(|| file.clone())?;
            let (begin, end) = (
                format!("<!-- {section}: begin -->"),
                format!("<!-- {section}: end -->"),
            );
            let found = between(&text, &begin, &end);
            whole.push_str(found.with_context(|| format!("{file} has no section {section}"))?);
        } else {
            whole.push_str(line);
        }
        whole.push('\n');
    }
    Ok(whole)
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
    let pages = PAGES.iter().map(|source| format!("{}.html", source.name));
    let entries: String = std::iter::once(String::new())
        .chain(pages)
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
