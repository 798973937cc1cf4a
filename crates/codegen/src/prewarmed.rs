//! `cargo xtask prewarmed`: simulates the scenes that a page may open with, and stores each as
//! `web/prewarmed/NAME.fire`, from which an element with `warm` starts at once.
//!
//! `cargo xtask codegen` does the same for a scene whose values have changed. A change of
//! the physics needs this command; a test fails until then.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use hearth_core::{Scene, Simulation};

use crate::{PREWARMED, scene_of_file};

/// Largest file \[bytes\].
const LARGEST: usize = 40_960;

/// Seconds of fire before the first candidate, and within which candidates are compared.
const BURNT: f64 = 3.0;
const WATCHED: f64 = 1.5;
/// Seconds of fire between two candidates.
const INTERVAL: f64 = 0.05;
/// Gas above this temperature shines \[K\].
const BRIGHT: f32 = 1000.0;

fn file(name: &str) -> String {
    format!("web/prewarmed/{name}.fire")
}

/// Simulates the scenes and stores those that differ from their files; unless `all`, only
/// those whose values differ from their file's. Returns the written files.
///
/// # Errors
/// A scene that does not burn, or a file that cannot be written.
pub fn refresh(checkout: &Path, all: bool) -> Result<Vec<String>> {
    let mut written = Vec::new();
    for name in PREWARMED {
        let scene = scene_of_file(checkout, name)?;
        let file = file(name);
        let path = checkout.join(&file);
        let present = fs::read(&path).unwrap_or_default();
        let mut fire = Simulation::new(scene.clone());
        if !all && fire.restore_burning(&present).is_ok() {
            continue;
        }
        let bytes = burn(&scene)?;
        if bytes != present {
            fs::create_dir_all(path.parent().unwrap_or(&path))?;
            fs::write(&path, bytes).with_context(|| file.clone())?;
            written.push(file);
        }
    }
    Ok(written)
}

/// A fire of this scene at the moment when most of its gas is bright.
fn burn(scene: &Scene) -> Result<Vec<u8>> {
    let mut fire = Simulation::new(scene.clone());
    let mut best = (0, Vec::new());
    let mut next = BURNT;
    while fire.time() < BURNT + WATCHED {
        fire.step();
        if fire.time() >= next {
            next += INTERVAL;
            let temperatures = fire.temperatures().into_iter();
            let bright = temperatures.filter(|&kelvin| kelvin > BRIGHT).count();
            if bright > best.0 {
                best = (bright, fire.burning().unwrap_or_default());
            }
        }
    }
    let (bright, bytes) = best;
    ensure!(
        bright > 0,
        "the scene does not burn, or not in the combustion model"
    );
    let size = bytes.len();
    ensure!(size <= LARGEST, "{size} bytes are more than {LARGEST}");
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stored_fires_match_their_scenes_and_the_physics() -> Result<()> {
        let checkout = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let written = refresh(&checkout, true)?;
        assert!(
            written.is_empty(),
            "stored fires were out of date and have been written; commit them: {written:?}"
        );
        Ok(())
    }
}
