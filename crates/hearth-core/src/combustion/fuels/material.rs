//! THE table of fuels: their numbers and the source of each.
//!
//! | number | wood | paper | coal | wax | cloth |
//! |---|---|---|---|---|---|
//! | heat of combustion | EN 1991-1-2, table E.3 | as wood | as wood | Hamins et al. 2005 | as wood |
//! | pyrolysis temperature | EN 1995-1-2, 3.4.2: the char line | Babrauskas 2003: cellulose | Drysdale 2011, 8.2: devolatilisation | Hamins et al. 2005: boiling | Babrauskas 2003: cotton |
//! | heat of pyrolysis | Tewarson 2002, table 3-4.7, less the sensible heat | as wood | Tewarson 2002 | Hamins et al. 2005: vaporisation and fusion | as paper |
//! | specific heat, conductivity | EN 1995-1-2, tables B.1 and B.2 | Touloukian 1970 | Incropera 2007, table A.3 | Hamins et al. 2005 | Incropera 2007, table A.3 |
//! | char | Ragland et al. 1991 | Drysdale 2011, 5.2.2: cellulose | ASTM D388: fixed carbon | none | as paper |
//! | ash | Ragland et al. 1991 | Ragland et al. 1991: with filler | ASTM D388 | none | as paper |

use crate::params::{Choice, Fuel};
use crate::state::{Bytes, State};

/// Heat of combustion of char [kJ/kg]: that of carbon (Drysdale 2011, table 1.13).
pub(super) const CHAR_HEAT: f32 = 32_800.0;
/// Specific heat [kJ/(kg·K)] and heat of vaporisation [kJ/kg] of water, and its boiling point \[K\].
pub(in crate::combustion) const WATER_CAPACITY: f32 = 4.18;
pub(in crate::combustion) const VAPORISATION: f32 = 2257.0;
pub(in crate::combustion) const BOILING: f32 = 373.15;

/// The numbers of a fuel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Material {
    /// Temperature from which it gives off gas \[K\].
    pub pyrolysis: f32,
    /// Heat that a kilogram of gas takes to be given off, besides that of its temperature [kJ/kg].
    pub gasification: f32,
    /// Heat of combustion of all of it [kJ/kg].
    heat: f32,
    /// Specific heat [kJ/(kg·K)].
    pub capacity: f32,
    /// Conductivity [kW/(m·K)].
    pub conductivity: f32,
    /// Char that is left, as a share of the dry mass; ash is a part of it.
    pub char: f32,
    /// Ash that is left, as a share of the dry mass.
    pub ash: f32,
}

const WOOD: Material = Material {
    pyrolysis: 573.0,
    gasification: 1340.0,
    heat: 17_500.0,
    capacity: 1.53,
    conductivity: 0.12e-3,
    char: 0.2,
    ash: 0.005,
};
const PAPER: Material = Material {
    pyrolysis: 548.0,
    gasification: 1800.0,
    heat: 20_000.0,
    capacity: 1.34,
    conductivity: 0.18e-3,
    char: 0.12,
    ash: 0.03,
};
const COAL: Material = Material {
    pyrolysis: 673.0,
    gasification: 300.0,
    heat: 30_000.0,
    capacity: 1.26,
    conductivity: 0.26e-3,
    char: 0.65,
    ash: 0.08,
};
const WAX: Material = Material {
    pyrolysis: 643.0,
    gasification: 480.0,
    heat: 43_100.0,
    capacity: 2.9,
    conductivity: 0.23e-3,
    char: 0.0,
    ash: 0.0,
};
const CLOTH: Material = Material {
    pyrolysis: 573.0,
    gasification: 1800.0,
    heat: 20_000.0,
    capacity: 1.3,
    conductivity: 0.06e-3,
    char: 0.13,
    ash: 0.01,
};

/// A material is written as the first fuel that has it.
impl State for &'static Material {
    fn save(&self, out: &mut Vec<u8>) {
        let mut fuels = Fuel::VALUES.iter();
        let fuel = fuels.find(|fuel| Material::of(**fuel) == Some(*self));
        fuel.copied().unwrap_or(Fuel::None).save(out);
    }

    fn load(bytes: &mut Bytes<'_>) -> Option<&'static Material> {
        Material::of(Fuel::load(bytes)?)
    }
}

impl Material {
    /// The numbers of a fuel; `None` for none.
    pub fn of(fuel: Fuel) -> Option<&'static Material> {
        Some(match fuel {
            Fuel::None => return None,
            Fuel::Wood => &WOOD,
            Fuel::Paper => &PAPER,
            Fuel::Coal => &COAL,
            Fuel::Wax => &WAX,
            Fuel::Cloth => &CLOTH,
        })
    }

    /// Char that forms with a kilogram of gas [kg].
    pub fn char_per_gas(&self) -> f32 {
        self.char / (1.0 - self.char)
    }

    /// Heat of combustion of its gas [kJ/kg]: what the char does not have.
    pub fn gas_heat(&self) -> f32 {
        (self.heat - CHAR_HEAT * (self.char - self.ash)) / (1.0 - self.char)
    }
}
