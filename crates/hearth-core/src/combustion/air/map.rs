//! A map of square cells over all places that may hold gas.
//!
//! A cell is as wide as the support of the kernel. Its depth is its chessboard distance to the
//! nearest cell without gas: 0 without gas, 1 in the outermost ring, up to [`DEEP`]. A border of
//! cells without gas surrounds the map, so a cell's neighbours need no check. Below a floor,
//! the border mirrors the lowest cells.

use glam::Vec2;

use crate::bounds::Bounds;

/// Largest depth that the map distinguishes.
pub(super) const DEEP: u8 = 5;
/// Largest depth of a cell near the rim: deeper ones only hold ordinary gas.
pub(super) const RIM: u8 = 3;

/// The eight cells around a cell.
pub(super) const AROUND: [(i32, i32); 8] = [
    (-1, -1),
    (0, -1),
    (1, -1),
    (-1, 0),
    (1, 0),
    (-1, 1),
    (0, 1),
    (1, 1),
];

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
        let column = self.index(position.x - self.left, self.columns);
        let row = self.index(position.y - self.bottom, self.rows);
        row * self.columns + column
    }

    #[inline]
    fn index(&self, along: f32, count: usize) -> usize {
        // A cast saturates, so a negative number and NaN become 0.
        ((along * self.per_metre) as usize).min(count - 1)
    }

    /// Lower left corner of a cell \[m\].
    pub fn corner(&self, cell: usize) -> Vec2 {
        let (column, row) = (cell % self.columns, cell / self.columns);
        Vec2::new(self.left, self.bottom) + Vec2::new(column as f32, row as f32) * self.cell
    }

    /// The cell that is this far from an inner cell.
    #[inline]
    pub fn beside(&self, cell: usize, (x, y): (i32, i32)) -> usize {
        (cell as i32 + y * self.columns as i32 + x) as usize
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

/// The depth of every cell.
#[derive(Clone, Debug, Default)]
pub(super) struct Map {
    pub layout: Layout,
    pub depth: Vec<u8>,
    /// Unit vector to the outside, in cells up to the depth [`RIM`].
    pub outward: Vec<Vec2>,
    /// Whether gas came to a cell with the last change.
    pub fresh: Vec<bool>,
    /// The cells with gas, and those of them up to the depth [`RIM`], in the order of their
    /// indices.
    pub live: Vec<u32>,
    pub rim: Vec<u32>,
}

impl Map {
    /// A map without gas.
    pub fn new(layout: Layout) -> Map {
        let n = layout.len();
        Map {
            layout,
            depth: vec![0; n],
            outward: vec![Vec2::ZERO; n],
            fresh: vec![false; n],
            live: Vec::with_capacity(n),
            rim: Vec::with_capacity(n),
        }
    }

    /// Puts gas into the cells of which `inside` is true, and into no others.
    pub fn fill(&mut self, inside: &[bool]) {
        let Layout { columns, .. } = self.layout;
        for (fresh, (&inside, &depth)) in self.fresh.iter_mut().zip(inside.iter().zip(&self.depth))
        {
            *fresh = inside && depth == 0;
        }
        // Two sweeps make the chessboard distance to a cell without gas. Below a floor it is deep.
        let below = if self.layout.floor { DEEP } else { 0 };
        self.depth[..columns].fill(below);
        let step = |depth: &[u8], cell: usize, before: [usize; 4]| {
            let least = before.map(|other| depth[other]).into_iter().min();
            if inside[cell] {
                DEEP.min(least.unwrap_or(0) + 1)
            } else {
                0
            }
        };
        for cell in self.layout.inner() {
            let before = [
                cell - columns - 1,
                cell - columns,
                cell - columns + 1,
                cell - 1,
            ];
            self.depth[cell] = step(&self.depth, cell, before);
        }
        let (rows, layout) = (self.layout.inner_rows(), self.layout);
        for cell in rows.rev().flat_map(|row| layout.row(row).rev()) {
            let after = [
                cell + columns + 1,
                cell + columns,
                cell + columns - 1,
                cell + 1,
            ];
            let back = step(&self.depth, cell, after);
            self.depth[cell] = self.depth[cell].min(back);
        }
        if self.layout.floor {
            let (border, inner) = self.depth.split_at_mut(columns);
            border.copy_from_slice(&inner[..columns]);
        }
        self.list();
    }

    /// Lists the cells with gas, and finds where the outside is.
    fn list(&mut self) {
        self.live.clear();
        self.rim.clear();
        for cell in self.layout.inner() {
            let depth = self.depth[cell];
            if depth == 0 {
                continue;
            }
            self.live.push(cell as u32);
            if depth <= RIM {
                self.rim.push(cell as u32);
                let slope: Vec2 = AROUND
                    .iter()
                    .map(|&(x, y)| {
                        let depth = self.depth[self.layout.beside(cell, (x, y))];
                        Vec2::new(x as f32, y as f32) * f32::from(depth)
                    })
                    .sum();
                self.outward[cell] = unit(-slope);
            }
        }
    }

    /// Whether there is gas at a position.
    pub fn holds(&self, position: Vec2) -> bool {
        let cell = self.layout.at(position);
        self.depth[cell] > 0 && cell >= self.layout.columns
    }

    /// The depth at a position, interpolated between the centres of the cells.
    #[inline]
    pub fn depth_at(&self, position: Vec2) -> f32 {
        let Layout {
            per_metre,
            columns,
            rows,
            left,
            bottom,
            ..
        } = self.layout;
        let part = |along: f32, count: usize| {
            let at = (along * per_metre - 0.5).max(0.0);
            let index = (at as usize).min(count - 2);
            (index, (at - index as f32).min(1.0))
        };
        let (column, x) = part(position.x - left, columns);
        let (row, y) = part(position.y - bottom, rows);
        let first = row * columns + column;
        let depth = |cell: usize| f32::from(self.depth[cell]);
        let mix = |cell: usize| depth(cell) + (depth(cell + 1) - depth(cell)) * x;
        let (lower, upper) = (mix(first), mix(first + columns));
        lower + (upper - lower) * y
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

#[cfg(test)]
mod tests {
    use super::*;

    fn layout(floor: bool) -> Layout {
        Layout::new(0.8, 0.3, 1.7, 0.1, floor)
    }

    /// A map with gas in every cell whose centre is in the rectangle.
    fn filled(floor: bool, from: Vec2, to: Vec2) -> Map {
        let mut map = Map::new(layout(floor));
        let half = Vec2::splat(0.05);
        let mut inside = vec![false; map.layout.len()];
        for cell in map.layout.inner() {
            let at = map.layout.corner(cell) + half;
            inside[cell] = at.cmpge(from).all() && at.cmple(to).all();
        }
        map.fill(&inside);
        map
    }

    #[test]
    fn all_places_are_inside_and_the_floor_is_at_zero() {
        for floor in [false, true] {
            let bounds = layout(floor).bounds();
            assert!(bounds.width >= 1.8 - 1e-5 && bounds.width < 2.01);
            assert!((bounds.bottom - if floor { 0.0 } else { -0.4 }).abs() < 1e-5);
            assert!(bounds.bottom + bounds.height >= 1.7 - 1e-5);
        }
    }

    #[test]
    fn a_position_is_in_its_cell_and_any_other_in_the_border() {
        let layout = layout(false);
        for cell in layout.inner() {
            assert_eq!(layout.at(layout.corner(cell) + Vec2::splat(0.05)), cell);
        }
        let inner: Vec<usize> = layout.inner().collect();
        for at in [
            Vec2::new(-9.0, 0.5),
            Vec2::new(0.0, 9.0),
            Vec2::new(f32::NAN, 0.5),
            Vec2::new(0.0, f32::NEG_INFINITY),
        ] {
            assert!(!inner.contains(&layout.at(at)), "{at}");
        }
    }

    #[test]
    fn common_cells_of_two_layouts_are_the_same_place() {
        for floor in [false, true] {
            let (small, large) = (layout(floor), Layout::new(2.0, 1.1, 1.75, 0.1, floor));
            for (one, other) in [(small, large), (large, small)] {
                let pairs: Vec<_> = one.common(&other).collect();
                assert_eq!(pairs.len(), small.inner().count());
                for (cell, same) in pairs {
                    assert!(one.corner(cell).distance(other.corner(same)) < 1e-5);
                }
            }
        }
    }

    #[test]
    fn the_depth_is_the_distance_to_the_outside() {
        let map = filled(false, Vec2::new(-0.7, 0.0), Vec2::new(0.7, 1.2));
        for cell in map.layout.inner() {
            let at = map.layout.corner(cell) + Vec2::splat(0.05);
            let to_edge = (0.7 - at.x.abs()).min(at.y).min(1.2 - at.y);
            let expected = ((to_edge / 0.1).round() + 1.0).clamp(0.0, f32::from(DEEP));
            let depth = f32::from(map.depth[cell]);
            assert!((depth - expected).abs() <= 1.0, "{depth} at {at}");
            assert!((map.depth_at(at) - depth).abs() < 1e-4);
        }
    }

    #[test]
    fn the_normal_points_outward_and_a_floor_is_no_outside() {
        let map = filled(true, Vec2::new(-0.6, 0.0), Vec2::new(0.6, 1.0));
        let at = |x, y| map.layout.at(Vec2::new(x, y));
        let left = map.outward[at(-0.55, 0.45)];
        assert!(left.distance(Vec2::NEG_X) < 1e-4, "{left}");
        assert!(map.outward[at(0.0, 0.95)].distance(Vec2::Y) < 1e-4);
        assert_eq!(map.depth[at(0.05, 0.05)], DEEP);
        assert!(map.outward[at(-0.55, 0.05)].distance(Vec2::NEG_X) < 1e-4);
    }

    #[test]
    fn cells_that_gas_enters_are_fresh_once() {
        let mut map = filled(false, Vec2::new(-0.5, 0.0), Vec2::new(0.5, 1.0));
        let fresh = |map: &Map| map.fresh.iter().filter(|&&fresh| fresh).count();
        assert_eq!(fresh(&map), map.live.len());
        let inside: Vec<bool> = map.depth.iter().map(|&depth| depth > 0).collect();
        map.fill(&inside);
        assert_eq!(fresh(&map), 0);
    }
}
