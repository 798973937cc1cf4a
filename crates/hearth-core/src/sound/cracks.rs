//! Crackle: snaps at random times, in clusters, whose sizes follow a power law. Each rings with the modes of a piece of
//! wood. The many small ones are the bed of the sound, the few large ones stand out of it.

use super::filters::{circle, decay, power_of as power};
use crate::random::Random;

/// Amplitude of the smallest snap, relative to full scale, and that of the largest over it.
const SMALLEST: f64 = 0.0132;
const LARGEST_RATIO: f64 = 60.0;
/// Exponent of the distribution of sizes, P(amplitude > a) ∝ a^−2.5, as in the recorded fireplace.
pub(super) const SIZE_EXPONENT: f64 = 2.5;
/// Mean number of snaps that a snap sets off, for each of its size, and the most; and the mean time until they begin \[s\].
const AFTERSHOCKS: f64 = 0.24;
const MOST_AFTERSHOCKS: f64 = 6.0;
const CLUSTER_TIME: f64 = 0.04;
/// Amplitude of the smallest and of the largest pop over that of the smallest snap, and the exponent between them.
const POP_RATIO: [f64; 2] = [24.0, 88.0];
const POP_EXPONENT: f64 = 1.5;
/// Lowest mode of a solid of that load \[Hz\], [kg/m²]: light sheets ring higher than logs.
const MODE: f64 = 1500.0;
const MODE_LOAD: f64 = 12.0;
/// The lowest and the highest such mode, that of sparks without fuel, and that of pops over those of snaps.
const LOWEST_MODE: f64 = 1200.0;
const HIGHEST_MODE: f64 = 4500.0;
const SPARK_MODE: f64 = 1700.0;
const POP_MODE: f64 = 0.6;
/// Ratio of the highest to the lowest mode of pieces of the same solid.
const MODE_SPREAD: f64 = 4.0;
/// The modes of a free bar over the lowest (Fletcher and Rossing 1998), and their amplitudes.
const RATIOS: [f64; MODES] = [1.0, 2.756, 5.404];
const AMPLITUDES: [f64; MODES] = [0.45, 0.7, 0.8];
const MODES: usize = 3;
/// Quality of the modes of charred wood.
const QUALITY: f64 = 9.0;
/// Amplitude of the fracture, which is noise, and its decay time \[s\].
const FRACTURE: f64 = 1.4;
const FRACTURE_TIME: f64 = 0.00025;
/// Decay times after which a snap is silent.
const DECAYS_HEARD: f64 = 7.0;
/// Most snaps at a time.
const MAX_SNAPS: usize = 48;

/// A damped oscillation: its last two samples, and its coefficients.
#[derive(Clone, Copy, Debug, Default)]
struct Mode {
    past: [f64; 2],
    turn: f64,
    loss: f64,
}

/// A snap of a piece of wood.
#[derive(Clone, Copy, Debug)]
struct Snap {
    modes: [Mode; MODES],
    fracture: f64,
    /// Samples until it is silent.
    left: f64,
    /// Amplitude on the left and on the right.
    sides: [f64; 2],
}

/// The cracks of one fire.
#[derive(Clone, Debug)]
pub(super) struct Cracks {
    rate: f64,
    /// Expected number of snaps until now, and that of the next. A Poisson process in that time has the rate 1.
    expected: f64,
    next: f64,
    /// Expected number of aftershocks that are due.
    due: f64,
    /// Lowest mode of the last piece that broke \[Hz\].
    piece: f64,
    fracture_decay: f64,
    snaps: Vec<Snap>,
}

/// What a sample of a crack follows.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Breaking {
    /// Rate of snaps, without aftershocks [1/s].
    pub rate: f64,
    /// Load of the solids that burn [kg/m²]; 0 without any.
    pub load: f64,
    /// From −1, left, to 1, right.
    pub pan: f64,
}

crate::state! {
    Mode: past turn loss,
    Snap: modes fracture left sides,
    Breaking: rate load pan,
    Cracks: rate expected next due piece fracture_decay snaps
}

impl Cracks {
    pub fn new(rate: f64, random: &mut Random) -> Cracks {
        Cracks {
            rate,
            expected: 0.0,
            next: waiting(random),
            due: 0.0,
            piece: SPARK_MODE,
            fracture_decay: decay(FRACTURE_TIME * rate),
            snaps: Vec::with_capacity(MAX_SNAPS),
        }
    }

    /// A sample of both channels, in which snaps begin at that rate.
    pub fn run(&mut self, breaking: &Breaking, random: &mut Random) -> [f64; 2] {
        let after = self.due / (CLUSTER_TIME * self.rate);
        self.due -= after;
        let spontaneous = breaking.rate / self.rate;
        self.expected += spontaneous + after;
        if self.expected >= self.next {
            self.next = self.expected + waiting(random);
            let share = f64::from(random.unit());
            let is_other = share * (spontaneous + after) < spontaneous;
            let size = power(1.0 - f64::from(random.unit()), -1.0 / SIZE_EXPONENT);
            let size = size.min(LARGEST_RATIO);
            self.due += (AFTERSHOCKS * size).min(MOST_AFTERSHOCKS);
            let spread = power(MODE_SPREAD, f64::from(random.unit()) - 0.5);
            if is_other {
                self.piece = mode_of(breaking.load) * spread;
            }
            self.begin(SMALLEST * size, self.piece, breaking.pan);
        }
        self.sound(random)
    }

    /// A piece pops, which throws a spark.
    pub fn pop(&mut self, breaking: &Breaking, random: &mut Random) {
        let [least, most] = POP_RATIO;
        let size = least * power(1.0 - f64::from(random.unit()), -1.0 / POP_EXPONENT);
        self.due += MOST_AFTERSHOCKS;
        let spread = power(MODE_SPREAD, f64::from(random.unit()) - 0.5);
        self.piece = mode_of(breaking.load) * spread;
        self.begin(
            SMALLEST * size.min(most),
            POP_MODE * self.piece,
            breaking.pan,
        );
    }

    fn begin(&mut self, amplitude: f64, lowest: f64, pan: f64) {
        if self.snaps.len() >= MAX_SNAPS {
            return;
        }
        let mut modes = [Mode::default(); MODES];
        for (mode, (ratio, share)) in modes.iter_mut().zip(RATIOS.into_iter().zip(AMPLITUDES)) {
            let frequency = ratio * lowest / self.rate;
            if frequency < 0.45 {
                let (sin, cos) = circle(frequency);
                let left = decay(QUALITY / (std::f64::consts::PI * frequency));
                *mode = Mode {
                    past: [0.0, -amplitude * share * sin / left],
                    turn: 2.0 * left * cos,
                    loss: left * left,
                };
            }
        }
        self.snaps.push(Snap {
            modes,
            fracture: FRACTURE * amplitude,
            left: DECAYS_HEARD * QUALITY * self.rate / (std::f64::consts::PI * lowest),
            sides: [1.0 - pan, 1.0 + pan].map(|share| (0.5 * share).sqrt()),
        });
    }

    fn sound(&mut self, random: &mut Random) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for snap in &mut self.snaps {
            let mut sample = snap.fracture * f64::from(random.between(-1.0, 1.0));
            snap.fracture *= self.fracture_decay;
            for mode in &mut snap.modes {
                let next = mode.turn * mode.past[0] - mode.loss * mode.past[1];
                mode.past = [next, mode.past[0]];
                sample += next;
            }
            snap.left -= 1.0;
            for (sum, side) in sum.iter_mut().zip(snap.sides) {
                *sum += side * sample;
            }
        }
        self.snaps.retain(|snap| snap.left > 0.0);
        sum
    }
}

/// A random number of expected snaps until the next.
fn waiting(random: &mut Random) -> f64 {
    -f64::from(libm::logf(1.0 - random.unit()))
}

/// The lowest mode of a solid of that load \[Hz\].
fn mode_of(load: f64) -> f64 {
    if load > 0.0 {
        (MODE * (MODE_LOAD / load).sqrt()).clamp(LOWEST_MODE, HIGHEST_MODE)
    } else {
        SPARK_MODE
    }
}
