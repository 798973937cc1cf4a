//! How many particles a fire has at most in an element of its size.
//!
//! A fire fits the height of its element, so a small element shows small particles and needs
//! fewer of them. An icon of 64 CSS pixels gets 300, a card of 240 × 300 gets 400, and from a
//! side of 560 each level has its full number. A change resamples the burning fire, so no
//! particle appears suddenly. The number changes only with a side that is a tenth longer or
//! shorter, so that dragging a window does not change it back and forth.

use super::level::Level;

/// Sides of small elements [CSS pixels] and their particles.
const ICON_SIDE_AND_PARTICLES: (f64, f64) = (64.0, 300.0);
const CARD_SIDE_AND_PARTICLES: (f64, f64) = (268.0, 400.0);
/// Side from which a level has its full number.
const FULL_LEVEL_SIDE: f64 = 560.0;
/// Side from which a scene has its own number, which shapes its look.
const FULL_SCENE_SIDE: f64 = 320.0;
/// Minimum ratio of two sides that count as different.
const MIN_RATIO_OF_SIDES: f64 = 1.1;

/// The limit of the particles in an element: its size, rounded to what matters here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeLimit {
    side: f64,
}

impl Default for SizeLimit {
    /// The limit of a large element, until the size is known.
    fn default() -> SizeLimit {
        SizeLimit {
            side: FULL_LEVEL_SIDE,
        }
    }
}

impl SizeLimit {
    /// The limit of an element. `side` is its height or, if that is less, the side of a square
    /// of the same area [CSS pixels].
    pub fn of(side: f64) -> SizeLimit {
        if side > 0.0 {
            SizeLimit {
                side: side.clamp(ICON_SIDE_AND_PARTICLES.0, FULL_LEVEL_SIDE),
            }
        } else {
            SizeLimit::default()
        }
    }

    /// Follows the size of the element; returns whether the change matters. An element without
    /// a size keeps its limit.
    pub fn resize(&mut self, side: f64) -> bool {
        let new = SizeLimit::of(side).side;
        let ratio = new / self.side;
        // The ends are reached exactly.
        let end = new == FULL_LEVEL_SIDE || new == ICON_SIDE_AND_PARTICLES.0;
        let differs = end || !(1.0 / MIN_RATIO_OF_SIDES..=MIN_RATIO_OF_SIDES).contains(&ratio);
        let matters = side > 0.0 && new != self.side && differs;
        if matters {
            self.side = new;
        }
        matters
    }

    /// Number of particles at a level.
    pub fn of_level(&self, level: Level) -> u32 {
        self.limit(level.particles(), FULL_LEVEL_SIDE)
    }

    /// Number of particles of a scene that sets `number`.
    pub fn of_scene(&self, number: u32) -> u32 {
        self.limit(number, FULL_SCENE_SIDE)
    }

    /// Number of particles if elements with a side of at least `full_side` have `max`.
    fn limit(&self, max: u32, full_side: f64) -> u32 {
        if self.side >= full_side {
            return max;
        }
        let between = |(low, few): (f64, f64), (high, many): (f64, f64)| {
            let part = (self.side - low) / (high - low);
            few + (many - few) * part
        };
        let number = if self.side < CARD_SIDE_AND_PARTICLES.0 {
            between(ICON_SIDE_AND_PARTICLES, CARD_SIDE_AND_PARTICLES)
        } else {
            // Proportional to the area, so that particles keep their size in the picture.
            let part =
                (self.side - CARD_SIDE_AND_PARTICLES.0) / (full_side - CARD_SIDE_AND_PARTICLES.0);
            CARD_SIDE_AND_PARTICLES.1 + (f64::from(max) - CARD_SIDE_AND_PARTICLES.1) * part * part
        };
        // Round numbers are easier to read in the statistics.
        let tens = (number / 10.0).round() as u32 * 10;
        tens.min(max)
    }
}
