//! Viscosity of the gas and of its eddies (Morris et al. 1997; Smagorinsky):
//! m aᵢ = Σ 2 Vᵢ Vⱼ ρ̄ (ν + ν_t + Sc (Dᵢ + Dⱼ)/2) vᵢⱼ (r·∇W)/(r² + 0.01 h²), with the
//! diffusivities Dᵢ, Dⱼ of their rolls.

use crate::combustion::gas::pair::{Context, Pair};
use crate::interaction::{PairInteraction, Rates};
use crate::lanes::Lanes;

/// Turbulent Schmidt number of the rolls: the ratio of their viscosity to their diffusivity, as in planar jets
/// and plumes.
const SCHMIDT: f32 = 0.5;

pub(super) struct Viscosity {
    /// −2 ν, times the factor of W'.
    molecular: Lanes,
    /// −2, times the factor of W'.
    eddy: Lanes,
    /// −Sc, times the factor of W'.
    roll: Lanes,
}

impl Viscosity {
    pub fn new(context: &Context) -> Viscosity {
        let norm = context.kernel.minus_dw_norm();
        Viscosity {
            molecular: Lanes::splat(-2.0 * norm * context.values.kinematic_viscosity),
            eddy: Lanes::splat(-2.0 * norm),
            roll: Lanes::splat(-norm * SCHMIDT),
        }
    }
}

impl PairInteraction<Pair> for Viscosity {
    #[inline(always)]
    fn add(&self, pair: &Pair, rates: &mut Rates) {
        let eddies = pair.eddy_viscosity * self.eddy + pair.roll_diffusivities * self.roll;
        rates.relative += pair.laplacian * (self.molecular + eddies);
    }
}
