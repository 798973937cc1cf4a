//! What pushes the particles: pressure, viscosity, buoyancy.
//!
//! With V = m/ρ the volume of a particle, the forces of a pair are
//!
//! ```text
//! pressure     Fᵢ = − Vᵢ Vⱼ (pᵢ + pⱼ) ∇W                            (Monaghan 2005)
//! viscosity    Fᵢ = 2 μ Vᵢ Vⱼ (vᵢ − vⱼ) (r·∇W) / (r² + 0.01 h²)     (Morris et al. 1997)
//! ```
//!
//! and j feels the opposite, so momentum is kept to rounding, whatever the
//! particles do. Buoyancy acts on each particle alone:
//!
//! ```text
//! a = [β (ρ_amb/ρ − 1) + β_T (1 − T_a/T)] g ŷ
//! ```
//!
//! The paper prints some of this differently. Each printed form can be chosen
//! by itself; [`AsPublished`] says how it differs
//! and reckons with it.

use glam::Vec2;

use super::as_published::AsPublished;
use super::pairs::{Block, Pairs};
use super::particles::Particles;
use crate::kernel::{self, Kernel};
use crate::lanes::{Lanes, Real};
use crate::neighbours::PairSum;
use crate::params::Physics;
use crate::turbulence::Turbulence;

/// Adds pressure and viscosity to the acceleration of every particle.
///
/// `viscosity` [Pa·s] is what the substep can bear, at most the parameter's.
pub(crate) fn push_and_rub(pairs: &mut Pairs, kernel: &Kernel, values: &Physics, viscosity: f32) {
    let printed = AsPublished::new(kernel, values, viscosity);
    if printed.any() {
        pairs.apply(&printed);
    } else {
        pairs.apply(&PushAndRub::new(kernel, values.particle_mass, viscosity));
    }
}

/// A particle, each property of it in all lanes.
pub(crate) struct Broadcast {
    pub place: [Lanes; 2],
    pub velocity: [Lanes; 2],
    pub volume: Lanes,
    pub pressure: Lanes,
}

impl Broadcast {
    #[inline(always)]
    pub fn of(block: &Block, lane: usize, shift: Vec2) -> Broadcast {
        Broadcast {
            place: [
                block.place[0].spread(lane) - shift.x,
                block.place[1].spread(lane) - shift.y,
            ],
            velocity: block.velocity.map(|v| v.spread(lane)),
            volume: block.volume.spread(lane),
            pressure: block.pressure.spread(lane),
        }
    }

    /// Offset from each of the others, in smoothing lengths.
    #[inline(always)]
    pub fn offset(&self, others: &Block) -> [Lanes; 2] {
        let [x, y] = others.place;
        [self.place[0] - x, self.place[1] - y]
    }

    /// Velocity against each of the others [m/s].
    #[inline(always)]
    pub fn apart(&self, others: &Block) -> [Lanes; 2] {
        let [vx, vy] = others.velocity;
        [self.velocity[0] - vx, self.velocity[1] - vy]
    }
}

/// Pressure and viscosity between the particles of a pair, with all factors that
/// every rub has.
struct PushAndRub {
    /// 2 μ m, times that of W'.
    rub: Lanes,
}

impl PushAndRub {
    fn new(kernel: &Kernel, mass: f32, viscosity: f32) -> PushAndRub {
        let each = mass * kernel.minus_dw_norm();
        PushAndRub {
            rub: Lanes::splat(2.0 * viscosity * each),
        }
    }
}

impl PairSum<2> for PushAndRub {
    type Block = Block;
    type Broadcast = Broadcast;

    #[inline(always)]
    fn one(&self, block: &Block, lane: usize, shift: Vec2) -> Broadcast {
        Broadcast::of(block, lane, shift)
    }

    #[inline(always)]
    fn pair(&self, one: &Broadcast, others: &Block) -> ([Lanes; 2], [Lanes; 2]) {
        let [x, y] = one.offset(others);
        let square = x * x + y * y;
        let q = kernel::distance(square);
        let softened = square + 0.01;
        // −W'/r is this times q² + 0.01, and −W'/r · r²/(r² + 0.01 h²) is this
        // times q²: one division serves both.
        let slope = kernel::minus_dw(q) * (one.volume * others.volume) / (q * softened);
        let push = slope * softened * (one.pressure + others.pressure);
        let rub = slope * square * self.rub;
        let [vx, vy] = one.apart(others);
        let gain = [x * push - vx * rub, y * push - vy * rub];
        (gain, gain)
    }

    #[inline(always)]
    fn gains(block: &mut Block) -> &mut [Lanes; 2] {
        &mut block.acceleration
    }
}

/// Acceleration upwards of gas of that temperature: buoyancy, and the weight that
/// the paper counts besides it.
#[inline(always)]
pub(crate) fn lift(block: &Block, temperature: Lanes, values: &Physics) -> Lanes {
    let lift = if values.printed_divisor {
        let density = Lanes::splat(1.0) / block.volume;
        (Lanes::splat(values.ambient_density) - density) * (values.buoyancy / values.particle_mass)
    } else {
        let warm = Lanes::splat(1.0) - Lanes::splat(values.ambient_temperature) / temperature;
        (block.volume * values.ambient_density - 1.0) * values.buoyancy
            + warm * values.thermal_buoyancy
    };
    let a = lift * values.gravity - values.extra_weight;
    resisted(a, block.velocity[1], values.terminal_speed)
}

/// Turbulence of the air, which drives gas no faster than the air lets it rise.
pub(crate) fn stir(
    particles: &Particles,
    pairs: &mut Pairs,
    turbulence: &Turbulence,
    values: &Physics,
) {
    if turbulence.stirs() {
        pairs.push_by(particles, |position, velocity| {
            let push = turbulence.push(position);
            let along = velocity.dot(push.normalize_or_zero());
            push * resisted(1.0, along, values.terminal_speed)
        });
    }
}

/// What the air leaves of an acceleration `a` at the speed `v` along it.
///
/// This model has no air around the fire, so nothing would stop what rises. In
/// air, lift meets a drag that grows with the square of the speed and balances
/// it at the terminal speed: a (1 − v|v|/v_t²). The bounds keep a particle
/// that is born faster from being hit harder than gravity hits it.
fn resisted<T: Real>(a: T, v: T, terminal_speed: f32) -> T {
    let (zero, one) = (T::of(0.0), T::of(1.0));
    let drag = v * v.fast_max(zero - v) / T::of(terminal_speed * terminal_speed);
    let left = |drag: T| (one - drag).fast_max(T::of(-1.0)).fast_min(T::of(2.0));
    // An acceleration downwards meets drag upwards.
    a.fast_max(zero) * left(drag) + a.fast_min(zero) * left(zero - drag)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Particle;
    use crate::bounds::Bounds;
    use crate::params::{Input, Model, Parameters};
    use crate::random::Random;

    const BOUNDS: Bounds = Bounds {
        width: 1.0,
        height: 1.0,
        periodic: true,
        endless: false,
    };

    /// A dense random cloud in random motion, with its densities and pressures.
    fn cloud(parameters: &Parameters, seed: u32) -> (Particles, Pairs, Kernel) {
        let mut random = Random::new(seed);
        let mut particles = Particles::default();
        for _ in 0..600 {
            particles.push(Particle {
                velocity: Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0)),
                temperature: random.between(300.0, 1900.0),
                ..Particle::at(Vec2::new(
                    random.between(-0.5, 0.5),
                    random.between(0.2, 0.5),
                ))
            });
        }
        let kernel = Kernel::new(parameters.smoothing_radius);
        let mut pairs = Pairs::default();
        pairs.sort(&mut particles, &BOUNDS, &kernel);
        pairs.sum_density(&mut particles, &kernel, parameters);
        (particles, pairs, kernel)
    }

    fn with(values: &[(&str, Input<'_>)]) -> Parameters {
        let mut parameters = Parameters::new(Model::Classic);
        for &(id, value) in values {
            parameters.set(id, value).expect(id);
        }
        parameters
    }

    /// Pair forces alone.
    fn weightless(more: &[(&str, Input<'_>)]) -> Parameters {
        let none = Input::Number(0.0);
        let mut values = vec![
            ("buoyancy", none),
            ("thermal_buoyancy", none),
            ("smoothing_radius", Input::Number(0.04)),
            ("particle_mass", Input::Number(1e-3)),
        ];
        values.extend_from_slice(more);
        with(&values)
    }

    fn sum(values: &[Vec2]) -> (f32, f32) {
        let net = values.iter().copied().sum::<Vec2>().length();
        let all = values.iter().map(|v| v.length()).sum();
        (net, all)
    }

    #[test]
    fn pair_forces_keep_momentum() {
        let parameters = weightless(&[("viscosity", Input::Number(0.05))]);
        for seed in 0..5 {
            let (_, mut pairs, kernel) = cloud(&parameters, seed);
            push_and_rub(&mut pairs, &kernel, &parameters, parameters.viscosity);
            let (net, all) = sum(&pairs.accelerations());
            assert!(all > 1.0, "nothing pushes");
            assert!(net < 1e-6 * all, "seed {seed}: {net} of {all}");
        }
    }

    #[test]
    fn viscosity_never_adds_energy() {
        let parameters = weightless(&[("viscosity", Input::Number(0.05))]);
        for seed in 0..5 {
            let (particles, mut pairs, kernel) = cloud(&parameters, seed);
            pairs.set_pressure(&particles, &kernel, parameters.particle_mass, |_| 0.0);
            push_and_rub(&mut pairs, &kernel, &parameters, parameters.viscosity);
            let accelerations = pairs.accelerations();
            let each = particles.iter().map(|p| p.velocity()).zip(&accelerations);
            let power: f64 = each.map(|(v, a)| f64::from(v.dot(*a))).sum();
            assert!(power < 0.0, "seed {seed}: {power}");
        }
    }

    #[test]
    fn the_printed_laplacian_speeds_up_a_pair_closer_than_eight_ninths() {
        // Two particles at q = 0.4 in opposite motion: viscosity must brake
        // them; the kernel's own Laplacian is negative there and speeds them up.
        let power = |printed: bool| {
            let parameters = weightless(&[
                ("viscosity", Input::Number(0.05)),
                ("printed_viscosity", Input::Flag(printed)),
            ]);
            let kernel = Kernel::new(parameters.smoothing_radius);
            let mut particles = Particles::default();
            for side in [-1.0, 1.0] {
                particles.push(Particle {
                    velocity: Vec2::new(0.0, side),
                    ..Particle::at(Vec2::new(side * 0.2 * parameters.smoothing_radius, 0.5))
                });
            }
            let mut pairs = Pairs::default();
            pairs.sort(&mut particles, &BOUNDS, &kernel);
            pairs.sum_density(&mut particles, &kernel, &parameters);
            push_and_rub(&mut pairs, &kernel, &parameters, parameters.viscosity);
            let accelerations = pairs.accelerations();
            let each = particles.iter().map(|p| p.velocity()).zip(&accelerations);
            each.map(|(v, a)| v.dot(*a)).sum::<f32>()
        };
        assert!(power(false) < 0.0);
        assert!(power(true) > 0.0);
    }

    /// A lattice with spacing `dx` whose pressure rises by 1 Pa/m along x.
    fn lattice_acceleration(parameters: &Parameters, dx: f32) -> Vec2 {
        let kernel = Kernel::new(parameters.smoothing_radius);
        let mut particles = Particles::default();
        for i in -10..=10 {
            for j in 0..=20 {
                particles.push(Particle::at(Vec2::new(i as f32 * dx, 0.1 + j as f32 * dx)));
            }
        }
        let mut pairs = Pairs::default();
        pairs.sort(&mut particles, &BOUNDS, &kernel);
        pairs.sum_density(&mut particles, &kernel, parameters);
        pairs.set_pressure(&particles, &kernel, parameters.particle_mass, |at| at.x);
        push_and_rub(&mut pairs, &kernel, parameters, 0.0);
        let middle = Vec2::new(0.0, 0.1 + 10.0 * dx);
        let at = particles
            .iter()
            .position(|p| p.position().distance(middle) < 0.1 * dx);
        pairs.accelerations()[at.expect("the lattice has a middle")]
    }

    #[test]
    fn a_linear_pressure_pushes_by_its_gradient() {
        // ρ = 1 on this lattice, so the acceleration is −∇p = −1.
        for ratio in [1.3_f32, 1.5, 2.0] {
            let dx = 0.02;
            let parameters = weightless(&[
                ("smoothing_radius", Input::Number(f64::from(ratio * dx))),
                ("particle_mass", Input::Number(f64::from(dx * dx))),
            ]);
            let a = lattice_acceleration(&parameters, dx);
            assert!(
                (a.x + 1.0).abs() < 0.03 && a.y.abs() < 1e-3,
                "h/dx = {ratio}: {a}"
            );
        }
    }

    #[test]
    fn the_printed_pressure_is_half_of_it() {
        let dx = 0.02;
        let parameters = weightless(&[
            ("smoothing_radius", Input::Number(0.03)),
            ("particle_mass", Input::Number(f64::from(dx * dx))),
            ("printed_pressure", Input::Flag(true)),
        ]);
        let a = lattice_acceleration(&parameters, dx);
        assert!((a.x + 0.5).abs() < 0.02, "{a}");
    }

    fn lone_lift(more: &[(&str, Input<'_>)], temperature: f32, density: f32, vy: f32) -> f32 {
        let parameters = with(more);
        let block = Block {
            volume: Lanes::splat(1.0 / density),
            velocity: [Lanes::ZERO, Lanes::splat(vy)],
            ..Block::EMPTY
        };
        lift(&block, Lanes::splat(temperature), &parameters).to_array()[0]
    }

    #[test]
    fn thin_gas_and_hot_gas_rise_and_dense_cold_gas_sinks() {
        assert!(lone_lift(&[], 293.0, 0.6, 0.0) > 0.0);
        assert!(lone_lift(&[], 1900.0, 1.2, 0.0) > 0.0);
        assert!(lone_lift(&[], 293.0, 1.8, 0.0) < 0.0);
        assert_eq!(
            lone_lift(&[("gravity", Input::Number(0.0))], 1900.0, 0.6, 0.0),
            0.0
        );
    }

    #[test]
    fn at_the_terminal_speed_nothing_lifts_any_more() {
        let terminal = Parameters::new(Model::Classic).terminal_speed;
        let free = lone_lift(&[], 1900.0, 0.6, 0.0);
        assert!(lone_lift(&[], 1900.0, 0.6, terminal).abs() < 1e-5 * free);
        assert!(lone_lift(&[], 1900.0, 0.6, 1.3 * terminal) < 0.0);
        assert!(lone_lift(&[], 1900.0, 0.6, 0.5 * terminal) < free);
    }

    #[test]
    fn the_printed_divisor_lifts_by_one_over_the_mass_and_not_by_heat() {
        let flag = ("printed_divisor", Input::Flag(true));
        let p = Parameters::new(Model::Classic);
        let expected = p.buoyancy * (p.ambient_density - 0.6) * p.gravity / p.particle_mass;
        let printed = lone_lift(&[flag], 1900.0, 0.6, 0.0);
        assert!((printed / expected - 1.0).abs() < 1e-5);
        assert_eq!(printed, lone_lift(&[flag], 293.0, 0.6, 0.0));
    }
}
