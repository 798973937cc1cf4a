//! How many particles a fire has, and why.
//!
//! Settings, level of quality, size of the element, speed of the machine and warm-up all bear on this
//! number. [`ParticleCount::of`] is the only place that combines them.

use super::level::Level;
use super::size_limit::SizeLimit;

/// Divisor of the number of particles in the first part of a warm-up, and the least result.
const COARSENING: u32 = 4;
const MIN_COARSE_PARTICLES: u32 = 600;

/// The number of particles that the settings request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resolution {
    /// That of the level of quality.
    Level,
    /// The own number of a scene.
    Scene(u32),
    /// The number that a page set, or that follows from the spacing that it set.
    Page(u32),
    /// The number of the classic model.
    Classic(u32),
}

impl Resolution {
    /// The number of particles without a limit of the device: that of the medium level if it
    /// follows the level.
    pub fn number(self) -> u32 {
        match self {
            Resolution::Level => Level::Medium.particles(),
            Resolution::Scene(number) | Resolution::Page(number) | Resolution::Classic(number) => {
                number
            }
        }
    }
}

/// What the number of particles depends on.
#[derive(Clone, Copy, Debug)]
pub struct CountInputs {
    /// The settings.
    pub settings: Resolution,
    /// The level of quality.
    pub level: Level,
    /// Whether a page requested that level. Its number then does not depend on the size.
    pub is_level_requested: bool,
    /// The size of the element.
    pub size: SizeLimit,
    /// The largest number that the machine steps in time.
    pub machine: u32,
    /// Whether the fire is in the first part of its warm-up.
    pub is_coarse: bool,
}

/// What limits the number of particles after the warm-up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CountLimit {
    /// Nothing: it is the number of the settings.
    Settings,
    /// The level of quality.
    Level(Level),
    /// The size of the element.
    Size,
    /// The speed of the machine.
    Machine,
}

impl CountLimit {
    /// Name in `stats`.
    pub fn name(self) -> &'static str {
        match self {
            CountLimit::Settings => "",
            CountLimit::Level(level) => {
                ["quality low", "quality medium", "quality high"][level as usize]
            }
            CountLimit::Size => "size",
            CountLimit::Machine => "speed",
        }
    }
}

/// The number of particles of a fire.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParticleCount {
    /// The number that fills the domain.
    pub number: u32,
    /// What limits it.
    pub limit: CountLimit,
}

impl ParticleCount {
    /// The number of particles, and its reason.
    ///
    /// | settings | number | limited by |
    /// |---|---|---|
    /// | level | of the level | the size, unless a page requested the level; levels have no other limit |
    /// | scene | of the scene | the size, unless a page requested the level; the machine |
    /// | page, classic | as set | the machine |
    ///
    /// The first part of a warm-up has a quarter of it, at least 600; the classic model has no such part.
    pub fn of(inputs: &CountInputs) -> ParticleCount {
        let full = match inputs.settings {
            Resolution::Level => inputs.level.particles(),
            settings => settings.number(),
        };
        let in_size = match inputs.settings {
            _ if inputs.is_level_requested => full,
            Resolution::Level => inputs.size.of_level(inputs.level),
            Resolution::Scene(number) => inputs.size.of_scene(number),
            Resolution::Page(_) | Resolution::Classic(_) => full,
        };
        let in_time = match inputs.settings {
            Resolution::Level => in_size,
            _ => in_size.min(inputs.machine),
        };
        let limit = if in_time < in_size {
            CountLimit::Machine
        } else if in_size < full {
            CountLimit::Size
        } else if inputs.settings == Resolution::Level {
            CountLimit::Level(inputs.level)
        } else {
            CountLimit::Settings
        };
        let is_coarse = inputs.is_coarse && !matches!(inputs.settings, Resolution::Classic(_));
        let number = if is_coarse {
            in_time.min((in_time / COARSENING).max(MIN_COARSE_PARTICLES))
        } else {
            in_time
        };
        ParticleCount { number, limit }
    }
}
