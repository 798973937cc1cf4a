//! What readers see of the water.

use std::fmt;

use glam::Vec2;

/// Droplets of one size that move and evaporate alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Droplets {
    /// Position \[m\].
    pub position: Vec2,
    /// Velocity [m/s].
    pub velocity: Vec2,
    /// Temperature \[K\].
    pub temperature: f32,
    /// Diameter of each \[m\].
    pub diameter: f32,
    /// Mass of all of them [kg/m], and at first.
    pub mass: f32,
    /// Mass of all of them at first [kg/m].
    pub first: f32,
    /// Time until they leave the nozzle \[s\].
    pub waits: f32,
}

/// Where the water of all sprays is: masses in kg and heat in kJ, per metre of depth. The sum of the
/// other masses is that of what was sprayed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SprayTotals {
    /// Mass of all that was sprayed.
    pub sprayed: f64,
    /// Mass of the droplets in the air.
    pub flying: f64,
    /// Mass that evaporated in the air.
    pub evaporated: f64,
    /// Mass that boiled off solids without fuel and off sources.
    pub boiled: f64,
    /// Mass that went into solids with fuel, which count it as their water and their steam.
    pub soaked: f64,
    /// Mass that wets sources.
    pub held: f64,
    /// Mass that ran off cold solids, fell to the floor or left the domain.
    pub run_off: f64,
    /// Heat that the gas lost to droplets.
    pub heat: f64,
    /// Heat that solids without fuel lost to droplets.
    pub solid_heat: f64,
}

crate::state! {
    Droplets: position velocity temperature diameter mass first waits,
    SprayTotals: sprayed flying evaporated boiled soaked held run_off heat solid_heat
}

/// The error of spraying water where no gas burns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SprayError;

impl SprayError {
    /// What the model must be instead.
    pub const ALLOWED: &'static str = "combustion: the classic model has no water";
}

impl fmt::Display for SprayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "model must be {}", SprayError::ALLOWED)
    }
}

impl std::error::Error for SprayError {}
