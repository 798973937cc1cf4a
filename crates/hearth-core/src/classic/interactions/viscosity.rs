//! Viscosity: Fᵢ = 2 μ Vᵢ Vⱼ (vᵢ − vⱼ) (r·∇W)/(r² + 0.01 h²) (Morris et al. 1997).

use crate::classic::pair::Pair;
use crate::interaction::{PairInteraction, Rates};
use crate::kernel::Kernel;
use crate::lanes::Lanes;

pub(super) struct Viscosity {
    /// −2 μ m, times the factor of W'.
    scale: Lanes,
}

impl Viscosity {
    /// Gas of particles of that `mass` and that dynamic `viscosity` [Pa·s].
    pub fn new(kernel: &Kernel, mass: f32, viscosity: f32) -> Viscosity {
        let each = mass * kernel.minus_dw_norm();
        Viscosity {
            scale: Lanes::splat(-2.0 * viscosity * each),
        }
    }
}

impl PairInteraction<Pair> for Viscosity {
    #[inline(always)]
    fn add(&self, pair: &Pair, rates: &mut Rates) {
        rates.relative += pair.quotient * (pair.offset.square * self.scale);
    }
}
