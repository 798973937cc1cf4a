//! `hearth film`: pictures at exact moments, as a film.

use std::collections::VecDeque;
use std::ffi::OsString;
use std::ops::{Range, RangeInclusive};

use clap::Args;
use hearth_core::params::Colour;
use hearth_settings::Settings;

use super::options::{DriverOptions, FireOptions, age, background, named, size};
use super::progress::{Counter, Progress};
use crate::Fire;
use crate::error::{Error, shown};
use crate::film::seam::{self, Loop};
use crate::film::sound;
use crate::film::{self, Clock, Encoder, Format, Header, Plays, Rate};
use crate::output::Output;
use crate::painter::Painter;
use crate::picture::Picture;

/// Most pictures of a film.
const MAX_PICTURES: u32 = 100_000;
/// Most pictures a second.
const MAX_RATE: u32 = 240;
/// Share of the time between two pictures during which the shutter is open.
const SHUTTER: f64 = 0.5;

/// Time over which the fine structure of a picture is carried on from earlier ones, its longest period \[s\].
const CARRIED_SECONDS: f64 = 1.5;

/// Length of a loop \[s\].
const LOOP_SECONDS: RangeInclusive<f64> = 1.0..=10.0;
/// Width and height of the pictures in which the beginning of a loop is looked for \[pixels\].
const SEEN_SIDE: u32 = 64;

/// Arguments of `hearth film`.
#[derive(Args)]
#[command(after_help = FORMATS)]
pub struct Film {
    /// A preset (`hearth scenes` lists them), a settings file, or - for one on standard input.
    scene: OsString,
    /// The new file, whose ending is the format; a folder for PNG files; or - for standard output.
    #[arg(long, short, value_name = "FILE")]
    out: OsString,
    /// The format, where the name has no such ending.
    #[arg(long = "as", value_name = "FORMAT", value_parser = named(Format::ALL.to_vec()))]
    film_format: Option<Format>,
    /// Replaces existing files.
    #[arg(long)]
    force: bool,
    /// Pictures a second, as 30, 29.97 or 30000/1001.
    #[arg(long, value_name = "RATE", default_value = "30", value_parser = rate, allow_negative_numbers = true)]
    fps: Rate,
    /// Length of the film in seconds.
    #[arg(long, value_name = "SECONDS", default_value = "5", value_parser = age, allow_negative_numbers = true)]
    seconds: f64,
    /// Age of the fire in seconds at the first picture.
    #[arg(long, value_name = "SECONDS", default_value = "3", value_parser = age, allow_negative_numbers = true)]
    from: f64,
    /// Draws only this part of the film: from the first of these numbers on, without the second.
    #[arg(long, value_name = "A..B", value_parser = frames)]
    frames: Option<Range<u32>>,
    /// Width and height in pixels.
    #[arg(long, value_name = "W×H", default_value = "512x512", value_parser = size)]
    size: [u32; 2],
    /// Draws so many pixels for one along each side, and takes the mean of their light.
    #[arg(long, value_name = "1..4", default_value = "1", value_parser = clap::value_parser!(u32).range(1..=4), allow_negative_numbers = true)]
    supersample: u32,
    /// Draws so many moments for a picture, half of the time between two, and takes the mean of their light.
    #[arg(long, value_name = "1..16", default_value = "1", value_parser = clap::value_parser!(u32).range(1..=16), allow_negative_numbers = true)]
    motion_blur: u32,
    /// The end goes over into the beginning: films of 1 to 10 seconds.
    #[arg(long = "loop", conflicts_with_all = ["motion_blur", "once"])]
    is_loop: bool,
    /// Adds the sound of the fire to WebM and MP4.
    #[arg(long, conflicts_with = "is_loop")]
    sound: bool,
    /// The film ends instead of playing again (APNG, WebP, GIF).
    #[arg(long)]
    once: bool,
    /// Colours are exact in WebP and WebM, whose files are some four times as large.
    #[arg(long)]
    lossless: bool,
    /// What is behind the fire: #rrggbb, black, white or transparent [default: that of the scene].
    #[arg(long, value_name = "COLOUR", value_parser = background)]
    background: Option<(String, Colour)>,
    #[command(flatten)]
    fire: FireOptions,
    #[command(flatten)]
    driver: DriverOptions,
}

const FORMATS: &str = "\
Formats: a folder or .zip of PNG files, .png or .apng, .webp, .gif; .webm and .mp4 by the program ffmpeg;
.wav, which is the sound alone.
With --out - the pictures go to another program, --as png or rgba (straight alpha, rows from the top).
--frames draws the same pictures as the whole film has there, so several machines can share it.";

impl Film {
    /// Writes the film.
    ///
    /// # Errors
    /// A value is refused, or the driver, the disk or the encoder fails.
    pub fn run(&self) -> Result<(), Error> {
        let background = self.background.iter();
        let background: Vec<_> = background
            .map(|(_, colour)| ("background".to_owned(), colour.to_string()))
            .collect();
        let settings = self.fire.settings(&self.scene, &background)?;
        let format = self.format()?;
        let part = self.part()?;
        let header = Header {
            size: self.size,
            rate: self.fps,
            first: part.start,
            count: part.end - part.start,
            plays: match self.once {
                true => Plays::Once,
                false => Plays::Forever,
            },
            is_lossless: self.lossless,
        };
        let clock = self.clock(&settings);
        let progress = Progress::new(clock.age(part.end));
        progress.name(&shown(&self.scene));
        if format == Format::Wav {
            if self.is_loop {
                return Err(Error::Use("--loop: a loop has no sound".to_owned()));
            }
            let output = Output::new(&self.out, self.force)?;
            return output.write(&self.wav(&settings, &part, &progress));
        }
        let sound = match (self.sound, format) {
            (false, _) => None,
            (_, Format::WebM | Format::Mp4) => Some(self.wav(&settings, &part, &progress)),
            _ => {
                let words = "--sound: only WebM and MP4 have sound; a name that ends with .wav is the sound alone";
                return Err(Error::Use(words.to_owned()));
            }
        };
        let mut encoder = film::encoder(format, &self.out, self.force, header, sound)?;
        let (offscreen, shared) = self.driver.open()?;
        self.driver.warn(&shared);
        let options = self.fire.picture(self.size, self.supersample);
        let mut painter = Painter::new(&offscreen, &shared, options)?;
        let fire = || self.fire.fire(&settings, self.size);
        if self.is_loop {
            let options = self.fire.picture([SEEN_SIDE; 2], 1);
            let mut small = Painter::new(&offscreen, &shared, options)?;
            self.draw_loop(
                clock,
                &fire,
                [&mut painter, &mut small],
                &part,
                &mut *encoder,
            )?;
            return encoder.finish();
        }
        let mut fire = fire();
        let mut counter = Counter::new(&progress);
        for number in 0..part.end {
            let is_kept = number >= part.start;
            let is_drawn = is_kept || clock.elapsed(part.start - number) <= CARRIED_SECONDS;
            let mut moments = Vec::new();
            for moment in 1..=self.motion_blur {
                let open = f64::from(self.motion_blur - moment) / f64::from(self.motion_blur);
                let before = SHUTTER * open * clock.elapsed(1);
                let time = clock.age(number) - before;
                fire.advance(time, &mut |age| counter.at(age));
                if is_kept {
                    moments.push(painter.paint(&mut fire)?);
                } else if is_drawn {
                    painter.draw(&mut fire, &mut |_| {})?;
                }
            }
            if let Some(picture) = Picture::mean(&moments) {
                encoder.add(&picture)?;
            }
        }
        progress.finish();
        encoder.finish()
    }

    /// The sound of a part of the film.
    fn wav(&self, settings: &Settings, part: &Range<u32>, progress: &Progress) -> Vec<u8> {
        let mut fire = self.fire.fire(settings, self.size);
        let mut counter = Counter::new(progress);
        let clock = self.clock(settings);
        let ages = [part.start, part.end].map(|number| clock.age(number));
        sound::wav(&sound::samples(&mut fire, ages, &mut |age| counter.at(age)))
    }

    /// Draws a part of a loop: once small, to find its beginning, and then what it shows.
    fn draw_loop(
        &self,
        clock: Clock,
        begin: &dyn Fn() -> Fire,
        [painter, small]: [&mut Painter<'_>; 2],
        part: &Range<u32>,
        encoder: &mut dyn Encoder,
    ) -> Result<(), Error> {
        let film = Loop::new(self.count()?, self.fps);
        let time = |number: u32| clock.age(number);
        let mut fire = begin();
        let life = f64::from(fire.simulation().parameters().ember_life_max);
        let lived = film.searched() + (life / clock.elapsed(1)).ceil() as u32;
        let progress = Progress::new(time(lived) + time(film.searched()));
        progress.name(&shown(&self.scene));
        let mut counter = Counter::new(&progress);
        let (mut seen, mut embers) = (Vec::new(), Vec::new());
        for number in 0..lived {
            fire.advance(time(number), &mut |age| counter.at(age));
            if number < film.searched() {
                seen.push(small.paint_with(&mut fire, &[])?);
            }
            fire.write();
            embers.push(seam::embers(fire.simulation(), &fire.embers));
        }
        let start = film.start(&seen);
        let born = [start, start + film.count].map(time);
        let mut fire = begin();
        let mut counter = Counter::new(&progress);
        let mut earlier = VecDeque::new();
        for number in 0..start + part.end {
            fire.advance(time(number), &mut |age| counter.at(age));
            // What is shown before the beginning is mixed into the end, with the embers of the end.
            let at = (number + film.fade).checked_sub(start);
            let at = at.map(|at| (at + film.count - film.fade) % film.count);
            let Some(at) = at else {
                if clock.elapsed(start - number) <= CARRIED_SECONDS {
                    painter.draw(&mut fire, &mut |_| {})?;
                }
                continue;
            };
            let shown = seam::embers_of(at, start, film.count, born, &embers);
            let picture = painter.paint_with(&mut fire, &shown)?;
            if number < start {
                earlier.push_back(picture);
                continue;
            }
            let picture = match film.share_of_earlier(at) {
                0.0 => picture,
                share => earlier
                    .pop_front()
                    .map_or(picture.clone(), |earlier| picture.mixed(&earlier, share)),
            };
            if part.contains(&at) {
                encoder.add(&picture)?;
            }
        }
        progress.finish();
        Ok(())
    }

    /// The format that is stated, or that of the name.
    fn format(&self) -> Result<Format, Error> {
        let of_name = (self.out != "-")
            .then(|| Format::of_name(&self.out.to_string_lossy()))
            .flatten();
        self.film_format.or(of_name).ok_or_else(|| {
            let words = match &*shown(&self.out) {
                "-" => "standard output needs a format, as --as rgba".to_owned(),
                name => format!(
                    "{name}: a film ends with .zip, .png, .apng, .webp, .gif, .webm, .mp4 or .rgba, or it is a folder; --as states another format"
                ),
            };
            Error::Use(words)
        })
    }

    /// When the pictures of a film with these settings are.
    fn clock(&self, settings: &Settings) -> Clock {
        Clock {
            from: self.from,
            rate: self.fps,
            speed: settings.parameters().time_scale.into(),
        }
    }

    /// The number of pictures of the whole film.
    fn count(&self) -> Result<u32, Error> {
        if self.is_loop && !LOOP_SECONDS.contains(&self.seconds) {
            return Err(Error::Use(format!(
                "a loop has --seconds from {} to {}",
                LOOP_SECONDS.start(),
                LOOP_SECONDS.end()
            )));
        }
        let count = (self.seconds / self.fps.time(1)).round().max(1.0);
        match count <= f64::from(MAX_PICTURES) {
            true => Ok(count as u32),
            false => Err(Error::Use(format!(
                "the film has {count} pictures; it may have {MAX_PICTURES}"
            ))),
        }
    }

    /// The numbers of the pictures that are drawn.
    fn part(&self) -> Result<Range<u32>, Error> {
        let count = self.count()?;
        let part = self.frames.clone().unwrap_or(0..count);
        match part.end <= count {
            true => Ok(part),
            false => Err(Error::Use(format!(
                "--frames {}..{} exceeds the film, which has the pictures 0..{count}",
                part.start, part.end
            ))),
        }
    }
}

/// A rate: a number with at most three decimals, or a fraction as `30000/1001`.
pub fn rate(text: &str) -> Result<Rate, String> {
    let whole = |text: &str| text.parse().ok().filter(|&number: &u32| number > 0);
    let rate = match text.split_once('/') {
        Some((pictures, seconds)) => whole(pictures).zip(whole(seconds)),
        None => match text.parse::<f64>() {
            Ok(number) if number.fract() == 0.0 => whole(text).map(|pictures| (pictures, 1)),
            Ok(number) => Some(((number * 1000.0).round() as u32, 1000)),
            Err(_) => None,
        },
    };
    let rate = rate.map(|(pictures, seconds)| Rate { pictures, seconds });
    let is_in_range = |rate: &Rate| {
        let [pictures, seconds] = [rate.pictures, rate.seconds].map(u64::from);
        (seconds..=seconds * u64::from(MAX_RATE)).contains(&pictures)
    };
    rate.filter(is_in_range)
        .ok_or_else(|| format!("it must be a number of pictures a second from 1 to {MAX_RATE}, or a fraction as 30000/1001"))
}

/// A part of a film, as `0..300`.
fn frames(text: &str) -> Result<Range<u32>, String> {
    let parts = text.split_once("..");
    let parts = parts.and_then(|(start, end)| Some(start.parse().ok()?..end.parse().ok()?));
    parts
        .filter(|part: &Range<u32>| part.start < part.end)
        .ok_or_else(|| {
            "it must be two numbers of pictures, the first below the second, as 0..300".to_owned()
        })
}
