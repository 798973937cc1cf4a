//! Walls: the surfaces of solids, and a floor at y = 0. For a particle near one, the wall is a
//! half space of gas at the pressure of the particle.
//!
//! The kernel is integrated over the half space in advance, so a wall needs no particles
//! (Adami, Hu & Adams 2012 without gravity; Kulasegaram et al. 2004 and Chiron, De Leffe et al.
//! 2019 for the integrals). With the distance d, the normal n, the velocity v relative to the
//! wall, W₁ = −dΓ/dd and K = ∫ |W'|/r over the half space:
//!
//! ```text
//! Y += ρ₀ Γ     ∇C −= W₁ n     a += (2 V p/m) W₁ n − 2 (ν W₁/d + C_s² h |v| K) v
//!                                   − ½ α c₀ h K min(v·n, 0) n
//! dT/dt += 2 (D + C_s² h |v|) K (T_wall − T)     where heat passes the wall
//! ```
//!
//! In the term of ν, the velocity continues linearly into the wall (Morris, Fox & Zhu 1997), so
//! that the gas at the surface has that of the wall.
//!
//! Walls add up. Pairs of particles whose connection crosses a thin solid do not interact.

mod integrals;

use glam::Vec2;

use super::Gas;
use super::pair::Context;
use super::time_step::PART;
use crate::combustion::reaction::chemistry::HEAT_CAPACITY;
use crate::extremes::{fast_max, fast_min};
use crate::grid::Grid;
use crate::kernel::Kernel;
use crate::scene::MAX_SPEED;
use crate::solids::Solids;

/// Smallest distance of a particle from a wall, in spacings.
pub(crate) const MIN_DISTANCE: f32 = 0.15;
/// Smallest distance over which a velocity is continued linearly, in smoothing lengths.
const MIN_LINEAR_DISTANCE: f32 = 0.3;
/// Cosine between the normals before and after a step, below which a particle may have passed through a solid.
const MIN_NORMAL_COSINE: f32 = 0.5;
/// The floor, in place of the index of a solid.
const FLOOR: u32 = u32::MAX;
/// The end of a list.
const NONE: u32 = u32::MAX;
/// Attempts to find a place between walls.
const ATTEMPTS: u32 = 3;

/// A particle near a wall.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near {
    pub index: u32,
    /// The index of the solid, or [`FLOOR`].
    pub solid: u32,
    /// The next entry of the same particle at a thin solid.
    next: u32,
    /// Distance \[m\].
    pub distance: f32,
    pub normal: Vec2,
    /// Γ.
    gamma: f32,
    /// W₁ [1/m].
    pub slope: f32,
    /// K [1/m²].
    pub friction: f32,
    /// Position \[m\].
    pub from: Vec2,
}

/// The particles near walls.
#[derive(Clone, Debug, Default)]
pub(crate) struct Walls {
    near: Vec<Near>,
    /// The first entry of each particle at a thin solid; empty if there is none.
    thin: Vec<u32>,
}

crate::state! { Walls:; near thin }

impl Walls {
    /// Makes room for so many particles near walls.
    pub fn reserve(&mut self, count: usize) {
        super::make_room(&mut self.near, count);
        super::make_room(&mut self.thin, count);
    }

    /// Finds the particles near walls. The order of the gas must not change until they are
    /// used.
    pub fn find(&mut self, gas: &Gas, grid: &Grid, solids: &Solids, floor: bool, kernel: &Kernel) {
        let support = kernel.support();
        self.near.clear();
        self.thin.clear();
        if floor {
            for (index, &position) in gas.position.iter().enumerate() {
                if position.y < support {
                    let at = (position, position.y, Vec2::Y);
                    self.near.push(Near::new(index, FLOOR, at, kernel));
                }
            }
        }
        if !solids.is_empty() {
            self.find_solids(gas, grid, solids, kernel);
        }
    }

    /// Finds the particles near solids.
    fn find_solids(&mut self, gas: &Gas, grid: &Grid, solids: &Solids, kernel: &Kernel) {
        let support = kernel.support();
        for (number, body) in (0..).zip(&solids.bodies) {
            let is_thin = body.is_thin(support);
            let reach = body.surface.frame.extent() + support;
            let (low, high) = (
                body.surface.frame.centre - reach,
                body.surface.frame.centre + reach,
            );
            for row in grid.rows_between(low.y, high.y) {
                for index in grid.particles_between(row, low.x, high.x) {
                    let position = gas.position[index];
                    if !body.may_touch(position, support) {
                        continue;
                    }
                    let (distance, normal) = body.surface.distance(position);
                    if distance < support {
                        let at = (position, distance, normal);
                        let mut near = Near::new(index, number, at, kernel);
                        if is_thin {
                            near.next = self.link(gas.len(), index);
                        }
                        self.near.push(near);
                    }
                }
            }
        }
    }

    /// Makes the next entry the first of a particle at thin solids. Returns the one before.
    fn link(&mut self, particles: usize, index: usize) -> u32 {
        if self.thin.is_empty() {
            self.thin.resize(particles, NONE);
        }
        std::mem::replace(&mut self.thin[index], self.near.len() as u32)
    }

    /// Whether any particle is near a thin solid.
    pub fn any_thin(&self) -> bool {
        !self.thin.is_empty()
    }

    /// The thin solids near a particle, if there are any: normal, distance and index.
    pub fn thin_near(&self, index: usize) -> impl Iterator<Item = (Vec2, f32, u32)> {
        let mut entry = if self.any_thin() {
            self.thin[index]
        } else {
            NONE
        };
        std::iter::from_fn(move || {
            if entry == NONE {
                return None;
            }
            let near = &self.near[entry as usize];
            entry = near.next;
            Some((near.normal, near.distance, near.solid))
        })
    }

    /// The particles near walls.
    pub fn near(&self) -> &[Near] {
        &self.near
    }

    /// Sum of Γ over all particles.
    pub fn gamma(&self) -> f64 {
        self.near.iter().map(|near| f64::from(near.gamma)).sum()
    }

    /// Adds the gas in the walls to the number densities.
    pub fn add_number_density(&self, gas: &mut Gas, air_density: f32) {
        for near in &self.near {
            gas.number_density[near.index as usize] += air_density * near.gamma;
        }
    }

    /// Adds the friction and heat of the walls to the rates of the gas.
    pub fn resist(&self, gas: &mut Gas, solids: &mut Solids, context: &Context) {
        let Context {
            kernel,
            values,
            mass,
            ..
        } = *context;
        let h = kernel.smoothing_length();
        let eddy = values.eddy_viscosity * values.eddy_viscosity * h;
        for near in &self.near {
            let i = near.index as usize;
            let body = solids.bodies.get_mut(near.solid as usize);
            let wall = (body.as_ref()).map_or(Vec2::ZERO, |body| body.velocity_at(near.from));
            let velocity = gas.velocity[i] - wall;
            let mixed = eddy * velocity.length();
            let linear = near.slope / fast_max(near.distance, MIN_LINEAR_DISTANCE * h);
            let friction = values.kinematic_viscosity * linear + mixed * near.friction;
            let slowed = velocity * (2.0 * friction);
            gas.acceleration[i] -= slowed;
            let Some(body) = body else {
                continue;
            };
            if body.is_free {
                body.push(near.from, mass, slowed);
            }
            if let Some(temperature) = body.temperature {
                let exchanged = 2.0 * (values.diffusion + mixed) * near.friction;
                let own = gas.state[i].x;
                gas.change[i].x += exchanged * (temperature - own);
                body.exchange(exchanged * mass * HEAT_CAPACITY, own);
            }
        }
    }

    /// Integrates the kernels where the gas is now, beyond the planes that were nearest at the start of the step.
    pub fn follow(&mut self, gas: &Gas, kernel: &Kernel) {
        for near in &mut self.near {
            let path = gas.position[near.index as usize] - near.from;
            let distance = near.distance + path.dot(near.normal);
            [near.gamma, near.slope, near.friction] = integrals::beyond(distance, kernel);
        }
    }

    /// Adds the pressure of the walls to that of the gas.
    pub fn press(&self, gas: &mut Gas, solids: &mut Solids, context: &Context) {
        let h = context.kernel.smoothing_length();
        let damping = 0.5 * context.artificial_viscosity * context.sound * h;
        for near in &self.near {
            let (i, normal) = (near.index as usize, near.normal);
            let body = solids.bodies.get_mut(near.solid as usize);
            let wall = (body.as_ref()).map_or(Vec2::ZERO, |body| body.velocity_at(near.from));
            let inward = fast_min((gas.velocity[i] - wall).dot(normal), 0.0);
            let pressed = 2.0 * gas.volume[i] / context.mass * gas.pressure[i] * near.slope;
            let pushed = normal * (pressed - damping * near.friction * inward);
            gas.pressing[i] += pushed;
            gas.concentration_gradient[i] -= normal * near.slope;
            if let Some(body) = body
                && body.is_free
            {
                // It acts for a part of the step.
                body.push(near.from, context.mass, pushed * -PART);
            }
        }
    }

    /// Keeps the gas outside of the walls. A particle without a place between them stays where
    /// it was; returns whether there is one. `dt` is the time since the walls were found \[s\].
    pub fn keep_outside(&self, gas: &mut Gas, solids: &mut Solids, spacing: f32, dt: f32) -> bool {
        let gap = MIN_DISTANCE * spacing;
        let moved = if solids.any_moves() {
            MAX_SPEED * dt
        } else {
            0.0
        };
        for _ in 0..ATTEMPTS {
            let mut has_moved = false;
            for near in &self.near {
                let path = gas.position[near.index as usize].distance(near.from) + moved;
                // Sampled distances are uncertain by half.
                if near.distance <= 2.0 * (gap + 2.0 * path) {
                    has_moved |= near.keep_outside(gas, solids, gap, dt);
                }
            }
            if !has_moved {
                return false;
            }
        }
        let mut stays = false;
        for near in &self.near {
            let i = near.index as usize;
            let moved = gas.position[i];
            let body = solids.bodies.get(near.solid as usize);
            if body.map_or(moved.y, |body| body.surface.distance(moved).0) < 0.5 * gap {
                gas.position[i] = near.from;
                stays = true;
            }
        }
        stays
    }
}

impl Near {
    fn new(
        index: usize,
        solid: u32,
        (from, distance, normal): (Vec2, f32, Vec2),
        kernel: &Kernel,
    ) -> Near {
        let [gamma, slope, friction] = integrals::beyond(distance, kernel);
        Near {
            index: index as u32,
            solid,
            next: NONE,
            distance,
            normal,
            gamma,
            slope,
            friction,
            from,
        }
    }

    /// Moves the particle out of the wall, and stops its motion into the wall. Returns whether
    /// it was nearer than the gap.
    #[inline]
    fn keep_outside(&self, gas: &mut Gas, solids: &mut Solids, gap: f32, dt: f32) -> bool {
        let i = self.index as usize;
        let position = gas.position[i];
        let Some(body) = solids.bodies.get_mut(self.solid as usize) else {
            let inside = position.y < gap;
            if inside {
                gas.position[i].y = gap;
                gas.velocity[i].y = fast_max(gas.velocity[i].y, 0.0);
            }
            return inside;
        };
        let (mut distance, mut normal) = body.surface.distance(position);
        // With a tolerance for rounding, so that a particle at the gap is not moved again.
        let mut inside = distance < 0.9 * gap;
        // A step may be longer than a solid is thick: the particle stays on its side.
        if normal.dot(self.normal) < MIN_NORMAL_COSINE && body.is_between(self.from, position) {
            gas.position[i] = self.from;
            (distance, normal, inside) = (gap, self.normal, true);
        }
        if distance <= gap {
            gas.position[i] += normal * (gap - distance);
            let wall = body.velocity_at(position);
            let inward = fast_min((gas.velocity[i] - wall).dot(normal), 0.0);
            gas.velocity[i] -= normal * inward;
            if body.is_free {
                body.push(position, gas.mass / dt, normal * inward);
            }
        }
        inside
    }
}
