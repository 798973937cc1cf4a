//! Where air is awake: around sources and around gas that is hot, sooty, fuelled or stirred.
//!
//! A cell with such gas stays awake for a moment. Gas is wherever the distance to a cell that
//! is awake is at most the band and the ring. Beyond a number of particles, the highest cells
//! sleep.

use glam::Vec2;

use super::super::gas::Gas;
use super::map::{Layout, Map};
use crate::params::Physics;

/// Width of the band of air around what is awake \[m\].
const BAND: f32 = 0.08;
/// Smallest width of the band, in cells.
const MIN_BAND: f32 = 1.0;
/// Width of the rim, whose pressure and motion are those of the far air, in cells.
const RING: f32 = 2.0;
/// How much farther gas stays than it comes, in cells, so that the rim does not flicker.
const HYSTERESIS: f32 = 0.5;
/// Gas hotter than the air by this wakes its cell \[K\], as do this much soot and fuel.
const HOT: f32 = 40.0;
const SOOTY: f32 = 0.02;
const FUELLED: f32 = 1e-3;
/// Time for which a cell stays awake \[s\].
const HOLD: f32 = 0.3;
/// The outermost ring wakes no cell: noise there must not spread.
const MIN_DEPTH: u8 = 2;
/// Distance to a cell that is awake where there is none.
const FAR: f32 = 1e6;
/// Share of the capacity that the cells below the ceiling may need.
const FULL: f32 = 0.97;
/// Share of it below which the ceiling rises.
const ROOM: f32 = 0.9;

/// The cells that are awake, and the distance of the others to them.
#[derive(Clone, Debug, Default)]
pub(super) struct Awake {
    /// For how long each cell stays awake \[s\].
    remaining: Vec<f32>,
    /// Distance to the nearest cell that is awake, in cells.
    distance: Vec<f32>,
    inside: Vec<bool>,
    /// The first row in which all cells sleep.
    ceiling: usize,
    /// Share of the cells in reach that sleep.
    pub asleep: f32,
}

/// A rectangle that is awake: a source \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rectangle {
    pub low: Vec2,
    pub high: Vec2,
}

impl Awake {
    pub fn new(layout: &Layout) -> Awake {
        let n = layout.len();
        Awake {
            remaining: vec![0.0; n],
            distance: vec![FAR; n],
            inside: vec![false; n],
            ceiling: layout.rows,
            asleep: 0.0,
        }
    }

    /// Continues the state of another layout with the same size of cells. A layout that ends
    /// lower has the ceiling at its end.
    pub fn continue_from(&mut self, old: &Awake, (from, to): (&Layout, &Layout)) {
        for (cell, same) in to.common(from) {
            self.remaining[cell] = old.remaining[same];
        }
        if old.ceiling < from.rows {
            let ceiling = old.ceiling as isize + to.lowest() - from.lowest();
            self.ceiling = (ceiling.max(0) as usize).min(to.rows);
        }
        self.asleep = old.asleep;
    }

    /// Wakes the cells of active gas that the map does not know yet.
    pub fn wake_active(&mut self, layout: &Layout, gas: &Gas, values: &Physics) {
        for position in active(gas, values) {
            self.remaining[layout.at(position)] = HOLD;
        }
    }

    /// Wakes the cells of all gas.
    pub fn wake_all(&mut self, layout: &Layout, positions: &[Vec2]) {
        for &position in positions {
            self.remaining[layout.at(position)] = HOLD;
        }
    }

    /// Wakes the cells of active gas and of the sources, after a time `dt`.
    pub fn wake(
        &mut self,
        map: &Map,
        gas: &Gas,
        values: &Physics,
        sources: impl Iterator<Item = Rectangle>,
        dt: f32,
    ) {
        for remaining in &mut self.remaining {
            *remaining -= dt;
        }
        for position in active(gas, values) {
            let cell = map.layout.at(position);
            if map.depth[cell] >= MIN_DEPTH {
                self.remaining[cell] = HOLD;
            }
        }
        for source in sources {
            let Layout { columns, .. } = map.layout;
            let (low, high) = (map.layout.at(source.low), map.layout.at(source.high));
            for row in low / columns..=high / columns {
                for column in low % columns..=high % columns {
                    self.remaining[row * columns + column] = HOLD;
                }
            }
        }
    }

    /// The cells that hold gas, of at most `capacity` particles. `counts` are the present
    /// particles of the cells, and `per_cell` those of a cell of air.
    pub fn inside(&mut self, map: &Map, counts: &[u32], per_cell: f32, capacity: f32) -> &[bool] {
        self.measure(&map.layout);
        let reach = (BAND / map.layout.cell).max(MIN_BAND) + RING;
        let in_reach =
            |distance: f32, depth: u8| distance <= reach + if depth > 0 { HYSTERESIS } else { 0.0 };
        let (mut needed, mut wanted, mut cells) = (0.0, 0.0, 0);
        let mut ceiling = map.layout.rows;
        for row in map.layout.inner_rows() {
            for cell in map.layout.row(row) {
                let inside = in_reach(self.distance[cell], map.depth[cell]);
                self.inside[cell] = inside;
                cells += u32::from(inside);
                if inside {
                    let present = map.depth[cell] > 0 && counts[cell] > 0;
                    wanted += if present {
                        counts[cell] as f32
                    } else {
                        per_cell
                    };
                }
            }
            if wanted > FULL * capacity && ceiling == map.layout.rows {
                ceiling = row;
            }
            if row < self.ceiling {
                needed = wanted;
            }
        }
        if ceiling <= self.ceiling {
            self.ceiling = ceiling;
        } else if needed < ROOM * capacity {
            self.ceiling += 1;
        }
        let mut sleeping = 0;
        for row in self.ceiling.max(1)..map.layout.rows - 1 {
            for cell in map.layout.row(row) {
                sleeping += u32::from(self.inside[cell]);
                self.inside[cell] = false;
                self.remaining[cell] = 0.0;
            }
        }
        self.asleep = sleeping as f32 / cells.max(1) as f32;
        &self.inside
    }

    /// Measures the distances: a chamfer distance of two sweeps (Borgefors 1986).
    fn measure(&mut self, layout: &Layout) {
        let columns = layout.columns;
        let distance = &mut self.distance;
        for (distance, &remaining) in distance.iter_mut().zip(&self.remaining) {
            *distance = if remaining > 0.0 { 0.0 } else { FAR };
        }
        let nearest = |distance: &[f32], cell: usize, straight: [usize; 2], across: [usize; 2]| {
            let straight = distance[straight[0]].min(distance[straight[1]]) + 1.0;
            let across = distance[across[0]].min(distance[across[1]]) + std::f32::consts::SQRT_2;
            distance[cell].min(straight).min(across)
        };
        for cell in layout.inner() {
            let below = cell - columns;
            distance[cell] = nearest(distance, cell, [cell - 1, below], [below - 1, below + 1]);
        }
        for cell in layout
            .inner_rows()
            .rev()
            .flat_map(|row| layout.row(row).rev())
        {
            let above = cell + columns;
            distance[cell] = nearest(distance, cell, [cell + 1, above], [above - 1, above + 1]);
        }
    }
}

/// The positions of active gas.
fn active<'a>(gas: &'a Gas, values: &Physics) -> impl Iterator<Item = Vec2> + use<'a> {
    let hot = values.ambient_temperature + HOT;
    let all = gas.state.iter().zip(&gas.position);
    all.filter_map(move |(state, &position)| {
        let active = state.x > hot || state.y > FUELLED || state.w > SOOTY;
        active.then_some(position)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::with;

    fn source(x: f32, y: f32) -> Rectangle {
        Rectangle {
            low: Vec2::new(x - 0.1, y),
            high: Vec2::new(x + 0.1, y + 0.05),
        }
    }

    /// The map around a source after that many updates with this capacity.
    fn around(source: Rectangle, updates: u32, capacity: f32) -> (Map, Awake) {
        let layout = Layout::new(1.4, 0.4, 3.4, 0.08, false);
        let (mut map, mut awake) = (Map::new(layout), Awake::new(&layout));
        let gas = Gas::default();
        for _ in 0..updates {
            awake.wake(&map, &gas, &with(&[]), [source].into_iter(), 0.01);
            let counts = vec![0; layout.len()];
            map.fill(awake.inside(&map, &counts, 9.0, capacity));
        }
        (map, awake)
    }

    #[test]
    fn gas_is_around_a_source_and_nowhere_else() {
        let at = source(0.3, 0.8);
        let (map, _) = around(at, 1, 1e6);
        assert!(!map.live.is_empty());
        for &cell in &map.live {
            let at = map.layout.corner(cell as usize) + Vec2::splat(0.04);
            let reach = (RING + MIN_BAND + 1.0) * 0.08;
            assert!(
                (at.x - 0.3).abs() < 0.1 + reach && (at.y - 0.8).abs() < 0.05 + reach,
                "{at}"
            );
        }
        assert!(map.depth_at(Vec2::new(0.3, 0.82)) >= 2.5);
    }

    #[test]
    fn hot_gas_wakes_its_cell_for_a_while_and_the_outermost_ring_wakes_none() {
        let (mut map, mut awake) = around(source(0.0, 0.5), 1, 1e6);
        let values = with(&[]);
        for (depth, wakes) in [(1, false), (2, true)] {
            let cell = map
                .live
                .iter()
                .find(|&&cell| map.depth[cell as usize] == depth);
            let cell = *cell.expect("a cell") as usize;
            let mut gas = Gas::default();
            gas.push(&crate::Particle {
                temperature: values.ambient_temperature + 100.0,
                ..crate::Particle::at(map.layout.corner(cell) + Vec2::splat(0.04))
            });
            awake.wake(&map, &gas, &values, std::iter::empty(), 0.0);
            assert_eq!(awake.remaining[cell] > 0.0, wakes, "depth {depth}");
        }
        let counts = vec![0; map.layout.len()];
        awake.wake(
            &map,
            &Gas::default(),
            &values,
            std::iter::empty(),
            2.0 * HOLD,
        );
        map.fill(awake.inside(&map, &counts, 9.0, 1e6));
        assert!(map.live.is_empty());
    }

    #[test]
    fn beyond_the_capacity_the_highest_cells_sleep_and_wake_when_there_is_room() {
        let tall = Rectangle {
            low: Vec2::new(-0.1, 0.2),
            high: Vec2::new(0.1, 2.8),
        };
        let (all, awake) = around(tall, 1, 1e6);
        assert_eq!(awake.asleep, 0.0);
        let capacity = 9.0 * all.live.len() as f32 / 2.0;
        let (map, mut awake) = around(tall, 3, capacity);
        assert!(9.0 * map.live.len() as f32 <= capacity);
        assert!(awake.asleep > 0.3 && awake.asleep < 0.7, "{}", awake.asleep);
        let highest = |map: &Map| map.live.last().map_or(0, |&cell| cell as usize);
        assert!(highest(&map) < highest(&all));
        let mut map = map;
        for _ in 0..200 {
            awake.wake(&map, &Gas::default(), &with(&[]), [tall].into_iter(), 0.01);
            let counts = vec![0; map.layout.len()];
            map.fill(awake.inside(&map, &counts, 9.0, 1e6));
        }
        assert_eq!((awake.asleep, highest(&map)), (0.0, highest(&all)));
    }
}
