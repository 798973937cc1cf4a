//! How the fire of a film burns and is drawn, and how it sounds.

use std::io::{Write, stderr};
use std::ops::Range;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use hearth_settings::{Settings, export};

use super::Film;
use crate::Fire;
use crate::command::progress::{Counter, Progress};
use crate::error::{Error, shown};
use crate::film::{Clock, Encoder, checkpoint, sound};
use crate::painter::{self, Painter};
use crate::picture::Picture;

/// Share of the time between two pictures during which the shutter is open.
const SHUTTER: f64 = 0.5;

/// Time over which the fine structure of a picture is carried on from earlier ones, its longest period \[s\].
pub(super) const CARRIED_SECONDS: f64 = 1.5;

/// Most moments that wait to be drawn, and most pictures that wait to be encoded.
const MOST_WAITING: usize = 2;

/// Memory from which on it is told \[bytes\].
const LEAST_TOLD: u64 = 512 << 20;

/// A fire at a moment of a picture.
pub(super) struct Shot {
    fire: Fire,
    /// Whether it is seen, or only prepares a picture that is.
    is_kept: bool,
    is_last: bool,
}

impl Film {
    /// Writes the pictures of a part of the film: it burns, is drawn and is encoded at the same time. Returns the state at
    /// its end if that becomes a checkpoint.
    pub(super) fn write_pictures(
        &self,
        settings: &Settings,
        part: &Range<u32>,
        progress: &Progress,
        encoder: &mut dyn Encoder,
    ) -> Result<Option<Vec<u8>>, Error> {
        let begun = self.begin(settings, part)?;
        let state = thread::scope(|scope| {
            let (burnt, shots) = sync_channel(MOST_WAITING);
            let burn = move || self.burn(begun, part, progress, Some(burnt));
            let burning = thread::Builder::new().spawn_scoped(scope, burn);
            let burning = burning.map_err(Error::of_thread)?;
            let (drawn, pictures) = sync_channel(MOST_WAITING);
            let draw = move || self.draw(shots, drawn);
            let drawing = thread::Builder::new().spawn_scoped(scope, draw);
            let drawing = drawing.map_err(Error::of_thread)?;
            for picture in pictures {
                encoder.add(&picture)?;
            }
            let failed = |_| Error::Failed("a thread of the film has failed".to_owned());
            drawing.join().map_err(failed)??;
            burning.join().map_err(failed)
        })?;
        progress.finish();
        Ok(state)
    }

    /// Writes to standard error how much memory large pictures take.
    pub(super) fn tell_memory(&self) {
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
    pub(super) fn begin(
        &self,
        settings: &Settings,
        part: &Range<u32>,
    ) -> Result<(Fire, u32), Error> {
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
    pub(super) fn burn(
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
    pub(super) fn wav(
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
}
