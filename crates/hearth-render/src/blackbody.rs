//! Black-body colours: Planck's law and the CIE 1931 standard observer.
//!
//! Soot glows nearly as a black body, so a table by temperature gives all colours of the flame.
//! The table separates chroma (linear sRGB of unit luminance) from the logarithm of luminance.
//! Luminance spans a factor of 170 000 between 1000 and 2000 K, far beyond a screen, so an
//! exponent compresses it; the chroma stays physical.
//!
//! A camera's white balance adapts the chroma: von Kries' law, in the cone space of Bradford (K. M. Lam, *Metamerism and
//! Colour Constancy*, University of Bradford 1985; matrix of ICC.1:2010, annex E).

use crate::cie::{FIRST_WAVELENGTH, OBSERVER, WAVELENGTH_STEP};
use crate::constants::{COLOUR_ENTRIES, COOLEST_KELVIN, HOTTEST_KELVIN};

/// Temperature of unit luminance \[K\]: the middle of a flame.
const UNIT_LUMINANCE_KELVIN: f64 = 1500.0;

/// The white of the displayed picture \[K\]: a camera balanced for it adapts nothing.
pub const NEUTRAL_KELVIN: f64 = 6500.0;
/// CIE XYZ to the responses of sharpened cones, and back.
const BRADFORD: [[f64; 3]; 3] = [
    [0.8951, 0.2664, -0.1614],
    [-0.7502, 1.7135, 0.0367],
    [0.0389, -0.0685, 1.0296],
];
const FROM_BRADFORD: [[f64; 3]; 3] = [
    [0.986_992_9, -0.147_054_3, 0.159_962_7],
    [0.432_305_3, 0.518_360_3, 0.049_291_2],
    [-0.008_528_7, 0.040_042_8, 0.968_486_7],
];

/// CIE 1931 chromaticity coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chromaticity {
    /// Share of X.
    pub x: f64,
    /// Share of Y.
    pub y: f64,
}

/// Chromaticity of a black body of `temperature` \[K\] to a camera balanced for a black body of `white` \[K\].
pub fn chromaticity(temperature: f64, white: f64) -> Chromaticity {
    let [x, y, z] = adapted(temperature, white);
    let sum = x + y + z;
    Chromaticity {
        x: x / sum,
        y: y / sum,
    }
}

/// Luminance of a black body of `temperature` \[K\] relative to 1500 K.
pub fn luminance(temperature: f64) -> f64 {
    tristimulus(temperature)[1] / tristimulus(UNIT_LUMINANCE_KELVIN)[1]
}

/// Linear sRGB of unit luminance of a black body of `temperature` \[K\] to a camera balanced for one of `white` \[K\]. Blue
/// is negative below about 1900 K, or less in an adapted picture, and clamped to zero.
pub fn linear_srgb(temperature: f64, white: f64) -> [f64; 3] {
    let [x, y, z] = adapted(temperature, white);
    let rgb = [
        3.240_454_2 * x - 1.537_138_5 * y - 0.498_531_4 * z,
        -0.969_266_0 * x + 1.876_010_8 * y + 0.041_556_0 * z,
        0.055_643_4 * x - 0.204_025_9 * y + 1.057_225_2 * z,
    ]
    .map(|channel| channel.max(0.0));
    let luminance = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    rgb.map(|channel| channel / luminance)
}

/// The colour table as a row of texels: chroma and ln(luminance).
pub(crate) fn table(white: f64) -> Vec<[f32; 4]> {
    // Above the first logarithm, so that the first search descends.
    let mut log_luminance = -20.0;
    (0..COLOUR_ENTRIES)
        .map(|entry| {
            let share = entry as f32 / (COLOUR_ENTRIES - 1) as f32;
            let temperature = f64::from(COOLEST_KELVIN + share * (HOTTEST_KELVIN - COOLEST_KELVIN));
            log_luminance = ln(luminance(temperature), log_luminance);
            let [r, g, b] = linear_srgb(temperature, white).map(|channel| channel as f32);
            [r, g, b, log_luminance as f32]
        })
        .collect()
}

/// Natural logarithm by Newton's method, from a guess at most 4 above or 2 below it.
fn ln(x: f64, mut guess: f64) -> f64 {
    for _ in 0..12 {
        guess += x * f64::from(libm::expf(-guess as f32)) - 1.0;
    }
    guess
}

/// X, Y and Z of a black body to a camera with this white balance, up to a common factor.
fn adapted(temperature: f64, white: f64) -> [f64; 3] {
    let cones = |kelvin| times(&BRADFORD, tristimulus(kelvin));
    let [mut seen, from, to] = [temperature, white, NEUTRAL_KELVIN].map(cones);
    for (cone, (from, to)) in seen.iter_mut().zip(from.into_iter().zip(to)) {
        *cone *= to / from;
    }
    times(&FROM_BRADFORD, seen)
}

fn times(matrix: &[[f64; 3]; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    matrix.map(|[a, b, c]| a * x + b * y + c * z)
}

/// X, Y and Z of a black body, up to a common factor.
fn tristimulus(temperature: f64) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (band, observer) in OBSERVER.iter().enumerate() {
        let radiance = planck(
            FIRST_WAVELENGTH + WAVELENGTH_STEP * band as f64,
            temperature,
        );
        for (sum, share) in sum.iter_mut().zip(observer) {
            *sum += radiance * f64::from(*share);
        }
    }
    sum
}

/// Planck's law for a wavelength \[nm\] and a temperature \[K\], up to a constant factor.
fn planck(wavelength: f64, temperature: f64) -> f64 {
    /// hc/k [nm·K].
    const SECOND_RADIATION: f64 = 1.438_776_877e7;
    // The exponent is above 5 for visible light, so the subtraction keeps its digits.
    let exponent = SECOND_RADIATION / (wavelength * temperature);
    (1e3 / wavelength).powi(5) / (f64::from(libm::expf(exponent as f32)) - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published values of the Planckian locus: temperature \[K\], x, y, sRGB scaled to a largest
    /// channel of 255, luminance [cd/m²].
    const LOCUS: [(f64, f64, f64, [u8; 3], f64); 6] = [
        (1000.0, 0.6528, 0.3445, [255, 23, 0], 2.7),
        (1200.0, 0.6250, 0.3675, [255, 68, 0], 139.0),
        (1500.0, 0.5857, 0.3931, [255, 102, 0], 7.7e3),
        (1800.0, 0.5492, 0.4082, [255, 126, 0], 1.2e5),
        (2000.0, 0.5267, 0.4133, [255, 139, 22], 4.6e5),
        (2500.0, 0.4770, 0.4137, [255, 164, 73], 5.6e6),
    ];

    fn encoded(linear: f64) -> f64 {
        if linear <= 0.003_130_8 {
            12.92 * linear
        } else {
            1.055 * linear.powf(1.0 / 2.4) - 0.055
        }
    }

    #[test]
    fn chromaticity_follows_the_planckian_locus() {
        for (temperature, x, y, ..) in LOCUS {
            let at = chromaticity(temperature, NEUTRAL_KELVIN);
            let distance = (at.x - x).hypot(at.y - y);
            assert!(
                distance <= 0.002,
                "{temperature} K: {at:?}, {distance} away"
            );
        }
    }

    #[test]
    fn displayed_colours_are_the_published_ones() {
        for (temperature, _, _, srgb, _) in LOCUS {
            let rgb = linear_srgb(temperature, NEUTRAL_KELVIN);
            for (channel, expected) in rgb.iter().zip(srgb) {
                let shown = 255.0 * encoded(channel / rgb[0]);
                assert!(
                    (shown - f64::from(expected)).abs() <= 2.5,
                    "{temperature} K: {shown} instead of {expected}"
                );
            }
        }
    }

    #[test]
    fn luminance_follows_the_published_values() {
        for (temperature, _, _, _, candela) in LOCUS {
            let ratio = luminance(temperature) / (candela / 7.7e3);
            assert!((0.93..1.07).contains(&ratio), "{temperature} K: {ratio}");
        }
    }

    #[test]
    fn luminance_rises_and_redness_falls_with_temperature() {
        let table = table(NEUTRAL_KELVIN);
        for pair in table.windows(2) {
            let ([r0, g0, _, y0], [r1, g1, _, y1]) = (pair[0], pair[1]);
            assert!(y1 > y0);
            assert!(g1 / r1 >= g0 / r0);
        }
    }

    #[test]
    fn logarithms_are_exact_to_the_precision_of_the_table() {
        for (entry, [.., log]) in table(NEUTRAL_KELVIN).into_iter().enumerate() {
            let share = entry as f32 / (COLOUR_ENTRIES - 1) as f32;
            let kelvin = f64::from(COOLEST_KELVIN + share * (HOTTEST_KELVIN - COOLEST_KELVIN));
            let exact = luminance(kelvin).ln();
            assert!((f64::from(log) - exact).abs() < 1e-5, "{kelvin} K: {log}");
        }
    }

    #[test]
    fn every_entry_is_finite_and_of_unit_luminance() {
        for white in [2000.0, 3600.0, NEUTRAL_KELVIN] {
            for [r, g, b, y] in table(white) {
                assert!(y.is_finite() && r >= 0.0 && g >= 0.0 && b >= 0.0);
                assert!((0.2126 * r + 0.7152 * g + 0.0722 * b - 1.0).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn a_fire_is_redder_than_the_white_of_its_camera() {
        for white in [3200.0, 4500.0, NEUTRAL_KELVIN] {
            for [r, g, b, _] in table(white) {
                assert!(r >= g && g >= b, "{white} K");
            }
        }
    }

    #[test]
    fn a_camera_sees_the_body_that_it_is_balanced_for_white() {
        let white = chromaticity(NEUTRAL_KELVIN, NEUTRAL_KELVIN);
        for kelvin in [2000.0, 3600.0, 5000.0] {
            let at = chromaticity(kelvin, kelvin);
            let distance = (at.x - white.x).hypot(at.y - white.y);
            assert!(distance < 1e-4, "{kelvin} K: {at:?}");
        }
    }

    #[test]
    fn adaptation_is_whiter_the_lower_the_balance() {
        let blue_of = |white| linear_srgb(1900.0, white)[2] / linear_srgb(1900.0, white)[0];
        let blues = [NEUTRAL_KELVIN, 5000.0, 4000.0, 3000.0, 2000.0].map(blue_of);
        assert!(blues.is_sorted() && blues[4] > 0.7, "{blues:?}");
    }

    #[test]
    fn an_adapted_fire_stays_near_the_locus() {
        // A camera sees black bodies on the locus of others, within what its white moves.
        for kelvin in [1500.0, 1700.0, 1900.0, 2200.0] {
            let at = chromaticity(kelvin, 4000.0);
            let distances = (1000..4000).step_by(5).map(|body| {
                let body = chromaticity(f64::from(body), NEUTRAL_KELVIN);
                (at.x - body.x).hypot(at.y - body.y)
            });
            let least = distances.fold(f64::INFINITY, f64::min);
            assert!(least < 0.012, "{kelvin} K: {least}");
        }
    }
}
