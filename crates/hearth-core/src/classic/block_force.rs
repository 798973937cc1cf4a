//! Body forces of the classic model, four particles at a time.

use super::pairs::Block;
use super::particles::ParticleState;
use crate::forces::{BodyForce, LocalGas};
use crate::lanes::{LANES, Lanes};

/// The state of a block for body forces.
pub(super) struct Four<'a> {
    pub states: &'a [ParticleState; LANES],
    /// Specific volume [m³/kg].
    pub volume: Lanes,
    /// Specific volume, relative to that of the surrounding air.
    pub expansion: Lanes,
    pub temperature: Lanes,
    pub velocity: [Lanes; 2],
}

impl<'a> Four<'a> {
    #[inline(always)]
    pub fn new(states: &'a [ParticleState; LANES], block: &Block, air_density: f32) -> Four<'a> {
        let [a, b, c, d] = states;
        Four {
            states,
            volume: block.volume,
            expansion: block.volume * air_density,
            temperature: Lanes::new([a, b, c, d].map(|particle| particle.temperature)),
            velocity: block.velocity,
        }
    }
}

/// A [`BodyForce`] on four particles at once. Every body force implements it, lane by lane.
pub(super) trait BlockForce {
    /// Adds its accelerations [m/s²].
    fn add(&self, four: &Four, sum: &mut [Lanes; 2]);
}

impl<F: BodyForce + ?Sized> BlockForce for F {
    fn add(&self, four: &Four, sum: &mut [Lanes; 2]) {
        let expansion = four.expansion.to_array();
        let [mut x, mut y] = sum.map(Lanes::to_array);
        for (lane, state) in four.states.iter().enumerate() {
            let a = self.acceleration(&LocalGas {
                position: state.position(),
                velocity: state.velocity(),
                temperature: state.temperature,
                expansion: expansion[lane],
            });
            x[lane] += a.x;
            y[lane] += a.y;
        }
        *sum = [x, y].map(Lanes::new);
    }
}

/// An optional force.
impl<F: BlockForce> BlockForce for Option<F> {
    #[inline(always)]
    fn add(&self, four: &Four, sum: &mut [Lanes; 2]) {
        if let Some(force) = self {
            force.add(four, sum);
        }
    }
}

/// Several forces, in order.
macro_rules! in_order {
    ($($name:ident)+) => {
        impl<$($name: BlockForce),+> BlockForce for ($($name,)+) {
            #[inline(always)]
            #[expect(non_snake_case, reason = "named as their types are")]
            fn add(&self, four: &Four, sum: &mut [Lanes; 2]) {
                let ($($name,)+) = self;
                $($name.add(four, sum);)+
            }
        }
    };
}
in_order!(A B);
in_order!(A B C);
