use std::collections::BTreeMap;
use std::path::PathBuf;

use super::frame::HEAD;
use super::*;
use crate::paths;

/// The text files of a site with these places, by name.
fn built(places: &Places) -> Result<BTreeMap<String, String>> {
    let sh = Shell::new()?;
    let folder = sh.create_temp_dir()?;
    write(&paths::root(), folder.path(), places)?;
    let mut files = BTreeMap::new();
    for below in ["", "docs", "community"] {
        for path in sh.read_dir(folder.path().join(below))? {
            let name = path.strip_prefix(folder.path())?.display().to_string();
            if path.is_file() {
                files.insert(name, String::from_utf8_lossy(&fs::read(path)?).into_owned());
            }
        }
    }
    Ok(files)
}

fn tags(html: &str) -> impl Iterator<Item = &str> {
    let tags = html.split('<').skip(1);
    tags.filter_map(|tag| Some(tag.split_once('>')?.0))
}

/// The values of an attribute.
fn values<'a>(html: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    let starts = tags(html).filter_map(|tag| Some(tag.split_once(&start)?.1));
    starts
        .filter_map(|rest| Some(rest.split_once('"')?.0))
        .collect()
}

fn addresses() -> Result<(Base, Base)> {
    Ok((
        "https://a.example/fire".parse()?,
        "https://b.example/source".parse()?,
    ))
}

#[test]
fn every_document_is_a_page() -> Result<()> {
    let listed: BTreeSet<_> = DOCUMENTS.iter().flat_map(|(_, names)| *names).collect();
    for entry in fs::read_dir(paths::root().join("docs"))? {
        let name = PathBuf::from(entry?.file_name());
        if let Some(name) = name.to_string_lossy().strip_suffix(".md") {
            assert!(listed.contains(&name), "docs/{name}.md is no page");
        }
    }
    Ok(())
}

#[test]
fn every_link_of_the_pages_leads_to_a_file_and_a_heading() -> Result<()> {
    let (url, repository) = addresses()?;
    let whole = Places {
        url: Some(&url),
        repository: Some(&repository),
    };
    for places in [Places::default(), whole] {
        let files = built(&places)?;
        for (name, html) in files.iter().filter(|(name, _)| name.ends_with(".html")) {
            let links = ["href", "src"]
                .map(|attribute| values(html, attribute))
                .concat();
            assert!(links.len() > 8, "{name}");
            for link in links
                .into_iter()
                .filter(|it| !it.starts_with("http") && !it.starts_with("data:"))
            {
                let (file, fragment) = link.split_once('#').unwrap_or((link, ""));
                let file = file.split('?').next().unwrap_or_default();
                let path = match (name.strip_prefix("docs/"), file.strip_prefix("../")) {
                    (_, Some(file)) => file.to_owned(),
                    (Some(_), _) if !file.is_empty() => format!("docs/{file}"),
                    _ if file.is_empty() => name.clone(),
                    _ => file.trim_start_matches("./").to_owned(),
                };
                // The build writes it with the site.
                let exists = path == "web/THIRD-PARTY.txt"
                    || files.contains_key(&path)
                    || paths::root().join(&path).is_file();
                assert!(exists, "{name}: {link}");
                let target = files.get(&path).filter(|_| !fragment.is_empty());
                if let Some(target) = target {
                    assert!(values(target, "id").contains(&fragment), "{name}: {link}");
                }
            }
        }
    }
    Ok(())
}

#[test]
fn no_page_has_a_script_a_handler_or_a_style_of_its_own() -> Result<()> {
    let landing = fs::read_to_string(paths::root().join("index.html"))?;
    let mut examples = 0;
    for (name, html) in built(&Places::default())? {
        if !name.ends_with(".html") {
            continue;
        }
        let (_, policy) = html.split_once("-Security-Policy\" ").unwrap_or_default();
        let policy = policy.lines().next().unwrap_or_default();
        // The page of measurements counts memory in a frame of the site.
        let policy = match name.as_str() {
            "bench.html" => policy.replace("frame-src 'self'; ", ""),
            _ => policy.to_owned(),
        };
        assert!(
            policy.contains("default-src 'none'") && landing.contains(&policy),
            "{name}"
        );
        let files = html.matches("<script type=\"module\" src=\"").count();
        assert!(
            files == html.matches("<script").count() && files <= 2,
            "{name}"
        );
        assert!(
            !html.contains(" style=\"") && !html.contains("<style"),
            "{name}"
        );
        for tag in tags(&html) {
            // Every second part is a value.
            let names = tag.split('"').step_by(2).collect::<String>();
            assert!(!names.contains(" on"), "{name}: <{tag}>");
        }
        let ids = values(&html, "id");
        let once: BTreeSet<_> = ids.iter().collect();
        assert_eq!(ids.len(), once.len(), "{name}: {ids:?}");
        assert_eq!(html.matches("<h1").count(), 1, "{name}");
        examples += html.matches("<div class=\"example\">").count();
    }
    assert!(examples >= 3, "{examples} examples burn");
    Ok(())
}

#[test]
fn pages_name_the_site_and_its_sources_only_where_they_are_known() -> Result<()> {
    let (url, repository) = addresses()?;
    let without = built(&Places::default())?;
    let with = built(&Places {
        url: Some(&url),
        repository: Some(&repository),
    })?;
    assert!(!without.contains_key("sitemap.xml"));
    let map = &with["sitemap.xml"];
    for page in ["docs/physics", "gallery", "bench"] {
        assert!(map.contains(&format!("<loc>https://a.example/fire/{page}.html</loc>")));
    }
    let page = "docs/physics.html";
    let picture = "content=\"https://a.example/fire/web/poster.jpg\"";
    assert!(with[page].contains(picture) && !without[page].contains("a.example"));
    let source = "https://b.example/source/blob/HEAD/docs/decisions/core.md";
    assert!(with.values().any(|html| html.contains(source)));
    assert!(with[page].contains(">Source</a>") && !without[page].contains(">Source</a>"));
    // A host shows this page at addresses in any folder.
    let lost = &with["404.html"];
    assert!(lost.contains("href=\"https://a.example/fire/web/docs/main.css\""));
    Ok(())
}

#[test]
fn every_page_has_the_head_and_marks_itself_there() -> Result<()> {
    let files = built(&Places::default())?;
    for (name, html) in files.iter().filter(|(name, _)| name.ends_with(".html")) {
        let root = if name.contains('/') { "../" } else { "./" };
        for (file, text) in HEAD {
            let link = format!("<a href=\"{root}{file}\"");
            let current = if file == name {
                " aria-current=\"page\""
            } else {
                ""
            };
            assert!(
                html.contains(&format!("{link}{current}>{text}</a>")),
                "{name}: {file}"
            );
        }
        assert_eq!(
            html.contains("id=\"contents\""),
            name.contains('/') || name == "404.html",
            "{name}"
        );
    }
    Ok(())
}

#[test]
fn a_measured_section_stands_in_one_document() -> Result<()> {
    let files = built(&Places::default())?;
    for (page, text) in [
        ("look", "roll-off of its spectrum"),
        ("evaluation", "salva2d DFSPH"),
    ] {
        assert!(files[&format!("docs/{page}.html")].contains(text), "{page}");
        assert!(files["docs/compare.html"].contains(text), "{page}");
    }
    let root = paths::root();
    for (line, named) in [
        ("<!-- look.md: nothing -->", "nothing"),
        ("<!-- none.md: a -->", "none.md"),
    ] {
        let why = with_sections(&root, line)
            .err()
            .map(|why| format!("{why:#}"));
        assert!(why.is_some_and(|why| why.contains(named)), "{line}");
    }
    Ok(())
}

#[test]
fn a_card_of_each_scene_leads_to_it_and_shows_its_texts_as_words() -> Result<()> {
    let files = built(&Places::default())?;
    let html = &files["gallery.html"];
    let cards: Vec<_> = html.split("<li class=\"card ").skip(1).collect();
    let (presets, given) = (
        codegen::scenes(&paths::root())?,
        codegen::community(&paths::root())?,
    );
    assert_eq!(cards.len(), presets.len() + given.len());
    for preset in presets {
        for query in ["", "&amp;open=panel", "&amp;open=save"] {
            let link = format!("href=\"./index.html?scene={}{query}\"", preset.name);
            assert!(html.contains(&link), "{link}");
        }
    }
    for scene in given {
        assert!(
            files.contains_key(&format!("community/{}.json", scene.name)),
            "{}",
            scene.name
        );
        let author = scene
            .credit
            .map(|[author, _]| escaped(&author))
            .unwrap_or_default();
        assert!(html.contains(&format!("<h2>{}</h2>", escaped(&scene.label))));
        assert!(html.contains(&format!("By {author}.")));
    }
    Ok(())
}

/// Reads a document with one heading, and renders it.
fn rendered(text: &str) -> Result<String> {
    let markdown = format!("# Title\n\n{text}");
    let document = [Document::read("about", &markdown)?];
    let root = paths::root();
    let targets = Targets {
        root: &root,
        documents: &document,
        repository: None,
    };
    Ok(document[0].render(&targets)?.html)
}

#[test]
fn what_a_page_cannot_show_is_refused_with_its_document() {
    for (text, named) in [
        ("a <script>alert(1)</script>", "<script>"),
        ("<div onclick=\"f()\">\n", "<div"),
        ("<img src=x>", "<img"),
        ("[a](nothing.md)", "nothing.md"),
        ("[a](#nothing)", "#nothing"),
        ("[a](javascript:alert(1))", "javascript"),
        ("[a](data:text/html,x)", "data:"),
        ("![a](nothing.jpg)", "nothing.jpg"),
        ("## Twice\n\n## Twice", "Twice"),
        ("```js live\n1\n```", "live"),
        ("```html burning\n```", "burning"),
        ("```json card\n{\"scene\": \"nothing\"}\n```", "nothing.jpg"),
        ("```json card\n{}\n```", "scene"),
        ("```json card\n{\"scene\": \"candle\"}\n```", "question"),
    ] {
        let why = rendered(text).err().map(|why| format!("{why:#}"));
        let why = why.unwrap_or_default();
        assert!(
            why.contains("docs/about.md") && why.contains(named),
            "{text}: {why}"
        );
    }
}

#[test]
fn markdown_becomes_html_for_a_strict_policy() -> Result<()> {
    for (text, html) in [
        ("<!-- mark -->\ntext", "<p>text</p>"),
        ("a & `<b>`", "<p>a &amp; <code>&lt;b&gt;</code></p>"),
        ("[a](#title)", "<a href=\"#title\">a</a>"),
        ("[a](../Cargo.toml) b", "<p>a b</p>"),
        (
            "[about.md](about.md#title)",
            "<a href=\"about.html#title\">Title</a>",
        ),
        (
            "[a](../web/pages/figures.html#figure-1)",
            "<a href=\"../figures.html#figure-1\">a</a>",
        ),
        (
            "## B `c`!",
            "<h2 id=\"b-c\"><a href=\"#b-c\">B <code>c</code>!</a></h2>",
        ),
        (
            "| a | |\n|--:|---|\n| 1 | 2 |",
            "<tr><td class=\"end\">1</td><td>2</td></tr>",
        ),
        ("| a | |\n|--:|---|", "<th class=\"end\">a</th><td></td>"),
        ("```html\n<p>\n```", "<span class=\"t\">&lt;p</span>"),
        ("> a", "<details><summary>Why?</summary>"),
        (
            "```json card\n{\"scene\": \"candle\"}\n```\n\nWhich?",
            "data-card=\"{&quot;scene&quot;:&quot;candle&quot;}\"",
        ),
    ] {
        let rendered = rendered(text)?;
        assert!(rendered.contains(html), "{text}: {rendered}");
    }
    Ok(())
}

#[test]
fn a_card_is_followed_by_its_question_the_lines_for_it_and_the_answer() -> Result<()> {
    let files = built(&Places::default())?;
    let html = &files["docs/learn.html"];
    let marks = ["data-card", "Question.", "class=\"lines\"", "<summary>Why?"];
    let mut all: Vec<_> = marks
        .iter()
        .flat_map(|mark| html.match_indices(mark))
        .collect();
    all.sort_unstable();
    let order: Vec<_> = all.into_iter().map(|(_, mark)| mark).collect();
    assert_eq!(order, marks.repeat(6));
    Ok(())
}
