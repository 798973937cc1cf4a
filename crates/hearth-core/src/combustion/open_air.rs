//! Open air: gas in a band around what is active, and nothing beyond.
//!
//! A [map](map) of cells states where gas is simulated: around sources and around
//! [active gas](awake). The [rim](rim) of the band is a reservoir at the pressure of the far
//! air. Gas that leaves is removed, and fresh air [enters](exchange) at rest or in the wind, so
//! the number of particles follows the fire. The air has no box, and a floor only where the
//! settings have one.

mod awake;
mod exchange;
mod map;
mod rim;

use glam::Vec2;

use super::gas::Gas;
use super::reaction::burner::Burner;
use crate::bounds::Bounds;
use crate::extremes::{fast_max, fast_min};
use crate::params::{Edges, Floor as FloorChoice, Physics};
use crate::scene::{Scene, SceneSource};
use crate::solids::Solids;
use awake::{Awake, Rectangle};
use exchange::{Exchange, Inflow};
use map::{Layout, Map};
use rim::Rim;

/// How far gas is simulated beyond the domain and what is seen, in heights of the domain and in
/// cells, so that its end is not visible. Below its upper end, slow eddies linger.
const MARGIN_SIDE: f32 = 0.1;
const MARGIN_ABOVE: f32 = 0.2;
const MIN_MARGIN: f32 = 2.0;
/// How far gas is simulated at most beyond the domain, in heights of the domain.
const MAX_BEYOND: f32 = 4.0;
/// Most cells beyond those of the domain and its smallest margin.
const MAX_CELLS: usize = 65_536;
/// Smallest share of the margin where there would be more cells.
const MIN_MARGIN_SHARE: f32 = 0.01;
/// Steps from one exchange of gas to the next, and from one map to the next.
const EXCHANGE_STEPS: u32 = 2;
const MAP_STEPS: u32 = 4;

/// Depths between which kernels of displays become as wide as elsewhere, and how many radii more
/// they have farther out.
const WIDENED_DEPTHS: (f32, f32) = (0.5, 2.5);
const MAX_WIDENING: f32 = 2.0;

/// Lower left and upper right corner of the part of the world that is seen \[m\].
pub(crate) type Seen = [Vec2; 2];

/// The open air around a fire.
#[derive(Clone, Debug)]
pub(super) struct OpenAir {
    map: Map,
    awake: Awake,
    exchange: Exchange,
    rim: Rim,
    spacing: f32,
    capacity: usize,
    steps: u32,
    /// Time since the last exchange and since the last map \[s\].
    since_exchange: f32,
    since_map: f32,
    /// For how long no cell loses its gas \[s\].
    kept: f32,
}

crate::state! { OpenAir: map awake exchange rim spacing capacity steps since_exchange since_map kept }

impl OpenAir {
    /// The air of these values; `None` with periodic edges.
    pub fn new(values: &Physics, seen: Option<Seen>) -> Option<Box<OpenAir>> {
        if values.edges == Edges::Periodic {
            return None;
        }
        let layout = layout(values, seen, values.spacing());
        let capacity = values.max_particles as usize;
        Some(Box::new(OpenAir {
            map: Map::new(layout),
            awake: Awake::new(&layout),
            exchange: Exchange::new(capacity),
            rim: Rim::new(capacity),
            spacing: values.spacing(),
            capacity,
            steps: 0,
            since_exchange: f32::INFINITY,
            since_map: 0.0,
            kept: 0.0,
        }))
    }

    /// Whether these values have the same map.
    pub fn fits(&self, values: &Physics, seen: Option<Seen>) -> bool {
        self.map.layout == layout(values, seen, values.spacing())
            && self.capacity == values.max_particles as usize
            && self.spacing == values.spacing()
    }

    /// The rectangle that the gas may reach.
    pub fn bounds(&self) -> Bounds {
        self.map.layout.bounds()
    }

    /// Share of the air around the fire that sleeps, because there would be more particles than
    /// `max_particles`.
    pub fn asleep(&self) -> f32 {
        self.awake.asleep
    }

    /// The air around the sources.
    pub fn air(&mut self, scene: &Scene, solids: &Solids) -> Gas {
        let mut gas = Gas::none(scene.world());
        self.exchange_gas(&mut gas, scene, solids, 0.0);
        gas
    }

    /// Holds this gas, and fills the rest of the map around what is active. A wider band around
    /// all of it would end the pull of its rim everywhere at once: a pulse, which focuses in the
    /// middle of a fire.
    pub fn surround(&mut self, gas: &Gas, values: &Physics) {
        self.map.occupy(gas);
        awake::activate(&mut self.map, gas, awake::hot(values), 0.0);
        (self.steps, self.since_exchange) = (0, f32::INFINITY);
        self.kept = awake::AWAKE_TIME;
    }

    /// Finds the cells that are to hold gas of another discretisation, which is resampled.
    pub fn adopt(&mut self, gas: &Gas, scene: &Scene, solids: &Solids) {
        let values = scene.world();
        awake::activate(&mut self.map, gas, awake::hot(values), 0.0);
        self.update(gas, scene, solids);
    }

    /// Continues another map with the same cells, of which there may be more or fewer.
    pub fn continue_from(&mut self, old: &OpenAir) {
        let layouts = (&old.map.layout, &self.map.layout);
        self.awake.continue_from(&old.awake, layouts);
        self.exchange.continue_from(&old.exchange);
        self.map.continue_from(&old.map);
        self.steps = old.steps;
        self.since_exchange = old.since_exchange;
        self.since_map = old.since_map;
        self.kept = old.kept;
    }

    /// Whether another map has cells of the same size.
    pub fn has_cells_of(&self, other: &OpenAir) -> bool {
        let (own, other) = (self.map.layout, other.map.layout);
        own.cell == other.cell && own.floor == other.floor
    }

    /// Whether this air holds gas at a position.
    pub fn holds(&self, place: Vec2) -> bool {
        self.map.holds(place)
    }

    /// Updates the map.
    fn update(&mut self, gas: &Gas, scene: &Scene, solids: &Solids) {
        let (map, values) = (&mut self.map, scene.world());
        for cell in &mut map.cells {
            cell.remaining -= self.since_map;
        }
        self.kept -= self.since_map;
        awake::activate(map, gas, awake::hot(values), awake::MIN_DEPTH);
        for source in scene.sources() {
            awake::activate_source(map, &awake_at(&source, solids));
        }
        let per_cell = exchange::per_cell(&map.layout, self.spacing);
        let kept = self.kept > 0.0;
        self.awake.spread(map, per_cell, self.capacity as f32, kept);
        map.fill();
        self.since_map = 0.0;
    }

    /// Activates the air in a rectangle. Only a part of the build calls this.
    #[inline(always)]
    pub fn activate(&mut self, low: Vec2, high: Vec2) {
        awake::activate_source(&mut self.map, &Rectangle { low, high });
    }

    /// Removes the gas that has left, and inserts the air that enters, after a step of the length `dt`.
    pub fn exchange_gas(&mut self, gas: &mut Gas, scene: &Scene, solids: &Solids, dt: f32) {
        self.since_exchange += dt;
        self.since_map += dt;
        let step = self.steps;
        self.steps = step.wrapping_add(1);
        if !step.is_multiple_of(EXCHANGE_STEPS) {
            return;
        }
        let values = scene.world();
        let inflow = Inflow::new(values, self.spacing, self.capacity, solids);
        if step.is_multiple_of(MAP_STEPS) {
            self.update(gas, scene, solids);
        } else {
            for cell in &mut self.map.cells {
                cell.fresh = false;
            }
        }
        let (map, exchange) = (&mut self.map, &mut self.exchange);
        exchange.remove(map, gas);
        exchange::follow(map, inflow.wind, self.since_exchange);
        exchange.blow(map, gas, &inflow, self.since_exchange);
        exchange.fill(map, gas, &inflow);
        self.since_exchange = 0.0;
    }

    /// By how many radii kernels of displays are wider at a position, so that the end of the gas
    /// is not visible.
    pub fn widening(&self, place: Vec2) -> f32 {
        MAX_WIDENING * (1.0 - rim::share(self.map.depth_at(place), WIDENED_DEPTHS))
    }

    /// Whether there is a floor.
    pub fn has_floor(&self) -> bool {
        self.map.layout.floor
    }

    /// Finds the sorted particles near the outside.
    pub fn find_rim(&mut self, gas: &Gas) {
        self.rim.find(&self.map, gas);
    }

    /// Weakens the pressure towards the outside.
    pub fn taper_pressure(&self, gas: &mut Gas) {
        self.rim.taper_pressure(gas);
    }

    /// Completes the volumes near the outside for readers.
    pub fn complete_volumes(&self, gas: &mut Gas, far: f32) {
        self.rim.complete_volumes(gas, far);
    }

    /// Removes the outward part of the shifts near the outside.
    pub fn remove_outward_shift(&self, gas: &mut Gas) {
        self.rim.remove_outward_shift(&self.map, gas);
    }

    /// Relaxes the velocity of the ring towards the flow at the rim for `dt`.
    pub fn relax_rim_velocity(&self, gas: &mut Gas, dt: f32) {
        self.rim.relax_velocity(&self.map, gas, dt);
    }
}

/// The map of these values for particles of this spacing \[m\]: of the domain and what is seen,
/// and a margin.
pub(super) fn layout(values: &Physics, seen: Option<Seen>, spacing: f32) -> Layout {
    let cell = 2.0 * values.smoothing_ratio * spacing;
    let (half, height) = (0.5 * values.domain_width, values.domain_height);
    let [low, high] = seen.unwrap_or([Vec2::ZERO; 2]);
    // NaN shows nothing beyond the domain.
    let beyond = |length: f32, margin: f32| {
        fast_min(fast_max(length, 0.0), MAX_BEYOND * height) + margin * height
    };
    let side = beyond(fast_max(-low.x, high.x) - half, MARGIN_SIDE);
    let (below, above) = (
        beyond(-low.y, MARGIN_SIDE),
        beyond(high.y - height, MARGIN_ABOVE),
    );
    let floor = values.floor == FloorChoice::Solid;
    let mut share = 1.0;
    loop {
        let reach = |beyond: f32| fast_max(share * beyond, MIN_MARGIN * cell);
        let (side, above) = (half + reach(side), height + reach(above));
        let layout = Layout::new(side, reach(below), above, cell, floor);
        if layout.len() <= MAX_CELLS || share < MIN_MARGIN_SHARE {
            return layout;
        }
        share *= 0.5;
    }
}

/// The rectangle around a source whose cells are awake.
fn awake_at(source: &SceneSource<'_>, solids: &Solids) -> Rectangle {
    let burner = Burner::of(source);
    let [low, high] = match solids.parts(source) {
        [] => burner.around(),
        [body, ..] => {
            let frame = &body.surface.frame;
            let half = frame.extent() + (burner.top - burner.bottom);
            [frame.centre - half, frame.centre + half]
        }
    };
    Rectangle { low, high }
}
