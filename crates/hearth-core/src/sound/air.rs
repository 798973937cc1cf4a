//! What sounds of the air: hiss of steam, jets and wood, the strike of a match, and the flutter of flames and sheets.

use super::filters::{Filter, high_pass, low_pass};
use crate::random::Random;

/// The bands of steam and wood, of jets, and of flutter: their ends \[Hz\].
const STEAM_BAND: [f64; 2] = [2000.0, 11_000.0];
const JET_BAND: [f64; 2] = [900.0, 5000.0];
const FLUTTER_BAND: [f64; 2] = [110.0, 600.0];
/// Time in which a hiss follows \[s\].
const HISS_TIME: f64 = 0.04;
/// Level below which it is not computed.
const SILENCE: f64 = 1e-6;

/// The strike that lights a narrow source: its level, and the times of the scratch and of the flare \[s\].
const STRIKE_LEVEL: f64 = 0.2;
const SCRATCH_TIME: f64 = 0.13;
const FLARE_TIME: f64 = 0.12;
/// Grains of the scratch in a second.
const GRAIN_RATE: f64 = 180.0;

/// A band of noise.
type Band = [Filter; 2];

/// The levels that a sample follows.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Levels {
    pub steam: f64,
    pub jet: f64,
    pub flutter: f64,
    /// Flaps in a second.
    pub flaps: f64,
}

/// The air around one fire.
#[derive(Clone, Debug)]
pub(super) struct Air {
    rate: f64,
    steam: Band,
    jet: Band,
    flutter: Band,
    levels: Levels,
    /// Time since a strike \[s\]; none without one.
    strike: Option<f64>,
    /// Share of the present flap that has passed, its strength, and its length over the mean.
    flap: f64,
    strength: f64,
    length: f64,
}

crate::state! { Levels: steam jet flutter flaps, Air: rate steam jet flutter levels strike flap strength length }

impl Air {
    pub fn new(rate: f64) -> Air {
        let band = |[low, high]: [f64; 2]| {
            [
                Filter::new(high_pass(low / rate)),
                Filter::new(low_pass(high / rate)),
            ]
        };
        Air {
            rate,
            steam: band(STEAM_BAND),
            jet: band(JET_BAND),
            flutter: band(FLUTTER_BAND),
            levels: Levels::default(),
            strike: None,
            flap: 0.0,
            strength: 1.0,
            length: 1.0,
        }
    }

    /// A match is struck.
    pub fn strike(&mut self) {
        self.strike = Some(0.0);
    }

    /// A sample of hiss and one of flutter, of white noise from −1 to 1.
    pub fn run(&mut self, to: &Levels, white: f64, random: &mut Random) -> [f64; 2] {
        let follow = 1.0 / (HISS_TIME * self.rate);
        let levels = &mut self.levels;
        levels.steam += (to.steam - levels.steam) * follow;
        levels.jet += (to.jet - levels.jet) * follow;
        levels.flutter += (to.flutter - levels.flutter) * follow;
        levels.flaps = to.flaps;
        let Levels {
            steam,
            jet,
            flutter,
            ..
        } = *levels;
        let strike = self.striking();
        let mut hiss = 0.0;
        if steam + strike > SILENCE {
            hiss += (steam + 0.6 * strike) * passed(&mut self.steam, white);
        }
        if jet + strike > SILENCE {
            hiss += (jet + 0.4 * strike) * passed(&mut self.jet, white);
        }
        let mut flapping = 0.0;
        if flutter > SILENCE {
            flapping = flutter * self.flapping(random) * passed(&mut self.flutter, white);
        }
        [hiss, flapping]
    }

    /// How strong the present flap is.
    fn flapping(&mut self, random: &mut Random) -> f64 {
        self.flap += self.levels.flaps / (self.length * self.rate);
        if self.flap >= 1.0 {
            self.flap = 0.0;
            self.strength = f64::from(random.between(0.3, 1.0));
            self.length = f64::from(random.between(0.6, 1.4));
        }
        self.strength * bump(self.flap)
    }

    /// The level of the strike.
    fn striking(&mut self) -> f64 {
        let Some(time) = &mut self.strike else {
            return 0.0;
        };
        *time += 1.0 / self.rate;
        let time = *time;
        if time < SCRATCH_TIME {
            return STRIKE_LEVEL * time / SCRATCH_TIME * bump((GRAIN_RATE * time) % 1.0);
        }
        if time > SCRATCH_TIME + 8.0 * FLARE_TIME {
            self.strike = None;
        }
        let passed = (SCRATCH_TIME - time) / FLARE_TIME;
        STRIKE_LEVEL * f64::from(libm::expf(passed as f32))
    }
}

/// Rises from 0 to 1 and falls again, while its place goes from 0 to 1.
fn bump(place: f64) -> f64 {
    let parabola = 4.0 * place * (1.0 - place);
    parabola * parabola
}

fn passed([high, low]: &mut Band, sample: f64) -> f64 {
    low.run(high.run(sample))
}
