//! A level and a share of its pixels.

use hearth_core::resolution::Level;

/// A level and how many of its pixels a picture has, coarsest first: below the lowest level, a fire has
/// a quarter or a half of that level's pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Detail(u8);

impl Detail {
    /// A quarter of the pixels of the lowest level.
    pub const COARSEST: Detail = Detail(0);
    /// All pixels of the lowest level.
    pub const LOW: Detail = Detail(2);
    /// All pixels of the highest level.
    pub const FINEST: Detail = Detail(4);

    /// All of the pixels of a level.
    pub fn of(level: Level) -> Detail {
        Detail(level as u8 + Detail::LOW.0)
    }

    /// The next finer one, of one that is not the finest.
    pub fn finer(self) -> Detail {
        Detail(self.0 + 1)
    }

    /// The next coarser one, of one that is not the coarsest.
    pub fn coarser(self) -> Detail {
        Detail(self.0 - 1)
    }

    /// Its level.
    pub fn level(self) -> Level {
        match self {
            Detail::FINEST => Level::High,
            Detail(3) => Level::Medium,
            _ => Level::Low,
        }
    }

    /// The share of the level's pixels.
    pub fn share(self) -> f64 {
        match self {
            Detail::COARSEST => 0.25,
            Detail(1) => 0.5,
            _ => 1.0,
        }
    }
}
