//! Examples that burn in their page: the markup of a fence `html live`, read and written again
//! from a list of what is allowed. No example contains a script, a handler or a foreign
//! address, so the page keeps its strict policy. A style becomes `data-style`, because that
//! policy has no styles in attributes; the page's script sets it.

use std::fmt::Write as _;

use anyhow::{Context, Result, bail, ensure};

/// The elements besides `hearth-…`.
const ELEMENTS: [&str; 11] = [
    "b", "div", "em", "h1", "h2", "h3", "header", "img", "p", "span", "strong",
];
/// The attributes of these elements; those of `hearth-…` are checked by the element itself.
const ATTRIBUTES: [&str; 7] = ["alt", "height", "id", "slot", "src", "style", "width"];
/// The attributes with an address.
const ADDRESSES: [&str; 2] = ["poster", "src"];
/// What an example begins with; the page does both itself.
const BEGINNINGS: [&str; 2] = [
    "<!doctype html>",
    "<script type=\"module\" src=\"./web/hearth-fire.js\"></script>",
];

/// The markup of `example` for a page in a folder of the site.
pub(super) fn rebuilt(example: &str) -> Result<String> {
    let mut rest = example;
    for beginning in BEGINNINGS {
        rest = rest.trim_start();
        rest = rest.strip_prefix(beginning).unwrap_or(rest);
    }
    let mut html = String::new();
    let mut open = Vec::new();
    rest = rest.trim();
    while !rest.is_empty() {
        let Some(tag) = rest.strip_prefix('<') else {
            let (text, after) = rest.split_at(rest.find('<').unwrap_or(rest.len()));
            html.push_str(&text.replace('>', "&gt;"));
            rest = after;
            continue;
        };
        if let Some(closing) = tag.strip_prefix('/') {
            let (name, after) = closing.split_once('>').context("a tag has no end")?;
            ensure!(open.pop() == Some(name), "</{name}> closes another element");
            let _ = write!(html, "</{name}>");
            rest = after;
            continue;
        }
        let (name, after) = word(tag);
        let ours = name.starts_with("hearth-");
        ensure!(
            ours || ELEMENTS.contains(&name),
            "<{name}> is not allowed; allowed are hearth-…, {}",
            ELEMENTS.join(", ")
        );
        let _ = write!(html, "<{name}");
        rest = attributes(name, ours, after, &mut html)?;
        if name != "img" {
            open.push(name);
        }
    }
    ensure!(open.is_empty(), "<{}> is not closed", open.join(">, <"));
    ensure!(html.contains("<hearth-fire"), "it has no <hearth-fire>");
    Ok(html)
}

/// Writes the attributes of a tag and its end; returns what follows.
fn attributes<'a>(name: &str, ours: bool, tag: &'a str, html: &mut String) -> Result<&'a str> {
    let mut rest = tag;
    loop {
        let blank = rest.trim_start();
        if let Some(after) = blank.strip_prefix('>') {
            html.push('>');
            return Ok(after);
        }
        ensure!(blank.len() < rest.len(), "<{name}> has no end");
        let (attribute, after) = word(blank);
        let known = ours || ATTRIBUTES.contains(&attribute);
        ensure!(
            known && !attribute.is_empty() && !attribute.starts_with("on"),
            "the attribute \"{attribute}\" of <{name}> is not allowed; allowed are {}",
            ATTRIBUTES.join(", ")
        );
        rest = after;
        let Some(quoted) = after.strip_prefix("=\"") else {
            let _ = write!(html, " {attribute}");
            continue;
        };
        let (value, after) = quoted
            .split_once('"')
            .with_context(|| format!("\"{attribute}\" has no closing quote"))?;
        let (attribute, value) = allowed(attribute, value)?;
        let _ = write!(html, " {attribute}=\"{value}\"");
        rest = after;
    }
}

/// An attribute as the page gets it.
fn allowed<'a>(attribute: &'a str, value: &str) -> Result<(&'a str, String)> {
    let only = |others: &str| {
        let others = |it: char| it.is_ascii_alphanumeric() || others.contains(it);
        value.chars().all(others)
    };
    if ADDRESSES.contains(&attribute) {
        let file = value.strip_prefix("./web/").filter(|_| only("-_./"));
        match file {
            Some(file) if !file.contains("..") => return Ok((attribute, format!("../web/{file}"))),
            _ => bail!("{attribute}=\"{value}\" is no file of ./web/"),
        }
    }
    if attribute == "style" {
        ensure!(
            only(" :;,.%#-"),
            "style=\"{value}\" has more than plain values"
        );
        return Ok(("data-style", value.to_owned()));
    }
    ensure!(
        !value.contains(['<', '>', '&']) && !value.contains("//"),
        "{attribute}=\"{value}\" contains <, >, & or //"
    );
    Ok((attribute, value.to_owned()))
}

/// The name that begins `text`, and the rest.
fn word(text: &str) -> (&str, &str) {
    let is_name = |it: char| it.is_ascii_lowercase() || it.is_ascii_digit() || it == '-';
    text.split_at(text.find(|it| !is_name(it)).unwrap_or(text.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_example_is_written_again_without_what_the_page_does() -> Result<()> {
        let example = "<!doctype html>\n<script type=\"module\" src=\"./web/hearth-fire.js\"></script>\n\
                       <h1 id=\"a\">Menu</h1>\n<hearth-fire  warm poster=\"./web/poster.jpg\"\n  \
                       style=\"width: 10px\"><hearth-solid of=\"#a\"></hearth-solid></hearth-fire>\n";
        assert_eq!(
            rebuilt(example)?,
            "<h1 id=\"a\">Menu</h1>\n<hearth-fire warm poster=\"../web/poster.jpg\" \
             data-style=\"width: 10px\"><hearth-solid of=\"#a\"></hearth-solid></hearth-fire>"
        );
        Ok(())
    }

    /// Of what runs, leaves the page or is not whole, nothing is left in a page.
    #[test]
    fn what_runs_or_leaves_the_site_is_refused() {
        let fire = "<hearth-fire></hearth-fire>";
        for (part, named) in [
            ("<script>alert(1)</script>", "<script>"),
            ("<script src=\"./web/hearth-fire.js\"></script>", "<script>"),
            ("<SCRIPT>alert(1)</SCRIPT>", "<>"),
            ("<scr<script>ipt>", "<scr>"),
            ("<style>p { color: red }</style>", "<style>"),
            ("<iframe src=\"./web/embed.html\"></iframe>", "<iframe>"),
            ("<svg></svg>", "<svg>"),
            ("<a href=\"javascript:alert(1)\">x</a>", "<a>"),
            ("<base href=\"./web/\">", "<base>"),
            ("<link rel=\"x\">", "<link>"),
            ("<meta>", "<meta>"),
            ("<object></object>", "<object>"),
            ("<template></template>", "<template>"),
            ("<!-- --><p>", "<>"),
            ("<p onclick=\"f()\">x</p>", "onclick"),
            ("<hearth-fire onready=\"f()\"></hearth-fire>", "onready"),
            ("<hearth-fire Onready=\"f()\"></hearth-fire>", "\"\""),
            ("<hearth-fire/onready=\"f()\"></hearth-fire>", "no end"),
            ("<p class=\"x\">x</p>", "class"),
            ("<img srcset=\"./web/poster.jpg\">", "srcset"),
            ("<img src=\"https://a.example/x.jpg\">", "https://a.example"),
            ("<img src=\"//a.example/x.jpg\">", "//a.example"),
            ("<img src=\"./web/../../x.jpg\">", "../../x.jpg"),
            ("<img src=\"data:image/png,\">", "data:"),
            ("<img src=\"&#47;&#47;a.example\">", "&#47;"),
            ("<img src='./web/poster.jpg'>", "no end"),
            ("<img src=./web/poster.jpg>", "no end"),
            (
                "<hearth-fire src=\"https://a.example\"></hearth-fire>",
                "https",
            ),
            (
                "<hearth-fire poster=\"//a.example\"></hearth-fire>",
                "//a.example",
            ),
            (
                "<hearth-fire any=\"https://a.example\"></hearth-fire>",
                "//",
            ),
            ("<p style=\"background: url(x)\">x</p>", "url(x)"),
            ("<p style=\"color: \\72 ed\">x</p>", "plain values"),
            ("<p id=\"&lt;\">x</p>", "&lt;"),
            ("<p>", "<p>"),
            ("</p>", "</p>"),
            ("<p></b>", "</b>"),
            ("<p", "no end"),
            ("<p id", "no end"),
            ("<p id=\"x", "no closing quote"),
            ("</p", "no end"),
            ("<", "<>"),
        ] {
            for example in [format!("{fire}{part}"), format!("{part}{fire}")] {
                let refused = rebuilt(&example).err().map(|why| format!("{why:#}"));
                assert!(refused.is_some(), "{example} is accepted");
            }
            let refused = rebuilt(&format!("{fire}{part}")).err();
            let why = refused.map(|why| format!("{why:#}")).unwrap_or_default();
            assert!(why.contains(named), "{part}: {why}");
        }
        assert!(rebuilt("<p>No fire</p>").is_err());
    }
}
