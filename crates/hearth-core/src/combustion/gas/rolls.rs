//! Mixing in rolls. In two dimensions nothing stretches vortices, so that the rolls of a plane flow do not break
//! up but merge. The eddies into which a roll of three dimensions breaks up have an eddy viscosity, with a
//! mixing length (Prandtl 1925) of the size of the fire:
//!
//! ```text
//! νᵢ = max(l² (|ω| − ½ √(b g/D*)) R − ν, 0)     l² = (C D*)² − (2.5 C_s h)²
//! R = max((ω² − s²)/(ω² + s²), 0)     ω = ∂ₓv − ∂ᵧu    s² = (∂ₓu − ∂ᵧv)² + (∂ₓv + ∂ᵧu)²
//! ```
//!
//! R is the Okubo–Weiss criterion (Okubo 1970, Weiss 1991): it is 0 where the gas strains as fast as it turns, as
//! in every shear layer. A roll that turns slower than the fire's own rate does not turn over in the life of a
//! flame. What eddies of the size of the kernel mix is in the eddy viscosity, and what molecules mix in ν.
//!
//! Rolls live for some hundred steps, so ∇v is summed in each fourth step only.

use glam::Vec2;

use super::pair::Context;
use super::{Gas, make_room};
use crate::combustion::fires::{Fires, lift};
use crate::extremes::{fast_max, fast_min};
use crate::grid::Grid;
use crate::interaction::Separation;
use crate::kernel;
use crate::lanes::{LANES, Lanes};
use crate::neighbours::{self, FAR_AWAY, Neighbours, PairSum};

/// ∇v is summed in one of so many steps.
const STEPS: u32 = 4;
/// Least vorticity of a roll that mixes, relative to √(b g/D*).
const LEAST_RATE: f32 = 0.5;
/// The size of the eddies of the eddy viscosity, in C_s h.
const RESOLVED_EDDIES: f32 = 2.5;
/// Largest viscosity, in h c₀: with it, 0.125 h²/ν is longer than the step for the sound.
const MAX_VISCOSITY: f32 = 0.085;

/// Four particles.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    /// Position, in smoothing lengths.
    position: [Lanes; 2],
    /// Volume \[m²\].
    volume: Lanes,
    /// Velocity [m/s].
    velocity: [Lanes; 2],
    /// ∂ₓv − ∂ᵧu, ∂ₓu − ∂ᵧv and ∂ₓv + ∂ᵧu without the factor of W'.
    rates: [Lanes; 3],
}

impl neighbours::Block for Block {
    fn position(&self) -> [Lanes; 2] {
        self.position
    }
    fn weight(&self) -> Lanes {
        self.volume
    }
    fn sum(&mut self) -> &mut Lanes {
        &mut self.rates[0]
    }
}

/// Rotation and strain, Σ V ∇W v.
struct VelocityGradient;

impl PairSum<3> for VelocityGradient {
    type Block = Block;
    /// Position, volume and velocity of a particle in all lanes.
    type Broadcast = ([Lanes; 2], Lanes, [Lanes; 2]);

    #[inline(always)]
    fn broadcast(
        &self,
        block: &Block,
        pick: impl Fn(&Lanes) -> Lanes,
        by: Vec2,
    ) -> Self::Broadcast {
        (
            [
                pick(&block.position[0]) + by.x,
                pick(&block.position[1]) + by.y,
            ],
            pick(&block.volume),
            block.velocity.each_ref().map(&pick),
        )
    }

    #[inline(always)]
    fn pair(
        &self,
        (position, volume, velocity): &Self::Broadcast,
        others: &Block,
        keep: Lanes,
    ) -> ([Lanes; 3], [Lanes; 3]) {
        let Separation { x, y, q, .. } = Separation::between(*position, others.position);
        let over_r = keep * kernel::minus_dw(q) / q;
        let (x, y) = (x * over_r, y * over_r);
        let u = velocity[0] - others.velocity[0];
        let v = velocity[1] - others.velocity[1];
        let rates = [x * v - y * u, x * u - y * v, x * v + y * u];
        (
            rates.map(|rate| rate * others.volume),
            rates.map(|rate| -(rate * *volume)),
        )
    }

    fn accumulator(block: &mut Block) -> &mut [Lanes; 3] {
        &mut block.rates
    }
}

/// The memory of the pass.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rolls {
    blocks: Vec<Block>,
    /// Steps until the next sum.
    left: u32,
}

crate::state! { Rolls: left; blocks }

impl Rolls {
    /// Makes room for so many blocks of particles.
    pub fn reserve(&mut self, blocks: usize) {
        make_room(&mut self.blocks, blocks);
    }

    /// Forgets when the last sum was: the next step sums.
    pub fn restart(&mut self) {
        self.left = 0;
    }

    /// Counts a step. Returns whether it is one that sums.
    pub fn is_due(&mut self) -> bool {
        let is_due = self.left == 0;
        self.left = if is_due { STEPS } else { self.left } - 1;
        is_due
    }

    /// Finds the viscosity of the roll around each particle.
    pub fn find(
        &mut self,
        gas: &mut Gas,
        grid: &Grid,
        neighbours: &Neighbours,
        fires: &Fires,
        context: &Context,
    ) {
        let (values, h) = (context.values, context.kernel.smoothing_length());
        let resolved = RESOLVED_EDDIES * values.eddy_viscosity * h;
        if values.roll_mixing * fires.greatest_length() <= resolved {
            gas.roll_viscosity.fill(0.0);
            return;
        }
        self.pack(gas, grid, 1.0 / h);
        neighbours.sum(&VelocityGradient, &mut self.blocks);
        let norm = context.kernel.minus_dw_norm() * h;
        let most = MAX_VISCOSITY * h * context.sound;
        for (block, members) in self.blocks.iter().zip(grid.members()) {
            let rates = block.rates.map(|rate| (rate * norm).to_array());
            for (lane, i) in members.enumerate() {
                let [turn, stretch, shear] = [0, 1, 2].map(|k| rates[k][lane]);
                let (turn, strain) = (turn * turn, stretch * stretch + shear * shear);
                let mut viscosity = 0.0;
                if turn > strain
                    && let Some(part) = fires.nearest(gas.position[i])
                {
                    let length = values.roll_mixing * part.length;
                    let square = length * length - resolved * resolved;
                    let least = LEAST_RATE * (lift(values) / part.length).sqrt();
                    let rate = (turn.sqrt() - least) * (turn - strain) / (turn + strain);
                    viscosity = square * rate - values.kinematic_viscosity;
                }
                gas.roll_viscosity[i] = fast_min(fast_max(viscosity, 0.0), most);
            }
        }
    }

    /// Packs the gas into blocks, with empty sums.
    fn pack(&mut self, gas: &Gas, grid: &Grid, inverse_h: f32) {
        self.blocks.clear();
        self.blocks.extend(grid.members().map(|members| {
            let mut position = [[FAR_AWAY; LANES]; 2];
            let mut velocity = [[0.0; LANES]; 2];
            let mut volume = [0.0; LANES];
            for (lane, i) in members.enumerate() {
                let (at, v) = (gas.position[i] * inverse_h, gas.velocity[i]);
                (position[0][lane], position[1][lane]) = (at.x, at.y);
                (velocity[0][lane], velocity[1][lane]) = (v.x, v.y);
                volume[lane] = gas.volume[i];
            }
            Block {
                position: position.map(Lanes::new),
                volume: Lanes::new(volume),
                velocity: velocity.map(Lanes::new),
                ..Block::default()
            }
        }));
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::TAU;

    use super::*;
    use crate::combustion::gas::pairs::Pairs;
    use crate::combustion::gas::periodic_bounds as bounds;
    use crate::combustion::gas::tests::{random_gas, with};
    use crate::combustion::gas::walls::Walls;
    use crate::kernel::Kernel;
    use crate::params::Parameters;
    use crate::solids::Solids;

    /// A closed domain, 1 m wide and high.
    fn square(values: &[(&str, f64)]) -> Parameters {
        let size = [("domain_width", 1.0), ("domain_height", 1.0)];
        with(&[&size, values].concat())
    }

    /// Places, and the viscosities of the rolls of gas that moves as `flow` in a fire of 220 kW/m.
    fn viscosities(parameters: &Parameters, flow: impl Fn(Vec2) -> Vec2) -> Vec<(Vec2, f32)> {
        let mut gas = random_gas(parameters, 3);
        for (velocity, at) in gas.velocity.iter_mut().zip(&gas.position) {
            *velocity = flow(*at);
        }
        let kernel = Kernel::new(parameters.smoothing_length());
        let context = Context::new(&gas, parameters, &kernel, 6.0);
        let mut pairs = Pairs::default();
        pairs.sort(&mut gas, &bounds(parameters), &kernel);
        let bare = (&Walls::default(), &Solids::default());
        pairs.find_and_sum(&mut gas, bare, &context);
        let mut fires = Fires::default();
        fires.add([Vec2::ZERO, Vec2::X], 220.0);
        fires.measure(parameters);
        pairs.find_rolls(&mut gas, &fires, &context);
        gas.position.into_iter().zip(gas.roll_viscosity).collect()
    }

    /// Four vortices in a square, with the vorticity `turn` in their middles.
    fn vortices(turn: f32) -> impl Fn(Vec2) -> Vec2 {
        move |at| {
            let Vec2 { x, y } = at * TAU;
            let along = Vec2::new(
                libm::cosf(x) * libm::sinf(y),
                -libm::sinf(x) * libm::cosf(y),
            );
            along * (turn / (2.0 * TAU))
        }
    }

    #[test]
    fn rolls_mix_in_their_middle_and_not_where_the_flow_strains() {
        let parameters = square(&[("kinematic_viscosity", 0.0)]);
        let turn = 30.0;
        let found = viscosities(&parameters, vortices(turn));
        // ω is −turn cos x cos y, greatest at the corners of the domain; the flow strains between.
        let length = 0.336 * parameters.roll_mixing;
        let resolved = 2.5 * parameters.eddy_viscosity * parameters.smoothing_length();
        let least = 0.5 * libm::sqrtf(9.81 / 0.336);
        let expected = (length * length - resolved * resolved) * (turn - least);
        let near = |place: Vec2, at: Vec2| (place - at).length() < 0.05;
        let mean = |middle: Vec2| {
            let values = found.iter().filter(|(at, _)| near(*at, middle));
            let values: Vec<f32> = values.map(|(_, viscosity)| *viscosity).collect();
            values.iter().sum::<f32>() / values.len() as f32
        };
        let middle = mean(Vec2::new(0.0, 0.5));
        assert!(
            (middle / expected - 1.0).abs() < 0.25,
            "{middle}, {expected}"
        );
        assert!(mean(Vec2::new(0.25, 0.25)) < 0.02 * expected);
    }

    #[test]
    fn shear_slow_rolls_viscous_gas_and_the_parameter_0_mix_nothing() {
        let none = |values: &[(&str, f64)], flow: &dyn Fn(Vec2) -> Vec2| {
            let found = viscosities(&square(values), flow);
            found.iter().all(|(_, viscosity)| *viscosity == 0.0)
        };
        let fast = vortices(30.0);
        assert!(!none(&[], &fast));
        assert!(none(&[], &vortices(2.0)));
        assert!(none(
            &[("kinematic_viscosity", 0.01), ("roll_mixing", 0.05)],
            &fast
        ));
        assert!(none(&[("roll_mixing", 0.0)], &fast));
        assert!(none(
            &[("eddy_viscosity", 0.4), ("roll_mixing", 0.08)],
            &fast
        ));
        let sheared = |at: Vec2| Vec2::new(3.0 * libm::sinf(TAU * at.y), 0.0);
        let sheared = viscosities(&square(&[]), sheared);
        let [most, vortex] = [sheared, viscosities(&square(&[]), vortices(3.0 * TAU))]
            .map(|found| found.iter().map(|found| found.1).sum::<f32>());
        assert!(most < 0.02 * vortex, "{most} of {vortex}");
    }

    #[test]
    fn rolls_are_due_in_the_first_step_and_where_a_fire_is_taken_up() {
        let mut rolls = Rolls::default();
        let mut due = |steps: u32| (0..steps).filter(|_| rolls.is_due()).count();
        assert_eq!(
            [due(1), due(STEPS - 1), due(1), due(STEPS - 2)],
            [1, 0, 1, 0]
        );
        rolls.restart();
        assert!(rolls.is_due());
    }

    #[test]
    fn no_roll_shortens_the_step() {
        let found = viscosities(&square(&[("roll_mixing", 0.2)]), vortices(2000.0));
        let most = found.iter().map(|found| found.1).fold(0.0, fast_max);
        let h = square(&[]).smoothing_length();
        assert_eq!(most, MAX_VISCOSITY * h * 6.0);
        assert!(0.125 * h * h / most > crate::combustion::gas::time_step::step_at_rest(h, 6.0));
    }
}
