//! How many particles a fire has in an element of its size.
//!
//! A fire fits the height of its element, so a small element shows large particles
//! small: nobody sees how many there are. An icon of 64 CSS pixels gets 300, a card of
//! 240 × 300 gets 400, and from a side of 560 on each level has its own number. Other
//! particles take over the burning fire, so nothing pops; and the number changes only
//! with a side that is a tenth longer or shorter, so a window that is dragged does not
//! make it flap.

use crate::quality::Level;

/// Sides that fewer particles go with [CSS pixels], and how many.
const ICON: (f64, f64) = (64.0, 300.0);
const CARD: (f64, f64) = (268.0, 400.0);
/// Side from which a level has its own number.
const STAGE: f64 = 560.0;
/// Side from which a scene has its own number, which is that of its look.
const SCENE: f64 = 320.0;
/// How much longer or shorter a side must be to count.
const ANOTHER: f64 = 1.1;

/// The size of an element, as far as it counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grain {
    side: f64,
}

impl Default for Grain {
    /// That of a stage, until the element has a size.
    fn default() -> Grain {
        Grain { side: STAGE }
    }
}

impl Grain {
    /// That of an element whose height or, where that is less, whose side of a square of
    /// the same area is so long [CSS pixels].
    pub fn of(side: f64) -> Grain {
        if side > 0.0 {
            Grain {
                side: side.clamp(ICON.0, STAGE),
            }
        } else {
            Grain::default()
        }
    }

    /// The element has another size; whether that counts. Without one, nothing does.
    pub fn resize(&mut self, side: f64) -> bool {
        let new = Grain::of(side).side;
        let longer = new / self.side;
        // The ends are reached exactly.
        let end = new == STAGE || new == ICON.0;
        let counts =
            side > 0.0 && new != self.side && (end || !(1.0 / ANOTHER..=ANOTHER).contains(&longer));
        if counts {
            self.side = new;
        }
        counts
    }

    /// How many particles that level has in it.
    pub fn particles(&self, level: Level) -> u32 {
        self.limit(level.particles(), STAGE)
    }

    /// How many particles a scene has in it that names this number.
    pub fn of_scene(&self, number: u32) -> u32 {
        self.limit(number, SCENE)
    }

    /// How many of `most` particles an element has that has all of them from a side of
    /// `stage` on.
    fn limit(&self, most: u32, stage: f64) -> u32 {
        if self.side >= stage {
            return most;
        }
        let between = |(low, few): (f64, f64), (high, many): (f64, f64)| {
            let part = (self.side - low) / (high - low);
            few + (many - few) * part
        };
        let number = if self.side < CARD.0 {
            between(ICON, CARD)
        } else {
            // As the area: as large in the picture, particle by particle.
            let part = (self.side - CARD.0) / (stage - CARD.0);
            CARD.1 + (f64::from(most) - CARD.1) * part * part
        };
        // A number that people can read.
        let tens = (number / 10.0).round() as u32 * 10;
        tens.min(most)
    }
}
