//! Births and deaths of air at the rim, and the velocity with which it crosses the rim.
//!
//! Gas that leaves the cells with air is removed. Air enters the ring wherever there is room:
//! at the place that is farthest from all particles. A cell that gas reaches for the first time
//! gets a lattice of air. Air that enters is at rest, or as fast as the wind, so suction alone
//! accelerates it and its total pressure is that of the far air.

use glam::Vec2;

use super::super::gas::Gas;
use super::map::{AROUND, Layout, Map};
use crate::Particle;
use crate::extremes::fast_min;
use crate::params::Physics;

/// Smallest distance of a birth from all particles, in spacings.
const ROOM: f32 = 0.85;
/// Places of a cell along each axis, of which a birth takes the freest.
const PLACES: u32 = 5;
/// Most births of a cell at once.
const MOST: u32 = 3;
/// Most particles of a cell with births, relative to those of a cell of air.
const FULL: f32 = 1.11;
/// A fresh cell with fewer particles than this share of a cell of air gets a lattice.
const EMPTY: f32 = 0.34;
/// Rate at which the velocity at the rim follows the gas inside [1/s].
const FOLLOW: f32 = 30.0;

/// No particle, at the end of a list.
const NONE: u32 = u32::MAX;

/// The particles of each cell, and the flow at the rim.
#[derive(Clone, Debug, Default)]
pub(super) struct Exchange {
    /// The first particle of each cell, and the next one of each particle.
    first: Vec<u32>,
    next: Vec<u32>,
    /// Number of particles of each cell.
    pub counts: Vec<u32>,
    /// Sum of their velocities [m/s].
    momentum: Vec<Vec2>,
    /// Velocity with which gas crosses the rim [m/s], in the cells of the rim.
    pub flow: Vec<Vec2>,
    /// The particles around one cell.
    nearby: Vec<Vec2>,
}

/// The air that enters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inflow {
    pub temperature: f32,
    pub wind: Vec2,
    /// Distance of particles of air \[m\].
    pub spacing: f32,
    /// Most particles of the gas.
    pub capacity: usize,
}

impl Inflow {
    pub fn new(values: &Physics, spacing: f32, capacity: usize) -> Inflow {
        Inflow {
            temperature: values.ambient_temperature,
            wind: Vec2::new(values.wind, 0.0),
            spacing,
            capacity,
        }
    }

    /// Number of particles of a cell of air.
    pub fn per_cell(&self, layout: &Layout) -> f32 {
        let columns = layout.cell / self.spacing;
        columns * columns
    }

    /// Adds a particle at a position. There must be room for it.
    fn bear(&self, gas: &mut Gas, position: Vec2, velocity: Vec2) {
        let volume = self.spacing * self.spacing;
        let air = Particle {
            temperature: self.temperature,
            velocity,
            ..Particle::at(position)
        };
        gas.bear(&air, volume);
    }
}

impl Exchange {
    pub fn new(layout: &Layout, capacity: usize) -> Exchange {
        let n = layout.len();
        Exchange {
            first: vec![NONE; n],
            next: Vec::with_capacity(capacity),
            counts: vec![0; n],
            momentum: vec![Vec2::ZERO; n],
            flow: vec![Vec2::ZERO; n],
            nearby: Vec::with_capacity(capacity),
        }
    }

    /// Continues the flow of another layout with the same size of cells.
    pub fn continue_from(&mut self, old: &Exchange, (from, to): (&Layout, &Layout)) {
        for (cell, same) in to.common(from) {
            self.flow[cell] = old.flow[same];
            self.counts[cell] = old.counts[same];
        }
    }

    /// Removes the gas outside, and lists the rest by cells.
    pub fn remove(&mut self, map: &Map, gas: &mut Gas) {
        self.first.fill(NONE);
        self.next.clear();
        self.counts.fill(0);
        self.momentum.fill(Vec2::ZERO);
        gas.retain(|position, velocity| {
            let stays = map.holds(position);
            if stays {
                self.list(map.layout.at(position), velocity);
            }
            stays
        });
    }

    /// Adds the next particle to the list of its cell.
    fn list(&mut self, cell: usize, velocity: Vec2) {
        let index = self.next.len() as u32;
        self.next.push(self.first[cell]);
        self.first[cell] = index;
        self.counts[cell] += 1;
        self.momentum[cell] += velocity;
    }

    /// Finds the velocity at the rim after a time `dt`: that of the gas inside where it leaves,
    /// that of the far air where it enters.
    pub fn follow(&mut self, map: &Map, wind: Vec2, dt: f32) {
        let share = fast_min(dt * FOLLOW, 1.0);
        for &cell in &map.rim {
            let cell = cell as usize;
            let (mut momentum, mut count) = (Vec2::ZERO, 0);
            for offset in AROUND {
                let other = map.layout.beside(cell, offset);
                if map.depth[other] > map.depth[cell] {
                    momentum += self.momentum[other];
                    count += self.counts[other];
                }
            }
            if count == 0 {
                (momentum, count) = (self.momentum[cell], self.counts[cell]);
            }
            let inside = if count == 0 {
                wind
            } else {
                momentum / count as f32
            };
            let enters = inside.dot(map.outward[cell]) < 0.0;
            let velocity = if enters { wind } else { inside };
            let flow = &mut self.flow[cell];
            *flow = if map.fresh[cell] {
                velocity
            } else {
                *flow + (velocity - *flow) * share
            };
        }
    }

    /// Fills the fresh cells and the ring with air.
    pub fn fill(&mut self, map: &Map, gas: &mut Gas, inflow: &Inflow) {
        let per_cell = inflow.per_cell(&map.layout);
        let full = (FULL * per_cell) as u32;
        for &cell in &map.live {
            let cell = cell as usize;
            if !map.fresh[cell] && map.depth[cell] > 1 {
                continue;
            }
            let lattice = map.fresh[cell] && (self.counts[cell] as f32) < EMPTY * per_cell;
            if !lattice && self.counts[cell] >= full {
                continue;
            }
            let velocity = if map.depth[cell] <= super::map::RIM {
                self.flow[cell]
            } else {
                inflow.wind
            };
            self.gather(map, gas, cell, ROOM * inflow.spacing);
            if lattice {
                self.add_lattice(map, gas, inflow, cell, velocity);
            } else {
                self.add_to_gaps(map, gas, inflow, cell, velocity, full);
            }
        }
    }

    /// Collects the particles of a cell and those less than `reach` outside of it.
    fn gather(&mut self, map: &Map, gas: &Gas, cell: usize, reach: f32) {
        self.nearby.clear();
        let low = map.layout.corner(cell) - Vec2::splat(reach);
        let high = low + Vec2::splat(map.layout.cell + 2.0 * reach);
        for offset in AROUND.into_iter().chain([(0, 0)]) {
            let mut particle = self.first[map.layout.beside(cell, offset)];
            while let Some(&position) = gas.position.get(particle as usize) {
                if position.cmpge(low).all() && position.cmple(high).all() {
                    self.nearby.push(position);
                }
                particle = self.next[particle as usize];
            }
        }
    }

    /// The square of the distance of a place to the nearest particle.
    fn room(&self, place: Vec2) -> f32 {
        let squares = self.nearby.iter().map(|at| at.distance_squared(place));
        squares.fold(f32::MAX, fast_min)
    }

    fn add(&mut self, gas: &mut Gas, inflow: &Inflow, cell: usize, place: Vec2, velocity: Vec2) {
        inflow.bear(gas, place, velocity);
        self.nearby.push(place);
        self.list(cell, velocity);
    }

    /// Adds air on the lattice of the whole map, except near present particles.
    fn add_lattice(
        &mut self,
        map: &Map,
        gas: &mut Gas,
        inflow: &Inflow,
        cell: usize,
        velocity: Vec2,
    ) {
        let Layout {
            cell: side,
            columns,
            left,
            bottom,
            ..
        } = map.layout;
        let spacing = inflow.spacing;
        // The same expression in every cell, so that no point is in two cells or in none.
        let points = |index: usize| {
            let point = |at: usize| (at as f32 * side / spacing + 0.5) as usize;
            point(index)..point(index + 1)
        };
        let close = ROOM * spacing * (ROOM * spacing);
        for y in points(cell / columns) {
            for x in points(cell % columns) {
                let offset = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) * spacing;
                let place = Vec2::new(left, bottom) + offset;
                if gas.len() < inflow.capacity && self.room(place) > close {
                    self.add(gas, inflow, cell, place, velocity);
                }
            }
        }
    }

    /// Adds air at the freest places of a cell.
    fn add_to_gaps(
        &mut self,
        map: &Map,
        gas: &mut Gas,
        inflow: &Inflow,
        cell: usize,
        velocity: Vec2,
        full: u32,
    ) {
        let corner = map.layout.corner(cell);
        let step = map.layout.cell / PLACES as f32;
        for _ in 0..MOST {
            if self.counts[cell] >= full || gas.len() >= inflow.capacity {
                return;
            }
            let (mut freest, mut room) = (None, ROOM * inflow.spacing * (ROOM * inflow.spacing));
            for index in 0..PLACES * PLACES {
                let (x, y) = ((index % PLACES) as f32, (index / PLACES) as f32);
                let place = corner + Vec2::new(x + 0.5, y + 0.5) * step;
                let here = self.room(place);
                if here > room {
                    (freest, room) = (Some(place), here);
                }
            }
            let Some(place) = freest else {
                return;
            };
            self.add(gas, inflow, cell, place, velocity);
        }
    }
}
