//! The account of removed gas.

/// The gas that solids have taken the place of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RemovedGas {
    /// Number of particles.
    pub particles: u64,
    /// Their mass [kg/m].
    pub mass: f64,
    /// Their heat, relative to air [kJ/m].
    pub heat: f64,
}

crate::state! { RemovedGas: particles mass heat }
