//! Pressure: m aᵢ = − Σ Vᵢ Vⱼ (pᵢ + pⱼ) ∇W.

use crate::combustion::gas::pair::{Context, Pair};
use crate::interaction::{PairInteraction, Rates};
use crate::lanes::Lanes;

pub(super) struct Pressure {
    /// h/m, times the factor of W'.
    scale: Lanes,
}

impl Pressure {
    pub fn new(context: &Context) -> Pressure {
        let (h, norm) = (
            context.kernel.smoothing_length(),
            context.kernel.minus_dw_norm(),
        );
        Pressure {
            scale: Lanes::splat(norm * h / context.mass),
        }
    }
}

impl PairInteraction<Pair> for Pressure {
    #[inline(always)]
    fn add(&self, pair: &Pair, rates: &mut Rates) {
        rates.radial += pair.gradient * pair.volumes * pair.pressures * self.scale;
    }
}
