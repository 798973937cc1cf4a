//! `hearth film`: pictures at exact moments, as a film.

mod burning;
mod loops;

use std::ffi::OsString;
use std::ops::{Range, RangeInclusive};

use clap::Args;
use hearth_settings::Settings;

use super::options::{DriverOptions, FireOptions, PictureOfFire, age, named, size};
use super::progress::Progress;
use crate::error::{Error, shown};
use crate::film::{self, Clock, Format, Header, Plays, Rate};
use crate::output::Output;

/// Most pictures of a film.
const MAX_PICTURES: u32 = 100_000;
/// Most pictures a second.
const MAX_RATE: u32 = 240;
/// Length of a loop \[s\].
const LOOP_SECONDS: RangeInclusive<f64> = 1.0..=10.0;

/// Arguments of `hearth film`.
#[derive(Args)]
#[command(after_help = FORMATS)]
pub struct Film {
    /// A preset (`hearth scenes` lists them), a settings file, a page's link, or - for a file on standard input.
    scene: OsString,
    /// The new file, whose ending is the format; a folder for PNG files; or - for standard output.
    #[arg(
        long,
        short,
        value_name = "FILE",
        required_unless_present = "checkpoint",
        default_value = "",
        hide_default_value = true
    )]
    out: OsString,
    /// Writes the state of the fire at the end of the part, from which later parts resume. Without --out, nothing is drawn.
    #[arg(long, value_name = "FILE", conflicts_with = "is_loop")]
    checkpoint: Option<OsString>,
    /// Begins from such a state instead of from the seed.
    #[arg(long, value_name = "FILE", conflicts_with = "is_loop")]
    resume: Option<OsString>,
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
    /// Adds alpha to MP4, as a grey below each picture: the film is twice as high.
    #[arg(long)]
    stacked_alpha: bool,
    /// Colours are exact in WebP and WebM, whose files are some four times as large.
    #[arg(long)]
    lossless: bool,
    #[command(flatten)]
    picture: PictureOfFire,
    #[command(flatten)]
    fire: FireOptions,
    #[command(flatten)]
    driver: DriverOptions,
}

const FORMATS: &str = "\
Formats: a folder or .zip of PNG files, .png or .apng, .webp, .gif; .webm and .mp4 by the program ffmpeg;
.wav, which is the sound alone.
With --out - the pictures go to another program, --as png or rgba (straight alpha, rows from the top).
--frames draws the same pictures as the whole film has there, so several machines can share it. A part that begins from
the checkpoint of an earlier one has the same bits, too.";

impl Film {
    /// Writes the film.
    ///
    /// # Errors
    /// A value is refused, or the driver, the disk or the encoder fails.
    pub fn run(&self) -> Result<(), Error> {
        let settings = self.fire.settings(&self.scene, &self.picture.values())?;
        let part = self.part()?;
        let kept = self.checkpoint.as_ref();
        let kept = kept.map(|name| Output::new(name, self.force)).transpose()?;
        let progress = Progress::new(self.clock(&settings).age(part.end));
        progress.name(&shown(&self.scene));
        let mut state = None;
        if !self.out.is_empty() {
            state = self.write(&settings, &part, &progress)?;
        }
        if let Some(output) = kept {
            let state = match state {
                Some(state) => Some(state),
                None => self.burn(self.begin(&settings, &part)?, &part, &progress, None),
            };
            progress.finish();
            output.write(&state.unwrap_or_default())?;
        }
        Ok(())
    }

    /// Writes the pictures or the sound. Returns the state for a checkpoint, if one burns beside the pictures.
    fn write(
        &self,
        settings: &Settings,
        part: &Range<u32>,
        progress: &Progress,
    ) -> Result<Option<Vec<u8>>, Error> {
        let format = self.format()?;
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
            is_opaque: settings.parameters().background.rgba[3] == 255,
            is_stacked: self.stacked_alpha,
            text: self.picture.text(settings),
        };
        if header.text.is_some() && matches!(format, Format::Rgba | Format::Wav) {
            let words = "--describe: raw pictures and WAV have no place for a text";
            return Err(Error::Use(words.to_owned()));
        }
        if self.stacked_alpha && format != Format::Mp4 {
            let words =
                "--stacked-alpha is for MP4: webp, apng, zip, webm and gif have alpha of their own";
            return Err(Error::Use(words.to_owned()));
        }
        if format == Format::Wav {
            if self.is_loop {
                return Err(Error::Use("--loop: a loop has no sound".to_owned()));
            }
            let output = Output::new(&self.out, self.force)?;
            output.write(&self.wav(settings, part, progress)?)?;
            return Ok(None);
        }
        let sound = match (self.sound, format) {
            (false, _) => None,
            (_, Format::WebM | Format::Mp4) => Some(self.wav(settings, part, progress)?),
            _ => {
                let words = "--sound: only WebM and MP4 have sound; a name that ends with .wav is the sound alone";
                return Err(Error::Use(words.to_owned()));
            }
        };
        let mut encoder = film::encoder(format, &self.out, self.force, header, sound)?;
        self.tell_memory();
        let state = match self.is_loop {
            true => self
                .write_loop(settings, part, &mut *encoder)
                .map(|()| None),
            false => self.write_pictures(settings, part, progress, &mut *encoder),
        }?;
        encoder.finish()?;
        Ok(state)
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
