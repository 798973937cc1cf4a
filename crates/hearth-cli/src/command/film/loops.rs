//! How a loop is drawn: once small, to find its beginning, and then what it shows.

use std::collections::VecDeque;
use std::ops::Range;

use hearth_core::looping::Sparks;
use hearth_settings::Settings;

use super::Film;
use super::burning::CARRIED_SECONDS;
use crate::command::progress::{Counter, Progress};
use crate::error::{Error, shown};
use crate::film::Encoder;
use crate::film::seam::Loop;
use crate::painter::Painter;

/// Width and height of the pictures in which the beginning of a loop is looked for \[pixels\].
const SEEN_SIDE: u32 = 64;

impl Film {
    /// Writes the pictures of a part of a loop.
    pub(super) fn write_loop(
        &self,
        settings: &Settings,
        part: &Range<u32>,
        encoder: &mut dyn Encoder,
    ) -> Result<(), Error> {
        let (offscreen, shared) = self.driver.open()?;
        self.driver.warn(&shared);
        let [mut painter, mut small] = {
            let [large, small] = [(self.size, self.supersample), ([SEEN_SIDE; 2], 1)];
            let painter = |(size, samples)| {
                Painter::new(&offscreen, &shared, self.fire.picture(size, samples))
            };
            [painter(large)?, painter(small)?]
        };
        let clock = self.clock(settings);
        let film = Loop::new(self.count()?, self.fps);
        let time = |number: u32| clock.age(number);
        let mut fire = self.fire.fire(settings, self.size);
        let life = f64::from(fire.simulation().parameters().ember_life_max);
        let lived = film.searched() + (life / clock.elapsed(1)).ceil() as u32;
        let progress = Progress::new(time(lived) + time(film.searched()));
        progress.name(&shown(&self.scene));
        let mut counter = Counter::new(&progress);
        let (mut seen, mut sparks) = (Vec::new(), Sparks::default());
        for number in 0..lived {
            fire.advance(time(number), &mut |age| counter.at(age));
            if number < film.searched() {
                seen.push(small.paint_with(&mut fire, &[])?);
            }
            fire.write();
            sparks.record(fire.simulation(), &fire.embers);
        }
        let start = film.start(&seen);
        let mut fire = self.fire.fire(settings, self.size);
        let mut counter = Counter::new(&progress);
        let (mut earlier, mut shown) = (VecDeque::new(), Vec::new());
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
            sparks.show(
                time(number),
                start as usize,
                film.count as usize,
                &mut shown,
            );
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
}
