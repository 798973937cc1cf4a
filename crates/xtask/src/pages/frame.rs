//! What all pages have in common: policy, head, search and foot.

use std::fmt::Write as _;

use anyhow::{Context, Result};

use super::highlight::escaped;
use super::markdown::Document;
use crate::links::Base;

/// The head of every page: the file, from the folder of the site, and its name there.
pub(super) const HEAD: [(&str, &str); 5] = [
    ("index.html", "Fire"),
    ("gallery.html", "Gallery"),
    ("docs/learn.html", "Learn"),
    ("docs/index.html", "Docs"),
    ("docs/about.html", "About"),
];

const FRAME: &str = include_str!("page.html");

/// What the site says about where it is.
#[derive(Default)]
pub(crate) struct Places<'a> {
    /// Its own address.
    pub url: Option<&'a Base>,
    /// The address of its sources.
    pub repository: Option<&'a Base>,
}

/// A page whose text is `web/pages/NAME.html`: a title, a paragraph that describes it, and the rest.
pub(super) struct Source {
    pub(super) name: &'static str,
    /// Its script and its style sheets below `web/`, without their ends.
    pub(super) script: &'static str,
    pub(super) styles: &'static [&'static str],
    /// Whether it shows frames of the site.
    pub(super) has_frames: bool,
}

/// What all pages have in common.
pub(super) struct Frame<'a> {
    policy: &'a str,
    icon: &'a str,
    documents: &'a [Document<'a>],
    url: Option<&'a str>,
    source: String,
}

/// A page without its frame.
pub(super) struct Content<'a> {
    /// From where its files are found.
    pub(super) root: &'a str,
    /// Its own file, from the folder of the site.
    pub(super) file: &'a str,
    /// HTML, as the description.
    pub(super) title: &'a str,
    pub(super) description: &'a str,
    pub(super) place: Place<'a>,
    pub(super) html: &'a str,
}

/// Where a page is.
pub(super) enum Place<'a> {
    /// Among the documents, one of which may be open.
    Documentation(Option<&'a Document<'a>>),
    Site(&'a Source),
}

impl<'a> Frame<'a> {
    /// The policy and the icon are those of the landing page.
    pub(super) fn new(
        landing: &'a str,
        documents: &'a [Document<'a>],
        places: &'a Places,
    ) -> Result<Frame<'a>> {
        let after = |start: &str| between(landing, start, "\"");
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

    /// A page in its frame.
    pub(super) fn page(&self, content: &Content) -> String {
        let root = content.root;
        let mut policy = self.policy.to_owned();
        let (mut files, mut contents) = (String::new(), String::new());
        match content.place {
            Place::Documentation(open) => {
                contents = super::contents::contents(root, self.documents, open);
                if content.html.contains("class=\"card\"") {
                    files = format!("<link rel=\"stylesheet\" href=\"{root}web/docs/cards.css\">");
                }
            }
            Place::Site(source) => {
                if source.has_frames {
                    policy = policy.replace("style-src", "frame-src 'self'; style-src");
                }
                for style in source.styles {
                    let _ = write!(
                        files,
                        "<link rel=\"stylesheet\" href=\"{root}web/{style}.css\">\n    "
                    );
                }
                let script = source.script;
                let _ = write!(
                    files,
                    "<script type=\"module\" src=\"{root}web/{script}.js\"></script>\n    "
                );
            }
        }
        let values = [
            ("title", content.title.to_owned()),
            ("description", content.description.to_owned()),
            ("policy", policy),
            ("icon", self.icon.to_owned()),
            ("root", root.to_owned()),
            ("base", self.url.unwrap_or(root).to_owned()),
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            ("source", self.source.clone()),
            ("head", head(root, content.file)),
            ("files", files),
            ("contents", contents),
            ("content", content.html.to_owned()),
        ];
        // Every second part is a name; no text is taken for one.
        let parts = FRAME.split(['{', '}']).enumerate().map(|(at, part)| {
            let value = values.iter().find(|(name, _)| at % 2 == 1 && *name == part);
            value.map_or(part, |(_, value)| value)
        });
        parts.collect()
    }
}

/// The links of the head.
fn head(root: &str, open: &str) -> String {
    let links = HEAD.iter().map(|(file, name)| {
        let current = if *file == open {
            " aria-current=\"page\""
        } else {
            ""
        };
        format!("<li><a href=\"{root}{file}\"{current}>{name}</a></li>")
    });
    links.collect()
}

/// What stands between two marks.
pub(super) fn between<'t>(text: &'t str, start: &str, end: &str) -> Option<&'t str> {
    let (_, rest) = text.split_once(start)?;
    Some(rest.split_once(end)?.0)
}
