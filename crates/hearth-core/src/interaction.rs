//! Pair interactions: forces and exchange between two particles within each other's support.
//!
//! An interaction is a type in a file of its own that implements [`PairInteraction`].
//! Each model lists its interactions as tuples (`combustion/gas/interactions.rs` and `pressing.rs`,
//! `classic/interactions.rs`), so the compiler fuses all of them into one loop, in which
//! the model's `Pair` holds the terms that several of them share.

use crate::kernel;
use crate::lanes::Lanes;

/// Offset of a particle from four others, in smoothing lengths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Separation {
    pub x: Lanes,
    pub y: Lanes,
    /// Square of the distance.
    pub square: Lanes,
    /// The distance, never quite zero.
    pub q: Lanes,
}

impl Separation {
    #[inline(always)]
    pub fn between(particle: [Lanes; 2], others: [Lanes; 2]) -> Separation {
        let (x, y) = (particle[0] - others[0], particle[1] - others[1]);
        let square = x * x + y * y;
        Separation {
            x,
            y,
            square,
            q: kernel::distance(square),
        }
    }

    /// r² + 0.01 h², which keeps quotients finite for coincident particles.
    #[inline(always)]
    pub fn softened(&self) -> Lanes {
        self.square + 0.01
    }
}

/// How fast a pair exchanges momentum and matter, summed over its interactions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rates {
    /// Acceleration along the offset, as a multiple of it.
    pub radial: Lanes,
    /// Acceleration along the relative velocity, as a multiple of it.
    pub relative: Lanes,
    /// Change of temperature and composition, as a multiple of their difference.
    pub mixing: Lanes,
}

impl Rates {
    /// The rates of no interaction. Adding to −0 changes no bit of the sum, so the compiler
    /// omits the first addition.
    pub const NONE: Rates = Rates {
        radial: Lanes::splat(-0.0),
        relative: Lanes::splat(-0.0),
        mixing: Lanes::splat(-0.0),
    };

    /// The acceleration of the one particle, lane by lane.
    #[inline(always)]
    pub fn acceleration(&self, offset: &Separation, velocity: [Lanes; 2]) -> [Lanes; 2] {
        [
            offset.x * self.radial + velocity[0] * self.relative,
            offset.y * self.radial + velocity[1] * self.relative,
        ]
    }
}

/// An interaction of two particles; `Pair` is the pair data of the model.
pub(crate) trait PairInteraction<Pair> {
    /// Adds to the rates of a pair.
    fn add(&self, pair: &Pair, rates: &mut Rates);
}

macro_rules! fused {
    ($($name:ident)+) => {
        impl<Pair, $($name: PairInteraction<Pair>),+> PairInteraction<Pair> for ($($name,)+) {
            #[inline(always)]
            #[expect(non_snake_case, reason = "named as their types are")]
            fn add(&self, pair: &Pair, rates: &mut Rates) {
                let ($($name,)+) = self;
                $($name.add(pair, rates);)+
            }
        }
    };
}
fused!(A B);
