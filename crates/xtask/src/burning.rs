//! `cargo xtask burning`: burns the scenes that a page may open on, and keeps each as
//! `web/burning/NAME.fire`, from which an element with `warm` starts at once.
//!
//! `cargo xtask codegen` does the same where a scene's values are not those that its file
//! was made with. A change of the physics asks for this command; a test tells.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use hearth_core::{Parameters, Simulation};

use crate::{codegen, paths};

/// The scenes that are kept.
pub(crate) const SCENES: [&str; 1] = ["fireside"];

/// Largest file [bytes].
const LARGEST: usize = 40_960;

/// Seconds of fire before it may be kept, and within which the best moment is looked for.
const BURNT: f64 = 3.0;
const WATCHED: f64 = 1.5;
/// Seconds of fire between two looks.
const LOOK: f64 = 0.05;
/// Gas that is hotter shines \[K\].
const BRIGHT: f32 = 1000.0;

/// Where the scene of that name is kept.
fn file(name: &str) -> PathBuf {
    let folder = paths::root().join("web").join("burning");
    folder.join(format!("{name}.fire"))
}

/// Burns the scenes and keeps those that differ from their files; unless `all`, only those
/// whose values are others than their file's. Returns what was written.
///
/// # Errors
/// A scene that is none, a fire that is too large, a file that cannot be written.
pub fn refresh(all: bool) -> Result<Vec<PathBuf>> {
    let mut written = Vec::new();
    for name in SCENES {
        let parameters = codegen::values_of_scene(name)?;
        let path = file(name);
        let present = fs::read(&path).unwrap_or_default();
        if !all
            && Simulation::new(parameters.clone())
                .restore_burning(&present)
                .is_ok()
        {
            continue;
        }
        let bytes = burn(&parameters)?;
        if bytes != present {
            fs::create_dir_all(path.parent().unwrap_or(&path))?;
            fs::write(&path, bytes).with_context(|| paths::shown(&path))?;
            written.push(path);
        }
    }
    Ok(written)
}

/// A fire of these values as it burns when most of its gas is bright.
fn burn(parameters: &Parameters) -> Result<Vec<u8>> {
    let mut fire = Simulation::new(parameters.clone());
    let mut best = (0, Vec::new());
    let mut next = BURNT;
    while fire.time() < BURNT + WATCHED {
        fire.step();
        if fire.time() >= next {
            next += LOOK;
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
        "the scene is not of the combustion model, or does not burn"
    );
    ensure!(
        bytes.len() <= LARGEST,
        "{} bytes are more than {LARGEST}",
        bytes.len()
    );
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kept_fires_are_what_their_scenes_and_the_physics_give() -> Result<()> {
        let written = refresh(true)?;
        assert!(
            written.is_empty(),
            "burning fires were behind their scene or the physics and have been written anew; commit \
             them: {written:?}"
        );
        Ok(())
    }

    #[test]
    fn a_kept_fire_of_other_values_is_noticed() -> Result<()> {
        for name in SCENES {
            let bytes = fs::read(file(name))?;
            let mut values = codegen::values_of_scene(name)?;
            let mut own = Simulation::new(values.clone());
            assert_eq!(own.restore_burning(&bytes), Ok(()), "{name}");
            values.set("fuel_power", hearth_core::params::Input::Number(123.0))?;
            let refused = Simulation::new(values).restore_burning(&bytes);
            assert_eq!(refused, Err(hearth_core::burning::BurningError::Other));
        }
        Ok(())
    }

    #[test]
    fn a_kept_fire_is_small_tall_and_of_every_quality() -> Result<()> {
        for name in SCENES {
            let bytes = fs::read(file(name))?;
            assert!(bytes.len() <= LARGEST, "{name}: {} bytes", bytes.len());
            for particles in [500.0, 1200.0, 3000.0, 6700.0] {
                let mut values = codegen::values_of_scene(name)?;
                values.set(
                    "max_particles",
                    hearth_core::params::Input::Number(particles),
                )?;
                let floor = hearth_core::Burner::of(&values).bottom;
                let height = values.domain_height;
                let mut fire = Simulation::new(values);
                assert_eq!(
                    fire.restore_burning(&bytes),
                    Ok(()),
                    "{name} at {particles}"
                );
                let count = fire.count() as f64;
                assert!(
                    (count / particles - 1.0).abs() < 0.1,
                    "{name}: {count} of {particles}"
                );
                let places = fire.positions().into_iter().zip(fire.temperatures());
                let bright = places.filter(|&(_, kelvin)| kelvin > BRIGHT);
                let top = bright.map(|(at, _)| at.y).fold(0.0, f32::max);
                assert!(
                    top - floor > 0.25 * height,
                    "{name} at {particles}: {top} m"
                );
            }
        }
        Ok(())
    }
}
