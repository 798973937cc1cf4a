//! The levels of quality.

/// How much work a fire does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// For phones and machines without a graphics card.
    Low,
    /// For most machines.
    Medium,
    /// For fast machines.
    High,
}

impl Level {
    /// All levels, lowest first.
    pub const ALL: [Level; 3] = [Level::Low, Level::Medium, Level::High];

    /// The level of that name.
    pub fn of(name: &str) -> Option<Level> {
        Level::ALL.into_iter().find(|level| level.name() == name)
    }

    /// Name in attributes and messages.
    pub fn name(self) -> &'static str {
        ["low", "medium", "high"][self as usize]
    }

    /// Default number of particles of the combustion model.
    pub fn particles(self) -> u32 {
        [1200, 3000, 6700][self as usize]
    }

    /// Default maximum of pixels in a picture: those of a 720p, 1080p or 1440p screen.
    pub fn pixels(self) -> f64 {
        [921_600.0, 2_073_600.0, 3_686_400.0][self as usize]
    }
}

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
