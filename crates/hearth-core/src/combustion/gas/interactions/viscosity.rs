//! Viscosity of the gas and of its eddies (Morris et al. 1997; Smagorinsky):
//! m aᵢ = Σ 2 Vᵢ Vⱼ ρ̄ (ν + ν_t) vᵢⱼ (r·∇W)/(r² + 0.01 h²).

use crate::combustion::gas::pair::{Context, Pair};
use crate::interaction::{PairInteraction, Rates};
use crate::lanes::Lanes;

pub(super) struct Viscosity {
    /// −2 ν, times the factor of W'.
    molecular: Lanes,
    /// −2, times the factor of W'.
    eddy: Lanes,
}

impl Viscosity {
    pub fn new(context: &Context) -> Viscosity {
        let norm = context.kernel.minus_dw_norm();
        Viscosity {
            molecular: Lanes::splat(-2.0 * norm * context.values.kinematic_viscosity),
            eddy: Lanes::splat(-2.0 * norm),
        }
    }
}

impl PairInteraction<Pair> for Viscosity {
    #[inline(always)]
    fn add(&self, pair: &Pair, rates: &mut Rates) {
        rates.relative += pair.laplacian * (self.molecular + pair.eddy_viscosity * self.eddy);
    }
}
