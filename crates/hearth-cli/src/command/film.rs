//! `hearth film`: pictures at exact moments, as a film.

use std::collections::VecDeque;
use std::ffi::OsString;
use std::io::{Write, stderr};
use std::ops::{Range, RangeInclusive};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use clap::Args;
use hearth_settings::{Settings, export};

use super::options::{DriverOptions, FireOptions, PictureOfFire, age, named, size};
use super::progress::{Counter, Progress};
use crate::Fire;
use crate::error::{Error, shown};
use crate::film::seam::{self, Loop};
use crate::film::{self, Clock, Encoder, Format, Header, Plays, Rate};
use crate::film::{checkpoint, sound};
use crate::output::Output;
use crate::painter::{self, Painter};
use crate::picture::Picture;

/// Most pictures of a film.
const MAX_PICTURES: u32 = 100_000;
/// Most pictures a second.
const MAX_RATE: u32 = 240;
/// Share of the time between two pictures during which the shutter is open.
const SHUTTER: f64 = 0.5;

/// Time over which the fine structure of a picture is carried on from earlier ones, its longest period \[s\].
const CARRIED_SECONDS: f64 = 1.5;

/// Most moments that wait to be drawn, and most pictures that wait to be encoded.
const MOST_WAITING: usize = 2;

/// Memory from which on it is told \[bytes\].
const LEAST_TOLD: u64 = 512 << 20;

/// Length of a loop \[s\].
const LOOP_SECONDS: RangeInclusive<f64> = 1.0..=10.0;
/// Width and height of the pictures in which the beginning of a loop is looked for \[pixels\].
const SEEN_SIDE: u32 = 64;

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

/// A fire at a moment of a picture.
struct Shot {
    fire: Fire,
    /// Whether it is seen, or only prepares a picture that is.
    is_kept: bool,
    is_last: bool,
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
            text: self.picture.text(settings),
        };
        if header.text.is_some() && matches!(format, Format::Rgba | Format::Wav) {
            let words = "--describe: raw pictures and WAV have no place for a text";
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
        if self.is_loop {
            let (offscreen, shared) = self.driver.open()?;
            self.driver.warn(&shared);
            let [large, small] = [(self.size, self.supersample), ([SEEN_SIDE; 2], 1)]
                .map(|(size, samples)| self.fire.picture(size, samples));
            let painters = [
                &mut Painter::new(&offscreen, &shared, large)?,
                &mut Painter::new(&offscreen, &shared, small)?,
            ];
            let fire = || self.fire.fire(settings, self.size);
            self.draw_loop(self.clock(settings), &fire, painters, part, &mut *encoder)?;
            encoder.finish()?;
            return Ok(None);
        }
        let begun = self.begin(settings, part)?;
        self.tell_memory();
        // The fire burns, is drawn and is encoded at the same time.
        let state = thread::scope(|scope| {
            let (burnt, shots) = sync_channel(MOST_WAITING);
            let burning = scope.spawn(move || self.burn(begun, part, progress, Some(burnt)));
            let (drawn, pictures) = sync_channel(MOST_WAITING);
            let drawing = scope.spawn(move || self.draw(shots, drawn));
            for picture in pictures {
                encoder.add(&picture)?;
            }
            let failed = |_| Error::Failed("a thread of the film has failed".to_owned());
            drawing.join().map_err(failed)??;
            burning.join().map_err(failed)
        })?;
        progress.finish();
        encoder.finish()?;
        Ok(state)
    }

    /// Writes to standard error how much memory large pictures take.
    fn tell_memory(&self) {
        let picture = 4 * u64::from(self.size[0]) * u64::from(self.size[1]);
        let waiting = 2 * MOST_WAITING as u64 + u64::from(self.motion_blur);
        let options = self.fire.picture(self.size, self.supersample);
        let bytes = painter::memory(&options) + waiting * picture;
        if bytes > LEAST_TOLD {
            // Words that nobody reads change nothing.
            let _ = writeln!(stderr(), "memory: about {} MB, and the file", bytes >> 20);
        }
    }

    /// Draws what burns, until nobody takes the pictures any more.
    fn draw(&self, shots: Receiver<Shot>, drawn: SyncSender<Picture>) -> Result<(), Error> {
        let (offscreen, shared) = self.driver.open()?;
        self.driver.warn(&shared);
        let options = self.fire.picture(self.size, self.supersample);
        let mut painter = Painter::new(&offscreen, &shared, options)?;
        let mut moments = Vec::new();
        for mut shot in shots {
            if !shot.is_kept {
                painter.draw(&mut shot.fire, &mut |_| {})?;
                continue;
            }
            moments.push(painter.paint(&mut shot.fire)?);
            if shot.is_last
                && let Some(picture) = Picture::mean(&std::mem::take(&mut moments))
                && drawn.send(picture).is_err()
            {
                break;
            }
        }
        Ok(())
    }

    /// The fire before its picture of that number: at its start, or from a checkpoint.
    fn begin(&self, settings: &Settings, part: &Range<u32>) -> Result<(Fire, u32), Error> {
        let mut fire = self.fire.fire(settings, self.size);
        let Some(name) = &self.resume else {
            return Ok((fire, 0));
        };
        let number = checkpoint::read(name, self.hash(settings), &mut fire)?;
        let earliest = (number..=part.end).find(|&start| self.lead(settings, start) >= number);
        match earliest {
            Some(earliest) if earliest <= part.start => Ok((fire, number)),
            _ => Err(Error::Use(format!(
                "{}: the checkpoint is for the pictures from {} on, and the first one is {}",
                shown(name),
                earliest.unwrap_or(part.end),
                part.start
            ))),
        }
    }

    /// Burns a part of the film, and shows what is drawn. Returns the state at its end if that becomes a checkpoint.
    fn burn(
        &self,
        (mut fire, first): (Fire, u32),
        part: &Range<u32>,
        progress: &Progress,
        shots: Option<SyncSender<Shot>>,
    ) -> Option<Vec<u8>> {
        let settings = fire.settings().clone();
        let clock = self.clock(&settings);
        match self.checkpoint {
            Some(_) => drop(fire.record_sound()),
            None => fire.forget_sound(),
        }
        let [drawn, kept] = [part.start, part.end].map(|number| self.lead(&settings, number));
        let mut counter = Counter::new(progress);
        let mut state = None;
        for number in first..part.end {
            if number == kept && self.checkpoint.is_some() {
                state = Some(checkpoint::write(self.hash(&settings), number, &fire));
                if shots.is_none() {
                    break;
                }
            }
            let is_kept = number >= part.start;
            for moment in 1..=self.motion_blur {
                fire.advance(self.moment(clock, number, moment), &mut |age| {
                    counter.at(age);
                });
                let shot = (is_kept || number >= drawn).then(|| Shot {
                    fire: fire.clone(),
                    is_kept,
                    is_last: moment == self.motion_blur,
                });
                if let (Some(shots), Some(shot)) = (&shots, shot)
                    && shots.send(shot).is_err()
                {
                    // Nobody draws any more.
                    return None;
                }
            }
        }
        state
    }

    /// The first picture that is drawn before that of a number: what is seen follows from those before it.
    fn lead(&self, settings: &Settings, number: u32) -> u32 {
        let pictures = CARRIED_SECONDS / self.clock(settings).elapsed(1).max(1e-6);
        number.saturating_sub(pictures as u32)
    }

    /// Age of the fire at a moment of a picture \[s\]. Of so many moments, the last one is the picture's own.
    fn moment(&self, clock: Clock, number: u32, moment: u32) -> f64 {
        let open = f64::from(self.motion_blur - moment) / f64::from(self.motion_blur);
        clock.age(number) - SHUTTER * open * clock.elapsed(1)
    }

    /// A hash of all that the fire of the film follows from.
    fn hash(&self, settings: &Settings) -> u64 {
        let values = (
            export(settings),
            self.size,
            self.from,
            self.fps,
            self.motion_blur,
        );
        checkpoint::hash(format!("{values:?} {:?}", self.fire.burning()).as_bytes())
    }

    /// The sound of a part of the film, whose fire stops at the same moments as that of the pictures.
    fn wav(
        &self,
        settings: &Settings,
        part: &Range<u32>,
        progress: &Progress,
    ) -> Result<Vec<u8>, Error> {
        let (mut fire, first) = self.begin(settings, part)?;
        let clock = self.clock(settings);
        let sound = fire.record_sound();
        let [start, end] = [part.start, part.end].map(|number| sound.sample_at(clock.age(number)));
        sound.keep_from(start);
        let mut counter = Counter::new(progress);
        for number in first.. {
            for moment in 1..=self.motion_blur {
                fire.advance(self.moment(clock, number, moment), &mut |age| {
                    counter.at(age);
                });
            }
            if number >= part.end
                && let Some(samples) = fire.record_sound().until(end)
            {
                return Ok(sound::wav(samples));
            }
        }
        Err(Error::Failed("the fire has no end".to_owned()))
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
