//! From where to where the colours of a measured quantity go.
//!
//! Nearly all of it is enclosed, and both ends are round numbers. Where there is more
//! they move at once; where there is less they wait, so that a fire that flickers
//! leaves them alone.

use hearth_core::Instance;
use hearth_core::params::{DisplayMode, Model, Quantity};

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

/// Least and most of what is measured, but for a few; nothing of no particles.
pub fn extremes(instances: &[Instance]) -> Option<[f32; 2]> {
    let measured = || {
        let last = instances.iter().map(|&[.., measured]| measured);
        last.filter(|measured| measured.is_finite())
    };
    let [mut least, mut most] = [f32::INFINITY, f32::NEG_INFINITY];
    for measured in measured() {
        least = least.min(measured);
        most = most.max(measured);
    }
    if least > most {
        return None;
    }
    let width = (most - least) / BINS as f32;
    let mut bins = [0; BINS];
    let mut count = 0;
    for measured in measured() {
        bins[(((measured - least) / width) as usize).min(BINS - 1)] += 1;
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
    Some([least + beyond(0), most - beyond(BINS - 1)])
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
    /// The ends; nothing where nothing is measured.
    pub fn ends(&self) -> Option<[f32; 2]> {
        self.of.map(|_| self.ends)
    }

    /// Takes in what a picture measures.
    pub fn see(&mut self, mode: DisplayMode, model: Model, seen: Option<[f32; 2]>) {
        let Some(quantity) = mode.quantity() else {
            self.of = None;
            return;
        };
        let is_new = self.of != Some((mode, model));
        self.of = Some((mode, model));
        let Some(seen) = seen else {
            if is_new {
                (self.ends, self.waited) = (rounded([0.0, 0.0], quantity), 0);
            }
            return;
        };
        let [least, most] = self.ends;
        let encloses = least <= seen[0] && seen[1] <= most;
        let whole = if quantity.signed {
            2.0 * seen[1].max(-seen[0])
        } else {
            seen[1] - seen[0]
        };
        if is_new || !encloses {
            (self.ends, self.waited) = (rounded(seen, quantity), 0);
        } else if whole >= LITTLE * (most - least) {
            self.waited = 0;
        } else {
            let [least, most] = if self.waited == 0 { seen } else { self.lately };
            self.lately = [least.min(seen[0]), most.max(seen[1])];
            self.waited += 1;
            if self.waited >= PATIENCE {
                (self.ends, self.waited) = (rounded(self.lately, quantity), 0);
            }
        }
    }
}

/// Round numbers around `least` and `most`.
fn rounded([least, most]: [f32; 2], quantity: Quantity) -> [f32; 2] {
    let largest = most.max(-least);
    if quantity.signed {
        let [over, under] = step(largest.max(SMALLEST));
        return [-over / under, over / under];
    }
    let whole = (most - least).max(SLIGHTEST * largest).max(SMALLEST);
    let [mut over, mut under] = step(whole / STEPS);
    if quantity.whole && over < under {
        [over, under] = [1.0, 1.0];
    }
    // Of whole numbers, so that each end is the float next to its decimal.
    let to_step = |end: f32| end * under / over;
    let lower = to_step(least).floor();
    let upper = to_step(most).ceil().max(lower + 1.0);
    [lower, upper].map(|end| end * over / under)
}

/// The least of 1, 2, 5, 10, 20, … and 0.5, 0.2, 0.1, … that is not below `size`: what
/// is to be divided by what.
fn step(size: f32) -> [f32; 2] {
    let [mut over, mut under] = [1.0, 1.0];
    while size * under < 1.0 && under < 1e9 {
        under *= 10.0;
    }
    while over * 10.0 <= size * under && over < 1e30 {
        over *= 10.0;
    }
    let factor = [1.0, 2.0, 5.0].into_iter();
    let factor = factor.filter(|factor| over * factor >= size * under);
    [over * factor.fold(10.0, f32::min), under]
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
        scale.ends().unwrap()
    }

    #[test]
    fn nearly_all_is_enclosed_and_what_lies_far_out_is_not() {
        // Most of it in little room, as the air around a fire, or spread out.
        for power in [0.2, 1.0, 3.0, 9.0] {
            for count in [1, 10, 199, 1000, 5000] {
                let of = |i: i32| (i as f32 / count as f32).powf(power) * 7.0 - 2.0;
                let mut all: Vec<f32> = (0..count).map(of).collect();
                all.push(f32::NAN);
                let [least, most] = extremes(&instances(all.clone())).unwrap();
                let inside = |&&x: &&f32| (least..=most).contains(&x);
                let held = all.iter().filter(inside).count() as f32;
                assert!(held >= 0.98 * count as f32, "{held} of {count}");
                assert!(least >= -2.0 && most <= 5.0);
            }
        }
        let mut far = vec![1.0; 999];
        far[..500].fill(2.0);
        far.push(1e6);
        let [_, most] = extremes(&instances(far)).unwrap();
        assert!(most < 1e4);
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
            ([-3.1, 1.0], DisplayMode::Pressure, [-5.0, 5.0]),
            ([-80.0, 120.0], DisplayMode::Vorticity, [-200.0, 200.0]),
            ([20.0, 22.0], DisplayMode::Neighbours, [20.0, 22.0]),
            // Nothing to tell apart.
            ([293.0, 293.0], DisplayMode::Temperature, [292.0, 294.0]),
            ([0.0, 0.0], DisplayMode::Fuel, [0.0, 0.002]),
            ([0.0, 0.0], DisplayMode::Vorticity, [-0.01, 0.01]),
        ] {
            assert_eq!(after(&mut Scale::default(), mode, [seen]), ends, "{mode:?}");
        }
        for exponent in -30..30 {
            let size = 3.0 * 10.0_f32.powi(exponent);
            let [least, most] = after(&mut Scale::default(), MODE, [[-size, 2.0 * size]]);
            assert!(least <= -size && 2.0 * size <= most, "{least} {most}");
        }
    }

    #[test]
    fn a_flickering_fire_leaves_them_alone() {
        for mode in [MODE, DisplayMode::Pressure] {
            let mut scale = Scale::default();
            let flicker = |picture: i32| {
                let most = 2.05 + 0.7 * (picture as f32 * 0.7).sin() + 0.2 * (picture as f32).sin();
                [-0.5 * most, most]
            };
            let ends = after(&mut scale, mode, (0..60).map(flicker));
            for picture in 60..2000 {
                let [least, most] = flicker(picture);
                assert_eq!(after(&mut scale, mode, [[least, most]]), ends);
                assert!(ends[0] <= least && most <= ends[1]);
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
        assert_eq!(scale.ends(), Some([0.0, 0.1]));
        for name in DisplayMode::NAMES {
            let mode = DisplayMode::from_name(name).unwrap();
            scale.see(mode, Model::Classic, None);
            assert_eq!(scale.ends().is_some(), mode.quantity().is_some());
        }
    }
}
