//! Extra weight: gravity besides buoyancy, as in the paper.

use crate::classic::block_force::{BlockForce, Four};
use crate::lanes::Lanes;
use crate::params::Physics;

/// A uniform acceleration downwards [m/s²].
pub(super) struct ExtraWeight(f32);

impl ExtraWeight {
    pub fn new(values: &Physics) -> ExtraWeight {
        ExtraWeight(values.extra_weight)
    }
}

impl BlockForce for ExtraWeight {
    #[inline(always)]
    fn add(&self, _four: &Four, sum: &mut [Lanes; 2]) {
        sum[1] = sum[1] - self.0;
    }
}
