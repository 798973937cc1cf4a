//! Previews of a link to the site. Every address in the site is relative, so that its
//! folder works anywhere; but most programs that preview a page need the absolute address
//! of its picture.
//!
//! There is no `og:url`: it would make one page of all links, and each link contains a fire
//! of its own.

use std::path::Path;
use std::str::FromStr;

use anyhow::{Result, ensure};

use crate::shell::Shell;

/// The pages that links name besides those of `pages`, and their folders.
const PAGES: [(&str, &str); 2] = [("index.html", ""), ("web/embed.html", "web/")];

/// The beginning of an address that previews read.
const RELATIVE: &str = "content=\"./";

/// The absolute address of a site, which ends in a slash.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Base(String);

impl Base {
    pub(crate) fn address(&self) -> &str {
        &self.0
    }
}

impl FromStr for Base {
    type Err = anyhow::Error;

    fn from_str(text: &str) -> Result<Base> {
        let host = ["https://", "http://"].map(|scheme| text.strip_prefix(scheme));
        let host = host.into_iter().flatten().next().unwrap_or_default();
        let allowed = |it: char| it.is_ascii_alphanumeric() || "-._~:/%[]@".contains(it);
        ensure!(
            !host.is_empty() && !host.starts_with('/') && host.chars().all(allowed),
            "it must be the address of the site's folder, as https://example.org/fire/, \
             not \"{text}\""
        );
        Ok(Base(format!("{}/", text.trim_end_matches('/'))))
    }
}

/// Makes the addresses absolute that previews read in the pages of the built site.
pub(crate) fn make_absolute(site: &Path, base: &Base) -> Result<()> {
    let sh = Shell::new()?;
    for (page, folder) in PAGES {
        let html = sh.read_file(site.join(page))?;
        ensure!(
            html.contains(RELATIVE),
            "{page} has no address for previews"
        );
        let absolute = format!("content=\"{}{folder}", base.0);
        sh.write_file(site.join(page), html.replace(RELATIVE, &absolute))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_addresses_of_folders_are_accepted() -> Result<()> {
        for (given, address) in [
            ("https://a.example", "https://a.example/"),
            ("https://a.example/fire/", "https://a.example/fire/"),
            ("http://127.0.0.1:80/a%20b", "http://127.0.0.1:80/a%20b/"),
        ] {
            assert_eq!(given.parse::<Base>()?, Base(address.to_owned()));
        }
        let refused = "a.example,/fire,ftp://a.example,https://,https:///fire,https://a.example/?x,\
                       https://a.example/#x,https://a.example/\"><script>,https://a.example/a b,";
        for given in refused.split(',') {
            assert!(given.parse::<Base>().is_err(), "{given}");
        }
        Ok(())
    }

    #[test]
    fn every_page_names_its_picture_by_an_absolute_address() -> Result<()> {
        let sh = Shell::new()?;
        let folder = sh.create_temp_dir()?;
        let site = folder.path();
        sh.create_dir(site.join("web"))?;
        for (page, _) in PAGES {
            sh.copy_file(page, site.join(page))?;
        }
        make_absolute(site, &"https://a.example/fire".parse()?)?;
        for (page, _) in PAGES {
            let html = sh.read_file(site.join(page))?;
            let image =
                "<meta property=\"og:image\" content=\"https://a.example/fire/web/poster.jpg\">";
            assert!(html.contains(image), "{page}");
            assert!(!html.contains(RELATIVE), "{page}");
        }
        // The page still works in any folder.
        let html = sh.read_file(site.join("index.html"))?;
        assert!(html.contains("src=\"./web/"));
        assert!(make_absolute(site, &"https://a.example".parse()?).is_err());
        Ok(())
    }
}
