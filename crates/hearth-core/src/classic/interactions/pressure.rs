//! Pressure: Fᵢ = − Vᵢ Vⱼ (pᵢ + pⱼ) ∇W (Monaghan 2005).

use crate::classic::pair::Pair;
use crate::interaction::{PairInteraction, Rates};

/// The pressures of the blocks contain its factors.
pub(super) struct Pressure;

impl PairInteraction<Pair> for Pressure {
    #[inline(always)]
    fn add(&self, pair: &Pair, rates: &mut Rates) {
        rates.radial += pair.quotient * (pair.softened * pair.pressures);
    }
}
