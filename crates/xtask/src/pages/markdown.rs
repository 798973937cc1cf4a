//! A document as a page: HTML without a script, a handler or a style in it.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use pulldown_cmark::{
    Alignment, CodeBlockKind, CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html,
};

use super::card::{card, lines};
use super::highlight::{escaped, highlight};

/// A picture of more bytes is a link: no page fetches it unasked.
const LARGE: u64 = 200_000;

/// A part of a document, from its heading to the next one.
#[derive(Clone, Default, Debug)]
pub(super) struct Section {
    /// 1 for the title.
    pub level: usize,
    pub anchor: String,
    pub heading: String,
    /// What a search finds in it: no code of examples.
    pub text: String,
}

/// A document that is read.
pub(super) struct Document<'a> {
    /// The name of its file, without the end.
    pub name: &'a str,
    /// The first is that of the title.
    pub sections: Vec<Section>,
    events: Vec<Event<'a>>,
}

/// What links of a document lead to.
pub(super) struct Targets<'a> {
    /// The checkout.
    pub root: &'a Path,
    pub documents: &'a [Document<'a>],
    /// Where the files are that the site lacks; without it, their links are texts.
    pub repository: Option<&'a str>,
}

/// A document as HTML.
pub(super) struct Rendered {
    pub html: String,
    /// The files of `docs/` that the page shows.
    pub files: BTreeSet<String>,
}

/// The anchor of a heading, as GitHub makes it.
pub fn anchor(heading: &str) -> String {
    let words = heading.trim().to_lowercase();
    let kept = words.chars().filter_map(|letter| match letter {
        ' ' => Some('-'),
        '-' | '_' => Some(letter),
        letter => letter.is_alphanumeric().then_some(letter),
    });
    kept.collect()
}

impl<'a> Document<'a> {
    pub(super) fn read(name: &'a str, markdown: &'a str) -> Result<Document<'a>> {
        let events = Parser::new_ext(markdown, Options::ENABLE_TABLES).map(|event| match event {
            // The only HTML of documents besides comments.
            Event::InlineHtml(tag) if *tag == *"<br>" => Event::HardBreak,
            event => event,
        });
        let events: Vec<_> = events.collect();
        let mut sections: Vec<Section> = Vec::new();
        let (mut in_heading, mut in_code) = (false, false);
        for event in &events {
            match event {
                Event::Start(Tag::Heading { level, .. }) => {
                    in_heading = true;
                    let level = *level as usize;
                    sections.push(Section {
                        level,
                        ..Section::default()
                    });
                }
                Event::End(TagEnd::Heading(_)) => in_heading = false,
                Event::Start(Tag::CodeBlock(_)) => in_code = true,
                Event::End(TagEnd::CodeBlock) => in_code = false,
                Event::Html(tag) | Event::InlineHtml(tag) => {
                    let comment = tag.trim_start().starts_with("<!--") || !tag.contains('<');
                    ensure!(comment, "docs/{name}.md contains HTML: {}", tag.trim());
                }
                event if !in_code => {
                    let text = match event {
                        Event::Text(text) | Event::Code(text) => &**text,
                        Event::SoftBreak
                        | Event::HardBreak
                        | Event::End(TagEnd::Paragraph | TagEnd::Item | TagEnd::TableCell) => " ",
                        _ => "",
                    };
                    match sections.last_mut() {
                        Some(section) if in_heading => section.heading.push_str(text),
                        Some(section) => section.text.push_str(text),
                        None => {}
                    }
                }
                _ => {}
            }
        }
        let mut anchors = BTreeSet::new();
        for section in &mut sections {
            section.anchor = anchor(&section.heading);
            let words = section.text.split_whitespace().collect::<Vec<_>>();
            section.text = words.join(" ");
            ensure!(
                anchors.insert(section.anchor.clone()),
                "docs/{name}.md has two headings \"{}\"",
                section.heading
            );
        }
        let title = sections.first().map(|title| title.level);
        ensure!(
            title == Some(1),
            "docs/{name}.md does not begin with a title"
        );
        Ok(Document {
            name,
            sections,
            events,
        })
    }

    pub(super) fn title(&self) -> &str {
        self.sections.first().map_or("", |title| &title.heading)
    }

    /// Its first sentence.
    pub(super) fn description(&self) -> &str {
        let mut texts = self.sections.iter().map(|section| &section.text);
        let text = texts.find(|text| !text.is_empty()).map_or("", |text| text);
        text.find(". ").map_or(text, |end| &text[..=end])
    }

    pub(super) fn render(&self, targets: &Targets) -> Result<Rendered> {
        let mut page = Page {
            document: self,
            targets,
            files: BTreeSet::new(),
            section: 0,
            alignments: Vec::new(),
            in_head: false,
            column: 0,
            unlinked: false,
            file: None,
            asks: false,
        };
        let mut made: Vec<Event> = Vec::new();
        let mut events = self.events.iter();
        while let Some(event) = events.next() {
            match event {
                Event::Start(Tag::CodeBlock(kind)) => {
                    let code = text_until(&mut events, TagEnd::CodeBlock);
                    made.push(page.code(kind, &code)?);
                }
                Event::Start(Tag::Image { dest_url, .. }) => {
                    let alt = text_until(&mut events, TagEnd::Image);
                    made.push(page.image(dest_url, &alt)?);
                }
                Event::Html(_) | Event::InlineHtml(_) => {}
                event => made.push(page.event(event)?),
            }
        }
        ensure!(
            !page.asks,
            "docs/{}.md: a card has no question behind it",
            self.name
        );
        let mut rendered = String::new();
        html::push_html(&mut rendered, made.into_iter());
        // An empty header cell is no header.
        let rendered = rendered.replace("<th></th>", "<td></td>");
        let rendered = rendered.replace("<th class=\"end\"></th>", "<td></td>");
        Ok(Rendered {
            html: rendered,
            files: page.files,
        })
    }
}

/// The text of the events before that end.
fn text_until<'e>(events: &mut impl Iterator<Item = &'e Event<'e>>, end: TagEnd) -> String {
    let inner = events.take_while(|event| **event != Event::End(end));
    inner
        .filter_map(|event| match event {
            Event::Text(text) | Event::Code(text) => Some(&**text),
            Event::SoftBreak => Some(" "),
            _ => None,
        })
        .collect()
}

/// Where a link leads.
enum Target {
    Address(String),
    /// To a file that the site lacks.
    Nowhere,
}

/// What has been read of a document so far.
struct Page<'a> {
    document: &'a Document<'a>,
    targets: &'a Targets<'a>,
    files: BTreeSet<String>,
    /// The number of headings so far.
    section: usize,
    alignments: Vec<Alignment>,
    in_head: bool,
    column: usize,
    /// Within a link that leads nowhere.
    unlinked: bool,
    /// A document that the link of now leads to: its file and its title.
    file: Option<(String, String)>,
    /// Whether the next paragraph is the question of a card.
    asks: bool,
}

impl Page<'_> {
    fn event<'e>(&mut self, event: &Event<'e>) -> Result<Event<'e>> {
        let html = match event {
            Event::Start(Tag::Heading { level, .. }) => self.heading(*level),
            Event::End(TagEnd::Heading(level)) => format!("</a></{level}>\n"),
            // A quote is the answer to a question.
            Event::Start(Tag::BlockQuote(_)) => "<details><summary>Why?</summary>".to_owned(),
            Event::End(TagEnd::BlockQuote(_)) => "</details>\n".to_owned(),
            Event::End(TagEnd::Paragraph) if self.asks => {
                self.asks = false;
                format!("</p>\n{}", lines())
            }
            Event::Start(Tag::Table(alignments)) => {
                self.alignments.clone_from(alignments);
                format!("<div class=\"scroll\"{}><table>", self.scrolls("Table"))
            }
            Event::End(TagEnd::Table) => "</tbody></table></div>\n".to_owned(),
            Event::Start(Tag::TableHead) => {
                (self.in_head, self.column) = (true, 0);
                "<thead><tr>".to_owned()
            }
            Event::End(TagEnd::TableHead) => {
                self.in_head = false;
                "</tr></thead><tbody>\n".to_owned()
            }
            Event::Start(Tag::TableRow) => {
                self.column = 0;
                "<tr>".to_owned()
            }
            Event::Start(Tag::TableCell) => {
                let alignment = self.alignments.get(self.column);
                self.column += 1;
                let cell = if self.in_head { "th" } else { "td" };
                match alignment {
                    // The page's policy has no styles in attributes.
                    Some(Alignment::Right) => format!("<{cell} class=\"end\">"),
                    _ => format!("<{cell}>"),
                }
            }
            Event::End(TagEnd::TableCell) => {
                format!("</{}>", if self.in_head { "th" } else { "td" })
            }
            Event::Start(Tag::Link { dest_url, .. }) => match self.target(dest_url)? {
                Target::Address(address) => format!("<a href=\"{}\">", escaped(&address)),
                Target::Nowhere => {
                    self.unlinked = true;
                    String::new()
                }
            },
            Event::End(TagEnd::Link) if self.unlinked => {
                self.unlinked = false;
                String::new()
            }
            Event::Text(text) => {
                // Readers of a page know titles, not files.
                let title = self.file.take().filter(|(file, _)| **file == **text);
                let title = title.map(|(_, title)| Event::Text(title.into()));
                return Ok(title.unwrap_or_else(|| event.clone()));
            }
            event => return Ok(event.clone()),
        };
        Ok(Event::InlineHtml(html.into()))
    }

    /// A heading is a link to itself.
    fn heading(&mut self, level: HeadingLevel) -> String {
        let section = self.document.sections.get(self.section);
        self.section += 1;
        let anchor = section.map_or("", |section| &section.anchor);
        format!("<{level} id=\"{anchor}\"><a href=\"#{anchor}\">")
    }

    /// The attributes of what scrolls by itself: keys reach it, and it has a name.
    fn scrolls(&self, what: &str) -> String {
        let section = self.document.sections.get(self.section.saturating_sub(1));
        let heading = escaped(section.map_or("", |section| &section.heading));
        format!(" tabindex=\"0\" role=\"group\" aria-label=\"{what}: {heading}\"")
    }

    fn code(&mut self, kind: &CodeBlockKind, code: &str) -> Result<Event<'static>> {
        let info = match kind {
            CodeBlockKind::Fenced(info) => info,
            CodeBlockKind::Indented => &CowStr::Borrowed(""),
        };
        let (language, live) = info.split_once(' ').unwrap_or((info, ""));
        let colours = highlight(language, code);
        let pre = format!("<pre{}><code>{colours}</code></pre>", self.scrolls("Code"));
        let html = match live {
            "" => format!("{pre}\n"),
            "live" if language == "html" => format!("<div class=\"example\">{pre}</div>\n"),
            "card" if language == "json" => {
                self.asks = true;
                card(self.targets.root, code)
                    .with_context(|| format!("docs/{}.md", self.document.name))?
            }
            other => bail!(
                "docs/{}.md: a fence of {language} says \"{other}\"; html can be \"live\", json a \"card\"",
                self.document.name
            ),
        };
        Ok(Event::Html(html.into()))
    }

    fn image(&mut self, file: &str, alt: &str) -> Result<Event<'static>> {
        let Target::Address(address) = self.target(file)? else {
            bail!(
                "docs/{}.md shows {file}, which the site lacks",
                self.document.name
            );
        };
        let path = self.targets.root.join("docs").join(file);
        let bytes = fs::metadata(&path)?.len();
        let (address, alt) = (escaped(&address), escaped(alt));
        let mut html = String::new();
        if bytes > LARGE {
            let _ = write!(
                html,
                "<a href=\"{address}\">{alt} ({} KB)</a>",
                bytes / 1000
            );
        } else {
            let (width, height) = size(&path)?;
            let _ = write!(
                html,
                "<img src=\"{address}\" alt=\"{alt}\" width=\"{width}\" height=\"{height}\" \
                 loading=\"lazy\" decoding=\"async\">"
            );
        }
        Ok(Event::InlineHtml(html.into()))
    }

    /// Where a link of the document leads on the site. A target that does not exist is an error.
    fn target(&mut self, link: &str) -> Result<Target> {
        let name = self.document.name;
        if link.starts_with("https://") || link.starts_with("http://") {
            return Ok(Target::Address(link.to_owned()));
        }
        ensure!(
            !link.contains(':'),
            "docs/{name}.md: {link} is no address of a page"
        );
        let (file, fragment) = link.split_once('#').unwrap_or((link, ""));
        let path = match file.strip_prefix("../") {
            Some(file) => file.to_owned(),
            None if file.is_empty() => format!("docs/{name}.md"),
            None => format!("docs/{file}"),
        };
        let exists = self.targets.root.join(&path).exists();
        ensure!(exists, "docs/{name}.md: {link} leads to no file");
        let named = path
            .strip_prefix("docs/")
            .and_then(|it| it.strip_suffix(".md"));
        let documents = self.targets.documents;
        if let Some(document) = documents.iter().find(|it| Some(it.name) == named) {
            let found = document.sections.iter().any(|it| it.anchor == fragment);
            ensure!(
                found || fragment.is_empty(),
                "docs/{name}.md: {link} leads to no heading"
            );
            self.file = Some((file.to_owned(), document.title().to_owned()));
            return Ok(Target::Address(link.replacen(".md", ".html", 1)));
        }
        if let Some(shown) = path.strip_prefix("docs/").filter(|it| !it.ends_with(".md")) {
            self.files.insert(shown.to_owned());
            return Ok(Target::Address(link.to_owned()));
        }
        let page = path.ends_with(".html");
        if page && path.starts_with("web/pages/") {
            return Ok(Target::Address(link.replacen("web/pages/", "", 1)));
        }
        let of_site = path.starts_with("web/") || page && path.starts_with("examples/");
        Ok(match self.targets.repository {
            _ if of_site => Target::Address(link.to_owned()),
            Some(repository) => {
                let fragment = link.strip_prefix(file).unwrap_or_default();
                Target::Address(format!("{repository}blob/HEAD/{path}{fragment}"))
            }
            None => Target::Nowhere,
        })
    }
}

/// The width and height of a picture, in pixels.
pub(super) fn size(path: &Path) -> Result<(usize, usize)> {
    if path.extension().is_some_and(|end| end == "svg") {
        let svg = fs::read_to_string(path)?;
        let (_, rest) = svg.split_once("viewBox=\"0 0 ").unwrap_or_default();
        let (size, _) = rest.split_once('"').unwrap_or_default();
        let (width, height) = size.split_once(' ').unwrap_or_default();
        let size = width.parse().ok().zip(height.parse().ok());
        return size.with_context(|| format!("{} has no size", path.display()));
    }
    let size = imagesize::size(path).with_context(|| format!("{}", path.display()))?;
    Ok((size.width, size.height))
}
