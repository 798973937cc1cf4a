//! What is around droplets in a step.

use crate::bounds::Bounds;
use crate::combustion::fuels::Fuels;
use crate::combustion::gas::Gas;
use crate::grid::Grid;
use crate::kernel::Kernel;
use crate::params::Physics;
use crate::solids::Solids;

/// What is around droplets in a step.
pub(crate) struct Around<'a> {
    pub gas: &'a mut Gas,
    pub grid: &'a Grid,
    pub kernel: &'a Kernel,
    pub bounds: &'a Bounds,
    pub solids: &'a mut Solids,
    pub fuels: Option<&'a mut Fuels>,
    pub has_floor: bool,
    pub values: &'a Physics,
    pub dt: f32,
    /// The particles around a place, and the weight of each.
    pub near: Vec<(usize, f32)>,
}
