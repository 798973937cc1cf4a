//! Births and deaths of air at the rim, and the velocity with which it crosses the rim.
//!
//! Gas that leaves the cells with air is removed. Air enters the ring wherever there is room:
//! at the place that is farthest from all particles. Wind brings a lattice of air through the
//! ring, because births in gaps alone leave it too thin to keep its speed. A cell that gas
//! reaches for the first time gets a lattice of air. Air that enters is at rest, or as fast as
//! the wind, so suction alone accelerates it and its total pressure is that of the far air.

use glam::Vec2;

use super::super::gas::Gas;
use super::map::{Cell, Layout, Map, NONE, RIM_DEPTH};
use crate::Particle;
use crate::extremes::fast_min;
use crate::lanes::{LANES, Lanes, Real};
use crate::params::Physics;
use crate::solids::Solids;

/// Smallest distance of a birth from all particles, in spacings.
const MIN_BIRTH_DISTANCE: f32 = 0.85;
/// Places of a cell along each axis, of which a birth takes the freest.
const PLACES_PER_AXIS: u32 = 5;
const PLACES: usize = (PLACES_PER_AXIS * PLACES_PER_AXIS) as usize;
/// Most births of a cell at once.
const MAX_BIRTHS: u32 = 3;
/// Most particles of a cell with births, relative to those of a cell of air.
const MAX_FILLING: f32 = 1.11;
/// A fresh cell with fewer particles than this share of a cell of air gets a lattice.
const LATTICE_FILLING: f32 = 0.34;
/// Smallest distance of a particle that the wind brings from all others, in spacings, and how
/// far inside of the ring it enters.
const MIN_LATTICE_DISTANCE: f32 = 0.5;
const ENTRY_DEPTH: f32 = 0.1;
/// Smallest distance of a birth from solids, in spacings.
const FROM_SOLIDS: f32 = 0.5;
/// Longest time for which the wind brings air at once \[s\]: the first exchange has no last one.
const MAX_INFLOW_TIME: f32 = 0.1;
/// Rate at which the velocity at the rim follows the gas inside [1/s].
const FOLLOW_RATE: f32 = 30.0;

/// Finds the velocity at the rim after a time `dt`: that of the gas inside where it leaves, that
/// of the far air where it enters.
pub(super) fn follow(map: &mut Map, wind: Vec2, dt: f32) {
    let share = fast_min(dt * FOLLOW_RATE, 1.0);
    for at in map.layout.inner() {
        let depth = map.depth[at];
        if depth == 0.0 || depth > RIM_DEPTH {
            continue;
        }
        let (mut momentum, mut count) = (Vec2::ZERO, 0);
        map.layout.around(at, &mut |other| {
            if map.depth[other] > depth {
                momentum += map.cells[other].momentum;
                count += map.cells[other].count;
            }
        });
        let cell = &mut map.cells[at];
        if count == 0 {
            (momentum, count) = (cell.momentum, cell.count);
        }
        let inside = if count == 0 {
            wind
        } else {
            momentum / count as f32
        };
        let enters = inside.dot(cell.outward) < 0.0;
        let velocity = if enters { wind } else { inside };
        let share = if cell.fresh { 1.0 } else { share };
        cell.flow += (velocity - cell.flow) * share;
    }
}

/// The lists of the particles of each cell.
#[derive(Clone, Debug, Default)]
pub(super) struct Exchange {
    /// The next particle of the cell of each particle.
    next: Vec<u32>,
    /// The particles around one cell.
    nearby: Vec<Vec2>,
    /// How far the wind has blown since its last column of particles, in spacings.
    blown: f32,
}

crate::state! { Exchange: blown; next nearby }

/// The air that enters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inflow<'a> {
    pub temperature: f32,
    pub wind: Vec2,
    /// Distance of particles of air \[m\].
    pub spacing: f32,
    /// Most particles of the gas.
    pub capacity: usize,
    pub solids: &'a Solids,
}

/// Number of particles of a cell of air.
pub(super) fn per_cell(layout: &Layout, spacing: f32) -> f32 {
    let columns = layout.cell / spacing;
    columns * columns
}

impl<'a> Inflow<'a> {
    pub fn new(values: &Physics, spacing: f32, capacity: usize, solids: &'a Solids) -> Inflow<'a> {
        Inflow {
            solids,
            temperature: values.ambient_temperature,
            wind: Vec2::new(values.wind, 0.0),
            spacing,
            capacity,
        }
    }

    /// Whether a place is outside of all solids.
    fn is_free(&self, place: Vec2) -> bool {
        !self.solids.touch(place, FROM_SOLIDS * self.spacing)
    }

    /// Adds a particle at a position. There must be room for it.
    fn insert_particle(&self, gas: &mut Gas, position: Vec2, velocity: Vec2) {
        let volume = self.spacing * self.spacing;
        let air = Particle {
            temperature: self.temperature,
            velocity,
            ..Particle::at(position)
        };
        gas.insert_particle(&air, volume);
    }
}

impl Exchange {
    pub fn new(capacity: usize) -> Exchange {
        Exchange {
            next: Vec::with_capacity(capacity),
            nearby: Vec::with_capacity(capacity),
            blown: 0.0,
        }
    }

    /// Continues the column of wind of another map.
    pub fn continue_from(&mut self, old: &Exchange) {
        self.blown = old.blown;
    }

    /// Removes the gas outside, and lists the rest by cells.
    pub fn remove(&mut self, map: &mut Map, gas: &mut Gas) {
        self.next.clear();
        for cell in &mut map.cells {
            (cell.first, cell.count, cell.momentum) = (NONE, 0, Vec2::ZERO);
        }
        gas.retain(|position, velocity| {
            let stays = map.holds(position);
            if stays {
                let cell = map.layout.at(position);
                self.list(&mut map.cells[cell], velocity);
            }
            stays
        });
    }

    /// Adds the next particle to the list of its cell.
    fn list(&mut self, cell: &mut Cell, velocity: Vec2) {
        let index = self.next.len() as u32;
        self.next.push(cell.first);
        cell.first = index;
        cell.count += 1;
        cell.momentum += velocity;
    }

    /// Lets the air in that the wind has brought in a time `dt`: a column of particles in each
    /// cell of the ring that the wind enters, whenever it has blown as far as a spacing.
    pub fn blow(&mut self, map: &mut Map, gas: &mut Gas, inflow: &Inflow<'_>, dt: f32) {
        let (wind, spacing, layout) = (inflow.wind.x, inflow.spacing, map.layout);
        self.blown += fast_min(
            wind.abs() * fast_min(dt, MAX_INFLOW_TIME) / spacing,
            MAX_BIRTHS as f32,
        );
        while self.blown >= 1.0 {
            self.blown -= 1.0;
            let into = (self.blown + ENTRY_DEPTH) * spacing;
            for row in layout.inner_rows() {
                for cell in layout.row(row) {
                    let before = if wind > 0.0 { cell - 1 } else { cell + 1 };
                    let enters = map.depth[cell] > 0.0 && map.depth[before] == 0.0;
                    if enters && !map.cells[cell].fresh {
                        let corner = layout.corner((cell - row * layout.columns, row));
                        let x = if wind > 0.0 { into } else { layout.cell - into };
                        self.gather(map, gas, cell, corner, inflow);
                        let at = (cell, row);
                        self.add_column(
                            map,
                            gas,
                            inflow,
                            at,
                            corner.x + x,
                            inflow.wind,
                            MIN_LATTICE_DISTANCE,
                        );
                    }
                }
            }
        }
    }

    /// Fills the fresh cells and the ring with air.
    pub fn fill(&mut self, map: &mut Map, gas: &mut Gas, inflow: &Inflow<'_>) {
        let layout = map.layout;
        let per_cell = per_cell(&layout, inflow.spacing);
        let full = (MAX_FILLING * per_cell) as u32;
        for row in layout.inner_rows() {
            for (column, at) in (1..).zip(layout.row(row)) {
                let (depth, cell) = (map.depth[at], map.cells[at]);
                if depth == 0.0 || (!cell.fresh && depth > 1.0) {
                    continue;
                }
                let lattice = cell.fresh && (cell.count as f32) < LATTICE_FILLING * per_cell;
                if !lattice && cell.count >= full {
                    continue;
                }
                let velocity = if depth <= RIM_DEPTH {
                    cell.flow
                } else {
                    inflow.wind
                };
                let corner = layout.corner((column, row));
                self.gather(map, gas, at, corner, inflow);
                if lattice {
                    for x in layout.points(column, inflow.spacing) {
                        let x = layout.left + (x as f32 + 0.5) * inflow.spacing;
                        self.add_column(
                            map,
                            gas,
                            inflow,
                            (at, row),
                            x,
                            velocity,
                            MIN_BIRTH_DISTANCE,
                        );
                    }
                } else {
                    self.add_to_gaps(map, gas, inflow, at, corner, velocity, full);
                }
            }
        }
    }

    /// Collects the particles of a cell and those around it.
    fn gather(&mut self, map: &Map, gas: &Gas, cell: usize, corner: Vec2, inflow: &Inflow<'_>) {
        self.nearby.clear();
        let reach = MIN_BIRTH_DISTANCE * inflow.spacing;
        let low = corner - Vec2::splat(reach);
        let high = low + Vec2::splat(map.layout.cell + 2.0 * reach);
        map.layout.around(cell, &mut |other| {
            let mut particle = map.cells[other].first;
            while particle != NONE {
                let position = gas.position[particle as usize];
                if position.cmpge(low).all() && position.cmple(high).all() {
                    self.nearby.push(position);
                }
                particle = self.next[particle as usize];
            }
        });
    }

    /// The square of the distance of a place to the nearest particle.
    fn room(&self, place: Vec2) -> f32 {
        let squares = self.nearby.iter().map(|at| at.distance_squared(place));
        squares.fold(f32::MAX, fast_min)
    }

    /// The squares of the distances of all places of a cell to the nearest particle.
    fn rooms(&self, place: &impl Fn(usize) -> Vec2) -> [f32; PLACES] {
        // Four places at once: one after another, each minimum would wait for the one before.
        let fours: [[Lanes; 2]; PLACES.div_ceil(LANES)] = std::array::from_fn(|four| {
            let places = [0, 1, 2, 3].map(|lane| place(four * LANES + lane));
            [
                Lanes::new(places.map(|place| place.x)),
                Lanes::new(places.map(|place| place.y)),
            ]
        });
        let mut least = [Lanes::splat(f32::MAX); PLACES.div_ceil(LANES)];
        for at in &self.nearby {
            for ([x, y], least) in fours.iter().zip(&mut least) {
                let (x, y) = (*x - at.x, *y - at.y);
                *least = least.fast_min(x * x + y * y);
            }
        }
        std::array::from_fn(|index| least[index / LANES].to_array()[index % LANES])
    }

    /// Adds air to a cell, if there is room for another particle.
    fn add(
        &mut self,
        cell: &mut Cell,
        gas: &mut Gas,
        inflow: &Inflow<'_>,
        place: Vec2,
        velocity: Vec2,
    ) {
        if gas.len() < inflow.capacity {
            inflow.insert_particle(gas, place, velocity);
            self.nearby.push(place);
            self.list(cell, velocity);
        }
    }

    /// Adds a column of the lattice of the whole map to a cell, except nearer than `close`
    /// spacings to present particles.
    #[expect(clippy::too_many_arguments)]
    fn add_column(
        &mut self,
        map: &mut Map,
        gas: &mut Gas,
        inflow: &Inflow<'_>,
        (cell, row): (usize, usize),
        x: f32,
        velocity: Vec2,
        close: f32,
    ) {
        let (layout, close) = (map.layout, close * inflow.spacing);
        for y in layout.points(row, inflow.spacing) {
            let place = Vec2::new(x, layout.bottom + (y as f32 + 0.5) * inflow.spacing);
            if self.room(place) > close * close && inflow.is_free(place) {
                self.add(&mut map.cells[cell], gas, inflow, place, velocity);
            }
        }
    }

    /// Adds air at the freest places of a cell.
    #[expect(clippy::too_many_arguments)]
    fn add_to_gaps(
        &mut self,
        map: &mut Map,
        gas: &mut Gas,
        inflow: &Inflow<'_>,
        cell: usize,
        corner: Vec2,
        velocity: Vec2,
        full: u32,
    ) {
        let step = map.layout.cell / PLACES_PER_AXIS as f32;
        let place = |index: usize| {
            let (x, y) = (
                index as u32 % PLACES_PER_AXIS,
                index as u32 / PLACES_PER_AXIS,
            );
            corner + (Vec2::new(x as f32, y as f32) + 0.5) * step
        };
        let mut rooms = self.rooms(&place);
        for _ in 0..MAX_BIRTHS {
            if map.cells[cell].count >= full {
                return;
            }
            let (mut freest, mut most) = (
                None,
                MIN_BIRTH_DISTANCE * inflow.spacing * (MIN_BIRTH_DISTANCE * inflow.spacing),
            );
            for (index, &room) in rooms.iter().enumerate() {
                if room > most && inflow.is_free(place(index)) {
                    (freest, most) = (Some(place(index)), room);
                }
            }
            let Some(birth) = freest else {
                return;
            };
            self.add(&mut map.cells[cell], gas, inflow, birth, velocity);
            for (index, room) in rooms.iter_mut().enumerate() {
                *room = fast_min(place(index).distance_squared(birth), *room);
            }
        }
    }
}
