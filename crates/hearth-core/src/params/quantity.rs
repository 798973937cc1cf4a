//! The quantity of a display mode.

use super::choices::DisplayMode;

/// A quantity of the gas in a colour map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Whether it has both signs, with zero in the middle of the colour map.
    pub signed: bool,
    /// Whether it is an integer.
    pub whole: bool,
}

impl DisplayMode {
    /// The quantity of this mode; `None` if its colours are those of a fire.
    pub const fn quantity(self) -> Option<Quantity> {
        use DisplayMode as Mode;
        let unit = match self {
            Mode::Fire | Mode::Paper | Mode::Sprites => return None,
            Mode::Particles | Mode::Temperature => "K",
            Mode::Density => "kg/m³",
            Mode::Pressure => "Pa",
            Mode::Velocity => "m/s",
            Mode::Vorticity => "1/s",
            Mode::Distance => "m",
            Mode::Fuel | Mode::Soot | Mode::Neighbours => "",
        };
        Some(Quantity {
            unit,
            signed: matches!(self, Mode::Pressure | Mode::Vorticity),
            whole: matches!(self, Mode::Neighbours),
        })
    }
}
