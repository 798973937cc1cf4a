//! What others show of a link to the site. Every address in the site is relative,
//! so that its folder works anywhere; but most programs that read a page for its
//! title and picture want to be told the picture's whole address.
//!
//! There is no `og:url`: it would make one page of all links, and each link holds
//! a fire of its own.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};

use crate::paths;

/// The pages that may be linked to, and where each lies.
const PAGES: [(&str, &str); 2] = [("index.html", ""), ("web/embed.html", "web/")];

/// The beginning of an address that is told to other programs.
const RELATIVE: &str = "content=\"./";

/// The whole address of a site, which ends in a slash.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Base(String);

impl Base {
    /// Reads an address that a person has typed.
    ///
    /// # Errors
    /// It is no address of a folder on the web.
    pub fn parse(text: &str) -> Result<Base> {
        let host = ["https://", "http://"]
            .iter()
            .find_map(|scheme| text.strip_prefix(scheme));
        let allowed =
            |letter: char| letter.is_ascii_alphanumeric() || "-._~:/%[]@".contains(letter);
        match host {
            Some(host)
                if !host.is_empty() && !host.starts_with('/') && host.chars().all(allowed) =>
            {
                Ok(Base(format!("{}/", text.trim_end_matches('/'))))
            }
            _ => bail!(
                "--url wants the address that the site will have, as https://example.org/fire/, \
                 not \"{text}\""
            ),
        }
    }
}

/// Makes the addresses whole that the pages of the built site tell others.
///
/// # Errors
/// A page that is not there, or that tells none.
pub fn make_whole(site: &Path, base: &Base) -> Result<()> {
    for (page, folder) in PAGES {
        let path = site.join(page);
        let html = fs::read_to_string(&path)
            .with_context(|| format!("cannot read {}", paths::shown(&path)))?;
        if !html.contains(RELATIVE) {
            bail!("{page} tells others no address");
        }
        let whole = format!("content=\"{}{folder}", base.0);
        fs::write(&path, html.replace(RELATIVE, &whole))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_of_folders_are_taken() -> Result<()> {
        for (typed, meant) in [
            ("https://a.example", "https://a.example/"),
            ("https://a.example/fire/", "https://a.example/fire/"),
            (
                "http://127.0.0.1:8080/a%20b",
                "http://127.0.0.1:8080/a%20b/",
            ),
        ] {
            assert_eq!(Base::parse(typed)?, Base(meant.to_owned()));
        }
        Ok(())
    }

    #[test]
    fn what_is_no_address_of_a_folder_is_refused() {
        for typed in [
            "",
            "a.example",
            "/fire",
            "ftp://a.example",
            "https://",
            "https:///fire",
            "https://a.example/?x",
            "https://a.example/#x",
            "https://a.example/\"><script>",
            "https://a.example/a b",
        ] {
            let said = Base::parse(typed).err().map(|error| error.to_string());
            assert!(
                said.is_some_and(|said| said.contains("--url wants")),
                "{typed}"
            );
        }
    }

    #[test]
    fn every_page_tells_a_whole_address_then() -> Result<()> {
        let site = std::env::temp_dir().join(format!("hearth-links-{}", std::process::id()));
        fs::create_dir_all(site.join("web"))?;
        for (page, _) in PAGES {
            fs::copy(paths::root().join(page), site.join(page))?;
        }
        make_whole(&site, &Base::parse("https://a.example/fire")?)?;
        for (page, _) in PAGES {
            let html = fs::read_to_string(site.join(page))?;
            let image =
                "<meta property=\"og:image\" content=\"https://a.example/fire/web/poster.jpg\">";
            assert!(html.contains(image), "{page}");
            assert!(!html.contains(RELATIVE), "{page}");
        }
        // The pages themselves work in any folder all the same.
        let page = fs::read_to_string(site.join("index.html"))?;
        assert!(page.contains("src=\"./web/pages/main.js\""));
        assert!(make_whole(&site, &Base::parse("https://a.example")?).is_err());
        fs::remove_dir_all(site)?;
        Ok(())
    }

    #[test]
    fn the_picture_is_a_small_one_of_the_size_that_is_told() -> Result<()> {
        let picture = fs::read(paths::root().join("web").join("poster.jpg"))?;
        assert!(picture.len() < 60_000, "{} bytes", picture.len());
        let told = |name: &str| -> Result<usize> {
            let html = fs::read_to_string(paths::root().join("index.html"))?;
            let start = format!("\"og:image:{name}\" content=\"");
            let (_, rest) = html.split_once(&start).context("no size is told")?;
            Ok(rest.split('"').next().unwrap_or_default().parse()?)
        };
        assert_eq!(size(&picture), Some((told("width")?, told("height")?)));
        Ok(())
    }

    #[test]
    fn the_picture_shows_the_scene_that_the_page_opens_with() -> Result<()> {
        let html = fs::read_to_string(paths::root().join("index.html"))?;
        let (_, fire) = html
            .split_once("<hearth-fire id=\"fire\"")
            .context("no fire")?;
        let (_, rest) = fire.split_once("preset=\"").context("no scene")?;
        let scene = rest.split('"').next().unwrap_or_default();
        let picture = fs::read(paths::root().join("web").join("poster.jpg"))?;
        let words = format!("Hearth: {scene}");
        let mut comment = vec![0xff, 0xfe, 0, u8::try_from(words.len() + 2)?];
        comment.extend(words.bytes());
        assert_eq!(
            picture.get(2..2 + comment.len()),
            Some(comment.as_slice()),
            "run `cargo xtask poster` and commit what it takes"
        );
        Ok(())
    }

    /// Width and height of a JPEG, from the head of its frame.
    fn size(jpeg: &[u8]) -> Option<(usize, usize)> {
        let number =
            |at: usize| Some(usize::from(*jpeg.get(at)?) * 256 + usize::from(*jpeg.get(at + 1)?));
        let mut at = 2;
        while *jpeg.get(at)? == 0xff {
            let kind = *jpeg.get(at + 1)?;
            if matches!(kind, 0xc0..=0xc2) {
                return Some((number(at + 7)?, number(at + 5)?));
            }
            at += 2 + number(at + 2)?;
        }
        None
    }
}
