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
//! by itself; [`Printed`] says how it differs
//! and reckons with it.

use glam::Vec2;

use super::density::DENSITY_FLOOR;
use super::particles::Particles;
use super::printed::Printed;
use crate::extremes::larger;
use crate::kernel::Kernel;
use crate::neighbours::Neighbours;
use crate::params::Values;
use crate::turbulence::Turbulence;

/// Sums the acceleration of every particle.
///
/// `viscosity` [Pa·s] is what the substep can bear, at most the parameter's.
pub(crate) fn accelerate(
    particles: &mut Particles,
    neighbours: &Neighbours,
    kernel: &Kernel,
    values: &Values,
    viscosity: f32,
) {
    let printed = Printed::chosen(values);
    particles.acceleration.fill(Vec2::ZERO);
    if printed.any() {
        printed.push_pairs(particles, neighbours, kernel, values, viscosity);
    } else {
        push_pairs(particles, neighbours, kernel, values, viscosity);
    }
    lift(particles, values);
}

/// Pressure and viscosity between the particles of each pair.
fn push_pairs(
    particles: &mut Particles,
    neighbours: &Neighbours,
    kernel: &Kernel,
    values: &Values,
    viscosity: f32,
) {
    let Particles {
        velocity,
        acceleration,
        density,
        pressure,
        ..
    } = particles;
    let mass = values.particle_mass;
    let softening = 0.01 * kernel.smoothing_length() * kernel.smoothing_length();

    for (i, pairs) in neighbours.iter() {
        let density_i = larger(density[i], DENSITY_FLOOR);
        let (pressure_i, velocity_i) = (pressure[i], velocity[i]);
        let mut sum = Vec2::ZERO;
        for pair in pairs {
            let j = pair.j as usize;
            // All particles have the same mass, so Vᵢ Vⱼ / m is this.
            let volumes = mass / (density_i * larger(density[j], DENSITY_FLOOR));
            let distance_squared = pair.offset.length_squared();
            let push = -(pressure_i + pressure[j]);
            let drag = 2.0 * viscosity * distance_squared / (distance_squared + softening);
            let a = (pair.offset * push + (velocity_i - velocity[j]) * drag)
                * (volumes * pair.gradient);
            sum += a;
            acceleration[j] -= a;
        }
        acceleration[i] += sum;
    }
}

/// Buoyancy, and the weight that the paper counts besides it.
fn lift(particles: &mut Particles, values: &Values) {
    let Particles {
        velocity,
        acceleration,
        temperature,
        density,
        ..
    } = particles;
    for (i, acceleration) in acceleration.iter_mut().enumerate() {
        let density = larger(density[i], DENSITY_FLOOR);
        let lift = if values.printed_divisor {
            values.buoyancy * (values.ambient_density - density) / values.particle_mass
        } else {
            values.buoyancy * (values.ambient_density / density - 1.0)
                + values.thermal_buoyancy * (1.0 - values.ambient_temperature / temperature[i])
        };
        let a = lift * values.gravity - values.extra_weight;
        acceleration.y += a * resisted(a, velocity[i].y, values.terminal_speed);
    }
}

/// Turbulence of the air, which drives gas no faster than the air lets it rise.
pub(crate) fn stir(particles: &mut Particles, turbulence: &Turbulence, values: &Values) {
    if !turbulence.stirs() {
        return;
    }
    for (i, acceleration) in particles.acceleration.iter_mut().enumerate() {
        let push = turbulence.push(particles.position[i]);
        let along = particles.velocity[i].dot(push.normalize_or_zero());
        *acceleration += push * resisted(1.0, along, values.terminal_speed);
    }
}

/// The share of an acceleration `a` that is left at the speed `v` along it.
///
/// This model has no air around the fire, so nothing would stop what rises. In
/// air, lift meets a drag that grows with the square of the speed and balances
/// it at the terminal speed: a (1 − v|v|/v_t²). The bounds keep a particle
/// that is born faster from being hit harder than gravity hits it.
fn resisted(a: f32, v: f32, terminal_speed: f32) -> f32 {
    let along = if a < 0.0 { -v } else { v };
    let drag = along * along.abs() / (terminal_speed * terminal_speed);
    (1.0 - drag).clamp(-1.0, 2.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Particle;
    use crate::classic::density::{pressure, sum_density};
    use crate::grid::{Bounds, Grid};
    use crate::params::{Input, Model, Parameters};
    use crate::random::Random;

    const BOUNDS: Bounds = Bounds {
        width: 1.0,
        height: 1.0,
        periodic: true,
        endless: false,
    };

    /// A dense random cloud in random motion, with its densities and pressures.
    fn cloud(parameters: &Parameters, seed: u32) -> (Particles, Neighbours, Kernel) {
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
        let (mut grid, mut neighbours) = (Grid::default(), Neighbours::default());
        particles.reorder(grid.sort(&particles.position, &BOUNDS, kernel.support()));
        sum_density(
            &mut particles,
            &mut neighbours,
            &grid,
            &kernel,
            parameters.particle_mass,
        );
        pressure(&mut particles, parameters);
        (particles, neighbours, kernel)
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
            let (mut particles, neighbours, kernel) = cloud(&parameters, seed);
            accelerate(
                &mut particles,
                &neighbours,
                &kernel,
                &parameters,
                parameters.viscosity,
            );
            let (net, all) = sum(&particles.acceleration);
            assert!(all > 1.0, "nothing pushes");
            assert!(net < 1e-6 * all, "seed {seed}: {net} of {all}");
        }
    }

    #[test]
    fn viscosity_never_adds_energy() {
        let parameters = weightless(&[("viscosity", Input::Number(0.05))]);
        for seed in 0..5 {
            let (mut particles, neighbours, kernel) = cloud(&parameters, seed);
            particles.pressure.fill(0.0);
            accelerate(
                &mut particles,
                &neighbours,
                &kernel,
                &parameters,
                parameters.viscosity,
            );
            let each = particles.velocity.iter().zip(&particles.acceleration);
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
            let (mut grid, mut neighbours) = (Grid::default(), Neighbours::default());
            particles.reorder(grid.sort(&particles.position, &BOUNDS, kernel.support()));
            sum_density(&mut particles, &mut neighbours, &grid, &kernel, 1e-3);
            accelerate(
                &mut particles,
                &neighbours,
                &kernel,
                &parameters,
                parameters.viscosity,
            );
            let each = particles.velocity.iter().zip(&particles.acceleration);
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
        let (mut grid, mut neighbours) = (Grid::default(), Neighbours::default());
        particles.reorder(grid.sort(&particles.position, &BOUNDS, kernel.support()));
        let mass = parameters.particle_mass;
        sum_density(&mut particles, &mut neighbours, &grid, &kernel, mass);
        for (pressure, position) in particles.pressure.iter_mut().zip(&particles.position) {
            *pressure = position.x;
        }
        accelerate(&mut particles, &neighbours, &kernel, parameters, 0.0);
        let middle = Vec2::new(0.0, 0.1 + 10.0 * dx);
        let at = particles
            .position
            .iter()
            .position(|p| p.distance(middle) < 0.1 * dx);
        particles.acceleration[at.expect("the lattice has a middle")]
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
        let mut particles = Particles::default();
        particles.push(Particle {
            velocity: Vec2::new(0.0, vy),
            temperature,
            ..Particle::at(Vec2::new(0.0, 0.5))
        });
        particles.density[0] = density;
        lift(&mut particles, &parameters);
        particles.acceleration[0].y
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
