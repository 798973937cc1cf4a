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
//! by itself; [`Printed`] says how it differs.

use glam::Vec2;

use crate::density::{DENSITY_FLOOR, Neighbours};
use crate::kernel::Kernel;
use crate::params::Values;
use crate::particles::Particles;

/// The paper's equations as they are printed, each to be chosen by itself.
#[derive(Clone, Copy, Debug)]
struct Printed {
    /// Equation 3, f = − m (pᵢ + pⱼ)/(2 ρⱼ) ∇W: the ½ halves the gradient of
    /// the pressure, and the density of force is taken for an acceleration.
    pressure: bool,
    /// Equation 4, f = μ m (vⱼ − vᵢ)/ρⱼ ∇²W with the kernel's own Laplacian.
    viscosity: bool,
    /// Equations 5 and 7, a = f/m: a density of force is divided by the mass
    /// instead of the density, and temperature lifts nothing.
    divisor: bool,
}

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
    let printed = Printed {
        pressure: values.printed_pressure,
        viscosity: values.printed_viscosity,
        divisor: values.printed_divisor,
    };
    particles.acceleration.fill(Vec2::ZERO);
    if printed.pressure || printed.viscosity || printed.divisor {
        push_pairs_as_printed(particles, neighbours, kernel, values, viscosity, printed);
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
    let Particles { velocity, acceleration, density, pressure, .. } = particles;
    let mass = values.particle_mass;
    let softening = 0.01 * kernel.smoothing_length() * kernel.smoothing_length();

    for (i, pairs) in neighbours.iter() {
        let density_i = density[i].max(DENSITY_FLOOR);
        let (pressure_i, velocity_i) = (pressure[i], velocity[i]);
        let mut sum = Vec2::ZERO;
        for pair in pairs {
            let j = pair.j as usize;
            // All particles have the same mass, so Vᵢ Vⱼ / m is this.
            let volumes = mass / (density_i * density[j].max(DENSITY_FLOOR));
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

/// The same, where at least one equation is taken as printed. The two ends of
/// a pair may then feel different forces.
fn push_pairs_as_printed(
    particles: &mut Particles,
    neighbours: &Neighbours,
    kernel: &Kernel,
    values: &Values,
    viscosity: f32,
    printed: Printed,
) {
    let Particles { velocity, acceleration, density, pressure, .. } = particles;
    let mass = values.particle_mass;
    let softening = 0.01 * kernel.smoothing_length() * kernel.smoothing_length();

    // Densities of force [N/m³] to accelerations [m/s²].
    let by = |density: f32, half_pressure: bool| {
        if printed.divisor {
            1.0 / mass
        } else if half_pressure {
            1.0
        } else {
            1.0 / density
        }
    };
    for (i, pairs) in neighbours.iter() {
        let density_i = density[i].max(DENSITY_FLOOR);
        for pair in pairs {
            let j = pair.j as usize;
            let density_j = density[j].max(DENSITY_FLOOR);
            let share = if printed.pressure { 0.5 } else { 1.0 };
            let push = pair.offset * (-share * mass * (pressure[i] + pressure[j]) * pair.gradient);

            let distance_squared = pair.offset.length_squared();
            let drag = if printed.viscosity {
                -kernel.laplacian(distance_squared.sqrt())
            } else {
                2.0 * pair.gradient * distance_squared / (distance_squared + softening)
            };
            let rub = (velocity[i] - velocity[j]) * (viscosity * mass * drag);

            acceleration[i] += push / density_j * by(density_i, printed.pressure)
                + rub / density_j * by(density_i, false);
            acceleration[j] -= push / density_i * by(density_j, printed.pressure)
                + rub / density_i * by(density_j, false);
        }
    }
}

/// Buoyancy, and the weight that the paper counts besides it.
fn lift(particles: &mut Particles, values: &Values) {
    let Particles { velocity, acceleration, temperature, density, .. } = particles;
    for (i, acceleration) in acceleration.iter_mut().enumerate() {
        let density = density[i].max(DENSITY_FLOOR);
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
