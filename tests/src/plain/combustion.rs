//! The combustion model, equation by equation.

mod boundary;

use glam::DVec2;
use hearth_core::scene::SceneSource;
use hearth_core::{Parameters, Particle, Scene};

use super::{Crowd, Domain, Kernel, Mixture, Neighbour, Plain, Sum};
use crate::fires::source;

/// Prandtl and Schmidt number of the eddies.
const PRANDTL: f64 = 0.7;
/// Heat capacity of the gas [kJ/(kg·K)].
const HEAT_CAPACITY: f64 = 1.0;
/// Steps from one search for rolls to the next.
const ROLL_STEPS: u32 = 4;
/// Parts of a step. Each has its own pressure; the pairs are those of the start of the step.
pub const PARTS: u32 = 2;
/// Distance up to which particles are pairs, in smoothing lengths.
const REACH: f32 = 2.05;
/// Longest step \[s\].
const LONGEST: f64 = 1.0 / 60.0;
/// What drives the strongest fire for which the parameter is the speed of sound.
const USUAL_DRIVE: f64 = 9.81 * 220.0;

/// The gas of the combustion model.
#[derive(Clone, Debug)]
pub struct Combustion {
    /// The particles, in the order in which they were put in.
    pub particles: Vec<Plain>,
    /// The neighbours that each particle had.
    pub crowd: Crowd,
    /// Viscosity of the roll around each particle [m²/s], found in each fourth step.
    rolls: Vec<Sum<f64>>,
    steps: u32,
    /// Length of the last step \[s\].
    pub length: f64,
    /// Power of the burning [kW/m].
    pub power: Sum<f64>,
    /// What made the gas of the source as hot as it is [kW/m].
    pub preheat: Sum<f64>,
}

/// The figures of a fire that all particles share.
struct Common<'a> {
    p: &'a Parameters,
    source: SceneSource<'a>,
    kernel: Kernel,
    domain: Domain,
    spacing: f64,
    /// Mass of a particle [kg/m].
    mass: f64,
    /// Speed of sound [m/s].
    sound: f64,
}

/// What the others do to a particle.
#[derive(Clone, Copy, Debug, Default)]
struct Rates {
    acceleration: Sum<DVec2>,
    /// Change of the mixture [1/s].
    change: Mixture,
    /// ΣV∇W [1/m].
    concentration_gradient: Sum<DVec2>,
}

impl Combustion {
    /// Gas of these particles.
    pub fn new(particles: &[Particle]) -> Combustion {
        Combustion {
            particles: particles.iter().map(Plain::new).collect(),
            crowd: Crowd::new(),
            rolls: Vec::new(),
            steps: 0,
            length: 0.0,
            power: Sum::default(),
            preheat: Sum::default(),
        }
    }

    /// Puts the particles where others are; their rolls stay.
    pub fn take_over(&mut self, particles: &[Particle]) {
        self.particles = particles.iter().map(Plain::new).collect();
    }

    /// Burns on by one step.
    pub fn step(&mut self, scene: &Scene) {
        let scene = &self.at_limit(scene);
        let common = Common::new(scene, self.particles.len());
        let (reach, support) = (f64::from(REACH) * common.kernel.h, common.kernel.support());
        let mut near = common.domain.neighbours(&self.particles, reach);
        self.crowd = Domain::crowd(&near, support);
        self.keep_pairs(&mut near, &common);
        let mean = self.fill(&common, &near, None);
        if self.steps.is_multiple_of(ROLL_STEPS) {
            self.rolls = (0..near.len())
                .map(|i| self.roll(i, &common, &near[i]))
                .collect();
        }
        self.steps += 1;
        let mut rates: Vec<Rates> = near
            .iter()
            .enumerate()
            .map(|(i, near)| self.exchanged(i, &common, near))
            .collect();
        self.confine(&common, &near, &mut rates);
        self.add_body_forces(common.p, &mut rates);
        let start: Vec<DVec2> = self.particles.iter().map(|q| q.position.value).collect();
        let mut pressed = self.pressed(&common, &near, &rates);
        let dt = self.max_stable_part(&common, &pressed);
        (self.power, self.preheat) = Default::default();
        let share = 1.0 / (f64::from(PARTS) * dt);
        for part in 0..PARTS {
            if part > 0 {
                let moved = |i: usize| self.particles[i].position.value - start[i];
                let near = near.iter().enumerate().map(|(i, near)| {
                    let follow = |&Neighbour { j, offset }| Neighbour {
                        j,
                        offset: offset + moved(i) - moved(j),
                    };
                    near.iter().map(follow).collect()
                });
                let near: Vec<Vec<Neighbour>> = near.collect();
                self.fill(&common, &near, Some(mean));
                pressed = self.pressed(&common, &near, &rates);
            }
            let max_speed = self.accelerate(&common, &pressed, dt);
            let burnt = self.react(&common, &pressed, dt).times(share);
            self.power.add_sum(burnt);
            let heated = self.feed(&common, dt).times(share);
            self.preheat.add_sum(heated);
            self.relax_to_air(&common, dt);
            self.advance(&common, &pressed, max_speed, dt);
        }
        for particle in &mut self.particles {
            particle.position.value = common.domain.wrap(particle.position.value);
        }
        self.length = f64::from(PARTS) * dt;
    }

    /// Removes what is beyond reach: a pair of the start of the step counts wherever its particles move, and any other
    /// does not. Single precision decides, as in the fast solver.
    fn keep_pairs(&self, near: &mut [Vec<Neighbour>], common: &Common) {
        let inverse_h = 1.0 / common.kernel.h as f32;
        for (here, near) in self.particles.iter().zip(near) {
            near.retain(|&Neighbour { j, offset }| {
                let [here, there] = [here, &self.particles[j]].map(|q| q.position.value);
                let shift = (here - there - offset).as_vec2() * inverse_h;
                let [here, there] = [here, there].map(|at| at.as_vec2() * inverse_h);
                (here - shift - there).length_squared() < REACH * REACH
            });
        }
    }

    /// Y = Σ m θ W, V = m θ/Y, p = c₀² (Y − Ȳ). Returns Ȳ, that of the start of the step.
    fn fill(&mut self, common: &Common, near: &[Vec<Neighbour>], mean: Option<f64>) -> f64 {
        let share = |particle: &Plain| common.mass * common.expansion(particle.temperature());
        let shares: Vec<f64> = self.particles.iter().map(share).collect();
        let kernel = &common.kernel;
        let number_densities: Vec<f64> = near
            .iter()
            .zip(&shares)
            .map(|(near, own)| {
                let others = near
                    .iter()
                    .map(|other| shares[other.j] * kernel.value(other.offset.length()));
                own * kernel.value(0.0) + others.sum::<f64>()
            })
            .collect();
        let own = number_densities.iter().sum::<f64>() / number_densities.len() as f64;
        let mean = mean.unwrap_or(own);
        let square = common.sound * common.sound;
        for ((particle, number_density), share) in
            self.particles.iter_mut().zip(number_densities).zip(shares)
        {
            particle.density = Sum::new(common.mass * number_density / share);
            particle.pressure = Sum {
                value: square * (number_density - mean),
                size: square * (number_density + mean),
            };
        }
        mean
    }

    /// The viscosities of the gas and of its eddies, and diffusion.
    fn exchanged(&self, i: usize, common: &Common, near: &[Neighbour]) -> Rates {
        let (p, mass, h) = (common.p, common.mass, common.kernel.h);
        let here = &self.particles[i];
        let mut rates = Rates::default();
        for &Neighbour { j, offset } in near {
            let there = &self.particles[j];
            let (v_i, v_j) = (mass / here.density.value, mass / there.density.value);
            let apart = here.velocity.value - there.velocity.value;
            let mean_density = 2.0 * mass / (v_i + v_j);
            let mut eddies = Sum::new(f64::from(p.eddy_viscosity).powi(2) * h * apart.length());
            eddies.add_sum(self.rolls[i].times(0.5));
            eddies.add_sum(self.rolls[j].times(0.5));

            // m a = 2 Vᵢ Vⱼ ρ̄ (ν + ν_t) vᵢⱼ (r·∇W)/(r² + 0.01 h²)
            let spread = 2.0 * v_i * v_j * mean_density * common.kernel.brookshaw(offset) / mass;
            let viscosity = f64::from(p.kinematic_viscosity);
            rates.acceleration.add_sum(Sum {
                value: apart * (spread * (viscosity + eddies.value)),
                size: (apart * (spread * (viscosity + eddies.size))).length(),
            });
            // m φ̇ = 2 Vᵢ Vⱼ ρ̄ (D₀ + ν_t/Pr) φᵢⱼ (r·∇W)/(r² + 0.01 h²)
            let mut diffusivity = Sum::new(f64::from(p.diffusion));
            diffusivity.add_sum(eddies.times(1.0 / PRANDTL));
            for (k, change) in rates.change.iter_mut().enumerate() {
                let difference = here.mixture[k].value - there.mixture[k].value;
                let mixed = diffusivity.times(spread * difference);
                change.add_sum(mixed);
            }
        }
        rates
    }

    /// All rates: pressure, artificial viscosity and concentration gradient besides those of the start of the step.
    fn pressed(&self, common: &Common, near: &[Vec<Neighbour>], steady: &[Rates]) -> Vec<Rates> {
        let (p, mass, h) = (common.p, common.mass, common.kernel.h);
        let mut all = steady.to_vec();
        for ((here, near), rates) in self.particles.iter().zip(near).zip(&mut all) {
            for &Neighbour { j, offset } in near {
                let there = &self.particles[j];
                let (v_i, v_j) = (mass / here.density.value, mass / there.density.value);
                let gradient = common.kernel.gradient(offset);
                let apart = here.velocity.value - there.velocity.value;
                let mean_density = 2.0 * mass / (v_i + v_j);

                // m a = − Vᵢ Vⱼ (pᵢ + pⱼ) ∇W
                let mut pressures = here.pressure;
                pressures.add_sum(there.pressure);
                rates.acceleration.add_sum(Sum {
                    value: gradient * (-v_i * v_j * pressures.value / mass),
                    size: gradient.length() * v_i * v_j * pressures.size / mass,
                });
                // m a = Vᵢ Vⱼ ρ̄ α c₀ μ ∇W, μ = h vᵢⱼ·r/(r² + 0.01 h²), where they approach
                let approach = apart.dot(offset).min(0.0);
                let mu = h * approach / (offset.length_squared() + 0.01 * h * h);
                let alpha = f64::from(p.artificial_viscosity);
                let damped = v_i * v_j * mean_density * alpha * common.sound * mu / mass;
                rates.acceleration.add(gradient * damped);
                rates.concentration_gradient.add(gradient * v_j);
            }
        }
        all
    }

    /// max(l² (|ω| − ½ √(b g/D*)) (ω² − s²)/(ω² + s²) − ν, 0), l² = (C D*)² − (2.5 C_s h)².
    fn roll(&self, i: usize, common: &Common, near: &[Neighbour]) -> Sum<f64> {
        let (p, h) = (common.p, common.kernel.h);
        let lift = (f64::from(p.buoyancy) * f64::from(p.gravity)).max(0.1);
        let heat = f64::from(p.ambient_density) * HEAT_CAPACITY * f64::from(p.ambient_temperature);
        let length = (f64::from(common.source.power) / heat).powi(2) / lift;
        let length = length.cbrt();
        let own = 2.5 * f64::from(p.eddy_viscosity) * h;
        let square = (f64::from(p.roll_mixing) * length).powi(2) - own * own;
        if square <= 0.0 {
            return Sum::default();
        }
        // ∂ₓ and ∂ᵧ of the velocity.
        let (mut x, mut y, mut size) = (DVec2::ZERO, DVec2::ZERO, 0.0);
        for other in near {
            let gradient = common.kernel.gradient(other.offset);
            let volume = common.mass / self.particles[other.j].density.value;
            let apart = self.particles[other.j].velocity.value - self.particles[i].velocity.value;
            x += apart * (gradient.x * volume);
            y += apart * (gradient.y * volume);
            size += apart.length() * gradient.length() * volume;
        }
        let turn = x.y - y.x;
        let strain = (x.x - y.y).hypot(x.y + y.x);
        if turn.abs() <= strain {
            return Sum {
                value: 0.0,
                size: square * size,
            };
        }
        let rate = turn.abs() - 0.5 * (lift / length).sqrt();
        let share = (turn * turn - strain * strain) / (turn * turn + strain * strain);
        let viscosity = square * rate * share - f64::from(p.kinematic_viscosity);
        Sum {
            value: viscosity.clamp(0.0, 0.085 * h * common.sound),
            size: square * size,
        }
    }

    /// a = ε h (∇|ω|/|∇|ω|| × ω).
    fn confine(&self, common: &Common, near: &[Vec<Neighbour>], rates: &mut [Rates]) {
        let strength = f64::from(common.p.vorticity_confinement) * common.kernel.h;
        if strength == 0.0 {
            return;
        }
        let volume = |j: usize| common.mass / self.particles[j].density.value;
        let velocity = |j: usize| self.particles[j].velocity.value;
        // Of what neighbours differ by from i, summed: Σ V ∇W (φⱼ − φᵢ).
        let curls: Vec<f64> = near
            .iter()
            .enumerate()
            .map(|(i, near)| {
                let turn = |other: &Neighbour| {
                    let gradient = common.kernel.gradient(other.offset);
                    volume(other.j) * gradient.perp_dot(velocity(other.j) - velocity(i))
                };
                near.iter().map(turn).sum()
            })
            .collect();
        for (i, rates) in rates.iter_mut().enumerate() {
            let more = |other: &Neighbour| {
                let gradient = common.kernel.gradient(other.offset);
                gradient * (volume(other.j) * (curls[other.j].abs() - curls[i].abs()))
            };
            let towards = near[i].iter().map(more).sum::<DVec2>().normalize_or_zero();
            // (t, 0) × (0, 0, ω)
            let confinement = DVec2::new(towards.y, -towards.x) * curls[i];
            rates.acceleration.add(confinement * strength);
        }
    }

    /// Buoyancy, b g (1 − Tₐ/T) θ, and the push of the wind, where there is a seam.
    fn add_body_forces(&self, p: &Parameters, rates: &mut [Rates]) {
        if p.seam == 0.0 {
            return;
        }
        let mean: f64 = self
            .particles
            .iter()
            .map(|q| q.velocity.value.x)
            .sum::<f64>()
            / self.particles.len() as f64;
        let wind = (f64::from(p.wind) - mean) / 0.3;
        let strength = f64::from(p.buoyancy) * f64::from(p.gravity);
        for (particle, rates) in self.particles.iter().zip(rates) {
            let temperature = particle.temperature();
            let room = expansion(p, temperature);
            rates.acceleration.add(DVec2::new(wind, strength * room));
            let weight = -strength * room * f64::from(p.ambient_temperature) / temperature;
            rates.acceleration.add(DVec2::new(0.0, weight));
        }
    }

    /// The values with an artificial viscosity of at least 0.2 while more than a hundredth of the gas is at
    /// the speed limit.
    fn at_limit(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        let sound = Common::new(&scene, self.particles.len()).sound;
        let speeds = self.particles.iter().map(|q| q.velocity.value.length());
        let fast = speeds.filter(|&speed| speed > 0.99 * 1.5 * sound).count();
        if fast * 100 > self.particles.len() {
            let more = f64::from(scene.world().artificial_viscosity).max(0.2);
            assert_eq!(scene.set("artificial_viscosity", more), Ok(()));
        }
        scene
    }

    /// The longest part of a step that all three limits allow.
    fn max_stable_part(&self, common: &Common, rates: &[Rates]) -> f64 {
        let (p, h, sound) = (common.p, common.kernel.h, common.sound);
        let speeds = self.particles.iter().map(|q| q.velocity.value.length());
        let speed = speeds.fold(0.0, f64::max);
        let accelerations = rates.iter().map(|rates| rates.acceleration.value.length());
        let hardest = accelerations.fold(0.0, f64::max);
        let viscosity =
            f64::from(p.kinematic_viscosity) + f64::from(p.artificial_viscosity) * h * sound / 8.0;
        let eddies = f64::from(p.eddy_viscosity).powi(2) * h * speed;
        let diffusivity = viscosity.max(p.diffusion.into()) + eddies;
        let rooms = self.particles.iter().map(|q| expansion(p, q.temperature()));
        let fastest_sound = sound * rooms.fold(1.65, f64::max).sqrt();
        (0.9 * h / (fastest_sound + speed))
            .min(0.25 * (h / hardest.max(1e-6)).sqrt())
            .min(0.125 * h * h / (f64::from(PARTS) * diffusivity).max(1e-9))
            .min(LONGEST / f64::from(PARTS))
    }

    /// New velocities, within 1.5 c₀. Returns the largest.
    fn accelerate(&mut self, common: &Common, rates: &[Rates], dt: f64) -> f64 {
        let limit = 1.5 * common.sound;
        let mut max_speed: f64 = 0.0;
        for (particle, rates) in self.particles.iter_mut().zip(rates) {
            let velocity = &mut particle.velocity;
            velocity.add_sum(rates.acceleration.times(dt));
            let speed = velocity.value.length();
            if speed > limit {
                *velocity = velocity.times(limit / speed);
            }
            max_speed = max_speed.max(speed.min(limit));
        }
        max_speed
    }

    /// Diffusion, burning, radiation, soot. Returns the heat of the burning [kJ/m].
    fn react(&mut self, common: &Common, rates: &[Rates], dt: f64) -> Sum<f64> {
        let p = common.p;
        let demand = f64::from(p.air_demand);
        let rise = f64::from(p.flame_rise) * (1.0 + demand);
        let (air, ignition) = (
            f64::from(p.ambient_temperature),
            f64::from(p.ignition_temperature),
        );
        let hottest = f64::from(common.source.temperature).max(ignition) + f64::from(p.flame_rise);
        let mut share = Sum::new(1.0);
        share.add(-(-dt / f64::from(p.burn_time)).exp());
        let left = |life: f32| 1.0 / (1.0 + dt / f64::from(life));
        let mut burnt = Sum::default();
        for (particle, rates) in self.particles.iter_mut().zip(rates) {
            for (amount, change) in particle.mixture.iter_mut().zip(rates.change) {
                amount.add_sum(change.times(dt));
            }
            let [t, fuel, oxygen, soot] = &mut particle.mixture;
            fuel.value = fuel.value.clamp(0.0, 1.0);
            oxygen.value = oxygen.value.clamp(0.0, 1.0);
            soot.value = soot.value.max(0.0);
            let mut burn = Sum::default();
            if t.value > ignition {
                let lacking = ((hottest - t.value) / rise).clamp(0.0, 1.0);
                let most = fuel.value.min(oxygen.value / demand).min(lacking);
                burn = share.times(most);
                burn.size += (fuel.size + oxygen.size / demand + t.size / rise) * share.value;
            }
            burnt.add_sum(burn);
            particle.burn = burn.times(1.0 / dt);

            let fourth = |t: f64| (t / 1500.0).powi(4);
            let lost = dt * f64::from(p.radiative_cooling) * (fourth(t.value) - fourth(air));
            // No farther than to the air; colder gas is warmed.
            t.value = (t.value - lost).max(air.min(t.value));
            t.size += 4.0 * lost.abs();
            t.add_sum(burn.times(rise));
            fuel.add_sum(burn.times(-1.0));
            oxygen.add_sum(burn.times(-demand));
            soot.add_sum(burn.times(1.0 + demand));
            let glowing = ((t.value - 850.0) / 300.0).clamp(0.0, 1.0);
            let (smoke, flame) = (left(p.smoke_life), left(p.soot_life));
            *soot = soot.times(smoke + glowing * (flame - smoke));
            soot.size += t.size / 300.0 * (smoke - flame).abs() * soot.value;
        }
        burnt.times(common.mass * HEAT_CAPACITY * rise)
    }

    /// Motion, and the shift −min(8 h u dt, 0.55 h²) ∇C, at most 0.55 h.
    fn advance(&mut self, common: &Common, rates: &[Rates], max_speed: f64, dt: f64) {
        let h = common.kernel.h;
        let strength = 8.0 * f64::from(common.p.shifting) * h * max_speed * dt;
        let shift = strength.min(0.55 * h * h);
        for (particle, rates) in self.particles.iter_mut().zip(rates) {
            let mut displacement = rates.concentration_gradient.times(-shift);
            let far = displacement.value.length();
            if far > 0.55 * h {
                displacement = displacement.times(0.55 * h / far);
            }
            let position = &mut particle.position;
            position.add_sum(particle.velocity.times(dt));
            position.add_sum(displacement);
        }
    }
}

/// θ = (T/Tₐ)^ε.
fn expansion(p: &Parameters, temperature: f64) -> f64 {
    (temperature / f64::from(p.ambient_temperature)).powf(p.gas_expansion.into())
}

impl Common<'_> {
    fn new(scene: &Scene, count: usize) -> Common<'_> {
        let (p, source) = (scene.world(), source(scene));
        let (width, height) = (f64::from(p.domain_width), f64::from(p.domain_height));
        let spacing = (width * height / f64::from(p.particles)).sqrt();
        let drive = f64::from(p.buoyancy) * f64::from(p.gravity) * f64::from(source.power);
        let risen = f64::from(p.stiffness) * (drive / USUAL_DRIVE).max(1.0).cbrt();
        Common {
            p,
            source,
            kernel: Kernel::new(f64::from(p.smoothing_ratio) * spacing),
            domain: Domain {
                width,
                height,
                across: true,
                up: true,
            },
            spacing,
            mass: f64::from(p.ambient_density) * width * height / count as f64,
            sound: risen.max(3.0 * f64::from(p.wind).abs()),
        }
    }

    fn expansion(&self, temperature: f64) -> f64 {
        expansion(self.p, temperature)
    }
}
