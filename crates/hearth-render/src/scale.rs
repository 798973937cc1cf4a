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
