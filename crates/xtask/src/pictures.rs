//! Pictures of fires, drawn natively by scripts of `tests/look`: `cargo xtask poster`,
//! `thumbnails` and `showcase`. The same scene gives the same picture; a changed scene or renderer
//! needs new ones.

use std::fs;

use anyhow::{Result, ensure};
use xshell::cmd;

use crate::shell::Shell;
use crate::{goldens, paths, tools};

/// Largest animation \[bytes\].
const LARGEST: u64 = 2_000_000;
/// Frames a second of the animation.
const RATE: u32 = 20;

/// Takes `web/poster.jpg`, which a link to the page shows, and the page while its fire
/// loads: a moment of the scene that the page opens with.
pub(crate) fn poster() -> Result<()> {
    let poster = paths::root().join("web/poster.jpg");
    goldens::run_script("poster.mjs", [poster], Some(tools::CJPEG.variable()?))
}

/// Takes `web/scenes/NAME.jpg` of these scenes, or of all of them, and the picture beside each file of the community. One is also the picture of
/// the crate `hearth-fire`.
pub(crate) fn thumbnails(names: &[String]) -> Result<()> {
    let folder = paths::root().join("web/scenes");
    let arguments = std::iter::once(folder).chain(names.iter().map(Into::into));
    goldens::run_script("thumbnails.mjs", arguments, Some(tools::CJPEG.variable()?))?;
    Ok(Shell::new()?.copy_file("web/scenes/fireside.jpg", "crates/hearth-fire/fire.jpg")?)
}

/// Takes `docs/fire.webp`, five seconds of the scene that the page opens with.
pub(crate) fn showcase() -> Result<()> {
    let img2webp = tools::IMG2WEBP.get()?;
    let frames = tools::target()?.join("hearth-showcase");
    let sh = Shell::new()?;
    sh.remove_path(&frames)?;
    sh.create_dir(&frames)?;
    let arguments = [frames.clone(), RATE.to_string().into()];
    goldens::run_script("showcase.mjs", arguments, None)?;

    // The animation replaces the committed one only if it is small enough.
    let (pictures, animation) = (sh.read_dir(&frames)?, frames.join("fire.webp"));
    let frames_made = pictures.len();
    let milliseconds = (1000 / RATE).to_string();
    // Every frame is a key frame: differences between frames show as blocks.
    let options = [
        "-loop", "0", "-kmin", "0", "-kmax", "1", "-lossy", "-q", "20", "-m", "6",
    ];
    cmd!(
        sh,
        "{img2webp} {options...} -d {milliseconds} {pictures...} -o {animation}"
    )
    .run()?;
    let size = fs::metadata(&animation)?.len();
    ensure!(
        size <= LARGEST,
        "the animation has {size} bytes, more than {LARGEST}"
    );
    sh.copy_file(&animation, "docs/fire.webp")?;
    println!("docs/fire.webp: {frames_made} frames, {size} bytes");
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use anyhow::Context;
    use hearth_core::preset::Preset;

    use super::*;

    #[test]
    fn every_scene_has_a_thumbnail_and_every_thumbnail_a_scene() -> Result<()> {
        let folder = paths::root().join("web/scenes");
        let mut expected = BTreeSet::new();
        for preset in Preset::all() {
            let path = folder.join(format!("{}.jpg", preset.name));
            let missing = "run `cargo xtask thumbnails` and commit the picture";
            let jpeg = fs::read(&path).with_context(|| format!("{}: {missing}", preset.name))?;
            let size = imagesize::blob_size(&jpeg)?;
            assert_eq!((size.width, size.height), (120, 160), "{}", preset.name);
            assert!(jpeg.len() <= 6000, "{}: {} bytes", preset.name, jpeg.len());
            expected.insert(path);
        }
        let present: BTreeSet<_> = Shell::new()?.read_dir(&folder)?.into_iter().collect();
        assert_eq!(present, expected);
        let shown = fs::read(paths::root().join("crates/hearth-fire/fire.jpg"))?;
        assert_eq!(shown, fs::read(folder.join("fireside.jpg"))?);
        Ok(())
    }

    #[test]
    fn every_scene_of_the_community_has_a_picture_and_all_are_small() -> Result<()> {
        let folder = paths::root().join("scenes/community");
        let mut sum = 0;
        let mut expected = BTreeSet::new();
        for scene in codegen::community(&paths::root())? {
            let path = folder.join(format!("{}.jpg", scene.name));
            let missing = "run `cargo xtask thumbnails community/NAME` and commit the picture";
            let jpeg = fs::read(&path).with_context(|| format!("{}: {missing}", scene.name))?;
            let size = imagesize::blob_size(&jpeg)?;
            assert_eq!((size.width, size.height), (240, 320), "{}", scene.name);
            sum += jpeg.len();
            expected.extend([path, folder.join(format!("{}.json", scene.name))]);
        }
        assert!(sum <= 300_000, "{sum} bytes");
        let present: BTreeSet<_> = Shell::new()?.read_dir(&folder)?.into_iter().collect();
        assert_eq!(present, expected);
        Ok(())
    }

    #[test]
    fn the_picture_of_links_is_small_and_has_the_size_that_the_page_names() -> Result<()> {
        let picture = fs::read(paths::root().join("web/poster.jpg"))?;
        assert!(picture.len() < 60_000, "{} bytes", picture.len());
        let size = imagesize::blob_size(&picture)?;
        let html = fs::read_to_string(paths::root().join("index.html"))?;
        for (name, pixels) in [("width", size.width), ("height", size.height)] {
            let named = format!("\"og:image:{name}\" content=\"{pixels}\"");
            assert!(html.contains(&named), "index.html lacks {named}");
        }
        Ok(())
    }
}
