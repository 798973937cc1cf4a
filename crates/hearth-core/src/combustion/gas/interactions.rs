//! The pair interactions of the combustion model: one line each in [`list`].
//!
//! With the harmonic mean density ρ̄ = 2 m/(Vᵢ + Vⱼ) of a pair, each file states its own
//! equation. Exchange within a pair is symmetric to the last bit. The same
//! pass sums the gradient of the particle concentration, Σ V ∇W, by which particles are
//! shifted.

mod artificial_viscosity;
mod diffusion;
mod pressure;
mod viscosity;

use glam::{Vec2, Vec4};

use super::pair::{Block, Broadcast, Context, Pair, SUMS};
use super::{Gas, make_room};
use crate::grid::Grid;
use crate::interaction::{PairInteraction, Rates};
use crate::lanes::{LANES, Lanes, transposed};
use crate::neighbours::{FAR_AWAY, Neighbours, PairSum};

/// All pair interactions, in the order in which their rates add up.
fn list(context: &Context) -> impl PairInteraction<Pair> {
    (
        pressure::Pressure::new(context),
        artificial_viscosity::ArtificialViscosity::new(context),
        viscosity::Viscosity::new(context),
        diffusion::Diffusion::new(context),
    )
}

/// All interactions of a step.
struct Sums<I> {
    interactions: I,
    eddy_scale: Lanes,
}

impl<I: PairInteraction<Pair>> PairSum<SUMS> for Sums<I> {
    type Block = Block;
    type Broadcast = Broadcast;

    #[inline(always)]
    fn broadcast(&self, block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Broadcast {
        Broadcast::of(block, pick, by)
    }

    #[inline(always)]
    fn pair(&self, particle: &Broadcast, others: &Block) -> ([Lanes; SUMS], [Lanes; SUMS]) {
        let pair = Pair::new(particle, others, self.eddy_scale);
        let mut rates = Rates::NONE;
        self.interactions.add(&pair, &mut rates);
        let [ax, ay] = rates.acceleration(&pair.offset, pair.velocity);
        let (x, y) = (pair.offset.x * pair.gradient, pair.offset.y * pair.gradient);
        let [t, f, o, s] =
            std::array::from_fn(|k| (particle.state[k] - others.state[k]) * rates.mixing);
        (
            [ax, ay, x * others.volume, y * others.volume, t, f, o, s],
            [ax, ay, x * particle.volume, y * particle.volume, t, f, o, s],
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

    /// Sums acceleration, diffusion and concentration gradient over the pairs.
    pub fn sum(&mut self, gas: &mut Gas, grid: &Grid, neighbours: &Neighbours, context: &Context) {
        let kernel = context.kernel;
        self.pack(gas, grid, 1.0 / kernel.smoothing_length());
        let sums = Sums {
            interactions: list(context),
            eddy_scale: Pair::eddy_scale(context),
        };
        neighbours.sum(&sums, &mut self.blocks);
        let gradient_norm = -kernel.minus_dw_norm() * kernel.smoothing_length();
        for (block, members) in self.blocks.iter().zip(grid.members()) {
            let [ax, ay, x, y, t, f, o, s] = block.sums;
            let motion = transposed([ax, ay, x * gradient_norm, y * gradient_norm]);
            let change = transposed([t, f, o, s]);
            for ((motion, change), i) in motion.into_iter().zip(change).zip(members) {
                let [ax, ay, x, y] = motion.to_array();
                gas.acceleration[i] = Vec2::new(ax, ay);
                gas.concentration_gradient[i] = Vec2::new(x, y);
                gas.change[i] = Vec4::from_array(change.to_array());
            }
        }
    }

    fn pack(&mut self, gas: &Gas, grid: &Grid, inverse_h: f32) {
        // Not cleared: the loop overwrites every block.
        self.blocks.resize(grid.block_count(), Block::EMPTY);
        for (block, members) in self.blocks.iter_mut().zip(grid.members()) {
            const EMPTY: [Lanes; 3] = [
                Lanes::new([FAR_AWAY, FAR_AWAY, 0.0, 0.0]),
                Lanes::new([1.0, 0.0, 0.0, 0.0]),
                Lanes::ZERO,
            ];
            let [mut motion, mut rest, mut state] = EMPTY.map(|lanes| [lanes; LANES]);
            for (lane, i) in members.enumerate() {
                let (at, v) = (gas.position[i] * inverse_h, gas.velocity[i]);
                motion[lane] = Lanes::new([at.x, at.y, v.x, v.y]);
                rest[lane] = Lanes::new([
                    gas.volume[i],
                    gas.pressure[i],
                    0.5 * gas.roll_viscosity[i],
                    0.0,
                ]);
                state[lane] = Lanes::new(gas.state[i].to_array());
            }
            let [x, y, vx, vy] = transposed(motion);
            let [volume, pressure, half_roll_viscosity, _] = transposed(rest);
            *block = Block {
                position: [x, y],
                velocity: [vx, vy],
                volume,
                pressure,
                half_roll_viscosity,
                state: transposed(state),
                sums: [Lanes::ZERO; SUMS],
            };
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
