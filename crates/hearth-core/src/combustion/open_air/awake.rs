//! Where air is awake: around sources and around gas that is hot, sooty, fuelled or stirred.
//!
//! A cell with such gas stays awake for a moment. Gas is wherever the distance to a cell that
//! is awake is at most the band and the ring. Beyond a number of particles, the highest cells
//! sleep.

use glam::Vec2;

use super::super::gas::Gas;
use super::map::{Layout, Map, measure};
use crate::params::Physics;

/// Width of the band of air around what is awake \[m\].
const BAND_WIDTH: f32 = 0.08;
/// Smallest width of the band, in cells.
const MIN_BAND: f32 = 1.0;
/// Width of the rim, whose pressure and motion are those of the far air, in cells.
const RIM_CELLS: f32 = 2.0;
/// How much farther gas stays than it comes, in cells, so that the rim does not flicker.
const HYSTERESIS_CELLS: f32 = 0.5;
/// Gas hotter than the air by this wakes its cell \[K\], as do this much soot and fuel.
const WAKING_HEAT: f32 = 40.0;
const WAKING_SOOT: f32 = 0.02;
const WAKING_FUEL: f32 = 1e-3;
/// Time for which a cell stays awake \[s\].
pub(super) const AWAKE_TIME: f32 = 0.3;
/// The outermost ring wakes no cell: noise there must not spread.
pub(super) const MIN_DEPTH: f32 = 2.0;
/// Distance to a cell that is awake where there is none.
const NO_DISTANCE: f32 = 1e6;
/// Share of the capacity that the cells below the ceiling may need.
const MAX_FILLING: f32 = 0.97;
/// Share of it below which the ceiling rises.
const MIN_FILLING: f32 = 0.9;

/// How far the cells sleep that would need too many particles.
#[derive(Clone, Debug, Default)]
pub(super) struct Awake {
    /// Distance to the nearest cell that is awake, in cells.
    distance: Vec<f32>,
    /// The first row in which all cells sleep.
    ceiling: usize,
    /// Share of the cells in reach that sleep.
    pub asleep: f32,
}

crate::state! { Awake: distance ceiling asleep }

/// A rectangle that is awake: a source \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rectangle {
    pub low: Vec2,
    pub high: Vec2,
}

/// Activates the cells of gas that is hotter than this or otherwise active, at least this deep.
pub(super) fn activate(map: &mut Map, gas: &Gas, hot: f32, min_depth: f32) {
    for (state, &position) in gas.state.iter().zip(&gas.position) {
        if state.x > hot || state.y > WAKING_FUEL || state.w > WAKING_SOOT {
            let cell = map.layout.at(position);
            if map.depth[cell] >= min_depth {
                map.cells[cell].remaining = AWAKE_TIME;
            }
        }
    }
}

/// Temperature of the coldest gas that is active by its heat \[K\].
pub(super) fn hot(values: &Physics) -> f32 {
    values.ambient_temperature + WAKING_HEAT
}

/// Activates the cells of a source; none of one outside of the map.
// One of its two callers is in a part of the build, where its code is then too.
#[inline(always)]
pub(super) fn activate_source(map: &mut Map, source: &Rectangle) {
    let Layout { columns, .. } = map.layout;
    if !map.layout.bounds().overlaps(source.low, source.high) {
        return;
    }
    let (low, high) = (map.layout.place(source.low), map.layout.place(source.high));
    for row in low.1..=high.1 {
        for cell in &mut map.cells[row * columns..][low.0..=high.0] {
            cell.remaining = AWAKE_TIME;
        }
    }
}

impl Awake {
    pub fn new(layout: &Layout) -> Awake {
        Awake {
            distance: vec![NO_DISTANCE; layout.len()],
            ceiling: layout.rows,
            asleep: 0.0,
        }
    }

    /// Continues the state of another layout with the same size of cells. A layout that ends
    /// lower has the ceiling at its end.
    pub fn continue_from(&mut self, old: &Awake, (from, to): (&Layout, &Layout)) {
        if old.ceiling < from.rows {
            let ceiling = old.ceiling as isize + to.lowest() - from.lowest();
            self.ceiling = (ceiling.max(0) as usize).min(to.rows);
        }
        self.asleep = old.asleep;
    }

    /// Finds the cells that are to hold gas, of at most `capacity` particles. `per_cell` is the
    /// number of those of a cell of air. If gas is `kept`, no cell below the ceiling loses it.
    pub fn spread(&mut self, map: &mut Map, per_cell: f32, capacity: f32, kept: bool) {
        let (layout, distance) = (map.layout, &mut self.distance);
        for (distance, cell) in distance.iter_mut().zip(&map.cells) {
            *distance = if cell.remaining > 0.0 {
                0.0
            } else {
                NO_DISTANCE
            };
        }
        measure(distance, &layout, std::f32::consts::SQRT_2);
        let reach = (BAND_WIDTH / layout.cell).max(MIN_BAND) + RIM_CELLS;
        let farthest = if kept {
            NO_DISTANCE
        } else {
            reach + HYSTERESIS_CELLS
        };
        let (mut needed, mut wanted, mut cells) = (0.0, 0.0, 0);
        let mut ceiling = layout.rows;
        for row in layout.inner_rows() {
            for at in layout.row(row) {
                let present = map.depth[at] > 0.0;
                let cell = &mut map.cells[at];
                cell.inside = distance[at] <= if present { farthest } else { reach };
                if cell.inside {
                    cells += 1;
                    wanted += if present && cell.count > 0 {
                        cell.count as f32
                    } else {
                        per_cell
                    };
                }
            }
            if wanted > MAX_FILLING * capacity && ceiling == layout.rows {
                ceiling = row;
            }
            if row < self.ceiling {
                needed = wanted;
            }
        }
        if ceiling <= self.ceiling {
            self.ceiling = ceiling;
        } else if needed < MIN_FILLING * capacity {
            self.ceiling += 1;
        }
        let mut sleeping = 0;
        for cell in &mut map.cells[self.ceiling.max(1) * layout.columns..] {
            sleeping += u32::from(cell.inside);
            (cell.inside, cell.remaining) = (false, 0.0);
        }
        self.asleep = sleeping as f32 / cells.max(1) as f32;
    }
}

#[cfg(test)]
mod tests {
    use super::super::map::tests::corner;
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
        for _ in 0..updates {
            update(&mut map, &mut awake, Some(source), capacity);
        }
        (map, awake)
    }

    fn update(map: &mut Map, awake: &mut Awake, source: Option<Rectangle>, capacity: f32) {
        if let Some(source) = source {
            activate_source(map, &source);
        }
        awake.spread(map, 9.0, capacity, false);
        map.fill();
    }

    fn live(map: &Map) -> Vec<usize> {
        let cells = map.layout.inner();
        cells.filter(|&cell| map.depth[cell] > 0.0).collect()
    }

    #[test]
    fn gas_is_around_a_source_and_nowhere_else() {
        let at = source(0.3, 0.8);
        let (map, _) = around(at, 1, 1e6);
        assert!(!live(&map).is_empty());
        for cell in live(&map) {
            let at = corner(&map.layout, cell) + Vec2::splat(0.04);
            let reach = (RIM_CELLS + MIN_BAND + 1.0) * 0.08;
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
        for (depth, wakes) in [(1.0, false), (2.0, true)] {
            let cells = live(&map);
            let cell = cells.into_iter().find(|&cell| map.depth[cell] == depth);
            let cell = cell.expect("a cell");
            map.cells[cell].remaining = 0.0;
            let mut gas = Gas::default();
            gas.push(&crate::Particle {
                temperature: values.ambient_temperature + 100.0,
                ..crate::Particle::at(corner(&map.layout, cell) + Vec2::splat(0.04))
            });
            activate(&mut map, &gas, hot(&values), MIN_DEPTH);
            assert_eq!(map.cells[cell].remaining > 0.0, wakes, "depth {depth}");
        }
        for cell in &mut map.cells {
            cell.remaining -= 2.0 * AWAKE_TIME;
        }
        update(&mut map, &mut awake, None, 1e6);
        assert!(live(&map).is_empty());
    }

    #[test]
    fn beyond_the_capacity_the_highest_cells_sleep_and_wake_when_there_is_room() {
        let tall = Rectangle {
            low: Vec2::new(-0.1, 0.2),
            high: Vec2::new(0.1, 2.8),
        };
        let (all, awake) = around(tall, 1, 1e6);
        assert_eq!(awake.asleep, 0.0);
        let capacity = 9.0 * live(&all).len() as f32 / 2.0;
        let (map, mut awake) = around(tall, 3, capacity);
        assert!(9.0 * live(&map).len() as f32 <= capacity);
        assert!(awake.asleep > 0.3 && awake.asleep < 0.7, "{}", awake.asleep);
        let highest = |map: &Map| live(map).last().copied();
        assert!(highest(&map) < highest(&all));
        let mut map = map;
        for _ in 0..200 {
            update(&mut map, &mut awake, Some(tall), 1e6);
        }
        assert_eq!((awake.asleep, highest(&map)), (0.0, highest(&all)));
    }
}
