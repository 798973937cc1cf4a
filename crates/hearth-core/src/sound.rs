//! The sound of a fire, computed from the series of its steps: the same series, seed and calls give the same samples,
//! natively and in wasm. `docs/sound.md` has the equations and their sources.

mod air;
mod cracks;
mod filters;
mod roar;
mod room;

use std::collections::VecDeque;

use crate::random::Random;
use crate::series::StepRecord;
use air::{Air, Levels};
use cracks::{Breaking, Cracks};
use filters::{decay, power_of};
use roar::Roar;
use room::Room;

/// Level of the roar at the reference power, beside the rest as in recorded campfires and fireplaces.
const ROAR_LEVEL: f64 = 0.015;
/// Least change of the power that is as loud as that, as a share of the power [1/s].
const LEAST_CHANGE: f64 = 0.6;
/// Level of the flame of a narrow source, which is laminar and changes only as its particles do.
const LAMINAR: f64 = 0.12;
/// Exponent of the loudness of the power (Stevens 1955), and the power at which the level is that of the constant above
/// [kW/m]. The power is averaged over that time \[s\]. Below the least power the gain grows no more [kW/m].
const LOUDNESS_EXPONENT: f64 = 0.6;
const REFERENCE_POWER: f64 = 300.0;
const LEAST_POWER: f64 = 2.0;
const POWER_TIME: f64 = 0.3;
/// Largest change of the power over its mean square root, in which that of the last half second counts.
const CREST: f64 = 5.0;
const CREST_TIME: f64 = 0.5;
/// Rate at which the power of every flame may change [1/s].
const FLICKER_RATE: f64 = 4.0;
/// Heat of a particle of the classic model \[kJ/m\], with which its level is that of the other model.
const PARTICLE_HEAT: f64 = 0.06;

/// Snaps for each spark thrown, gram of water dried, gram of char formed, and part broken off.
const SNAPS_PER_SPARK: f64 = 1.0;
const SNAPS_PER_DRIED: f64 = 15.0;
const SNAPS_PER_CHARRED: f64 = 28.0;
const SNAPS_PER_BREAK: f64 = 100.0;
/// Time over which events become a rate of snaps \[s\].
const RATE_TIME: f64 = 0.25;
/// Most snaps in a second, and pops in a step.
const MAX_RATE: f64 = 300.0;
const MOST_POPS: f32 = 4.0;

/// Hiss of steam: its power for a gram in a second. That of wood: its power for a snap in a second, of the rate averaged
/// over so long \[s\].
const STEAM_POWER: f64 = 2e-4;
const WOOD_POWER: f64 = 2.4e-6;
const WOOD_TIME: f64 = 1.5;
/// Hiss of a jet of 1 m/s. Its amplitude grows with the fourth power of the speed (Lighthill 1952).
const JET_LEVEL: f64 = 0.01;
/// Flutter of a flame and of sheets at the reference power, and the load of a sheet [kg/m²].
const FLUTTER_LEVEL: f64 = 0.14;
const SHEET_LOAD: f64 = 1.5;
/// Flaps of a sheet in a second, and from how many a flame flutters.
const SHEET_FLAPS: f64 = 11.0;
const LEAST_FLAPS: f64 = 3.0;
/// Power above which a fire is lit, and below which it is out [kW/m].
const LIT_POWER: f64 = 0.01;

/// Share of the width between the loudspeakers that places take.
const PAN_WIDTH: f64 = 0.7;
/// Samples up to this are as they are; larger ones stay below 1.
const LINEAR: f64 = 0.7;
/// Time of every fade \[s\].
const FADE_TIME: f64 = 0.08;

/// How loud each part of the sound is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mix {
    /// The volume from 0 to 1: equal steps are about equally loud.
    pub volume: f32,
    /// The roar, relative to the balance of recorded fires.
    pub roar: f32,
    /// The crackle, relative to the balance of recorded fires.
    pub crackle: f32,
    /// The hiss, relative to the balance of recorded fires.
    pub hiss: f32,
}

impl Default for Mix {
    /// The balance of recorded fires.
    fn default() -> Mix {
        Mix {
            volume: 1.0,
            roar: 1.0,
            crackle: 1.0,
            hiss: 1.0,
        }
    }
}

impl Mix {
    fn gains(&self) -> [f64; 4] {
        let Mix {
            volume,
            roar,
            crackle,
            hiss,
        } = *self;
        [volume * volume, roar, crackle, hiss].map(f64::from)
    }
}

/// What lasts from the middle of a step to that of the next, by the clock.
#[derive(Clone, Copy, Debug, Default)]
struct Segment {
    duration: f64,
    slope: f64,
    /// Level of the roar, and the change of the power that has it at least.
    roar: f64,
    least: f64,
    breaking: Breaking,
    levels: Levels,
    wall: f64,
    pops: u32,
    strikes: bool,
}

/// A value that moves to another at a constant rate.
#[derive(Clone, Copy, Debug, Default)]
struct Ramp {
    value: f64,
    target: f64,
}

impl Ramp {
    fn at(value: f64) -> Ramp {
        Ramp {
            value,
            target: value,
        }
    }

    /// Advances by a sample, in which it changes by that much at most.
    fn next(&mut self, step: f64) -> f64 {
        self.value += within(self.target - self.value, step);
        self.value
    }
}

/// The sound of one fire.
///
/// ```
/// # use hearth_core::{Parameters, Simulation, sound::{Mix, Synthesis}};
/// let mut fire = Simulation::new(Parameters::default());
/// fire.record_series(true);
/// let mut sound = Synthesis::new(48_000.0, 1, Mix::default());
/// for _ in 0..100 {
///     fire.step();
/// }
/// sound.push(&fire.read_series(), 1.0, 0.9);
/// let frames = (sound.ahead() * 48_000.0) as usize;
/// let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
/// sound.render(&mut left, &mut right);
/// assert!(left.iter().any(|&sample| sample != 0.0));
/// ```
#[derive(Clone, Debug)]
pub struct Synthesis {
    rate: f64,
    random: Random,
    roar: Roar,
    cracks: Cracks,
    air: Air,
    room: Room,
    /// What is heard now, and what is not heard yet.
    segments: VecDeque<Segment>,
    /// Their duration \[s\].
    ahead: f64,
    /// Length and power of the last step.
    last: Option<[f64; 2]>,
    /// Mean square of the change of the power, and mean power.
    square: f64,
    power: f64,
    /// Snaps that are due, of solids with fuel and of sparks.
    fuel_snaps: f64,
    spark_snaps: f64,
    /// Mean rate of snaps.
    snaps: f64,
    step_rate: f64,
    presence: Ramp,
    wall: Ramp,
    /// Volume, roar, crackle and hiss.
    mix: [Ramp; 4],
}

crate::state! {
    Segment: duration slope roar least breaking levels wall pops strikes,
    Ramp: value target,
    Synthesis: rate random roar cracks air room segments ahead last square power fuel_snaps spark_snaps snaps
        step_rate presence wall mix
}

impl Synthesis {
    /// The sound of a fire that has not begun, with a sample rate \[Hz\].
    pub fn new(rate: f64, seed: u32, mix: Mix) -> Synthesis {
        let mut random = Random::new(seed);
        Synthesis {
            rate,
            roar: Roar::new(rate),
            cracks: Cracks::new(rate, &mut random),
            air: Air::new(rate),
            room: Room::new(rate),
            random,
            segments: VecDeque::new(),
            ahead: 0.0,
            last: None,
            square: 0.0,
            power: 0.0,
            fuel_snaps: 0.0,
            spark_snaps: 0.0,
            snaps: 0.0,
            step_rate: 0.0,
            presence: Ramp::default(),
            wall: Ramp::default(),
            mix: mix.gains().map(Ramp::at),
        }
    }

    /// Fades to another mix.
    pub fn mix(&mut self, mix: Mix) {
        for (ramp, gain) in self.mix.iter_mut().zip(mix.gains()) {
            ramp.target = gain;
        }
    }

    /// Seconds of the clock for which there are samples.
    pub fn ahead(&self) -> f64 {
        self.ahead
    }

    /// Drops the oldest steps beyond so many seconds of the clock.
    pub fn trim(&mut self, seconds: f64) {
        while self.ahead > seconds
            && let Some(dropped) = self.segments.pop_front()
        {
            self.ahead -= dropped.duration;
        }
    }

    /// Takes the next steps. `speed` is the seconds of fire in a second of the clock; the edges of the picture are at
    /// that distance from its middle \[m\].
    pub fn push(&mut self, steps: &[StepRecord], speed: f64, half_width: f32) {
        for step in steps {
            self.add(step, speed, half_width);
        }
    }

    fn add(&mut self, step: &StepRecord, speed: f64, half_width: f32) {
        let seconds = f64::from(step.length);
        let length = seconds / speed;
        if !(length > 0.0 && length.is_finite()) {
            return;
        }
        let lives = f64::from(step.births) + f64::from(step.deaths);
        let power = f64::from(step.power) + PARTICLE_HEAT * lives / (2.0 * seconds);
        let last = self.last.replace([length, power]);
        let [last_length, last_power] = last.unwrap_or([length, power]);
        let duration = 0.5 * (last_length + length);
        let follow = |time: f64| 1.0 - decay(time / duration);
        self.power += (power - self.power) * follow(POWER_TIME);
        // A preset or a new particle count changes the power at once, which no flame does.
        let most = CREST * self.square.sqrt() + FLICKER_RATE * self.power.min(power);
        let slope = within((power - last_power) / duration, most);
        self.square += (slope * slope - self.square) * follow(CREST_TIME);
        let spent = 1.0 - follow(RATE_TIME);
        self.fuel_snaps = self.fuel_snaps * spent
            + 1000.0 * SNAPS_PER_DRIED * f64::from(step.dried)
            + 1000.0 * SNAPS_PER_CHARRED * f64::from(step.charred)
            + SNAPS_PER_BREAK * f64::from(step.broken);
        self.spark_snaps = self.spark_snaps * spent + SNAPS_PER_SPARK * f64::from(step.sparks);
        let first = self.step_rate == 0.0;
        let share = if first { 1.0 } else { follow(POWER_TIME) };
        self.step_rate += (1.0 / length - self.step_rate) * share;
        self.roar.follow(self.step_rate);
        let snaps = if self.fuel_snaps > 0.1 {
            self.fuel_snaps
        } else {
            self.spark_snaps
        };
        let rate = (snaps / RATE_TIME).min(MAX_RATE);
        self.snaps += (rate - self.snaps) * follow(WOOD_TIME);
        let load = f64::from(step.load);
        let steam = 1000.0 * f64::from(step.steam + step.dried) / length;
        let sheet = if load > 0.0 && load < SHEET_LOAD {
            1.0
        } else {
            0.0
        };
        let flaps = f64::from(step.flutter);
        let flame = ((flaps - LEAST_FLAPS) / LEAST_FLAPS).clamp(0.0, 1.0);
        let jet = f64::from(step.jet);
        let place = within(f64::from(step.place / half_width), 1.0);
        let is_laminar = jet > 0.0 && flaps == 0.0 && load == 0.0;
        let turbulence = if is_laminar { LAMINAR } else { 1.0 };
        let mean = self.power.max(LEAST_POWER);
        let loudness = power_of(mean / REFERENCE_POWER, LOUDNESS_EXPONENT);
        self.ahead += duration;
        self.segments.push_back(Segment {
            duration,
            slope,
            roar: ROAR_LEVEL * loudness * turbulence,
            least: LEAST_CHANGE * mean * speed,
            breaking: Breaking {
                rate,
                load,
                pan: PAN_WIDTH * place,
            },
            levels: Levels {
                steam: (STEAM_POWER * steam + WOOD_POWER * self.snaps).sqrt(),
                jet: JET_LEVEL * jet * jet * jet * jet,
                flutter: FLUTTER_LEVEL * loudness * flame.max(sheet),
                flaps: if sheet > 0.0 { SHEET_FLAPS } else { flaps },
            },
            wall: f64::from(step.wall),
            pops: step.pops.min(MOST_POPS) as u32,
            strikes: jet > 0.0 && power > LIT_POWER && last_power <= LIT_POWER,
        });
    }

    /// Fills both channels, of one length. Where the series ends, the sound fades.
    pub fn render(&mut self, left: &mut [f32], right: &mut [f32]) {
        let dt = 1.0 / self.rate;
        let fade = dt / FADE_TIME;
        for (left, right) in left.iter_mut().zip(right) {
            let segment = self.advance(dt);
            let heard = segment.duration > 0.0;
            self.presence.target = f64::from(u8::from(heard));
            let [volume, roar, crackle, hiss] = self.mix.each_mut().map(|ramp| ramp.next(fade));
            let volume = volume * self.presence.next(fade);
            let white = f64::from(self.random.between(-1.0, 1.0));
            let low = self
                .roar
                .run(segment.slope, segment.roar, segment.least, white);
            let [hissing, flutter] = self.air.run(&segment.levels, white, &mut self.random);
            let low = roar * (low + flutter);
            let cracks = self.cracks.run(&segment.breaking, &mut self.random);
            let bright = cracks.map(|crack| hiss * hissing + crackle * crack);
            if heard {
                self.wall.target = segment.wall;
            }
            let wall = self.wall.next(fade);
            let returned = if wall > 0.0 {
                self.room.run(bright[0] + bright[1])
            } else {
                [0.0; 2]
            };
            for (out, (side, returned)) in [left, right]
                .into_iter()
                .zip(bright.into_iter().zip(returned))
            {
                *out = limited(volume * (low + side + wall * returned)) as f32;
            }
        }
    }

    /// Advances by a sample. Returns what lasts in it, with the mean change of the power; after the end, nothing.
    fn advance(&mut self, dt: f64) -> Segment {
        let (mut left, mut change) = (dt, 0.0);
        let mut heard = Segment::default();
        while left > 0.0 {
            let Some(segment) = self.segments.front_mut() else {
                // The next step follows a pause. No rounding error lasts.
                (self.last, self.ahead) = (None, 0.0);
                break;
            };
            if std::mem::take(&mut segment.strikes) {
                self.air.strike();
            }
            for _ in 0..std::mem::take(&mut segment.pops) {
                self.cracks.pop(&segment.breaking, &mut self.random);
            }
            heard = *segment;
            let part = left.min(segment.duration);
            change += part * segment.slope;
            segment.duration -= part;
            self.ahead -= part;
            left -= part;
            if segment.duration <= 0.0 {
                self.segments.pop_front();
            }
        }
        heard.slope = change / dt;
        heard
    }
}

/// A sample below 1: small ones are as they are.
fn limited(sample: f64) -> f64 {
    let over = (sample.abs() - LINEAR).max(0.0) / (1.0 - LINEAR);
    let most = sample.abs().min(LINEAR) + (1.0 - LINEAR) * over / (1.0 + over);
    most.copysign(sample)
}

/// A number of at most that magnitude. `clamp` panics for some, with words that are larger than the synthesis.
fn within(number: f64, most: f64) -> f64 {
    number.min(most).max(-most)
}
