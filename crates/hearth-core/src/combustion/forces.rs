//! What the particles of the gas do to each other: pressure, viscosity, and the
//! exchange of heat, fuel, oxygen and soot.
//!
//! Hot gas takes more room. Each particle is weighted by y = m θ, θ = (T/Tₐ)^ε,
//! and Y = Σ yⱼ Wᵢⱼ says how full a place is, whatever mixture fills it. So the
//! volume V = y/Y and the pressure p = c₀² (Y − Ȳ) run smoothly across the edge of
//! a flame, where a plain p(ρ, T) would act as a false surface tension
//! (density-independent SPH: Saitoh & Makino, ApJ 768, 2013). ε = 1 is the ideal
//! gas (the paper's equation 8), ε = 0 the paper's own equation of state. Ȳ is the
//! mean over the particles: hot gas in a closed domain raises the pressure everywhere,
//! which moves nothing, but its noise damps every instability. Pressure below the mean
//! pulls particles into crowds, which shifting dissolves; so there is no gas
//! without any shifting.
//!
//! ```text
//! m aᵢ = − Σ Vᵢ Vⱼ (pᵢ + pⱼ) ∇W
//!        + Σ 2 Vᵢ Vⱼ ρ̄ (ν + ν_t) vᵢⱼ (r·∇W)/(r² + 0.01 h²)        Morris et al. 1997
//!        + Σ Vᵢ Vⱼ ρ̄ α c₀ μᵢⱼ ∇W   where particles approach         Monaghan 1992
//! m φ̇ᵢ = Σ 2 Vᵢ Vⱼ ρ̄ (D₀ + ν_t/Pr) φᵢⱼ (r·∇W)/(r² + 0.01 h²)      Cleary & Monaghan 1999
//! ```
//!
//! with the harmonic mean ρ̄ = 2 m/(Vᵢ + Vⱼ), the eddy viscosity ν_t = C_s² h |vᵢⱼ|,
//! and φ for temperature, fuel, oxygen and soot. Whatever i gains j loses.

use glam::{Vec2, Vec4};

use super::gas::Gas;
use super::vorticity_confinement::VorticityConfinement;
use crate::grid::Grid;
use crate::kernel::{self, Kernel};
use crate::lanes::{LANES, Lanes, Real, sums, transposed};
use crate::neighbours::{self, NOWHERE, Neighbours};
use crate::params::Physics;

/// Prandtl and Schmidt number of the eddies: how much better they mix momentum
/// than heat and matter.
const PRANDTL: f32 = 0.7;

/// Excess over the air below which the expansion is as good as linear.
const SLIGHT: f32 = 2e-3;

/// θ = (T/Tₐ)^ε.
pub(crate) fn expansion(temperature: f32, values: &Physics) -> f32 {
    let ratio = temperature / values.ambient_temperature;
    let excess = ratio - 1.0;
    // Most of the domain is air, and a power takes as long as ten pairs.
    if excess.abs() < SLIGHT {
        1.0 + values.gas_expansion * excess
    } else if values.gas_expansion == 0.5 {
        // The default; and libm computes a root without the processor's help.
        ratio.sqrt()
    } else {
        libm::powf(ratio, values.gas_expansion)
    }
}

/// Four particles, as the search for pairs takes them.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    /// Position, in smoothing lengths.
    x: Lanes,
    y: Lanes,
    /// θ, what each gives to the sums.
    share: Lanes,
    /// What each gets of that.
    sum: Lanes,
}

impl neighbours::Block for Block {
    #[inline(always)]
    fn place(&self) -> (Lanes, Lanes) {
        (self.x, self.y)
    }
    #[inline(always)]
    fn share(&self) -> Lanes {
        self.share
    }
    #[inline(always)]
    fn sum(&mut self) -> &mut Lanes {
        &mut self.sum
    }
}

/// A particle, as the exchange takes it: four numbers of it at a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct PackedParticle {
    /// Position, in smoothing lengths, and velocity [m/s].
    pub motion: Lanes,
    /// Volume \[m²\] and pressure \[Pa\], and two that are not used.
    pub room: Lanes,
    /// Temperature \[K\], fuel, oxygen, soot.
    pub state: Lanes,
}

impl PackedParticle {
    /// Of no consequence: nowhere.
    const NONE: PackedParticle = PackedParticle {
        motion: Lanes::new([NOWHERE, NOWHERE, 0.0, 0.0]),
        room: Lanes::new([1.0, 0.0, 0.0, 0.0]),
        state: Lanes::ZERO,
    };
}

/// What a particle gains from others.
#[derive(Clone, Copy, Debug)]
struct Gain {
    /// Acceleration [m/s²], and concentration_gradient in the units of [`Exchange`].
    motion: Lanes,
    /// Change of its state [1/s].
    state: Lanes,
}

/// The exchange of a pair, with all factors that every pair has.
struct Exchange {
    /// h/m, times that of W'.
    push: Lanes,
    /// α c₀ h, times that of W'.
    artificial: Lanes,
    /// C_s² h
    eddy: Lanes,
    /// −2 ν and −2 D, times the factor of W'.
    viscosity: Lanes,
    diffusion: Lanes,
    /// −2 and −2/Pr, times the factor of W'.
    stirs: Lanes,
    mixes: Lanes,
}

impl Exchange {
    fn new(kernel: &Kernel, values: &Physics, sound: f32, mass: f32) -> Exchange {
        let (h, factor) = (kernel.smoothing_length(), kernel.minus_dw_norm());
        Exchange {
            push: Lanes::splat(factor * h / mass),
            artificial: Lanes::splat(factor * values.artificial_viscosity * sound * h),
            eddy: Lanes::splat(values.eddy_viscosity * values.eddy_viscosity * h),
            viscosity: Lanes::splat(-2.0 * factor * values.kinematic_viscosity),
            diffusion: Lanes::splat(-2.0 * factor * values.diffusion),
            stirs: Lanes::splat(-2.0 * factor),
            mixes: Lanes::splat(-2.0 * factor / PRANDTL),
        }
    }
}

/// What four others give to a particle, and lose.
struct Flow {
    /// Acceleration, lane by lane.
    force: [Lanes; 2],
    /// Offset, as steep as the kernel is there.
    slope: [Lanes; 2],
    /// Volume of the others.
    volume: Lanes,
    /// What the differences of the states are to be multiplied by.
    mix: Lanes,
}

impl Exchange {
    #[inline(always)]
    fn flow(&self, one: &Broadcast, others: [PackedParticle; LANES]) -> Flow {
        let [x, y, vx, vy] = transposed(others.map(|other| other.motion));
        let [volume, pressure, ..] = transposed(others.map(|other| other.room));
        let (x, y) = (one.motion[0] - x, one.motion[1] - y);
        let (vx, vy) = (one.motion[2] - vx, one.motion[3] - vy);
        let square = x * x + y * y;
        let q = kernel::distance(square);
        let softened = square + 0.01;
        // −W'/r is this times q² + 0.01, and −W'/r · r²/(r² + 0.01 h²) is this
        // times q²: one division serves both.
        let slope = kernel::minus_dw(q) / (q * softened);
        let steep = slope * softened;

        // Vᵢ Vⱼ ρ̄/m, both ways.
        let volumes = one.volume * volume;
        let common = (volumes + volumes) / (one.volume + volume);
        let stirred = (vx * vx + vy * vy).sqrt() * self.eddy;
        let laplacian = common * slope * square;
        let approach = (vx * x + vy * y).fast_min(Lanes::ZERO);

        let push = steep * volumes * (one.pressure + pressure) * self.push
            - common * slope * approach * self.artificial;
        let rub = laplacian * (self.viscosity + stirred * self.stirs);
        Flow {
            force: [x * push + vx * rub, y * push + vy * rub],
            slope: [x * steep, y * steep],
            volume,
            mix: laplacian * (self.diffusion + stirred * self.mixes),
        }
    }
}

/// A particle, each property of it in all lanes.
struct Broadcast {
    motion: [Lanes; 4],
    volume: Lanes,
    pressure: Lanes,
}

impl Broadcast {
    /// A particle, moved by so many smoothing lengths.
    #[inline(always)]
    fn of(parcel: &PackedParticle, shift: Vec2) -> Broadcast {
        let [x, y, vx, vy] = [0, 1, 2, 3].map(|k| parcel.motion.spread(k));
        Broadcast {
            motion: [x - shift.x, y - shift.y, vx, vy],
            volume: parcel.room.spread(0),
            pressure: parcel.room.spread(1),
        }
    }
}

/// The passes over pairs, and their memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct Forces {
    neighbours: Neighbours,
    blocks: Vec<Block>,
    packed: Vec<PackedParticle>,
    gains: Vec<Gain>,
    /// The others of one particle.
    others: Vec<u32>,
    /// θ
    expansions: Vec<f32>,
    vorticity_confinement: VorticityConfinement,
}

impl Forces {
    /// Finds all pairs of a sorted grid; fills in how full every place is,
    /// and from it volume and pressure.
    pub fn fill(
        &mut self,
        gas: &mut Gas,
        grid: &Grid,
        kernel: &Kernel,
        values: &Physics,
        sound: f32,
    ) {
        let Forces {
            neighbours,
            blocks,
            expansions,
            ..
        } = self;
        expansions.clear();
        expansions.extend(gas.state.iter().map(|state| expansion(state.x, values)));
        let inverse_h = 1.0 / kernel.smoothing_length();
        // Not cleared: every block is written as a whole.
        blocks.resize(grid.block_count(), Block::default());
        for (block, members) in blocks.iter_mut().zip(grid.members()) {
            let mut place = [[NOWHERE; LANES]; 2];
            let mut share = [0.0; LANES];
            for (lane, i) in members.enumerate() {
                let at = gas.position[i] * inverse_h;
                (place[0][lane], place[1][lane]) = (at.x, at.y);
                share[lane] = expansions[i];
            }
            let [x, y] = place.map(Lanes::new);
            *block = Block {
                x,
                y,
                share: Lanes::new(share),
                sum: Lanes::ZERO,
            };
        }
        neighbours.find(blocks, grid, kernel.smoothing_length());

        let each = gas.mass * kernel.w_norm();
        let mut sum = 0.0;
        for (block, members) in blocks.iter().zip(grid.members()) {
            let number_density = (block.sum * each).to_array();
            for (i, number_density) in members.zip(number_density) {
                gas.number_density[i] = number_density;
                sum += f64::from(number_density);
            }
        }
        let mean = (sum / gas.len().max(1) as f64) as f32;
        for (i, &number_density) in gas.number_density.iter().enumerate() {
            gas.volume[i] = gas.mass * expansions[i] / number_density;
            gas.pressure[i] = sound * sound * (number_density - mean);
        }
    }

    /// Sums acceleration, exchange and concentration_gradient over the pairs.
    pub fn exchange(
        &mut self,
        gas: &mut Gas,
        grid: &Grid,
        kernel: &Kernel,
        values: &Physics,
        sound: f32,
    ) {
        let Forces {
            neighbours,
            blocks,
            packed,
            gains,
            others,
            ..
        } = self;
        let inverse_h = 1.0 / kernel.smoothing_length();
        // Broadcast more than there are places: the lists are filled up with it.
        let places = LANES * blocks.len() + 1;
        packed.resize(places, PackedParticle::NONE);
        packed[places - 1] = PackedParticle::NONE;
        let (fours, _) = packed.as_chunks_mut::<LANES>();
        for (packed, members) in fours.iter_mut().zip(grid.members()) {
            packed[members.len()..].fill(PackedParticle::NONE);
            for (parcel, i) in packed.iter_mut().zip(members) {
                let (at, v) = (gas.position[i] * inverse_h, gas.velocity[i]);
                *parcel = PackedParticle {
                    motion: Lanes::new([at.x, at.y, v.x, v.y]),
                    room: Lanes::new([gas.volume[i], gas.pressure[i], 0.0, 0.0]),
                    state: Lanes::new(gas.state[i].to_array()),
                };
            }
        }
        gains.clear();
        gains.resize(
            places,
            Gain {
                motion: Lanes::ZERO,
                state: Lanes::ZERO,
            },
        );

        let law = Exchange::new(kernel, values, sound, gas.mass);
        neighbours.each(others, |here, shift, others| {
            let parcel = packed[here];
            let one = Broadcast::of(&parcel, shift);
            let mut motion = [Lanes::ZERO; 4];
            let mut state = Lanes::ZERO;
            for four in others.chunks_exact(LANES) {
                let four = [0, 1, 2, 3].map(|k| four[k] as usize);
                let theirs = four.map(|there| packed[there]);
                let flow = law.flow(&one, theirs);
                let [fx, fy] = flow.force;
                let [x, y] = flow.slope;
                motion[0] += fx;
                motion[1] += fy;
                motion[2] += x * flow.volume;
                motion[3] += y * flow.volume;
                let lost = transposed([fx, fy, x * one.volume, y * one.volume]);
                for k in 0..LANES {
                    let flux = (parcel.state - theirs[k].state) * flow.mix.spread(k);
                    state += flux;
                    let gain = &mut gains[four[k]];
                    gain.motion -= lost[k];
                    gain.state -= flux;
                }
            }
            let gain = &mut gains[here];
            gain.motion += sums(motion);
            gain.state += state;
        });

        let crowd = -kernel.minus_dw_norm() * kernel.smoothing_length();
        let (fours, _) = gains.as_chunks::<LANES>();
        for (gains, members) in fours.iter().zip(grid.members()) {
            for (gain, i) in gains.iter().zip(members) {
                let [ax, ay, x, y] = gain.motion.to_array();
                gas.acceleration[i] = Vec2::new(ax, ay);
                gas.concentration_gradient[i] = Vec2::new(x, y) * crowd;
                gas.change[i] = Vec4::from_array(gain.state.to_array());
            }
        }
    }

    /// Adds vorticity confinement.
    pub fn confine(&mut self, gas: &mut Gas, grid: &Grid, kernel: &Kernel, strength: f32) {
        if strength != 0.0 {
            self.vorticity_confinement.confine(
                gas,
                grid,
                &self.neighbours,
                &self.packed,
                kernel,
                strength,
            );
        }
    }

    /// θ of every particle, as the last search for pairs found it.
    pub fn expansions(&self) -> &[f32] {
        &self.expansions
    }

    /// Neighbours of a particle, on average, and the most of one.
    pub fn mean_and_max(&self) -> (f32, u32) {
        self.neighbours.mean_and_max()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::bounds;
    use crate::combustion::gas::tests::{wild, with};
    use crate::params::Parameters;

    /// The gas with its forces summed, and what summed them.
    fn summed(parameters: &Parameters, seed: u32) -> (Gas, Forces, Grid, Kernel) {
        let mut gas = wild(parameters, seed);
        let kernel = Kernel::new(parameters.smoothing_length());
        let (mut grid, mut forces) = (Grid::default(), Forces::default());
        let positions = gas.position.clone().into_iter();
        gas.reorder(grid.sort(positions, &bounds(parameters), kernel.support()));
        forces.fill(&mut gas, &grid, &kernel, parameters, 6.0);
        forces.exchange(&mut gas, &grid, &kernel, parameters, 6.0);
        (gas, forces, grid, kernel)
    }

    #[test]
    fn what_one_gains_another_loses() {
        for seed in 0..3 {
            let parameters = with(&[("max_particles", 1500.0), ("gas_expansion", 1.0)]);
            let (gas, ..) = summed(&parameters, seed);
            let net: Vec2 = gas.acceleration.iter().sum();
            let all: f32 = gas.acceleration.iter().map(|a| a.length()).sum();
            assert!(net.length() < 1e-5 * all, "{net} of {all}");
            let net: Vec4 = gas.change.iter().sum();
            let all: Vec4 = gas.change.iter().map(|c| c.abs()).sum();
            assert!((net.abs() / all).max_element() < 1e-5, "{net} of {all}");
        }
    }

    #[test]
    fn viscosity_of_each_kind_takes_energy() {
        for id in [
            "kinematic_viscosity",
            "eddy_viscosity",
            "artificial_viscosity",
        ] {
            let work = |value: f64| {
                let parameters = with(&[
                    ("max_particles", 1500.0),
                    ("kinematic_viscosity", 0.0),
                    ("eddy_viscosity", 0.0),
                    ("artificial_viscosity", 0.02),
                    (id, value),
                ]);
                let (gas, ..) = summed(&parameters, 5);
                let pairs = gas.velocity.iter().zip(&gas.acceleration);
                pairs.map(|(v, a)| f64::from(v.dot(*a))).sum::<f64>()
            };
            let lowest = if id == "artificial_viscosity" {
                0.02
            } else {
                0.0
            };
            assert!(
                work(if id == "kinematic_viscosity" {
                    0.01
                } else {
                    0.4
                }) < work(lowest) - 1.0,
                "{id}"
            );
        }
    }

    #[test]
    fn hot_gas_takes_the_room_that_its_expansion_says() {
        for (expansion, expected) in [(0.0, 1.0), (0.5, 2.0), (1.0, 4.0)] {
            let parameters = with(&[("gas_expansion", expansion)]);
            let hot = 4.0 * parameters.ambient_temperature;
            assert!((super::expansion(hot, &parameters) - expected).abs() < 1e-5);
            // No step where the power takes over from the line.
            let edge = parameters.ambient_temperature * (1.0 + SLIGHT);
            let step = super::expansion(edge * 1.0001, &parameters)
                - super::expansion(edge * 0.9999, &parameters);
            assert!(step.abs() < 3e-4, "{step}");
        }
    }

    #[test]
    fn the_particles_fill_the_domain_whatever_they_are_made_of() {
        let parameters = with(&[("max_particles", 1500.0)]);
        let (gas, ..) = summed(&parameters, 7);
        let filled: f32 = gas.volume.iter().sum();
        let domain = parameters.domain_width * parameters.domain_height;
        assert!((filled / domain - 1.0).abs() < 0.03, "{filled} of {domain}");
    }

    #[test]
    fn confinement_turns_vortices_and_leaves_still_air_alone() {
        let parameters = with(&[("max_particles", 1500.0)]);
        let (mut gas, mut forces, grid, kernel) = summed(&parameters, 9);
        let before = gas.acceleration.clone();
        forces.confine(&mut gas, &grid, &kernel, 0.0);
        assert_eq!(gas.acceleration, before);
        forces.confine(&mut gas, &grid, &kernel, 0.5);
        assert_ne!(gas.acceleration, before);

        for velocity in &mut gas.velocity {
            *velocity = Vec2::new(0.7, -0.2);
        }
        forces.exchange(&mut gas, &grid, &kernel, &parameters, 6.0);
        let before = gas.acceleration.clone();
        forces.confine(&mut gas, &grid, &kernel, 0.5);
        assert_eq!(gas.acceleration, before);
    }
}
