//! Pressure: Fᵢ = − Vᵢ Vⱼ (pᵢ + pⱼ) ∇W (Monaghan 2005).

use crate::classic::pair::Pair;
use crate::interaction::{PairInteraction, Rates};

/// Its factors are in the pressures of the blocks.
pub(super) struct Pressure;

impl PairInteraction<Pair> for Pressure {
    #[inline(always)]
    fn add(&self, pair: &Pair, rates: &mut Rates) {
        rates.radial += pair.gradient * pair.pressures;
    }
}
