//! The picture that previews of a link to the page show.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The rest of `index.html` after `start`, up to the next quote.
fn quoted_after(start: &str) -> Result<String> {
    let html = fs::read_to_string(root().join("index.html"))?;
    let (_, rest) = html.split_once(start).context("index.html lacks it")?;
    Ok(rest.split('"').next().unwrap_or_default().to_owned())
}

#[test]
fn the_picture_is_small_and_has_the_size_that_the_page_names() -> Result<()> {
    let picture = fs::read(root().join("web/poster.jpg"))?;
    assert!(picture.len() < 60_000, "{} bytes", picture.len());
    let size = imagesize::blob_size(&picture)?;
    for (name, pixels) in [("width", size.width), ("height", size.height)] {
        let named = quoted_after(&format!("\"og:image:{name}\" content=\""))?;
        assert_eq!(named, pixels.to_string());
    }
    Ok(())
}
