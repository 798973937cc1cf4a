//! The burner: a block of gas or a layer of gas around a solid, three spacings high, into which
//! fuel flows.
//!
//! Its input is its power, so it burns alike at every resolution: the fuel of a step is spread
//! over the gas in the block, and what exceeds the capacity of that gas over the gas above it or
//! farther from the solid.
//! Perlin noise modulates the fuel in space and time (the paper's §5.3) and keeps the sum.

use glam::Vec2;

use super::chemistry::{HEAT_CAPACITY, heat_of_combustion};
use crate::combustion::gas::Gas;
use crate::extremes::{fast_max, fast_min};
use crate::noise::perlin;
use crate::params::{Edges, Floor};
use crate::scene::SceneSource;
use crate::solids::Body;
use crate::source;

/// Height of the block, in spacings of the particles.
const HEIGHT_ROWS: f32 = 3.0;
/// Rate at which gas in the block relaxes to the emission velocity [1/s].
const VELOCITY_RELAXATION: f32 = 400.0;
/// Minimum width of the block, in spacings: a burner between two particles would heat
/// neither.
const MIN_WIDTH: f32 = 4.0;
/// A pilot flame: gas in the block is hotter than the ignition temperature by this factor.
const PILOT_FACTOR: f32 = 1.02;
/// Lattice cells of the emission noise across the burner.
const NOISE_CELLS: f32 = 5.0;
/// Lattice cells of the emission noise per second.
const NOISE_PER_SECOND: f64 = 8.0;

/// A particle at a burner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BurnerParticle {
    index: usize,
    /// Its share of the fuel, relative to the other particles.
    share: f32,
}

/// The block of the burner in the combustion model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Burner {
    /// Horizontal position of its middle; 0 is the middle of the domain \[m\].
    pub middle: f32,
    /// Half of its width \[m\].
    pub half_width: f32,
    /// Height of its lower edge \[m\].
    pub bottom: f32,
    /// Height of its upper edge \[m\].
    pub top: f32,
    /// Its edges \[m\]. A particle on an edge is outside, also on the edge of the domain.
    left: f32,
    right: f32,
    /// Direction of its width if it is turned about the middle of its lower edge.
    axis: Option<Vec2>,
    /// Highest top of a layer above the block that takes excess fuel \[m\].
    highest: f32,
}

crate::state! { Burner: middle half_width bottom top left right axis highest }

impl Burner {
    /// The burner of these parameters, clamped to the domain, between the seams of periodic
    /// edges, and to a minimum width.
    pub fn of(source: &SceneSource<'_>) -> Burner {
        Burner::at(source, source.world.spacing())
    }

    /// The burner of these source; `None` without power.
    pub(crate) fn new(source: &SceneSource<'_>, spacing: f32) -> Option<Burner> {
        (source.power > 0.0).then(|| Burner::at(source, spacing))
    }

    fn at(source: &SceneSource<'_>, spacing: f32) -> Burner {
        let height = HEIGHT_ROWS * spacing;
        let seam = match source.world.edges {
            Edges::Periodic => source.world.seam,
            Edges::Open => 0.0,
        };
        let (low, high) = (seam, 1.0 - seam);
        let highest = (high * source.world.domain_height - height).max(0.0);
        let lowest = (low * source.world.domain_height).min(highest);
        let bottom = source.y.max(lowest).min(highest);
        let width = source
            .width
            .max(MIN_WIDTH * spacing)
            .min(source.world.domain_width);
        let (half_width, edge) = (0.5 * width, 0.5 * source.world.domain_width);
        let middle = source::middle(source, width, seam * source.world.domain_width);
        Burner {
            middle,
            half_width,
            left: (middle - half_width).max(-edge),
            right: (middle + half_width).min(edge),
            bottom,
            top: bottom + height,
            axis: source::axis(source),
            highest: high * source.world.domain_height,
        }
    }

    /// Lower left and upper right corner of a rectangle around it \[m\].
    pub(crate) fn around(&self) -> [Vec2; 2] {
        let base = Vec2::new(self.middle, self.bottom);
        let height = self.top - self.bottom;
        let Some(axis) = self.axis else {
            return [
                base - Vec2::new(self.half_width, 0.0),
                base + Vec2::new(self.half_width, height),
            ];
        };
        let side = axis.abs() * self.half_width;
        let up = axis.perp() * height;
        [
            base - side + up.min(Vec2::ZERO),
            base + side + up.max(Vec2::ZERO),
        ]
    }

    /// Direction of its width.
    pub(crate) fn axis(&self) -> Vec2 {
        self.axis.unwrap_or(Vec2::X)
    }

    /// Whether a position is in the block or in one as high below it.
    pub(crate) fn is_beside(&self, position: Vec2) -> bool {
        let at = self.upright(position);
        let height = self.top - self.bottom;
        (at.x - self.middle).abs() < self.half_width && (at.y - self.bottom).abs() < height
    }

    /// The share of a path after which it crosses the lower edge downwards; `None` if it does not.
    pub(crate) fn crossing(&self, from: Vec2, to: Vec2) -> Option<f32> {
        let (from, to) = (self.upright(from), self.upright(to));
        if from.y <= self.bottom || to.y > self.bottom {
            return None;
        }
        let share = (from.y - self.bottom) / (from.y - to.y);
        let x = from.x + (to.x - from.x) * share;
        ((x - self.middle).abs() < self.half_width).then_some(share)
    }

    /// A position as if the burner were not turned.
    fn upright(&self, position: Vec2) -> Vec2 {
        let Some(axis) = self.axis else {
            return position;
        };
        let base = Vec2::new(self.middle, self.bottom);
        let from = position - base;
        base + Vec2::new(axis.dot(from), axis.perp_dot(from))
    }

    /// Adds fuel to the gas in the block or, with a solid, beside the solid for `dt`. Returns the
    /// heat that brought the gas to the temperature of the source [kJ/m], which is not part of the
    /// power.
    pub(crate) fn feed(
        &self,
        gas: &mut Gas,
        source: &SceneSource<'_>,
        (time, dt): (f64, f32),
        solid: &[Body],
        particles: &mut Vec<BurnerParticle>,
    ) -> f32 {
        let height = self.top - self.bottom;
        let top = if solid.is_empty() { self.top } else { 0.0 };
        let mut above = 0.0;
        self.find(gas, source, time, solid, above, particles);
        let heat = self.condition(gas, source, dt, !solid.is_empty(), particles);
        let mut left = source.power / heat_of_combustion(source.world) * dt;
        while left > 0.0 && top + above <= self.highest {
            if above > 0.0 {
                self.find(gas, source, time, solid, above, particles);
            }
            left = add_fuel(gas, particles, left);
            above += height;
        }
        heat
    }

    /// Finds the particles of the layer so far `above` the first one.
    fn find(
        &self,
        gas: &Gas,
        source: &SceneSource<'_>,
        time: f64,
        solid: &[Body],
        above: f32,
        particles: &mut Vec<BurnerParticle>,
    ) {
        particles.clear();
        let mut add = |index: usize, cells: f32| {
            let noise = perlin(source.seed, cells, time * NOISE_PER_SECOND);
            let share = 1.0 + source.noise * noise;
            particles.push(BurnerParticle { index, share });
        };
        let positions = gas.position.iter().copied().enumerate();
        if solid.is_empty() {
            for (index, position) in positions {
                let at = self.upright(position);
                if self.contains(at, above) {
                    let across = (at.x - self.middle) / self.half_width;
                    add(index, across * (0.5 * NOISE_CELLS));
                }
            }
            return;
        }
        let height = self.top - self.bottom;
        for body in solid {
            let frame = &body.surface.frame;
            let half = frame.half + (frame.radius + above + height);
            let cells = 0.5 * NOISE_CELLS / body.reach;
            for (index, position) in positions.clone() {
                let local = frame.local(position);
                if local.abs().cmpgt(half).any() {
                    continue;
                }
                let (distance, _) = body.surface.distance(position);
                if distance > above && distance <= above + height {
                    add(index, cells * source::along(local));
                }
            }
        }
    }

    /// Sets the temperature, oxygen and velocity of the gas at the source. Returns the heat
    /// [kJ/m].
    fn condition(
        &self,
        gas: &mut Gas,
        source: &SceneSource<'_>,
        dt: f32,
        on_solid: bool,
        particles: &[BurnerParticle],
    ) -> f32 {
        // A floor and a solid supply no gas, so a burner on them must not drag the gas along.
        let on_floor = source.world.floor == Floor::Solid && self.bottom < self.top - self.bottom;
        let relaxation = if on_solid || on_floor && source.world.edges == Edges::Open {
            0.0
        } else {
            (VELOCITY_RELAXATION * dt).min(1.0)
        };
        let hot = source
            .temperature
            .max(PILOT_FACTOR * source.world.ignition_temperature);
        let emitted = self.axis.map_or(Vec2::Y, Vec2::perp) * source.speed;
        let mut heated = 0.0;
        for particle in particles {
            let state = &mut gas.state[particle.index];
            heated += fast_max(hot - state.x, 0.0);
            state.x = fast_max(state.x, hot);
            // Air enters the block from below, unlike a real burner. The gas of the source
            // displaces it.
            state.z = fast_min(state.z, source.oxygen);
            let velocity = &mut gas.velocity[particle.index];
            *velocity += (emitted - *velocity) * relaxation;
        }
        heated * gas.mass * HEAT_CAPACITY
    }

    fn contains(&self, at: Vec2, above: f32) -> bool {
        let height = at.y - above;
        at.x > self.left && at.x < self.right && height > self.bottom && height < self.top
    }
}

/// Spreads `fuel` [kg/m] over particles by their shares, and returns the excess over pure fuel.
fn add_fuel(gas: &mut Gas, particles: &[BurnerParticle], fuel: f32) -> f32 {
    let mut shares = 0.0;
    for particle in particles {
        shares += particle.share;
    }
    if shares <= 0.0 {
        return fuel;
    }
    let each = fuel / (gas.mass * shares);
    let mut left = 0.0;
    for particle in particles {
        let state = &mut gas.state[particle.index];
        let fuelled = state.y + each * particle.share;
        state.y = fuelled.min(1.0);
        left += (fuelled - 1.0).max(0.0) * gas.mass;
    }
    left
}

#[cfg(test)]
mod tests;
