//! From where to where the colours of a measured quantity go.
//!
//! Nearly all of it is enclosed, and both ends are round numbers. Where there is more
//! they move at once; where there is less they wait, so that a fire that flickers
//! leaves them alone.

use hearth_core::Instance;
use hearth_core::params::{DisplayMode, Model};

use crate::instance::measured;

/// One particle of so many may lie beyond either end.
const BEYOND: u32 = 200;
/// Parts of the whole between which those beyond are told from the rest.
const BINS: usize = 256;
/// Steps that the ends are rounded to have so many in the whole, or fewer.
const STEPS: f32 = 8.0;
/// Smallest whole: by itself, and as a share of what is measured. Below is rounding.
const SMALLEST: f32 = 0.01;
const SLIGHTEST: f32 = 0.05;
/// Where the quantity takes less than this share of the whole for so many pictures,
/// the ends come closer.
const LITTLE: f32 = 0.4;
const PATIENCE: u32 = 60;

/// Smallest and largest value of what is measured, except a few; none without particles.
pub fn extremes(instances: &[Instance]) -> Option<[f32; 2]> {
    let measured = || {
        let all = instances.iter().map(measured);
        all.filter(|measured| measured.abs() < f32::MAX)
    };
    let [mut min, mut max] = [f32::MAX, f32::MIN];
    for measured in measured() {
        // Not `min` and `max`, which are longer in wasm.
        min = if measured < min { measured } else { min };
        max = if measured > max { measured } else { max };
    }
    if min > max {
        return None;
    }
    let width = (max - min) / BINS as f32;
    if width.is_infinite() {
        return None;
    }
    let mut bins = [0; BINS];
    let mut count = 0;
    for measured in measured() {
        bins[(((measured - min) / width) as usize).min(BINS - 1)] += 1;
        count += 1;
    }
    // How far the bins reach that hold few of all, from the first or from the last one.
    let beyond = |from: usize| {
        let (mut left, mut passed) = (count / BEYOND, 0);
        while bins[(from ^ passed) % BINS] <= left {
            left -= bins[(from ^ passed) % BINS];
            passed += 1;
        }
        passed as f32 * width
    };
    Some([min + beyond(0), max - beyond(BINS - 1)])
}

/// What the colours go from and to, and how that came.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scale {
    of: Option<(DisplayMode, Model)>,
    ends: [f32; 2],
    /// What was enclosed since it last was more than little, and in how many pictures.
    lately: [f32; 2],
    waited: u32,
}

impl Scale {
    /// What is measured, and the ends; nothing where nothing is.
    pub fn ends(&self) -> Option<(DisplayMode, [f32; 2])> {
        self.of.map(|(mode, _)| (mode, self.ends))
    }

    /// Takes in what a picture measures.
    pub fn see(&mut self, mode: DisplayMode, model: Model, seen: Option<[f32; 2]>) {
        let Some(quantity) = mode.quantity() else {
            self.of = None;
            return;
        };
        let is_new = self.of != Some((mode, model));
        self.of = Some((mode, model));
        let [mut min, mut max] = match seen {
            Some(seen) => seen,
            None if is_new => [0.0; 2],
            None => return,
        };
        if quantity.signed {
            max = max.max(-min).max(SMALLEST);
            min = -max;
        }
        let [from, to] = self.ends;
        if !is_new && from <= min && max <= to {
            if max - min >= LITTLE * (to - from) {
                self.waited = 0;
                return;
            }
            if self.waited > 0 {
                min = min.min(self.lately[0]);
                max = max.max(self.lately[1]);
            }
            self.lately = [min, max];
            self.waited += 1;
            if self.waited < PATIENCE {
                return;
            }
        }
        self.ends = rounded([min, max], quantity.whole);
        self.waited = 0;
    }
}

/// Round numbers around `min` and `max`.
fn rounded([min, max]: [f32; 2], are_whole: bool) -> [f32; 2] {
    let enough = (SLIGHTEST * max).max(SMALLEST);
    let step = (max - min).max(enough) / STEPS;
    // 1, 2, 5, 10, 20, … or 0.5, 0.2, 0.1, …, told by what is to be divided by what,
    // so that each end is the float next to its decimal.
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

    /// The ends after pictures that measure that.
    fn after(
        scale: &mut Scale,
        mode: DisplayMode,
        seen: impl IntoIterator<Item = [f32; 2]>,
    ) -> [f32; 2] {
        for seen in seen {
            scale.see(mode, Model::Combustion, Some(seen));
        }
        scale.ends().unwrap().1
    }

    #[test]
    fn nearly_all_is_enclosed_and_what_lies_far_out_is_not() {
        // Most of it in little room, as the air around a fire, or spread out.
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
    fn ends_are_round_and_outside() {
        for (seen, mode, ends) in [
            ([0.0, 2.3], DisplayMode::Velocity, [0.0, 2.5]),
            ([293.0, 1811.0], DisplayMode::Temperature, [200.0, 2000.0]),
            ([0.41, 1.19], DisplayMode::Density, [0.4, 1.2]),
            ([-3.1, 1.0], DisplayMode::Pressure, [-4.0, 4.0]),
            ([-80.0, 130.0], DisplayMode::Vorticity, [-150.0, 150.0]),
            ([20.0, 22.0], DisplayMode::Neighbours, [20.0, 22.0]),
            // Nothing to tell apart.
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
    fn a_flickering_fire_leaves_them_alone() {
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
    fn they_follow_what_grows_at_once_and_what_shrinks_for_good() {
        let mut scale = Scale::default();
        assert_eq!(
            after(&mut scale, MODE, [[0.0, 1.0], [0.0, 30.0]]),
            [0.0, 30.0]
        );
        let little = [[0.0, 0.8]; PATIENCE as usize - 1];
        assert_eq!(after(&mut scale, MODE, little), [0.0, 30.0]);
        assert_eq!(after(&mut scale, MODE, [[0.0, 20.0]]), [0.0, 30.0]);
        assert_eq!(after(&mut scale, MODE, little), [0.0, 30.0]);
        assert_eq!(after(&mut scale, MODE, [[0.1, 0.5]]), [0.0, 0.8]);
    }

    #[test]
    fn another_mode_or_model_starts_anew() {
        let mut scale = Scale::default();
        after(&mut scale, MODE, [[0.0, 30.0]]);
        assert_eq!(
            after(&mut scale, DisplayMode::Fuel, [[0.0, 0.8]]),
            [0.0, 0.8]
        );
        scale.see(DisplayMode::Fuel, Model::Classic, Some([0.0, 0.1]));
        assert_eq!(scale.ends(), Some((DisplayMode::Fuel, [0.0, 0.1])));
        for name in DisplayMode::NAMES {
            let mode = DisplayMode::from_name(name).unwrap();
            scale.see(mode, Model::Classic, None);
            let measured = scale.ends().map(|(mode, _)| mode);
            assert_eq!(measured, mode.quantity().map(|_| mode));
        }
    }
}
