//! Colours of code, put in when the site is built: `<span class="…">` around comments (`c`),
//! strings (`s`), keywords (`k`), tags (`t`), attributes (`a`) and numbers (`n`).

use std::fmt::Write as _;

/// Of JavaScript, TypeScript, Rust, JSON and shells together.
const KEYWORDS: &str = " as async await break case catch cargo class const continue default else enum export \
     extends false finally fn for from function if impl import in instanceof interface let loop match mod mut new \
     node npm npx null of pub ref return self static struct super switch this throw trait true try type typeof \
     undefined use var where while ";

/// `code` of that language as HTML; an unknown language has no colours.
pub(super) fn highlight(language: &str, code: &str) -> String {
    let mut html = String::with_capacity(2 * code.len());
    match language {
        "html" => markup(code, &mut html),
        "js" | "ts" | "tsx" | "json" => plain("//", &['"', '\'', '`'], code, &mut html),
        // A single quote begins a lifetime more often than a letter.
        "rust" => plain("//", &['"'], code, &mut html),
        "sh" => plain("#", &['"', '\''], code, &mut html),
        _ => html.push_str(&escaped(code)),
    }
    html
}

/// `text` without a character that HTML gives a meaning to, also within double quotes.
pub(super) fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}

fn span(class: &str, text: &str, html: &mut String) {
    let text = escaped(text);
    let _ = match class {
        "" => write!(html, "{text}"),
        _ => write!(html, "<span class=\"{class}\">{text}</span>"),
    };
}

/// The length of what ends with `end`, which is part of it and not among the first `skipped` bytes.
fn through(text: &str, skipped: usize, end: &str) -> usize {
    let rest = text.get(skipped..).and_then(|rest| rest.find(end));
    rest.map_or(text.len(), |length| skipped + length + end.len())
}

/// The length of the characters at the beginning of `text` that are `wanted`.
fn run(text: &str, wanted: impl Fn(char) -> bool) -> usize {
    text.find(|it| !wanted(it)).unwrap_or(text.len())
}

fn is_word(letter: char) -> bool {
    letter.is_alphanumeric() || "_$".contains(letter)
}

/// The length of the string that begins `text`, to its closing quote.
fn string(text: &str, quote: char) -> usize {
    let mut escape = false;
    let end = text.char_indices().skip(1).find(|(_, letter)| {
        let ends = *letter == quote && !escape;
        escape = *letter == '\\' && !escape;
        ends
    });
    end.map_or(text.len(), |(at, _)| at + quote.len_utf8())
}

fn plain(comment: &str, quotes: &[char], mut code: &str, html: &mut String) {
    while let Some(first) = code.chars().next() {
        let (class, length) = match first {
            _ if code.starts_with(comment) => ("c", run(code, |it| it != '\n')),
            _ if comment == "//" && code.starts_with("/*") => ("c", through(code, 2, "*/")),
            _ if quotes.contains(&first) => ("s", string(code, first)),
            '0'..='9' => ("n", run(code, |it| is_word(it) || it == '.')),
            _ if is_word(first) => {
                let length = run(code, is_word);
                let keyword = KEYWORDS.contains(&format!(" {} ", &code[..length]));
                (if keyword { "k" } else { "" }, length)
            }
            _ => ("", first.len_utf8()),
        };
        span(class, &code[..length], html);
        code = &code[length..];
    }
}

fn markup(mut code: &str, html: &mut String) {
    while !code.is_empty() {
        let text = run(code, |it| it != '<');
        span("", &code[..text], html);
        code = &code[text..];
        if code.starts_with("<!--") {
            let length = through(code, 4, "-->");
            span("c", &code[..length], html);
            code = &code[length..];
        } else if let Some(after) = code.strip_prefix('<') {
            let length = 1 + run(after, |it| is_word(it) || "/!-".contains(it));
            let name = &code[..length];
            span("t", name, html);
            code = attributes(&code[length..], html);
            if name == "<script" {
                let length = code.find("</script").unwrap_or(code.len());
                plain("//", &['"', '\'', '`'], &code[..length], html);
                code = &code[length..];
            }
        }
    }
}

/// Writes what stands in a tag behind its name, with the end of the tag; returns the rest.
fn attributes<'a>(mut tag: &'a str, html: &mut String) -> &'a str {
    while let Some(first) = tag.chars().next() {
        let (class, length) = match first {
            '>' => ("t", 1),
            '"' | '\'' => ("s", string(tag, first)),
            _ if is_word(first) => ("a", run(tag, |it| is_word(it) || "-:".contains(it))),
            _ => ("", first.len_utf8()),
        };
        span(class, &tag[..length], html);
        tag = &tag[length..];
        if first == '>' {
            break;
        }
    }
    tag
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The text that HTML of this module shows.
    fn shown(html: &str) -> String {
        let mut parts = html.split('<');
        let first = parts.next().unwrap_or_default().to_owned();
        let texts = parts.map(|part| part.split_once('>').map_or("", |(_, text)| text));
        let text = first + &texts.collect::<String>();
        let text = text.replace("&lt;", "<").replace("&gt;", ">");
        text.replace("&quot;", "\"").replace("&amp;", "&")
    }

    #[test]
    fn code_stays_what_it_is_and_only_spans_are_added() {
        for (language, code) in [
            (
                "html",
                "<!doctype html>\n<p a=\"1 < 2\" b='c'>é & <!-- x --></p><br",
            ),
            ("html", "<script>if (a < b) f('</p>') // no</script><b><"),
            ("html", "<a b=\"open\n<script>`${"),
            ("js", "const a = '\\'b'; /* é */ x$1 = 0.5e3 // \"end"),
            ("rust", "fn a<'b>(c: &'b str) { \"d\\\"\" }"),
            ("sh", "npm ci # that's all"),
            ("json", "{\"a\": [true, -1.5]}"),
            ("text", "<b> & \"c\""),
        ] {
            let html = highlight(language, code);
            assert_eq!(shown(&html), code, "{language}: {html}");
            let spans = html.matches("<span class=").count();
            assert_eq!(html.matches('<').count(), 2 * spans, "{language}: {html}");
        }
    }

    #[test]
    fn tokens_have_the_class_of_their_kind() {
        for (language, code, token) in [
            ("html", "<p id=\"x\">", "<span class=\"t\">&lt;p</span>"),
            ("html", "<p id=\"x\">", "<span class=\"a\">id</span>"),
            (
                "html",
                "<p id=\"x\">",
                "<span class=\"s\">&quot;x&quot;</span>",
            ),
            (
                "html",
                "<script>let a</script>",
                "<span class=\"k\">let</span>",
            ),
            (
                "html",
                "<!-- a -->",
                "<span class=\"c\">&lt;!-- a --&gt;</span>",
            ),
            (
                "js",
                "await letter",
                "<span class=\"k\">await</span> letter",
            ),
            ("sh", "ls # all", "<span class=\"c\"># all</span>"),
            ("rust", "let x = 1.5;", "<span class=\"n\">1.5</span>;"),
        ] {
            let html = highlight(language, code);
            assert!(html.contains(token), "{code}: {html}");
        }
    }
}
