//! The forces of pairs where an equation is taken as the paper prints it.
//!
//! Each printed form can be chosen by itself, so that a reader can see what it
//! does. They stand apart because the two ends of a pair may then feel
//! different forces, and because the usual forces need not ask at every pair.

use super::density::DENSITY_FLOOR;
use super::particles::Particles;
use crate::kernel::Kernel;
use crate::neighbours::Neighbours;
use crate::params::Values;

/// The paper's equations as they are printed, each to be chosen by itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Printed {
    /// Equation 3, f = − m (pᵢ + pⱼ)/(2 ρⱼ) ∇W: the ½ halves the gradient of
    /// the pressure, and the density of force is taken for an acceleration.
    pub pressure: bool,
    /// Equation 4, f = μ m (vⱼ − vᵢ)/ρⱼ ∇²W with the kernel's own Laplacian.
    pub viscosity: bool,
    /// Equations 5 and 7, a = f/m: a density of force is divided by the mass
    /// instead of the density, and temperature lifts nothing.
    pub divisor: bool,
}

impl Printed {
    /// Which of them `values` choose.
    pub fn chosen(values: &Values) -> Printed {
        Printed {
            pressure: values.printed_pressure,
            viscosity: values.printed_viscosity,
            divisor: values.printed_divisor,
        }
    }

    /// Whether at least one of them is chosen.
    pub fn any(self) -> bool {
        self.pressure || self.viscosity || self.divisor
    }

    /// Pressure and viscosity between the particles of each pair.
    pub fn push_pairs(
        self,
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

        // Densities of force [N/m³] to accelerations [m/s²].
        let by = |density: f32, half_pressure: bool| {
            if self.divisor {
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
                let share = if self.pressure { 0.5 } else { 1.0 };
                let push =
                    pair.offset * (-share * mass * (pressure[i] + pressure[j]) * pair.gradient);

                let distance_squared = pair.offset.length_squared();
                let drag = if self.viscosity {
                    -kernel.laplacian(distance_squared.sqrt())
                } else {
                    2.0 * pair.gradient * distance_squared / (distance_squared + softening)
                };
                let rub = (velocity[i] - velocity[j]) * (viscosity * mass * drag);

                acceleration[i] += push / density_j * by(density_i, self.pressure)
                    + rub / density_j * by(density_i, false);
                acceleration[j] -= push / density_i * by(density_j, self.pressure)
                    + rub / density_i * by(density_j, false);
            }
        }
    }
}
