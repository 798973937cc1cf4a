//! Digital filters of first and second order. Frequencies are shares of the sample rate.

use crate::direction::direction;

/// A filter of second order in transposed direct form II.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Filter {
    coefficients: Coefficients,
    past: [f64; 2],
}

crate::state! { Filter: coefficients past }

/// The coefficients b0, b1, b2, a1, a2, with a0 = 1.
pub(super) type Coefficients = [f64; 5];

impl Filter {
    pub fn new(coefficients: Coefficients) -> Filter {
        Filter {
            coefficients,
            past: [0.0; 2],
        }
    }

    /// Keeps what it has heard.
    pub fn set(&mut self, coefficients: Coefficients) {
        self.coefficients = coefficients;
    }

    /// Filters a sample.
    pub fn run(&mut self, sample: f64) -> f64 {
        let [b0, b1, b2, a1, a2] = self.coefficients;
        let result = b0 * sample + self.past[0];
        self.past[0] = b1 * sample - a1 * result + self.past[1];
        self.past[1] = b2 * sample - a2 * result;
        result
    }

    /// Squared magnitude of the transfer function at a frequency.
    pub fn power(&self, frequency: f64) -> f64 {
        let [b0, b1, b2, a1, a2] = self.coefficients;
        let (sin, cos) = circle(frequency);
        let (sin2, cos2) = (2.0 * sin * cos, cos * cos - sin * sin);
        let squared = |c0: f64, c1: f64, c2: f64| {
            let (real, imaginary) = (c0 + c1 * cos + c2 * cos2, c1 * sin + c2 * sin2);
            real * real + imaginary * imaginary
        };
        squared(b0, b1, b2) / squared(1.0, a1, a2)
    }
}

/// Sine and cosine of the angle that a frequency passes in a sample.
pub(super) fn circle(frequency: f64) -> (f64, f64) {
    let at = direction((360.0 * frequency) as f32);
    (f64::from(at.y), f64::from(at.x))
}

/// A frequency warped for the bilinear transform.
// The filters are made rarely, so that one copy of this code is enough.
#[inline(never)]
fn warped(frequency: f64) -> f64 {
    let (sin, cos) = circle(0.5 * frequency.min(0.49));
    sin / cos
}

/// Butterworth's low pass of second order.
pub(super) fn low_pass(frequency: f64) -> Coefficients {
    let (k, norm, a1, a2) = butterworth(frequency);
    let b = k * k * norm;
    [b, 2.0 * b, b, a1, a2]
}

/// Butterworth's high pass of second order.
pub(super) fn high_pass(frequency: f64) -> Coefficients {
    let (_, norm, a1, a2) = butterworth(frequency);
    [norm, -2.0 * norm, norm, a1, a2]
}

#[inline(never)]
fn butterworth(frequency: f64) -> (f64, f64, f64, f64) {
    let k = warped(frequency);
    let norm = 1.0 / (1.0 + std::f64::consts::SQRT_2 * k + k * k);
    let a2 = (1.0 - std::f64::consts::SQRT_2 * k + k * k) * norm;
    (k, norm, 2.0 * (k * k - 1.0) * norm, a2)
}

/// A section of first order, (1 + s / zero) / (1 + s / pole); without a zero it is a low pass.
pub(super) fn section(pole: f64, zero: Option<f64>) -> Coefficients {
    let (p, z) = (
        1.0 / warped(pole),
        zero.map_or(0.0, |zero| 1.0 / warped(zero)),
    );
    let norm = 1.0 / (1.0 + p);
    [
        (1.0 + z) * norm,
        (1.0 - z) * norm,
        0.0,
        (1.0 - p) * norm,
        0.0,
    ]
}

/// Share that is left after a time of one, with that decay time.
pub fn decay(time: f64) -> f64 {
    f64::from(libm::expf((-1.0 / time) as f32))
}

/// `base`, which is above 0, to the power of `exponent`. `powf` has 1.7 KB.
#[inline(never)]
pub fn power_of(base: f64, exponent: f64) -> f64 {
    f64::from(libm::expf(exponent as f32 * libm::logf(base as f32)))
}
