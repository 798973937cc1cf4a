//! `hearth bench`: the time of each pass.

use std::time::Instant;

use std::ffi::OsString;

use clap::Args;
use serde_json::json;

use super::options::{DriverOptions, FireOptions, age, size};
use super::progress::{Counter, Progress};
use crate::error::{Error, shown};
use crate::output;
use crate::painter::Painter;
use crate::{Fire, Offscreen};

/// Arguments of `hearth bench`.
#[derive(Args)]
pub struct Bench {
    /// A preset, a settings file, a page's link, or - for a file on standard input.
    #[arg(default_value = "fireside")]
    scene: OsString,
    /// Age of the fire in seconds.
    #[arg(long, value_name = "SECONDS", default_value = "3", value_parser = age, allow_negative_numbers = true)]
    at: f64,
    /// Width and height in pixels.
    #[arg(long, value_name = "W×H", default_value = "1920x1080", value_parser = size)]
    size: [u32; 2],
    /// Number of measured pictures.
    #[arg(long, value_name = "N", default_value = "20", value_parser = clap::value_parser!(u32).range(1..=1000), allow_negative_numbers = true)]
    pictures: u32,
    /// Prints JSON.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    fire: FireOptions,
    #[command(flatten)]
    driver: DriverOptions,
}

/// A pass and its times \[ms\], one for each picture.
type Times = Vec<(&'static str, Vec<f64>)>;

impl Bench {
    /// Measures, and prints a table or JSON.
    ///
    /// # Errors
    /// A value is refused, or the driver fails.
    pub fn run(&self) -> Result<(), Error> {
        let settings = self.fire.settings(&self.scene, &[])?;
        let (offscreen, shared) = self.driver.open()?;
        self.driver.warn(&shared);
        let options = self.fire.picture(self.size, 1);
        let mut painter = Painter::new(&offscreen, &shared, options)?;
        let mut fire = self.fire.fire(&settings, self.size);
        let progress = Progress::new(self.at);
        progress.name(&shown(&self.scene));
        let mut counter = Counter::new(&progress);
        fire.burn(self.at, &mut |age| counter.at(age));
        progress.finish();
        // The first picture compiles programs and creates targets.
        painter.draw(&mut fire, &mut |_| {})?;
        offscreen.finish();
        let whole = median(self.wholes(&offscreen, &mut painter, &mut fire)?);
        let passes = self.passes(&offscreen, &mut painter, &mut fire)?;
        let passes: Vec<_> = passes
            .into_iter()
            .map(|(name, times)| (name, median(times)))
            .collect();
        let driver = offscreen.driver();
        let timer = if driver.timer_queries {
            "gpu"
        } else {
            "submit"
        };
        let ([width, height], level) = (self.size, self.fire.quality.name());
        let (particles, format) = (fire.simulation().count(), shared.target_format().name());
        if self.json {
            let passes = passes
                .iter()
                .map(|(name, ms)| json!({ "pass": name, "ms": ms }));
            let record = json!({
                "renderer": driver.renderer,
                "version": driver.version,
                "scene": self.scene.to_string_lossy(),
                "at": fire.simulation().time(),
                "width": width,
                "height": height,
                "quality": level,
                "format": format,
                "particles": particles,
                "pictures": self.pictures,
                "timer": timer,
                "passes": passes.collect::<Vec<_>>(),
                "pictureMs": whole,
            });
            return output::print(format!("{record:#}\n").as_bytes());
        }
        let mut text = format!(
            "{}, {width} x {height}, {level}, {format}, {particles} particles, {}\nmedian of {} pictures [ms]",
            shown(&self.scene),
            driver.renderer,
            self.pictures
        );
        text += match driver.timer_queries {
            true => ", by timer queries\n\n",
            false => "; without timer queries: the time in which a pass is submitted\n\n",
        };
        for (name, ms) in &passes {
            text += &format!("{name:18}{ms:9.3}\n");
        }
        let sum: f64 = passes.iter().map(|(_, ms)| ms).sum();
        text += &format!(
            "{:18}{sum:9.3}\n{:18}{whole:9.3}\n",
            "sum", "picture, by clock"
        );
        output::print(text.as_bytes())
    }

    /// Times of whole pictures, with the upload \[ms\].
    fn wholes(
        &self,
        offscreen: &Offscreen,
        painter: &mut Painter<'_>,
        fire: &mut Fire,
    ) -> Result<Vec<f64>, Error> {
        let pictures = 0..self.pictures;
        pictures
            .map(|_| {
                let start = Instant::now();
                painter.draw(fire, &mut |_| {})?;
                offscreen.finish();
                Ok(milliseconds(start))
            })
            .collect()
    }

    /// Times of the passes of so many pictures.
    fn passes(
        &self,
        offscreen: &Offscreen,
        painter: &mut Painter<'_>,
        fire: &mut Fire,
    ) -> Result<Times, Error> {
        let has_timer = offscreen.has_timer();
        let mut times = Times::new();
        for _ in 0..self.pictures {
            let mut start = Instant::now();
            offscreen.begin_timer();
            painter.draw(fire, &mut |name| {
                let time = match has_timer {
                    true => offscreen.end_timer(),
                    false => Some(milliseconds(start)),
                };
                let of_pass = times.iter_mut().find(|(known, _)| *known == name);
                match (of_pass, time) {
                    (Some((_, times)), Some(time)) => times.push(time),
                    (None, time) => times.push((name, time.into_iter().collect())),
                    (Some(_), None) => {}
                }
                start = Instant::now();
                offscreen.begin_timer();
            })?;
            offscreen.end_timer();
        }
        Ok(times)
    }
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1000.0
}

/// The median; 0 of no times.
fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(0.0)
}
