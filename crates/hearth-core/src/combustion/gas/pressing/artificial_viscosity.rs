//! Artificial viscosity between particles that approach (Monaghan 1992):
//! m aᵢ = Σ Vᵢ Vⱼ ρ̄ α c₀ μᵢⱼ ∇W, μᵢⱼ = h r·v/(r² + 0.01 h²) where r·v < 0.

use crate::combustion::gas::pair::{Context, Pair};
use crate::interaction::{PairInteraction, Rates};
use crate::lanes::Lanes;

pub(super) struct ArtificialViscosity {
    /// α c₀ h, times the factor of W'.
    scale: Lanes,
}

impl ArtificialViscosity {
    pub fn new(context: &Context) -> ArtificialViscosity {
        let (h, norm) = (
            context.kernel.smoothing_length(),
            context.kernel.minus_dw_norm(),
        );
        ArtificialViscosity {
            scale: Lanes::splat(norm * context.artificial_viscosity * context.sound * h),
        }
    }
}

impl PairInteraction<Pair> for ArtificialViscosity {
    #[inline(always)]
    fn add(&self, pair: &Pair, rates: &mut Rates) {
        rates.radial -= pair.mean_volume * pair.softened_gradient * pair.approach() * self.scale;
    }
}
