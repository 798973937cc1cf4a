//! The roar of a flame: the low band, which is the time derivative of its power, and the noise above it, whose level
//! follows the low band (Chadwick and James 2011).

use super::filters::{Filter, high_pass, low_pass, power_of as power, section};

/// Highest frequency of the low band \[Hz\], and its highest share of the rate of steps.
const CUTOFF: f64 = 180.0;
const CUTOFF_SHARE: f64 = 0.35;
/// Lowest frequency that is heard \[Hz\].
const LOWEST: f64 = 45.0;
/// Exponent of the power spectral density of the noise (Clavin and Siggia 1991).
const NOISE_EXPONENT: f64 = 2.5;
/// Sections that make the slope between that of a low pass, 2, and the exponent, and their highest frequency \[Hz\].
const SECTIONS: usize = 5;
const HIGHEST: f64 = 14_000.0;
/// Time over which the level of the low band is averaged \[s\].
const WINDOW: f64 = 0.04;
/// Time over which the low band has the level of its power \[s\].
const LEVEL_TIME: f64 = 1.5;
/// Change of the cut-off frequency that makes other filters.
const CUTOFF_TOLERANCE: f64 = 0.1;
/// Frequencies at which the filters are integrated.
const POINTS: u32 = 200;

/// The roar of one fire.
#[derive(Clone, Debug)]
pub(super) struct Roar {
    rate: f64,
    cutoff: f64,
    low: [Filter; 2],
    /// The upper octave of the low band.
    octave: Filter,
    noise: [Filter; SECTIONS + 2],
    /// Level of the noise over that of the upper octave.
    gain: f64,
    /// Mean square of the upper octave, and of the low band over more time.
    level: f64,
    mean: f64,
    /// What the low band is multiplied by.
    scale: f64,
}

crate::state! { Roar: rate cutoff low octave noise gain level mean scale }

impl Roar {
    pub fn new(rate: f64) -> Roar {
        let mut roar = Roar {
            rate,
            cutoff: 0.0,
            low: [Filter::default(), Filter::new(high_pass(LOWEST / rate))],
            octave: Filter::default(),
            noise: Default::default(),
            gain: 0.0,
            level: 0.0,
            mean: 0.0,
            scale: 0.0,
        };
        roar.follow(CUTOFF / CUTOFF_SHARE);
        roar
    }

    /// Sets the filters for a rate of steps [1/s].
    pub fn follow(&mut self, steps: f64) {
        let cutoff = CUTOFF.min(CUTOFF_SHARE * steps);
        if (cutoff - self.cutoff).abs() <= CUTOFF_TOLERANCE * self.cutoff {
            return;
        }
        self.cutoff = cutoff;
        let at = cutoff / self.rate;
        self.low[0].set(low_pass(at));
        self.octave.set(high_pass(0.5 * at));
        let ratio = power(HIGHEST / cutoff, 1.0 / SECTIONS as f64);
        let zero = power(ratio, 0.5 * NOISE_EXPONENT - 1.0);
        self.noise[0].set(high_pass(at));
        self.noise[1].set(section(0.5 * at, None));
        let mut pole = at;
        for filter in &mut self.noise[2..] {
            filter.set(section(pole, Some(pole * zero)));
            pole *= ratio;
        }
        self.match_levels(at);
    }

    /// Finds the gain with which noise and low band have one spectral density at the cut-off.
    fn match_levels(&mut self, cutoff: f64) {
        let (mut octave, mut above, mut made) = (0.0, 0.0, 0.0);
        let ratio = power(8.0 / cutoff, 1.0 / f64::from(POINTS));
        let mut frequency = cutoff / 16.0;
        while frequency < 0.5 {
            let width = frequency * (ratio - 1.0);
            let density = power(frequency / cutoff, -NOISE_EXPONENT) * width;
            octave += density * self.low[0].power(frequency) * self.octave.power(frequency);
            above += density * self.noise[0].power(frequency);
            let passed = self.noise.iter().map(|filter| filter.power(frequency));
            // White noise from −1 to 1 has the variance 1/3, spread from 0 to half of the rate.
            made += 2.0 / 3.0 * width * passed.product::<f64>();
            frequency *= ratio;
        }
        self.gain = (above / octave / made).sqrt();
    }

    /// Advances by a sample, in which the power changes at that rate, with white noise from −1 to 1. How much the power
    /// changes follows from the size of the particles, too: what it changes by on average has that level, and so has
    /// the least change. Without a level it keeps its scale.
    pub fn run(&mut self, slope: f64, level: f64, least: f64, white: f64) -> f64 {
        let [first, second] = &mut self.low;
        let low = second.run(first.run(slope));
        self.mean += (low * low - self.mean) / (LEVEL_TIME * self.rate);
        if level > 0.0 {
            self.scale = level / self.mean.sqrt().max(least);
        }
        let low = self.scale * low;
        let upper = self.octave.run(low);
        self.level += (upper * upper - self.level) / (WINDOW * self.rate);
        let noise = self
            .noise
            .iter_mut()
            .fold(white, |sample, filter| filter.run(sample));
        low + noise * self.gain * self.level.sqrt()
    }
}
