//! Molecular and turbulent diffusion of heat, fuel, oxygen and soot
//! (Cleary & Monaghan 1999): m φ̇ᵢ = Σ 2 Vᵢ Vⱼ ρ̄ (D₀ + ν_t/Pr) φᵢⱼ (r·∇W)/(r² + 0.01 h²).

use crate::combustion::gas::pair::{Context, Pair};
use crate::interaction::{PairInteraction, Rates};
use crate::lanes::Lanes;

/// Turbulent Prandtl and Schmidt number: the ratio of eddy viscosity to eddy diffusivity.
const PRANDTL: f32 = 0.7;

pub(super) struct Diffusion {
    /// −2 D₀, times the factor of W'.
    molecular: Lanes,
    /// −2/Pr, times the factor of W'.
    eddy: Lanes,
}

impl Diffusion {
    pub fn new(context: &Context) -> Diffusion {
        let norm = context.kernel.minus_dw_norm();
        Diffusion {
            molecular: Lanes::splat(-2.0 * norm * context.values.diffusion),
            eddy: Lanes::splat(-2.0 * norm / PRANDTL),
        }
    }
}

impl PairInteraction<Pair> for Diffusion {
    #[inline(always)]
    fn add(&self, pair: &Pair, rates: &mut Rates) {
        rates.mixing += pair.laplacian * (self.molecular + pair.eddy_viscosity * self.eddy);
    }
}
