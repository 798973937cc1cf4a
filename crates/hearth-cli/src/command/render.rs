//! `hearth render`: one picture.

use std::ffi::OsString;

use clap::Args;

use super::options::{DriverOptions, FireOptions, PictureOfFire, age, size};
use super::progress::{Counter, Progress};
use crate::error::{Error, shown};
use crate::output::Output;
use crate::painter::Painter;

/// Arguments of `hearth render`.
#[derive(Args)]
pub struct Render {
    /// A preset (`hearth scenes` lists them), a settings file, a page's link, or - for a file on standard input.
    scene: OsString,
    /// Age of the fire in seconds.
    #[arg(long, value_name = "SECONDS", default_value = "5", value_parser = age, allow_negative_numbers = true)]
    at: f64,
    /// Width and height in pixels.
    #[arg(long, value_name = "W×H", default_value = "1280x720", value_parser = size)]
    size: [u32; 2],
    /// The new PNG file, or - for standard output.
    #[arg(long, short, value_name = "FILE")]
    out: OsString,
    /// Replaces an existing file.
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    picture: PictureOfFire,
    /// Draws so many pixels for one along each side, and takes the mean of their light.
    #[arg(long, value_name = "1..4", default_value = "1", value_parser = clap::value_parser!(u32).range(1..=4), allow_negative_numbers = true)]
    supersample: u32,
    #[command(flatten)]
    fire: FireOptions,
    #[command(flatten)]
    driver: DriverOptions,
}

impl Render {
    /// Draws the picture.
    ///
    /// # Errors
    /// A value is refused, or the driver or the disk fails.
    pub fn run(&self) -> Result<(), Error> {
        let settings = self.fire.settings(&self.scene, &self.picture.values())?;
        let output = Output::of_png(&self.out, self.force)?;
        let (offscreen, shared) = self.driver.open()?;
        self.driver.warn(&shared);
        let options = self.fire.picture(self.size, self.supersample);
        let mut painter = Painter::new(&offscreen, &shared, options)?;
        let mut fire = self.fire.fire(&settings, self.size);
        let progress = Progress::new(self.at);
        progress.name(&shown(&self.scene));
        let mut counter = Counter::new(&progress);
        fire.burn(self.at, &mut |age| counter.at(age));
        let picture = painter.paint(&mut fire)?;
        progress.finish();
        output.write(&picture.png(self.picture.text(&settings).as_deref())?)
    }
}
