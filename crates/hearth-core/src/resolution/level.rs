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
        [1500, 3000, 6700][self as usize]
    }

    /// Default maximum of pixels in a picture: those of a 720p, 1080p or 1440p screen.
    pub fn pixels(self) -> f64 {
        [921_600.0, 2_073_600.0, 3_686_400.0][self as usize]
    }
}
