//! `cargo xtask thumbnails`: takes the small picture of each scene,
//! `web/scenes/NAME.jpg`. The same scene gives the same picture; it wants a new one
//! when its values change, or the way in which fires are drawn.

use anyhow::Result;

use crate::stages::browser;
use crate::{paths, process};

/// Builds the site and takes the pictures of these scenes in it; without a name, of
/// all of them.
///
/// # Errors
/// No browser, no Node, a site that does not build, or a name that no scene has.
pub fn take(names: &[String]) -> Result<()> {
    let mut script = browser::script("thumbnails.mjs")?;
    script.arg(paths::root().join("web").join("scenes"));
    process::run(script.args(names))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;

    use anyhow::{Context, Result};
    use hearth_core::preset::PRESETS;

    use super::*;

    /// Width and height that a JPEG's frame header says.
    fn size(jpeg: &[u8]) -> Option<[u16; 2]> {
        let mut rest = jpeg.strip_prefix(&[0xFF, 0xD8])?;
        while let [0xFF, kind, high, low, after @ ..] = rest {
            if (0xC0..=0xC2).contains(kind) {
                let [_, h1, h0, w1, w0, ..] = after else {
                    return None;
                };
                return Some([[w1, w0], [h1, h0]].map(|[a, b]| u16::from_be_bytes([*a, *b])));
            }
            let length = usize::from(u16::from_be_bytes([*high, *low]));
            rest = rest.get(2 + length..)?;
        }
        None
    }

    #[test]
    fn every_scene_has_its_small_picture_and_no_picture_is_left_over() -> Result<()> {
        let folder = paths::root().join("web").join("scenes");
        for preset in PRESETS {
            let path = folder.join(format!("{}.jpg", preset.name));
            let missing = "run `cargo xtask thumbnails` and commit what it takes";
            let jpeg = fs::read(&path).with_context(|| format!("{}: {missing}", preset.name))?;
            assert_eq!(size(&jpeg), Some([120, 160]), "{}", preset.name);
            assert!(jpeg.len() <= 6000, "{}: {} bytes", preset.name, jpeg.len());
        }
        let expected = PRESETS.iter().map(|preset| format!("{}.jpg", preset.name));
        let expected: BTreeSet<_> = expected.collect();
        for entry in fs::read_dir(&folder)? {
            let name = entry?.file_name().to_string_lossy().into_owned();
            assert!(expected.contains(&name), "{name} is of no scene");
        }
        Ok(())
    }
}
