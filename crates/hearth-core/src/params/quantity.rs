//! What a display mode measures.

use super::choices::DisplayMode;

/// A quantity of the gas that a picture shows by colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Whether it goes both ways from zero, which is then the middle of the colours.
    pub signed: bool,
    /// Whether it is a whole number.
    pub whole: bool,
}

impl DisplayMode {
    /// What the colours of this mode measure; nothing where they are those of a fire.
    pub const fn quantity(self) -> Option<Quantity> {
        use DisplayMode as Mode;
        let unit = match self {
            Mode::Fire | Mode::Paper | Mode::Sprites => return None,
            Mode::Particles | Mode::Temperature => "K",
            Mode::Density => "kg/m³",
            Mode::Pressure => "Pa",
            Mode::Velocity => "m/s",
            Mode::Vorticity => "1/s",
            Mode::Fuel | Mode::Soot | Mode::Neighbours => "",
        };
        Some(Quantity {
            unit,
            signed: matches!(self, Mode::Pressure | Mode::Vorticity),
            whole: matches!(self, Mode::Neighbours),
        })
    }
}
