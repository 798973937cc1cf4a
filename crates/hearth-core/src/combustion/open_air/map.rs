//! A map of square cells over all places that may hold gas.
//!
//! A cell is as wide as the support of the kernel. Its depth is its chessboard distance to the
//! nearest cell without gas: 0 without gas, 1 in the outermost ring, up to [`MAX_DEPTH`]. A border of
//! cells without gas surrounds the map, so a cell's neighbours need no check. Below a floor,
//! the border mirrors the lowest cells.

#[cfg(test)]
pub(super) mod tests;

use glam::Vec2;

use super::super::gas::Gas;
use crate::bounds::Bounds;
use crate::extremes::fast_min;
use crate::lanes::{LANES, Lanes, Real};

/// Largest depth that the map distinguishes.
pub(super) const MAX_DEPTH: f32 = 5.0;
/// Largest depth of a cell near the rim: deeper ones only hold ordinary gas.
pub(super) const RIM_DEPTH: f32 = 3.0;
/// No particle, at the end of a list.
pub(super) const NONE: u32 = u32::MAX;

/// The place and size of the map.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Layout {
    /// Side of a cell \[m\].
    pub cell: f32,
    /// Cells per metre.
    per_metre: f32,
    /// Number of columns and rows, the border included.
    pub columns: usize,
    pub rows: usize,
    /// Lower left corner of the border \[m\].
    pub left: f32,
    pub bottom: f32,
    /// Whether a floor closes the map at y = 0.
    pub floor: bool,
}

impl Layout {
    /// The layout for places up to `side` \[m\] from the middle, and from `below` the floor to
    /// `above` it \[m\]; a solid floor has nothing below. The corners of the cells are at whole
    /// multiples of `cell`, so that layouts of one size of cells have the same cells.
    pub fn new(side: f32, below: f32, above: f32, cell: f32, floor: bool) -> Layout {
        let cells = |length: f32| (length / cell).ceil().max(1.0) as usize;
        let below = if floor { 0 } else { cells(below) };
        let side = cells(side) + 1;
        Layout {
            cell,
            per_metre: 1.0 / cell,
            columns: 2 * side,
            rows: below + cells(above) + 2,
            left: -(side as f32) * cell,
            bottom: -(below as f32 + 1.0) * cell,
            floor,
        }
    }

    /// The pairs of inner cells of this layout and of another with the same size of cells that
    /// are the same place.
    pub fn common(&self, other: &Layout) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (own, other) = (*self, *other);
        let aside = other.columns as isize / 2 - own.columns as isize / 2;
        let lower = other.lowest() - own.lowest();
        own.inner().filter_map(move |cell| {
            let column = (cell % own.columns) as isize + aside;
            let row = (cell / own.columns) as isize + lower;
            let is_inner = (1..other.columns as isize - 1).contains(&column)
                && (1..other.rows as isize - 1).contains(&row);
            is_inner.then(|| (cell, row as usize * other.columns + column as usize))
        })
    }

    /// The number of the border's lower rows below y = 0.
    pub fn lowest(&self) -> isize {
        (-self.bottom * self.per_metre + 0.5) as isize
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.columns * self.rows
    }

    /// The rectangle of all cells, the border included: gas that leaves comes so far until it
    /// is removed.
    pub fn bounds(&self) -> Bounds {
        let top = self.bottom + self.rows as f32 * self.cell;
        let bottom = if self.floor { 0.0 } else { self.bottom };
        Bounds {
            bottom,
            width: self.columns as f32 * self.cell,
            height: top - bottom,
            periodic_x: false,
            periodic_y: false,
        }
    }

    /// The cell at a position. NaN and positions outside are in the border.
    #[inline]
    pub fn at(&self, position: Vec2) -> usize {
        let (column, row) = self.place(position);
        row * self.columns + column
    }

    /// Its column and row.
    #[inline]
    pub fn place(&self, position: Vec2) -> (usize, usize) {
        let column = self.index(position.x - self.left, self.columns);
        let row = self.index(position.y - self.bottom, self.rows);
        (column, row)
    }

    #[inline]
    fn index(&self, along: f32, count: usize) -> usize {
        // A cast saturates, so a negative number and NaN become 0.
        ((along * self.per_metre) as u32 as usize).min(count - 1)
    }

    /// Lower left corner of the cell in a column and row \[m\].
    pub fn corner(&self, (column, row): (usize, usize)) -> Vec2 {
        Vec2::new(self.left, self.bottom) + Vec2::new(column as f32, row as f32) * self.cell
    }

    /// Calls `each` with an inner cell and the eight around it.
    pub fn around(&self, cell: usize, each: &mut dyn FnMut(usize)) {
        for middle in [cell - self.columns, cell, cell + self.columns] {
            for other in middle - 1..=middle + 1 {
                each(other);
            }
        }
    }

    /// The points of the lattice of this spacing \[m\] over the map that a column or row of cells
    /// has along its axis. Every point is in one of them.
    pub fn points(&self, index: usize, spacing: f32) -> std::ops::Range<usize> {
        // The same expression in every cell, so that no point is in two cells or in none.
        let point = |at: usize| (at as f32 * self.cell / spacing + 0.5) as usize;
        point(index)..point(index + 1)
    }

    /// The cells inside the border, row by row.
    pub fn inner(&self) -> impl Iterator<Item = usize> + use<> {
        let columns = self.columns;
        (1..self.rows - 1).flat_map(move |row| row * columns + 1..(row + 1) * columns - 1)
    }

    /// The rows inside the border.
    pub fn inner_rows(&self) -> std::ops::Range<usize> {
        1..self.rows - 1
    }

    /// The inner cells of a row.
    pub fn row(&self, row: usize) -> std::ops::Range<usize> {
        row * self.columns + 1..(row + 1) * self.columns - 1
    }
}

/// A cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// For how long it stays awake \[s\].
    pub remaining: f32,
    /// Whether it is to hold gas.
    pub inside: bool,
    /// Whether gas came to it with the last change.
    pub fresh: bool,
    /// Unit vector to the outside, up to the depth [`RIM_DEPTH`].
    pub outward: Vec2,
    /// Velocity with which gas crosses the rim [m/s], up to the depth [`RIM_DEPTH`].
    pub flow: Vec2,
    /// Its first particle, the number of its particles, and the sum of their velocities [m/s].
    pub first: u32,
    pub count: u32,
    pub momentum: Vec2,
}

impl Cell {
    const EMPTY: Cell = Cell {
        remaining: 0.0,
        inside: false,
        fresh: false,
        outward: Vec2::ZERO,
        flow: Vec2::ZERO,
        first: NONE,
        count: 0,
        momentum: Vec2::ZERO,
    };
}

/// All cells.
#[derive(Clone, Debug, Default)]
pub(super) struct Map {
    pub layout: Layout,
    pub cells: Vec<Cell>,
    /// The depth of each cell.
    pub depth: Vec<f32>,
}

crate::state! {
    Layout: cell per_metre columns rows left bottom floor,
    Cell: remaining inside fresh outward flow first count momentum,
    Map: layout cells depth
}

impl Map {
    /// A map without gas.
    pub fn new(layout: Layout) -> Map {
        let n = layout.len();
        Map {
            layout,
            cells: vec![Cell::EMPTY; n],
            depth: vec![0.0; n],
        }
    }

    /// Puts gas into the cells that are to hold gas, and into no others.
    pub fn fill(&mut self) {
        let Layout { columns, floor, .. } = self.layout;
        for (cell, depth) in self.cells.iter_mut().zip(&mut self.depth) {
            cell.fresh = cell.inside && *depth == 0.0;
            *depth = if cell.inside { MAX_DEPTH } else { 0.0 };
        }
        // Below a floor it is deep.
        self.depth[..columns].fill(if floor { MAX_DEPTH } else { 0.0 });
        measure(&mut self.depth, &self.layout, 1.0);
        if floor {
            self.depth.copy_within(columns..2 * columns, 0);
        }
        for cell in self.layout.inner() {
            let side = |at: usize, step: usize| {
                self.depth[at - step] + self.depth[at] + self.depth[at + step]
            };
            let slope = Vec2::new(
                side(cell + 1, columns) - side(cell - 1, columns),
                side(cell + columns, 1) - side(cell - columns, 1),
            );
            self.cells[cell].outward = unit(-slope);
        }
    }

    /// Puts gas into the cells that particles fill. Thin gas may leave a cell among others empty.
    pub fn occupy(&mut self, gas: &Gas) {
        let mut filled = vec![0.0; self.layout.len()];
        for (&position, volume) in gas.position.iter().zip(&gas.volume) {
            filled[self.layout.at(position)] += volume;
        }
        let half = 0.5 * self.layout.cell * self.layout.cell;
        for cell in self.layout.inner() {
            let (mut own, mut around) = (0.0, 0.0);
            self.layout.around(cell, &mut |other| {
                let filled = filled[other];
                own = if other == cell { filled } else { own };
                around += filled;
            });
            self.cells[cell].inside = own > half || around > 9.0 * half;
        }
        self.fill();
    }

    /// Continues another map with cells of the same size.
    pub fn continue_from(&mut self, old: &Map) {
        for (cell, same) in self.layout.common(&old.layout) {
            self.cells[cell] = Cell {
                inside: old.depth[same] > 0.0,
                first: NONE,
                ..old.cells[same]
            };
        }
        self.fill();
        for cell in &mut self.cells {
            cell.fresh = false;
        }
    }

    /// Whether there is gas at a position.
    pub fn holds(&self, position: Vec2) -> bool {
        let cell = self.layout.at(position);
        self.depth[cell] > 0.0 && cell >= self.layout.columns
    }

    /// The depth at a position.
    pub fn depth_at(&self, position: Vec2) -> f32 {
        self.depths_at([position; LANES]).0.to_array()[0]
    }

    /// The depths at four positions, interpolated between the centres of the cells, and the cells that
    /// hold them.
    #[inline(always)]
    pub fn depths_at(&self, positions: [Vec2; LANES]) -> (Lanes, [u32; LANES]) {
        let layout = &self.layout;
        let part = |along: Lanes, count: usize| {
            // The middle of the border's cells is the outermost place, NaN included.
            let at = (along * layout.per_metre - 0.5)
                .fast_max(Lanes::ZERO)
                .fast_min(Lanes::splat((count - 2) as f32));
            let nearest = (at - 0.5).fast_max(Lanes::ZERO).nearest_integers();
            let part = at - Lanes::new(nearest.map(|index| index as f32));
            (nearest, part)
        };
        let x = Lanes::new(positions.map(|position| position.x)) - layout.left;
        let y = Lanes::new(positions.map(|position| position.y)) - layout.bottom;
        let ((columns, x), (rows, y)) = (part(x, layout.columns), part(y, layout.rows));
        let first: [usize; LANES] =
            std::array::from_fn(|k| rows[k] as usize * layout.columns + columns[k] as usize);
        let corner = |step: usize| Lanes::new(first.map(|first| self.depth[first + step]));
        let mix = |step: usize| {
            let depth = corner(step);
            depth + (corner(step + 1) - depth) * x
        };
        let (lower, upper) = (mix(0), mix(layout.columns));
        let half = Lanes::splat(0.5);
        let (right, above) = (half.less_mask(x), half.less_mask(y));
        let cells = std::array::from_fn(|k| {
            let aside = (right >> k & 1) as usize + (above >> k & 1) as usize * layout.columns;
            (first[k] + aside) as u32
        });
        (lower + (upper - lower) * y, cells)
    }
}

/// Lowers each distance to that of the way through other inner cells, with steps of 1 along the
/// axes and `across` along diagonals, by two sweeps (Borgefors 1986).
pub(super) fn measure(distance: &mut [f32], layout: &Layout, across: f32) {
    for _ in 0..2 {
        for cell in layout.inner() {
            let below = cell - layout.columns;
            let straight = fast_min(distance[cell - 1], distance[below]) + 1.0;
            let diagonal = fast_min(distance[below - 1], distance[below + 1]) + across;
            let least = fast_min(straight, diagonal);
            distance[cell] = fast_min(distance[cell], least);
        }
        distance.reverse();
    }
}

/// The unit vector along `vector`; zero for zero.
fn unit(vector: Vec2) -> Vec2 {
    let length = vector.length();
    if length > 0.0 {
        vector / length
    } else {
        Vec2::ZERO
    }
}
