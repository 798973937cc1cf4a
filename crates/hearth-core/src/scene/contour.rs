//! The lines of an outline, and what is inside.

use glam::Vec2;

use crate::extremes::fast_max;

/// The opacity at the edge of a mask.
pub(super) const EDGE_OPACITY: f32 = 0.5;
/// Distance beside a line at which a point is inside or outside, as a share of the outline.
const SIDE_DISTANCE: f32 = 1e-4;

/// A part of an outline \[m\].
pub(super) type Line = [Vec2; 2];

/// The places of the nodes of a field.
pub(super) struct Nodes {
    /// The lower left one, relative to the centre of the solid \[m\].
    pub first: Vec2,
    /// Distance between two \[m\].
    pub step: Vec2,
    pub columns: usize,
    pub rows: usize,
}

impl Nodes {
    /// The place of a node \[m\].
    pub fn place(&self, column: usize, row: usize) -> Vec2 {
        self.first + Vec2::new(column as f32, row as f32) * self.step
    }
}

/// The sides of a polygon.
pub(super) fn sides(points: &[Vec2]) -> Vec<Line> {
    let ends = points.iter().skip(1).chain(points.first());
    points
        .iter()
        .copied()
        .zip(ends.copied())
        .map(|(start, end)| [start, end])
        .collect()
}

/// The outline of a polygon with these sides: without what is inside of one that crosses or touches itself.
pub(super) fn of_polygon(sides: &[Line]) -> Vec<Line> {
    let mut lines = Vec::new();
    let mut places = Vec::new();
    for &whole in sides {
        let [from, to] = whole;
        places.clear();
        places.push(1.0);
        for &other in sides {
            let place = crossing(whole, other);
            if place > 0.0 && place < 1.0 {
                // The standard library's sort would be kilobytes of wasm.
                let at = places.partition_point(|before| *before < place);
                places.insert(at, place);
            }
        }
        let mut begin = 0.0;
        for &end in &places {
            if end > begin {
                let line = [begin, end].map(|place| from + (to - from) * place);
                if is_edge(sides, line) {
                    lines.push(line);
                }
                begin = end;
            }
        }
    }
    lines
}

/// The place where a line crosses another one, between 0 and 1; NaN or beyond if it does not.
fn crossing([from, to]: Line, [start, end]: Line) -> f32 {
    let (path, across, apart) = (to - from, end - start, start - from);
    let area = path.perp_dot(across);
    let there = apart.perp_dot(path) / area;
    if (0.0..=1.0).contains(&there) {
        apart.perp_dot(across) / area
    } else {
        f32::NAN
    }
}

/// Whether one side of a line is inside and one is outside.
fn is_edge(sides: &[Line], [start, end]: Line) -> bool {
    let path = end - start;
    let middle = 0.5 * (start + end);
    let aside = path.perp() * (SIDE_DISTANCE / fast_max(path.length(), 1e-6));
    (winding(sides, middle + aside) != 0) != (winding(sides, middle - aside) != 0)
}

/// How often a polygon with these sides winds around a point. Without a branch, four sides are computed at once.
pub(super) fn winding(sides: &[Line], at: Vec2) -> i32 {
    let turns = sides.iter().map(|&[start, end]| {
        // 1 if the side rises past the height of the point, −1 if it falls and 0 if it does not pass.
        let turn = i32::from(start.y <= at.y) - i32::from(end.y <= at.y);
        let x = start.x + (end.x - start.x) * ((at.y - start.y) / (end.y - start.y));
        turn * i32::from(x < at.x)
    });
    turns.sum()
}

/// The lines between nodes with an opacity above and below the edge: marching squares.
pub(super) fn of_nodes(nodes: &Nodes, opacity: &[f32]) -> Vec<Line> {
    let mut lines = Vec::new();
    for row in 1..nodes.rows {
        for column in 1..nodes.columns {
            let mut begin = None;
            let mut from = [column - 1, row];
            for to in [
                [column - 1, row - 1],
                [column, row - 1],
                [column, row],
                from,
            ] {
                if let Some(place) = cut(nodes, opacity, from, to) {
                    match begin.take() {
                        Some(begin) => lines.push([begin, place]),
                        None => begin = Some(place),
                    }
                }
                from = to;
            }
            debug_assert_eq!(begin, None);
        }
    }
    lines
}

/// The place between two nodes where the opacity is that of the edge.
fn cut(nodes: &Nodes, opacity: &[f32], from: [usize; 2], to: [usize; 2]) -> Option<Vec2> {
    let [a, b] = [from, to].map(|[column, row]| opacity[row * nodes.columns + column]);
    let [start, end] = [from, to].map(|[column, row]| nodes.place(column, row));
    let place = start + (end - start) * ((EDGE_OPACITY - a) / (b - a));
    ((a > EDGE_OPACITY) != (b > EDGE_OPACITY)).then_some(place)
}
