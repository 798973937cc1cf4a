//! The state of the solids that burn.

use glam::Vec2;

use super::cells::Burning;

/// Blocks along each side of the region.
pub(super) const BLOCKS: usize = 24;

/// Hot gas: its power [kW/m], and that times its position.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Block {
    pub power: f32,
    pub moment: Vec2,
}

/// All solids of a scene that burn.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fuels {
    pub(super) all: Vec<Burning>,
    /// The gas beside each cell of all of them, one after another.
    pub(super) beside: Vec<AdjacentGas>,
    /// What each particle near a wall touches.
    pub(super) touches: Vec<Touch>,
    pub(super) blocks: Vec<Block>,
    /// The share of a block that each cell sees, in the same order.
    pub(super) views: Vec<f32>,
    pub(super) steps: u32,
    /// Time since the outlines were looked at \[s\].
    pub(super) since: f32,
    /// Power of the gas that is given off and of the char that burns [kW/m].
    pub(super) power: f32,
    /// Power of the flames in the film at the surface, in the last step [kW/m].
    pub(super) film: f32,
}

/// The gas beside a cell in a step: what it offers and what it gets.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct AdjacentGas {
    /// Conductance [kW/(m·K)], and its products with temperature and oxygen.
    pub(super) conductance: f32,
    pub(super) heat: f32,
    pub(super) oxygen: f32,
    /// Sum of the shares in what the cell gives off.
    pub(super) weight: f32,
    /// Conductance of free convection, for each unit of weight [kW/(m·K)].
    pub(super) convection: f32,
    /// Temperature of the cell after the exchange \[K\].
    pub(super) temperature: f32,
    /// Heat of what leaves the cell [kJ/m].
    pub(super) carried: f32,
    /// Fuel that the cell offers, and fuel that the gas has taken [kg/m].
    pub(super) fuel: f32,
    pub(super) taken: f32,
    /// Share of the oxygen at the surface that burns.
    pub(super) burnt: f32,
    /// Heat of the flame in the film [kJ/m].
    pub(super) flame: f32,
}

crate::state! {
    Block: power moment,
    Fuels: all beside blocks views steps since power film; touches,
    AdjacentGas: conductance heat oxygen weight convection temperature carried fuel taken burnt flame
}

/// The place of a cell that does not exist.
pub(super) const NOTHING: u32 = u32::MAX;

/// A particle near a wall: the place of its cell in `beside`, or [`NOTHING`], and its conductance
/// [kW/(m·K)].
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    pub(super) place: u32,
    pub(super) conductance: f32,
}
