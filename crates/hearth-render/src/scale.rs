//! The colour scale of a measured quantity: the values of its first and last colour.
//!
//! The scale encloses nearly all particles between two round numbers. It grows at once and
//! shrinks after a delay, so that a flickering fire does not change it.

use hearth_core::Instance;
use hearth_core::params::{DisplayMode, Model, Quantity};

use crate::instance::measured;

/// One particle in this number may lie beyond each end.
const PARTICLES_PER_OUTLIER: u32 = 200;
/// Bins of the histogram that finds outliers.
const HISTOGRAM_BINS: usize = 256;
/// Maximum number of round steps between the ends.
const MAX_ROUND_STEPS: f32 = 8.0;
/// Minimum span: absolute, and relative to the largest value. Less is rounding error.
const MIN_SPAN: f32 = 0.01;
const MIN_RELATIVE_SPAN: f32 = 0.05;
/// The scale shrinks after the quantity spans less than this share of it for this number of
/// pictures.
const SHRINKING_SHARE: f32 = 0.4;
const SHRINKING_PICTURES: u32 = 60;

/// Minimum and maximum of the measured quantity without outliers; `None` without particles.
pub fn extremes(instances: &[Instance]) -> Option<[f32; 2]> {
    let measured = || {
        let all = instances.iter().map(measured);
        all.filter(|measured| measured.abs() < f32::MAX)
    };
    let [mut min, mut max] = [f32::MAX, f32::MIN];
    for measured in measured() {
        // `f32::min` and `max` take more instructions in wasm.
        min = if measured < min { measured } else { min };
        max = if measured > max { measured } else { max };
    }
    if min > max {
        return None;
    }
    let width = (max - min) / HISTOGRAM_BINS as f32;
    if width.is_infinite() {
        return None;
    }
    let mut bins = [0; HISTOGRAM_BINS];
    let mut count = 0;
    for measured in measured() {
        bins[(((measured - min) / width) as usize).min(HISTOGRAM_BINS - 1)] += 1;
        count += 1;
    }
    // Width of the bins that hold the outliers, from the first or the last bin on.
    let outliers = |end: usize| {
        let (mut left, mut passed) = (count / PARTICLES_PER_OUTLIER, 0);
        while bins[(end ^ passed) % HISTOGRAM_BINS] <= left {
            left -= bins[(end ^ passed) % HISTOGRAM_BINS];
            passed += 1;
        }
        passed as f32 * width
    };
    Some([min + outliers(0), max - outliers(HISTOGRAM_BINS - 1)])
}

/// The scale of a fire.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scale {
    of: Option<(DisplayMode, Model)>,
    ends: [f32; 2],
    /// Range of the quantity while it spans little of the scale, and the number of pictures.
    recent: [f32; 2],
    waited: u32,
}

impl Scale {
    /// The measured mode and the ends; `None` if the mode measures nothing.
    pub fn ends(&self) -> Option<(DisplayMode, [f32; 2])> {
        self.of.map(|(mode, _)| (mode, self.ends))
    }

    /// Adds the range that a picture measures.
    pub fn add(&mut self, mode: DisplayMode, model: Model, range: Option<[f32; 2]>) {
        match mode.quantity() {
            Some(quantity) => self.enclose((mode, model), quantity, range),
            None => self.of = None,
        }
    }

    fn enclose(&mut self, of: (DisplayMode, Model), quantity: Quantity, range: Option<[f32; 2]>) {
        let is_new = self.of != Some(of);
        self.of = Some(of);
        let [mut min, mut max] = match range {
            Some(range) => range,
            None if is_new => [0.0; 2],
            None => return,
        };
        if quantity.signed {
            max = max.max(-min).max(MIN_SPAN);
            min = -max;
        }
        let [from, to] = self.ends;
        if !is_new && from <= min && max <= to {
            if max - min >= SHRINKING_SHARE * (to - from) {
                self.waited = 0;
                return;
            }
            if self.waited > 0 {
                min = min.min(self.recent[0]);
                max = max.max(self.recent[1]);
            }
            self.recent = [min, max];
            self.waited += 1;
            if self.waited < SHRINKING_PICTURES {
                return;
            }
        }
        self.ends = rounded([min, max], quantity.whole);
        self.waited = 0;
    }
}

/// Round numbers that enclose `min` and `max`.
fn rounded([min, max]: [f32; 2], are_whole: bool) -> [f32; 2] {
    let min_span = (MIN_RELATIVE_SPAN * max).max(MIN_SPAN);
    let step = (max - min).max(min_span) / MAX_ROUND_STEPS;
    // The step is 1, 2, 5, 10, 20, … or 0.5, 0.2, 0.1, …, as a fraction of whole numbers, so
    // that each end is the float nearest to its decimal.
    let (mut over, mut under, mut doubled) = (1.0, 1.0, 0);
    while step * under < 1.0 && !are_whole {
        under *= 10.0;
    }
    while over < step * under {
        over *= if doubled == 1 { 2.5 } else { 2.0 };
        doubled = (doubled + 1) % 3;
    }
    let lower = (min * under / over).floor();
    let upper = (max * under / over).ceil().max(lower + 1.0);
    [lower, upper].map(|end| end * over / under)
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::Choice;

    const MODE: DisplayMode = DisplayMode::Velocity;

    fn instances(measured: impl IntoIterator<Item = f32>) -> Vec<Instance> {
        let of = |measured| [0.0, 0.0, 0.0, 0.0, 300.0, 1e-4, 0.0, measured];
        measured.into_iter().map(of).collect()
    }

    /// The ends after pictures that measure these ranges.
    fn after(
        scale: &mut Scale,
        mode: DisplayMode,
        ranges: impl IntoIterator<Item = [f32; 2]>,
    ) -> [f32; 2] {
        for range in ranges {
            scale.add(mode, Model::Combustion, Some(range));
        }
        scale.ends().unwrap().1
    }

    #[test]
    fn the_extremes_enclose_nearly_all_particles_without_outliers() {
        // Concentrated values, as the air around a fire, to uniform ones.
        for power in [0.2, 1.0, 3.0, 9.0] {
            for count in [1, 10, 199, 1000, 5000] {
                let of = |i: i32| (i as f32 / count as f32).powf(power) * 7.0 - 2.0;
                let mut all: Vec<f32> = (0..count).map(of).collect();
                all.push(f32::NAN);
                let [min, max] = extremes(&instances(all.clone())).unwrap();
                let inside = |&&x: &&f32| (min..=max).contains(&x);
                let held = all.iter().filter(inside).count() as f32;
                assert!(held >= 0.98 * count as f32, "{held} of {count}");
                assert!(min >= -2.0 && max <= 5.0);
            }
        }
        let mut far = vec![1.0; 999];
        far[..500].fill(2.0);
        far.push(1e6);
        let [_, max] = extremes(&instances(far)).unwrap();
        assert!(max < 1e4);
        assert_eq!(extremes(&[]), None);
        assert_eq!(extremes(&instances([f32::INFINITY])), None);
        assert_eq!(extremes(&instances([3.0, 3.0])), Some([3.0, 3.0]));
    }

    #[test]
    fn ends_are_round_and_enclose_the_range() {
        for (seen, mode, ends) in [
            ([0.0, 2.3], DisplayMode::Velocity, [0.0, 2.5]),
            ([293.0, 1811.0], DisplayMode::Temperature, [200.0, 2000.0]),
            ([0.41, 1.19], DisplayMode::Density, [0.4, 1.2]),
            ([-3.1, 1.0], DisplayMode::Pressure, [-4.0, 4.0]),
            ([-80.0, 130.0], DisplayMode::Vorticity, [-150.0, 150.0]),
            ([20.0, 22.0], DisplayMode::Neighbours, [20.0, 22.0]),
            // Ranges without a span.
            ([293.0, 293.0], DisplayMode::Temperature, [292.0, 294.0]),
            ([0.0, 0.0], DisplayMode::Fuel, [0.0, 0.002]),
            ([0.0, 0.0], DisplayMode::Vorticity, [-0.01, 0.01]),
        ] {
            assert_eq!(after(&mut Scale::default(), mode, [seen]), ends, "{mode:?}");
        }
        for exponent in -30..20 {
            let size = 3.0 * 10.0_f32.powi(exponent);
            let [min, max] = after(&mut Scale::default(), MODE, [[-size, 2.0 * size]]);
            assert!(min <= -size && 2.0 * size <= max, "{min} {max}");
        }
    }

    #[test]
    fn a_flickering_fire_does_not_change_the_ends() {
        for mode in [MODE, DisplayMode::Pressure] {
            let mut scale = Scale::default();
            let flicker = |picture: i32| {
                let max = 2.05 + 0.7 * (picture as f32 * 0.7).sin() + 0.2 * (picture as f32).sin();
                [-0.5 * max, max]
            };
            let ends = after(&mut scale, mode, (0..60).map(flicker));
            for picture in 60..2000 {
                let [min, max] = flicker(picture);
                assert_eq!(after(&mut scale, mode, [[min, max]]), ends);
                assert!(ends[0] <= min && max <= ends[1]);
            }
        }
    }

    #[test]
    fn ends_grow_at_once_and_shrink_after_a_delay() {
        let mut scale = Scale::default();
        assert_eq!(
            after(&mut scale, MODE, [[0.0, 1.0], [0.0, 30.0]]),
            [0.0, 30.0]
        );
        let little = [[0.0, 0.8]; SHRINKING_PICTURES as usize - 1];
        assert_eq!(after(&mut scale, MODE, little), [0.0, 30.0]);
        assert_eq!(after(&mut scale, MODE, [[0.0, 20.0]]), [0.0, 30.0]);
        assert_eq!(after(&mut scale, MODE, little), [0.0, 30.0]);
        assert_eq!(after(&mut scale, MODE, [[0.1, 0.5]]), [0.0, 0.8]);
    }

    #[test]
    fn another_mode_or_model_resets_the_scale() {
        let mut scale = Scale::default();
        after(&mut scale, MODE, [[0.0, 30.0]]);
        assert_eq!(
            after(&mut scale, DisplayMode::Fuel, [[0.0, 0.8]]),
            [0.0, 0.8]
        );
        scale.add(DisplayMode::Fuel, Model::Classic, Some([0.0, 0.1]));
        assert_eq!(scale.ends(), Some((DisplayMode::Fuel, [0.0, 0.1])));
        for name in DisplayMode::NAMES {
            let mode = DisplayMode::from_name(name).unwrap();
            scale.add(mode, Model::Classic, None);
            let measured = scale.ends().map(|(mode, _)| mode);
            assert_eq!(measured, mode.quantity().map(|_| mode));
        }
    }
}
