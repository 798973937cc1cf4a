//! The classic model, equation by equation.

use glam::DVec2;
use hearth_core::params::Walls;
use hearth_core::{Parameters, Particle};

use super::{Crowd, Domain, Kernel, Neighbour, Plain, Size, Sum};

/// Minimum density in a force [kg/m³].
const LEAST_DENSITY: f64 = 0.3;
/// Most parts of a step.
const MOST_SUBSTEPS: f64 = 32.0;

/// The particles of the classic model. No source feeds them.
#[derive(Clone, Debug)]
pub struct Classic {
    /// The particles, in the order of their birth.
    pub particles: Vec<Plain>,
    /// How many parts the last step had.
    pub substeps: u32,
    /// The neighbours that each particle had in the last part.
    pub crowd: Crowd,
    /// Largest speed and largest acceleration of the last substep.
    max_speed: f64,
    max_acceleration: f64,
}

impl Classic {
    /// These particles, about to be moved for the first time.
    pub fn new(particles: &[Particle]) -> Classic {
        Classic {
            particles: particles.iter().map(Plain::new).collect(),
            substeps: 0,
            crowd: Crowd::new(),
            max_speed: 0.0,
            max_acceleration: 0.0,
        }
    }

    /// These particles in the place of those that it has; the next step is divided
    /// by the motion of the last one.
    pub fn take_over(&mut self, particles: &[Particle]) {
        self.particles = particles.iter().map(Plain::new).collect();
    }

    /// Moves the particles by one time step.
    pub fn step(&mut self, parameters: &Parameters) {
        let p = parameters;
        let (h, step) = (f64::from(p.smoothing_radius), f64::from(p.time_step));
        let bears = |length: f64| 0.125 * h * h * LEAST_DENSITY / length;
        let viscosity = f64::from(p.viscosity);

        let sound = f64::from(p.gas_constant).sqrt();
        let courant = 0.35 * h / (sound + self.max_speed);
        let force = 0.25 * (h / self.max_acceleration.max(1e-6)).sqrt();
        let diffusion = bears(viscosity.max(1e-9));
        let longest = courant.min(force).min(diffusion);
        let count = (step / longest).ceil().clamp(1.0, MOST_SUBSTEPS);
        let length = step / count;
        self.substeps = count as u32;
        for _ in 0..self.substeps {
            self.substep(p, length, viscosity.min(bears(length)));
        }
    }

    fn substep(&mut self, p: &Parameters, dt: f64, viscosity: f64) {
        let h = f64::from(p.smoothing_radius);
        let kernel = if p.printed_kernel {
            Kernel::as_printed(h)
        } else {
            Kernel::new(h)
        };
        let domain = Domain {
            width: p.domain_width.into(),
            height: p.domain_height.into(),
            across: p.walls == Walls::Periodic,
            up: false,
        };
        let near = domain.neighbours(&self.particles, kernel.support());
        self.crowd = Domain::crowd(&near, kernel.support());
        self.press(p, &kernel, &near);
        let accelerations: Vec<Sum<DVec2>> = (0..self.particles.len())
            .map(|i| {
                let mut acceleration = self.pushed(i, p, &kernel, viscosity, &near[i]);
                acceleration.add_sum(self.lifted(i, p));
                acceleration
            })
            .collect();
        self.integrate(p, &accelerations, dt);
        for particle in &mut self.particles {
            let temperature = &mut particle.mixture[0];
            temperature.add(-f64::from(p.cooling_rate) * dt);
            temperature.value = temperature.value.max(p.ambient_temperature.into());
            particle.age += dt;
            stop(particle, p.walls, &domain);
        }
        self.particles.retain(|particle| {
            particle.age < particle.lifetime && domain.holds(particle.position.value)
        });
    }

    /// ρ = Σ m W and p = k (ρ − ρ₀), at least 0.
    fn press(&mut self, p: &Parameters, kernel: &Kernel, near: &[Vec<Neighbour>]) {
        let mass = f64::from(p.particle_mass);
        let (k, rest) = (f64::from(p.gas_constant), f64::from(p.rest_density));
        for (particle, near) in self.particles.iter_mut().zip(near) {
            let mut density = Sum::new(mass * kernel.value(0.0));
            for other in near {
                density.add(mass * kernel.value(other.offset.length()));
            }
            particle.density = density;
            particle.pressure = Sum {
                value: k * (density.value - rest).max(0.0),
                size: k * (density.size + rest),
            };
        }
    }

    /// Pressure and viscosity: densities of force, divided by what makes
    /// accelerations of them. The two differ as printed.
    fn pushed(
        &self,
        i: usize,
        p: &Parameters,
        kernel: &Kernel,
        viscosity: f64,
        near: &[Neighbour],
    ) -> Sum<DVec2> {
        let mass = f64::from(p.particle_mass);
        let of = |particle: &Plain| particle.density.value.max(LEAST_DENSITY);
        let here = &self.particles[i];
        let divisor = if p.printed_divisor { mass } else { of(here) };
        let mut acceleration = Sum::default();
        for &Neighbour { j, offset } in near {
            let there = &self.particles[j];
            let volume = mass / of(there);
            // Vᵢ Vⱼ (pᵢ + pⱼ) ∇W over m is this over ρᵢ.
            let gradient = kernel.gradient(offset) * volume;
            let mut pressures = here.pressure;
            pressures.add_sum(there.pressure);
            let by = match (p.printed_pressure, p.printed_divisor) {
                (true, false) => 0.5,
                (true, true) => 0.5 / mass,
                (false, _) => 1.0 / divisor,
            };
            acceleration.add_sum(Sum {
                value: gradient * (-pressures.value * by),
                size: gradient.size() * pressures.size * by,
            });

            let apart = here.velocity.value - there.velocity.value;
            let drag = if p.printed_viscosity {
                -kernel.laplacian(offset.length())
            } else {
                2.0 * kernel.brookshaw(offset)
            };
            acceleration.add(apart * (viscosity * volume * drag / divisor));
        }
        acceleration
    }

    /// Buoyancy less the extra weight, as far as the air lets it be.
    fn lifted(&self, i: usize, p: &Parameters) -> Sum<DVec2> {
        let here = &self.particles[i];
        let density = here.density.value.max(LEAST_DENSITY);
        let (buoyancy, air) = (f64::from(p.buoyancy), f64::from(p.ambient_density));
        let mut lift = Sum::default();
        if p.printed_divisor {
            let mass = f64::from(p.particle_mass);
            lift.add(buoyancy * air / mass);
            lift.add(-buoyancy * density / mass);
        } else {
            let thermal = f64::from(p.thermal_buoyancy);
            lift.add(buoyancy * air / density);
            lift.add(-buoyancy);
            lift.add(thermal);
            lift.add(-thermal * f64::from(p.ambient_temperature) / here.temperature());
        }
        let mut a = lift.times(p.gravity.into());
        a.add(-f64::from(p.extra_weight));

        let speed = here.velocity.value.y;
        let along = if a.value < 0.0 { -speed } else { speed };
        let share = along * along.abs() / f64::from(p.terminal_speed).powi(2);
        let left = (1.0 - share).clamp(-1.0, 2.0);
        Sum {
            value: DVec2::new(0.0, a.value * left),
            size: a.size * (1.0 + share.abs()).min(2.0),
        }
    }

    /// Symplectic Euler, or forward Euler as printed, below the speed limit.
    fn integrate(&mut self, p: &Parameters, accelerations: &[Sum<DVec2>], dt: f64) {
        (self.max_speed, self.max_acceleration) = (0.0, 0.0);
        let limit = f64::from(p.speed_limit);
        for (particle, acceleration) in self.particles.iter_mut().zip(accelerations) {
            let old = particle.velocity;
            let mut new = old;
            new.add_sum(acceleration.times(dt));
            let speed = new.value.length();
            if speed > limit {
                new = new.times(limit / speed);
            }
            particle.velocity = new;
            let moved = if p.printed_euler { old } else { new };
            particle.position.add_sum(moved.times(dt));
            self.max_speed = self.max_speed.max(speed.min(limit));
            self.max_acceleration = self.max_acceleration.max(acceleration.value.length());
        }
    }
}

/// Stops a particle at the walls, or brings it round.
fn stop(particle: &mut Plain, walls: Walls, domain: &Domain) {
    let (at, velocity) = (&mut particle.position.value, &mut particle.velocity.value);
    if walls == Walls::Open {
        return;
    }
    if at.y < 0.0 {
        at.y = 0.0;
        velocity.y = velocity.y.max(0.0);
    }
    let half = 0.5 * domain.width;
    if walls == Walls::Periodic {
        *at = domain.wrap(*at);
    } else if at.x < -half {
        at.x = -half;
        velocity.x = velocity.x.max(0.0);
    } else if at.x > half {
        at.x = half;
        velocity.x = velocity.x.min(0.0);
    }
}
