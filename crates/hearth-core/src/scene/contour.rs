//! The lines of an outline, and what is inside.

use glam::Vec2;

use crate::extremes::{fast_max, fast_min};

/// The opacity at the edge of a mask.
pub(super) const EDGE: f32 = 0.5;
/// Distance beside a line at which a point is inside or outside, as a share of the outline.
const BESIDE: f32 = 1e-4;

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
fn sides(points: &[Vec2]) -> impl Iterator<Item = Line> + Clone {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(&one, &other)| [one, other])
}

/// The outline of a polygon: its sides, without what is inside of a polygon that crosses or touches
/// itself.
pub(super) fn of_polygon(points: &[Vec2]) -> Vec<Line> {
    let mut lines = Vec::new();
    for [from, to] in sides(points) {
        let mut places = vec![0.0, 1.0];
        for other in sides(points) {
            if let Some(place) = crossing([from, to], other)
                && let Some(at) = places.iter().position(|&known| known > place)
            {
                places.insert(at, place);
            }
        }
        let parts = places.array_windows::<2>();
        lines.extend(parts.map(|part| part.map(|place| from + (to - from) * place)));
    }
    lines.retain(|line| is_edge(points, line));
    lines
}

/// The place where a line crosses another one, between 0 and 1.
fn crossing([from, to]: Line, [one, other]: Line) -> Option<f32> {
    let (path, across) = (to - from, other - one);
    let area = path.perp_dot(across);
    let (place, there) = (
        (one - from).perp_dot(across) / area,
        (one - from).perp_dot(path) / area,
    );
    let crosses = place > 0.0 && place < 1.0 && (0.0..=1.0).contains(&there);
    crosses.then_some(place)
}

/// Whether one side of a line is inside and one is outside.
fn is_edge(points: &[Vec2], &[one, other]: &Line) -> bool {
    let path = other - one;
    let middle = 0.5 * (one + other);
    let aside = path.perp() * (BESIDE / fast_max(path.length(), 1e-6));
    let [left, right] = [middle + aside, middle - aside].map(|at| winding(points, at) != 0);
    left != right
}

/// How often a polygon winds around a point.
fn winding(points: &[Vec2], at: Vec2) -> i32 {
    let turns = sides(points).map(|line| match passes(line, at.y) {
        Some((x, turn)) if x < at.x => turn,
        _ => 0,
    });
    turns.sum()
}

/// Where a line passes a height, and 1 if it rises or −1 if it falls.
fn passes([one, other]: Line, y: f32) -> Option<(f32, i32)> {
    let rises = one.y <= y && y < other.y;
    let falls = other.y <= y && y < one.y;
    let x = one.x + (other.x - one.x) * ((y - one.y) / (other.y - one.y));
    (rises || falls).then_some((x, if rises { 1 } else { -1 }))
}

/// Calls `inside` with the number of each node that a polygon winds around.
pub(super) fn fill(points: &[Vec2], nodes: &Nodes, mut inside: impl FnMut(usize)) {
    let columns = nodes.columns;
    let mut turns = vec![0; columns + 1];
    for row in 0..nodes.rows {
        turns.fill(0);
        let left = nodes.place(0, row);
        for line in sides(points) {
            if let Some((x, turn)) = passes(line, left.y) {
                let column = (x - left.x) / nodes.step.x;
                let column = fast_min(fast_max(column, 0.0), columns as f32);
                if let Some(first) = turns.get_mut(libm::ceilf(column) as usize) {
                    *first += turn;
                }
            }
        }
        let mut winding = 0;
        for (column, turn) in turns.iter().take(columns).enumerate() {
            winding += turn;
            if winding != 0 {
                inside(row * columns + column);
            }
        }
    }
}

/// The lines between nodes with an opacity above and below the edge: marching squares.
pub(super) fn of_nodes(nodes: &Nodes, opacity: impl Fn(usize) -> f32) -> Vec<Line> {
    let mut lines = Vec::new();
    for row in 1..nodes.rows {
        for column in 1..nodes.columns {
            let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(right, up)| {
                let (column, row) = (column - 1 + right, row - 1 + up);
                (
                    nodes.place(column, row),
                    opacity(row * nodes.columns + column),
                )
            });
            let mut ends = [Vec2::ZERO; 4];
            let mut count = 0;
            for side in 0..4 {
                let ((one, a), (other, b)) = (corners[side], corners[(side + 1) % 4]);
                if (a > EDGE) != (b > EDGE) {
                    ends[count] = one + (other - one) * ((EDGE - a) / (b - a));
                    count += 1;
                }
            }
            if count >= 2 {
                lines.push([ends[0], ends[1]]);
            }
            if count == 4 {
                lines.push([ends[2], ends[3]]);
            }
        }
    }
    lines
}
