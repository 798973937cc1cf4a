//! Frequencies of what swings.

use std::f64::consts::{PI, TAU};

/// Frequency \[Hz\] of a smooth swing of (time \[s\], value), from the times
/// at which it crosses zero.
pub fn crossing_frequency(swing: &[(f64, f64)]) -> f64 {
    let crossings: Vec<f64> = swing
        .windows(2)
        .filter(|pair| (pair[0].1 < 0.0) != (pair[1].1 < 0.0))
        .map(|pair| {
            let ((t0, a), (t1, b)) = (pair[0], pair[1]);
            t0 + (t1 - t0) * a / (a - b)
        })
        .collect();
    match (crossings.first(), crossings.last()) {
        (Some(first), Some(last)) if crossings.len() > 1 => {
            0.5 * (crossings.len() - 1) as f64 / (last - first)
        }
        _ => f64::NAN,
    }
}

/// Frequency times power over frequency \[Hz\], the premultiplied spectrum, whose
/// area over a logarithmic axis is energy, so that slow drift does not outweigh a
/// beat; of a signal of `rate` samples a second: the mean
/// over segments of so many seconds that overlap by half, each without its
/// trend and under a Hann window (Welch's method). Frequencies are a quarter
/// of a segment's resolution apart, up to `highest` \[Hz\].
pub fn spectrum(signal: &[f64], rate: f64, segment: f64, highest: f64) -> Vec<(f64, f64)> {
    let length = ((segment * rate) as usize).min(signal.len());
    let step = 0.25 * rate / length as f64;
    let mut power = vec![0.0; (highest / step) as usize];
    let mut segments = 0.0;
    for part in signal.windows(length).step_by((length / 2).max(1)) {
        let trend = super::fit::line(part.iter().enumerate().map(|(i, &y)| (i as f64, y)));
        let shaped: Vec<f64> = part
            .iter()
            .enumerate()
            .map(|(i, &y)| {
                let x = i as f64;
                let window = 0.5 - 0.5 * (TAU * (x + 0.5) / length as f64).cos();
                (y - trend.intercept - trend.slope * x) * window
            })
            .collect();
        for (k, power) in power.iter_mut().enumerate() {
            let turn = TAU * (k as f64 + 1.0) * step / rate;
            let (mut re, mut im) = (0.0, 0.0);
            for (i, y) in shaped.iter().enumerate() {
                let (sin, cos) = (turn * i as f64).sin_cos();
                re += y * cos;
                im += y * sin;
            }
            *power += re * re + im * im;
        }
        segments += 1.0;
    }
    power
        .into_iter()
        .enumerate()
        .map(|(k, p)| {
            let frequency = (k as f64 + 1.0) * step;
            (frequency, frequency * p / segments)
        })
        .collect()
}

/// Power over frequency \[Hz\] from frequency times power: the plain spectrum, in
/// which whatever is slow weighs more.
pub fn plain(premultiplied: &[(f64, f64)]) -> Vec<(f64, f64)> {
    premultiplied.iter().map(|&(f, p)| (f, p / f)).collect()
}

/// The frequency of the most power from `lowest` on.
pub fn peak(spectrum: &[(f64, f64)], lowest: f64) -> f64 {
    spectrum
        .iter()
        .filter(|(f, _)| *f >= lowest)
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .map_or(f64::NAN, |(f, _)| *f)
}

/// Rate \[1/s\] of e^(rate·t) through (time, value), from logarithms.
pub fn growth(points: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    super::fit::line(points.into_iter().map(|(t, y)| (t, y.ln()))).slope
}

/// Σ over odd n from 1 of `term(n)`, until terms no longer count.
pub fn odd_series(term: impl Fn(f64) -> f64) -> f64 {
    (0..200).map(|i| term(2.0 * f64::from(i) + 1.0)).sum()
}

/// sin(nπx), for the series of slow flows.
pub fn mode(n: f64, x: f64) -> f64 {
    (n * PI * x).sin()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossings_give_a_frequency() {
        let swing: Vec<_> = (0..500)
            .map(|i| {
                let t = f64::from(i) * 0.01;
                (t, (TAU * 1.7 * t + 0.3).cos() * (-0.2 * t).exp())
            })
            .collect();
        assert!((crossing_frequency(&swing) - 1.7).abs() < 0.005);
        assert!(crossing_frequency(&[(0.0, 1.0), (1.0, 1.0)]).is_nan());
    }

    #[test]
    fn a_spectrum_finds_an_oscillation_with_noise_and_trend() {
        let mut random = hearth_core::random::Random::new(1);
        let signal: Vec<f64> = (0..1500)
            .map(|i| {
                let t = f64::from(i) / 60.0;
                let noise = f64::from(random.between(-2.0, 2.0));
                5.0 + 0.3 * t + (TAU * 1.95 * t).sin() + noise
            })
            .collect();
        let found = peak(&spectrum(&signal, 60.0, 8.0, 10.0), 0.4);
        assert!((found - 1.95).abs() < 0.05, "{found}");
    }

    #[test]
    fn a_slow_drift_outweighs_a_beat_in_the_plain_spectrum_alone() {
        let signal: Vec<f64> = (0..3000)
            .map(|i| {
                let t = f64::from(i) / 60.0;
                1.3 * (TAU * 0.6 * t).sin() + (TAU * 1.8 * t).sin()
            })
            .collect();
        let spectrum = spectrum(&signal, 60.0, 8.0, 10.0);
        assert!((peak(&spectrum, 0.3) - 1.8).abs() < 0.05);
        assert!((peak(&plain(&spectrum), 0.3) - 0.6).abs() < 0.05);
    }

    #[test]
    fn a_growth_gives_its_rate() {
        let rate = growth((0..50).map(|i| {
            let t = f64::from(i) * 0.02;
            (t, 1e-3 * (4.2 * t).exp())
        }));
        assert!((rate - 4.2).abs() < 1e-9);
    }
}
