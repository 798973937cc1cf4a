//! The pair interactions of the combustion model: one line each in [`list`], or in that of
//! [`pressing`](super::pressing).
//!
//! With the harmonic mean density ρ̄ = 2 m/(Vᵢ + Vⱼ) of a pair, each file states its own
//! equation. Exchange within a pair is symmetric to the last bit. The same
//! pass sums the gradient of the particle concentration, Σ V ∇W, by which particles are
//! shifted.

mod diffusion;
mod viscosity;

use glam::{Vec2, Vec4};

use super::pair::{Context, Motion, Pair};
use super::pressing::{self, Pressing};
use super::{Gas, make_room};
use crate::grid::Grid;
use crate::interaction::{PairInteraction, Rates};
use crate::lanes::{LANES, Lanes, transposed};
use crate::neighbours::{self, Neighbours, PairSum};

/// The interactions that a step sums once, in the order in which their rates add up.
fn list(context: &Context) -> impl PairInteraction<Pair> {
    (
        viscosity::Viscosity::new(context),
        diffusion::Diffusion::new(context),
    )
}

/// Four particles.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Block {
    pub motion: Motion,
    /// Half of the viscosity of its roll [m²/s].
    half_roll_viscosity: Lanes,
    /// Temperature \[K\], fuel, oxygen, soot.
    state: [Lanes; 4],
    /// What [`pressing`](super::pressing) sums, acceleration by viscosity [m/s²], and change of the state [1/s].
    sums: [Lanes; SUMS],
}

/// Number of sums of a particle.
const SUMS: usize = 10;

impl neighbours::Block for Block {
    #[inline(always)]
    fn position(&self) -> [Lanes; 2] {
        self.motion.position
    }
    #[inline(always)]
    fn weight(&self) -> Lanes {
        self.motion.volume
    }
    #[inline(always)]
    fn sum(&mut self) -> &mut Lanes {
        &mut self.sums[0]
    }
}

/// Particles that are paired with those of a block, lane by lane.
struct Broadcast {
    motion: Motion,
    half_roll_viscosity: Lanes,
    state: [Lanes; 4],
}

/// All interactions.
struct All<P, E> {
    pressing: Pressing<P>,
    exchange: E,
    eddy_scale: Lanes,
}

impl<P: PairInteraction<Pair>, E: PairInteraction<Pair>> PairSum<SUMS> for All<P, E> {
    type Block = Block;
    type Broadcast = Broadcast;

    #[inline(always)]
    fn broadcast(&self, block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Broadcast {
        Broadcast {
            motion: block.motion.picked(&pick, by),
            half_roll_viscosity: pick(&block.half_roll_viscosity),
            state: block.state.each_ref().map(&pick),
        }
    }

    #[inline(always)]
    fn pair(
        &self,
        particle: &Broadcast,
        others: &Block,
        keep: Lanes,
    ) -> ([Lanes; SUMS], [Lanes; SUMS]) {
        let of_rolls = particle.half_roll_viscosity + others.half_roll_viscosity;
        let pair = Pair::new(&particle.motion, &others.motion, keep);
        let pair = pair.with_eddies(self.eddy_scale, of_rolls);
        let ([a, b, c, d], [e, f, g, h]) =
            (self.pressing).ends(&pair, particle.motion.volume, others.motion.volume);
        let mut rates = Rates::NONE;
        self.exchange.add(&pair, &mut rates);
        let [vx, vy] = pair.velocity.map(|along| along * rates.relative);
        let [t, fuel, oxygen, soot] =
            std::array::from_fn(|k| (particle.state[k] - others.state[k]) * rates.mixing);
        (
            [a, b, c, d, vx, vy, t, fuel, oxygen, soot],
            [e, f, g, h, vx, vy, t, fuel, oxygen, soot],
        )
    }

    #[inline(always)]
    fn accumulator(block: &mut Block) -> &mut [Lanes; SUMS] {
        &mut block.sums
    }
}

/// The memory of the pass.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interactions {
    blocks: Vec<Block>,
}

impl Interactions {
    /// Makes room for so many blocks of particles.
    pub fn reserve(&mut self, blocks: usize) {
        make_room(&mut self.blocks, blocks);
    }

    /// Sums accelerations, diffusion and concentration gradient over the pairs.
    pub fn sum(&mut self, gas: &mut Gas, grid: &Grid, neighbours: &Neighbours, context: &Context) {
        self.pack(gas, grid, 1.0 / context.kernel.smoothing_length());
        let all = All {
            pressing: Pressing::new(context),
            exchange: list(context),
            eddy_scale: Pair::eddy_scale(context),
        };
        neighbours.sum(&all, &mut self.blocks);
        for (block, members) in self.blocks.iter().zip(grid.members()) {
            let [a, b, c, d, vx, vy, t, fuel, oxygen, soot] = block.sums;
            pressing::unpack([a, b, c, d], gas, members.clone(), context);
            let (vx, vy) = (vx.to_array(), vy.to_array());
            let change = transposed([t, fuel, oxygen, soot]);
            for (lane, i) in members.enumerate() {
                gas.acceleration[i] = Vec2::new(vx[lane], vy[lane]);
                gas.change[i] = Vec4::from_array(change[lane].to_array());
            }
        }
    }

    fn pack(&mut self, gas: &Gas, grid: &Grid, inverse_h: f32) {
        // Field by field: a copied block is a call of C in wasm.
        self.blocks.resize(grid.block_count(), Block::default());
        for (block, members) in self.blocks.iter_mut().zip(grid.members()) {
            let mut state = [Lanes::ZERO; LANES];
            let mut rolls = [0.0; LANES];
            for (lane, i) in members.clone().enumerate() {
                state[lane] = Lanes::new(gas.state[i].to_array());
                rolls[lane] = 0.5 * gas.roll_viscosity[i];
            }
            block.motion.read(gas, members, inverse_h);
            block.half_roll_viscosity = Lanes::new(rolls);
            block.state = transposed(state);
            for sum in &mut block.sums {
                *sum = Lanes::ZERO;
            }
        }
    }

    /// The gas as the last pass packed it.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::number_density;
    use crate::combustion::gas::pairs::Pairs;
    use crate::combustion::gas::periodic_bounds as bounds;
    use crate::combustion::gas::tests::{random_gas, with};
    use crate::combustion::gas::walls::Walls;
    use crate::kernel::Kernel;
    use crate::params::Parameters;
    use crate::random::Random;
    use crate::solids::Solids;

    /// Gas in random motion with its interactions summed; `rolls` is the strength of its rolls.
    fn summed(parameters: &Parameters, rolls: f32, seed: u32) -> Gas {
        let mut gas = random_gas(parameters, seed);
        let mut random = Random::new(seed);
        for viscosity in &mut gas.roll_viscosity {
            *viscosity = rolls * random.between(0.0, 0.02);
        }
        let kernel = Kernel::new(parameters.smoothing_length());
        let context = Context::new(&gas, parameters, &kernel, 6.0);
        let mut pairs = Pairs::default();
        pairs.sort(&mut gas, &bounds(parameters), &kernel);
        let bare = (&Walls::default(), &Solids::default());
        let mean = pairs.find_and_sum(&mut gas, bare, &context);
        number_density::set_pressure(&mut gas, mean, context.sound);
        pairs.interact(&mut gas, &context);
        for (acceleration, pressing) in gas.acceleration.iter_mut().zip(&gas.pressing) {
            *acceleration += *pressing;
        }
        gas
    }

    #[test]
    fn exchange_is_conservative() {
        for seed in 0..3 {
            let parameters = with(&[("particles", 1500.0), ("gas_expansion", 1.0)]);
            let gas = summed(&parameters, 1.0, seed);
            let net: Vec2 = gas.acceleration.iter().sum();
            let all: f32 = gas.acceleration.iter().map(|a| a.length()).sum();
            assert!(net.length() < 1e-5 * all, "{net} of {all}");
            let net: Vec4 = gas.change.iter().sum();
            let all: Vec4 = gas.change.iter().map(|c| c.abs()).sum();
            assert!((net.abs() / all).max_element() < 1e-5, "{net} of {all}");
        }
    }

    #[test]
    fn viscosity_of_each_kind_dissipates_energy() {
        for (id, low, high) in [
            ("kinematic_viscosity", 0.0, 0.01),
            ("eddy_viscosity", 0.0, 0.4),
            ("artificial_viscosity", 0.02, 0.4),
        ] {
            let work = |value: f64| {
                let parameters = with(&[
                    ("particles", 1500.0),
                    ("kinematic_viscosity", 0.0),
                    ("eddy_viscosity", 0.0),
                    ("artificial_viscosity", 0.02),
                    (id, value),
                ]);
                let gas = summed(&parameters, 0.0, 5);
                let pairs = gas.velocity.iter().zip(&gas.acceleration);
                pairs.map(|(v, a)| f64::from(v.dot(*a))).sum::<f64>()
            };
            assert!(work(high) < work(low) - 1.0, "{id}");
        }
    }

    #[test]
    fn rolls_dissipate_energy_and_even_out_what_they_mix() {
        let parameters = with(&[("particles", 1500.0)]);
        // The changes of v²/2 and φ²/2 [1/s].
        let changes = |rolls| {
            let gas = summed(&parameters, rolls, 4);
            let work = gas.velocity.iter().zip(&gas.acceleration);
            let work = work.map(|(v, a)| f64::from(v.dot(*a))).sum::<f64>();
            let states = gas.state.iter().zip(&gas.change);
            (work, states.map(|(state, change)| *state * *change).sum())
        };
        let (still, turning): ((f64, Vec4), (f64, Vec4)) = (changes(0.0), changes(1.0));
        assert!(turning.0 < still.0 - 1.0);
        assert!(turning.1.cmplt(1.1 * still.1).all());
    }

    #[test]
    fn the_volumes_of_any_mixture_fill_the_domain() {
        let parameters = with(&[("particles", 1500.0)]);
        let gas = summed(&parameters, 0.0, 7);
        let filled: f32 = gas.volume.iter().sum();
        let domain = parameters.domain_width * parameters.domain_height;
        assert!((filled / domain - 1.0).abs() < 0.03, "{filled} of {domain}");
    }
}
