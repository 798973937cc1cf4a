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

#[test]
fn the_picture_shows_the_scene_that_the_page_opens_with() -> Result<()> {
    let element = "<hearth-fire id=\"fire\"";
    let html = fs::read_to_string(root().join("index.html"))?;
    let (_, fire) = html.split_once(element).context("index.html has no fire")?;
    let (_, scene) = fire
        .split_once("preset=\"")
        .context("the fire has no scene")?;
    let words = format!("Hearth: {}", scene.split('"').next().unwrap_or_default());
    let mut comment = vec![0xff, 0xfe, 0, u8::try_from(words.len() + 2)?];
    comment.extend(words.bytes());
    let picture = fs::read(root().join("web/poster.jpg"))?;
    assert!(
        picture[2..].starts_with(&comment),
        "run `cargo xtask poster` and commit the picture"
    );
    Ok(())
}
